#include "ui/browser/folder_listing.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <system_error>

#include <fmt/core.h>
#include <sys/stat.h>

#include "text/characters.h"
#include "text/shown_text.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

EntryKind kind_of(mode_t mode) {
    if (S_ISDIR(mode)) return EntryKind::folder;
    if (S_ISREG(mode)) return EntryKind::file;
    if (S_ISLNK(mode)) return EntryKind::broken_link;
    return EntryKind::other;
}

FolderEntry entry_at(const fs::path& path) {
    FolderEntry entry{.name = path.filename(), .label = {}, .order = {}};
    entry.label = shown_name(entry.name.native());
    entry.order = NaturalName(entry.label);
    struct stat status {};
    // Describe a link itself if it leads nowhere, or in a circle.
    if (::stat(path.c_str(), &status) != 0 && ::lstat(path.c_str(), &status) != 0) {
        entry.kind = EntryKind::other;  // removed in the meantime, or access denied
        return entry;
    }
    entry.kind = kind_of(status.st_mode);
    entry.size = entry.kind == EntryKind::file ? static_cast<std::uint64_t>(status.st_size) : 0;
    entry.modified = status.st_mtime;
    return entry;
}

/// Whether \p a comes before \p b in the order of a column. Entries that are equal there are ordered by name.
bool is_before(const FolderEntry& a, const FolderEntry& b, SortOrder order) {
    if (a.is_folder() != b.is_folder()) return a.is_folder();
    const FolderEntry& first = order.descending ? b : a;
    const FolderEntry& second = order.descending ? a : b;
    if (order.column == SortColumn::size && a.size != b.size) return first.size < second.size;
    if (order.column == SortColumn::modified && a.modified != b.modified)
        return first.modified < second.modified;
    const bool by_name = order.column == SortColumn::name;
    const FolderEntry& left = by_name ? first : a;
    const FolderEntry& right = by_name ? second : b;
    if (left.order != right.order) return left.order < right.order;
    return left.name.native() < right.name.native();
}

}  // namespace

FolderListing read_folder(const fs::path& folder) {
    FolderListing listing;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        listing.entries.push_back(entry_at(entry->path()));
    if (error) listing.error = error.message();
    return listing;
}

bool is_of_type(const FolderEntry& entry, const FileType& type) {
    return type.extensions.empty() || std::ranges::any_of(type.extensions, [&](const std::string& extension) {
               return entry.order.folded.ends_with(folded(extension));
           });
}

std::vector<std::size_t> shown_entries(std::span<const FolderEntry> entries, const ListingFilter& filter,
                                       SortOrder order) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const FolderEntry& entry = entries[i];
        if (entry.is_hidden() && !filter.hidden) continue;
        if (!entry.is_folder() && (filter.only_folders || !is_of_type(entry, filter.type))) continue;
        shown.push_back(i);
    }
    std::ranges::sort(shown,
                      [&](std::size_t a, std::size_t b) { return is_before(entries[a], entries[b], order); });
    return shown;
}

std::string size_text(std::uint64_t bytes) {
    if (bytes < 1000) return fmt::format("{} B", bytes);
    constexpr std::array units{"kB", "MB", "GB", "TB", "PB", "EB"};
    auto value = static_cast<double>(bytes) / 1000;
    std::size_t unit = 0;
    constexpr double rounded_up = 999.5;
    while (value >= rounded_up && unit + 1 < units.size()) {
        value /= 1000;
        ++unit;
    }
    constexpr double rounds_to_ten = 9.95;
    return fmt::format("{:.{}f} {}", value, value < rounds_to_ten ? 1 : 0, units.at(unit));
}

std::string date_text(std::int64_t seconds) {
    const std::time_t time = seconds;
    std::tm local{};
    if (::localtime_r(&time, &local) == nullptr) return "";
    std::array<char, 64> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local)};
}

}  // namespace interleaf
