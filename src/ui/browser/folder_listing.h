// What is in a folder: read once, then filtered and sorted for the file browser. Knows no ImGui.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "text/natural_order.h"

namespace interleaf {

enum class EntryKind : std::uint8_t { folder, file, broken_link, other };

/// Links count as what they lead to.
struct FolderEntry {
    std::filesystem::path name;  ///< in its folder
    std::string label;           ///< the name as shown_name() shows it
    NaturalName order;           ///< of the label, to sort and to find by
    EntryKind kind = EntryKind::file;
    std::uint64_t size = 0;     ///< bytes; of files
    std::int64_t modified = 0;  ///< seconds since 1970, UTC

    bool is_folder() const { return kind == EntryKind::folder; }
    bool is_hidden() const { return name.native().starts_with('.'); }
};

struct FolderListing {
    std::vector<FolderEntry> entries;
    std::string error;  ///< what the system said when it could not be read, or not to its end
};

FolderListing read_folder(const std::filesystem::path& folder);

/// Files a person may want to see alone.
struct FileType {
    std::string name;                     ///< "Meshes"
    std::vector<std::string> extensions;  ///< ".obj"; none: all files
};

/// Whether the name ends in one of the type's extensions, in any case.
bool is_of_type(const FolderEntry& entry, const FileType& type);

enum class SortColumn : std::uint8_t { name, size, modified };

struct SortOrder {
    SortColumn column = SortColumn::name;
    bool descending = false;
    bool operator==(const SortOrder&) const = default;
};

struct ListingFilter {
    FileType type;
    bool hidden = false;  ///< show hidden files, too
    bool only_folders = false;
};

/// The entries to show, as indices in their order: folders first, then by \p order, equal ones in the natural
/// order of their names. Folders pass every type.
std::vector<std::size_t> shown_entries(std::span<const FolderEntry> entries, const ListingFilter& filter,
                                       SortOrder order);

/// "1.2 MB": at most four characters and the unit, of 1000.
std::string size_text(std::uint64_t bytes);

/// "2026-03-09 14:05", local time; "" where there is no such date.
std::string date_text(std::int64_t seconds);

}  // namespace interleaf
