// Tests of file stamps: every change by others is noticed, and reported once.
#include "app/storage/file_stamps.h"

#include <chrono>

#include "scratch_folder.h"
#include <doctest/doctest.h>

using namespace interleaf;

namespace fs = std::filesystem;

namespace {

/// As if written some seconds later, so that no clock's grain hides it.
void put_later(const fs::path& file, std::string_view text, int seconds) {
    const auto written = fs::last_write_time(file);
    put(file, text);
    fs::last_write_time(file, written + std::chrono::seconds(seconds));
}

}  // namespace

TEST_CASE("files that stay as they are, and no files, are not reported") {
    const ScratchFolder folder;
    put(folder / "a", "text");
    FileStamps stamps({folder / "a", folder.path(), folder / "never there"});
    CHECK_FALSE(stamps.take_changed());
    CHECK(content(folder / "a") == "text");
    CHECK_FALSE(stamps.take_changed());
    CHECK_FALSE(FileStamps().take_changed());
}

TEST_CASE("another size, another time alone, an earlier one too, is a change, reported once") {
    const ScratchFolder folder;
    put(folder / "a", "text");
    FileStamps stamps({folder / "a"});
    const auto written = fs::last_write_time(folder / "a");

    put(folder / "a", "other");
    fs::last_write_time(folder / "a", written);
    CHECK(stamps.take_changed() == folder / "a");
    CHECK_FALSE(stamps.take_changed());

    for (const int seconds : {1, -60}) {
        put_later(folder / "a", "OTHER", seconds);
        CHECK(stamps.take_changed() == folder / "a");
        CHECK_FALSE(stamps.take_changed());
    }
}

TEST_CASE("a file that goes is a change, and so is one that comes, an empty one too") {
    const ScratchFolder folder;
    put(folder / "a", "");
    FileStamps stamps({folder / "a", folder / "b"});
    fs::remove(folder / "a");
    CHECK(stamps.take_changed() == folder / "a");
    CHECK_FALSE(stamps.take_changed());
    put(folder / "b", "");
    CHECK(stamps.take_changed() == folder / "b");
    CHECK_FALSE(stamps.take_changed());
    put(folder / "a", "");
    CHECK(stamps.take_changed() == folder / "a");
    CHECK_FALSE(stamps.take_changed());
}

TEST_CASE("of several changes each is reported, the first file first") {
    const ScratchFolder folder;
    for (const char* const name : {"a", "b", "c"}) put(folder / name, "text");
    FileStamps stamps({folder / "c", folder / "a", folder / "b"});
    put(folder / "a", "longer text");
    put(folder / "c", "longer text");
    CHECK(stamps.take_changed() == folder / "c");
    CHECK(stamps.take_changed() == folder / "a");
    CHECK_FALSE(stamps.take_changed());
}
