// The content of a folder: read once, then filtered and sorted for the file browser. Does not use ImGui.
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

/// An entry of a folder. A link has the properties of its target.
struct FolderEntry {
    std::filesystem::path name;  ///< without the folder
    std::string label;           ///< the name as shown_name() shows it
    NaturalName order;           ///< the label, prepared for sorting and searching
    EntryKind kind = EntryKind::file;
    std::uint64_t size = 0;     ///< bytes; 0 unless the entry is a file
    std::int64_t modified = 0;  ///< seconds since 1970, UTC

    bool is_folder() const { return kind == EntryKind::folder; }
    bool is_hidden() const { return name.native().starts_with('.'); }
};

struct FolderListing {
    std::vector<FolderEntry> entries;
    std::string error;  ///< the system's message if the folder could not be read to its end; empty otherwise
};

FolderListing read_folder(const std::filesystem::path& folder);

/// A type of files that the user can show alone.
struct FileType {
    std::string name;                     ///< "Meshes"
    std::vector<std::string> extensions;  ///< ".obj"; empty for all files
};

/// Whether the name ends in one of the type's extensions, ignoring case.
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

/// The indices of the entries to show, in their order: folders first, then by \p order, then in the natural
/// order of names. Folders pass every type.
std::vector<std::size_t> shown_entries(std::span<const FolderEntry> entries, const ListingFilter& filter,
                                       SortOrder order);

/// A size in few digits: "1.2 MB". Units are powers of 1000.
std::string size_text(std::uint64_t bytes);

/// Local date and time: "2026-03-09 14:05". Empty if there is no such date.
std::string date_text(std::int64_t seconds);

}  // namespace interleaf
