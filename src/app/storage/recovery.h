// Recoveries: documents of programs that ended without saving. A running program keeps its unsaved document
// in a folder of its own, STATE/recovery/PID-START[-NUMBER]. The folder holds a family folder "family", and
// recovery.json, which describes the document. The folder's name identifies the process. When that process no
// longer runs, the recovery is abandoned. Another program may claim it by renaming the folder; only one
// program can succeed. Only discard_recovery() removes a family.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

/// The content of recovery.json.
struct RecoveryNote {
    std::string name;                       ///< of the document
    std::filesystem::path document_folder;  ///< the document's folder; empty if it has none yet
    std::int64_t time = 0;                  ///< time of writing, seconds since 1970 UTC; 0 if unknown

    bool operator==(const RecoveryNote&) const = default;
};

/// Reads a note. \p name stands for the file in messages.
/// \throw InputError naming \p name, the place and what was expected
RecoveryNote parse_recovery_note(std::string_view json, std::string_view name);
std::string recovery_note_text(const RecoveryNote& note);

struct Recovery {
    std::filesystem::path folder;
    RecoveryNote note;

    std::filesystem::path family() const { return folder / "family"; }
    std::filesystem::path note_file() const { return folder / "recovery.json"; }
};

/// Creates an empty recovery folder for this process.
/// \throw MachineError if it cannot be created
Recovery make_recovery(const std::filesystem::path& state_folder);

/// The recoveries that hold a family and whose programs no longer run, the latest first. If a note is missing
/// or damaged, the document's name is "Unnamed". Folders of such programs without a complete family are
/// removed.
std::vector<Recovery> abandoned_recoveries(const std::filesystem::path& state_folder);

/// Claims \p recovery for this process. It is abandoned again if this process ends without discarding it.
/// \return the recovery in its new place; none if another program was faster, or if it cannot be renamed
std::optional<Recovery> claim_recovery(const Recovery& recovery);

/// Removes \p recovery from the disk, after the document was saved elsewhere or discarded.
/// \throw MachineError if it cannot be removed
void discard_recovery(const Recovery& recovery);

}  // namespace interleaf
