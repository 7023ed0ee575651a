// The journal of a save: the key files that a save makes, and the key files that the new family.json will not
// name.
//
// The journal is the file .interleaf-save beside family.json. It exists from before the first of these files
// changes until the last is settled. So after a save was killed, the next save can find the files that belong
// to neither the old nor the new family.
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

/// A key file, with its size and checksum to distinguish it from another file of the same name.
struct KeyFileMark {
    std::string name;
    std::uint64_t size = 0;
    std::uint32_t checksum = 0;  ///< the last four bytes of the file

    bool operator==(const KeyFileMark&) const = default;
};

KeyFileMark mark_of(std::string name, std::span<const std::byte> bytes);

/// The mark of the key file \p name in \p folder; none if there is no such file, or if it is too short to be
/// a hierarchy file.
std::optional<KeyFileMark> mark_of(std::string name, const std::filesystem::path& folder);

/// The key files directly in \p folder that its family.json names. The set is empty if there is no
/// family.json. There is no set if the family.json cannot be understood.
std::optional<std::set<std::string>> named_key_files(const std::filesystem::path& folder);

/// Writes the journal.
/// \throw MachineError if the journal cannot be written
void begin_save(const std::filesystem::path& folder, std::span<const KeyFileMark> files);

/// Removes the files that the journal lists and family.json does not name, if they still match their marks.
/// Then removes the journal. A file that cannot be removed does no harm, so this is not an error.
void finish_save(const std::filesystem::path& folder);

}  // namespace interleaf
