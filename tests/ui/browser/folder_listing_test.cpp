// Tests of reading, filtering and sorting a folder, and of finding a name in it by typing.
#include "ui/browser/folder_listing.h"

#include <algorithm>
#include <vector>

#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "text/shown_text.h"
#include "ui/browser/type_ahead.h"

using namespace interleaf;

namespace fs = std::filesystem;

namespace {

FolderEntry entry(const std::string& name, EntryKind kind = EntryKind::file, std::uint64_t size = 0,
                  std::int64_t modified = 0) {
    return {.name = name,
            .label = shown_name(name),
            .order = NaturalName(shown_name(name)),
            .kind = kind,
            .size = size,
            .modified = modified};
}

std::string names(const std::vector<FolderEntry>& entries, const ListingFilter& filter,
                  SortOrder order = {}) {
    std::string text;
    for (const std::size_t i : shown_entries(entries, filter, order)) text += entries[i].label + " ";
    return text;
}

const FolderEntry& named(const FolderListing& listing, const fs::path& name) {
    const auto found = std::ranges::find(listing.entries, name, &FolderEntry::name);
    REQUIRE(found != listing.entries.end());
    return *found;
}

const std::vector<FolderEntry> sample{entry("flow.10.ilh", EntryKind::file, 5, 30),
                                      entry("b", EntryKind::folder, 0, 10),
                                      entry("flow.2.ILH", EntryKind::file, 7, 20),
                                      entry(".hidden.ilh", EntryKind::file, 1, 1),
                                      entry("mesh.obj", EntryKind::file, 5, 40),
                                      entry("A", EntryKind::folder, 0, 50),
                                      entry(".git", EntryKind::folder),
                                      entry("lost.ilh", EntryKind::broken_link, 0, 5)};

const FileType all{.name = "All", .extensions = {}};
const FileType keys{.name = "Keys", .extensions = {".json", ".ilh"}};

}  // namespace

TEST_CASE("reading a folder gives kinds, sizes and dates, and those of the target for a link") {
    const ScratchFolder folder;
    put(folder / "file", "12345");
    fs::create_directory(folder / "inner");
    fs::create_symlink("file", folder / "to file");
    fs::create_symlink("inner", folder / "to folder");
    fs::create_symlink("nowhere", folder / "to nothing");
    fs::create_symlink("circle", folder / "circle");
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    put(folder / "bad\xff", "");
    const FolderListing listing = read_folder(folder.path());
    CHECK(listing.error.empty());
    CHECK(listing.entries.size() == 8);
    CHECK(named(listing, "file").size == 5);
    CHECK(named(listing, "file").modified > 1'500'000'000);
    CHECK(named(listing, "to file").size == 5);
    CHECK(named(listing, "to file").kind == EntryKind::file);
    CHECK(named(listing, "inner").is_folder());
    CHECK(named(listing, "to folder").is_folder());
    CHECK(named(listing, "to nothing").kind == EntryKind::broken_link);
    CHECK(named(listing, "circle").kind == EntryKind::broken_link);
    CHECK(named(listing, "pipe").kind == EntryKind::other);
    CHECK(named(listing, "bad\xff").label == "bad\\xff");
}

TEST_CASE("a folder that cannot be read gives the reason") {
    const ScratchFolder folder;
    CHECK(read_folder(folder / "missing").error == "No such file or directory");
    put(folder / "file", "");
    CHECK(read_folder(folder / "file").error == "Not a directory");
    fs::create_directory(folder / "closed");
    fs::permissions(folder / "closed", fs::perms::none);
    if (::access((folder / "closed").c_str(), R_OK) != 0)
        CHECK(read_folder(folder / "closed").error == "Permission denied");
    CHECK(read_folder(folder.path()).error.empty());
}

TEST_CASE("folders come first, and names are in natural order") {
    CHECK(names(sample, {.type = all}) == "A b flow.2.ILH flow.10.ilh lost.ilh mesh.obj ");
    CHECK(names(sample, {.type = all}, {.column = SortColumn::name, .descending = true}) ==
          "b A mesh.obj lost.ilh flow.10.ilh flow.2.ILH ");
}

TEST_CASE("entries of equal size or date are ordered by name, ascending and descending") {
    CHECK(names(sample, {.type = all}, {.column = SortColumn::size}) ==
          "A b lost.ilh flow.10.ilh mesh.obj flow.2.ILH ");
    CHECK(names(sample, {.type = all}, {.column = SortColumn::size, .descending = true}) ==
          "A b flow.2.ILH flow.10.ilh mesh.obj lost.ilh ");
    CHECK(names(sample, {.type = all}, {.column = SortColumn::modified, .descending = true}) ==
          "A b mesh.obj flow.10.ilh flow.2.ILH lost.ilh ");
}

TEST_CASE("a type passes all folders, and its files in any case") {
    CHECK(names(sample, {.type = keys}) == "A b flow.2.ILH flow.10.ilh lost.ilh ");
    CHECK(names(sample, {.type = keys, .hidden = true}) ==
          ".git A b .hidden.ilh flow.2.ILH flow.10.ilh lost.ilh ");
    CHECK(names(sample, {.type = all, .only_folders = true}) == "A b ");
}

TEST_CASE("typing finds the next name with this beginning, and wraps around") {
    const auto shown = shown_entries(sample, {.type = all}, {});  // A b flow.2 flow.10 lost mesh
    TypeAhead typing;
    CHECK(typing.type("F", 0, sample, shown, 0) == 2);
    CHECK(typing.type("l", 0.5, sample, shown, 2) == 2);
    CHECK(typing.type("ow.1", 0.9, sample, shown, 2) == 3);
    CHECK(typing.is_typing(1.5));
    CHECK_FALSE(typing.type("x", 1.5, sample, shown, 3));
    CHECK_FALSE(typing.is_typing(3));
    CHECK(typing.type("a", 3, sample, shown, 3) == 0);
    CHECK_FALSE(TypeAhead().type("a", 0, sample, {}, 0));
}

TEST_CASE("repeating a letter goes from name to name") {
    const auto shown = shown_entries(sample, {.type = all}, {});
    TypeAhead typing;
    CHECK(typing.type("f", 0, sample, shown, 0) == 2);
    CHECK(typing.type("f", 0.2, sample, shown, 2) == 3);
    CHECK(typing.type("f", 0.4, sample, shown, 3) == 2);
}

TEST_CASE("a doubled letter can be the beginning of a name") {
    const std::vector<FolderEntry> entries{entry("oak"), entry("oo"), entry("ox")};
    const std::vector<std::size_t> shown{0, 1, 2};
    TypeAhead typing;
    CHECK(typing.type("o", 0, entries, shown, 0) == 1);
    CHECK(typing.type("o", 0.2, entries, shown, 1) == 1);
    CHECK(typing.type("o", 5, entries, shown, 1) == 2);
}

TEST_CASE("sizes have few digits") {
    CHECK(size_text(0) == "0 B");
    CHECK(size_text(999) == "999 B");
    CHECK(size_text(1000) == "1.0 kB");
    CHECK(size_text(9949) == "9.9 kB");
    CHECK(size_text(9950) == "10 kB");
    CHECK(size_text(999'499) == "999 kB");
    CHECK(size_text(999'500) == "1.0 MB");
    CHECK(size_text(1'234'567'890) == "1.2 GB");
    CHECK(size_text(UINT64_MAX) == "18 EB");
}

TEST_CASE("dates have minutes, and an invalid date has no text") {
    CHECK(date_text(1'800'000'000).size() == std::string("2027-01-15 08:00").size());
    CHECK(date_text(INT64_MAX).empty());
}
