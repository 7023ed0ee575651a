// The journal of a save: which key files a save of a family makes, and which it will leave without a name.
//
// It lies beside family.json as .interleaf-save from before the first of these files is touched until the
// last is settled. So when a save is killed, the next one finds out which files belong to neither the old nor
// the new family.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace interleaf {

/// A key file, and what tells it from another file of that name.
struct KeyFileMark {
    std::string name;
    std::uint64_t size = 0;
    std::uint32_t checksum = 0;  ///< its last four bytes

    bool operator==(const KeyFileMark&) const = default;
};

KeyFileMark mark_of(std::string name, std::span<const std::byte> bytes);

/// Of the key file \p name in \p folder; none if there is no such file, or it is no hierarchy file at all.
std::optional<KeyFileMark> mark_of(std::string name, const std::filesystem::path& folder);

/// The key files directly in \p folder that its family.json names; none of them if there is no family.json.
/// Nothing if there is one that cannot be understood.
std::optional<std::set<std::string>> named_key_files(const std::filesystem::path& folder);

/// Writes the journal.
/// \throw MachineError when it cannot be written
void begin_save(const std::filesystem::path& folder, std::span<const KeyFileMark> files);

/// Removes the files in the journal that family.json does not name, if they are still those that the journal
/// knows, and then the journal. What cannot be removed does no harm, so that is no error.
void finish_save(const std::filesystem::path& folder);

}  // namespace interleaf
