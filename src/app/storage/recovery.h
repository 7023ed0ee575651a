// Documents of programs that ended without saving. A program keeps what is not yet saved in a folder of its
// own, STATE/recovery/PID-START[-NUMBER]: a family folder "family", and recovery.json about the document. The
// folder's name says whose it is; when no such process runs any more, it is abandoned, and another program
// may claim it by renaming it, which only one can. Nothing here removes a family but discard_recovery().
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

/// What recovery.json holds.
struct RecoveryNote {
    std::string name;                       ///< of the document
    std::filesystem::path document_folder;  ///< where it was opened from or saved to; empty if nowhere yet
    std::int64_t time = 0;                  ///< of writing, seconds since 1970 UTC; 0 when not known

    bool operator==(const RecoveryNote&) const = default;
};

/// \throw InputError naming \p name, the place and what was expected
RecoveryNote parse_recovery_note(std::string_view json, std::string_view name);
std::string recovery_note_text(const RecoveryNote& note);

struct Recovery {
    std::filesystem::path folder;
    RecoveryNote note;

    std::filesystem::path family() const { return folder / "family"; }
    std::filesystem::path note_file() const { return folder / "recovery.json"; }
};

/// Makes an empty folder that is this process's.
/// \throw MachineError when it cannot be made
Recovery make_recovery(const std::filesystem::path& state_folder);

/// Those of programs that run no more and hold a family, the latest first. A note that is missing or damaged
/// gives the document's name as "Unnamed". Folders of such programs without a whole family are removed.
std::vector<Recovery> abandoned_recoveries(const std::filesystem::path& state_folder);

/// Makes \p recovery this process's, so that it is abandoned again should this process end without discarding
/// it. \return it in its new place; none when another program was faster, or it cannot be renamed
std::optional<Recovery> claim_recovery(const Recovery& recovery);

/// Removes it from the disk: after it was saved elsewhere, or nobody wants it.
/// \throw MachineError when it cannot be removed
void discard_recovery(const Recovery& recovery);

}  // namespace interleaf
