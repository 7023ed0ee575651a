#include "io/file/safe_write.h"

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file/file_descriptor.h"
#include "io/file/temporary_file.h"
#include "io/file_size_limit.h"

namespace interleaf {

namespace fs = std::filesystem;

namespace {}  // namespace

TEST_CASE("a file is written whole and no other file remains beside it") {
    const ScratchFolder folder;
    for (const std::string& text : {std::string("first"), std::string(), std::string(3'000'000, 'x')}) {
        write_file(folder / "a.txt", text);
        CHECK(content(folder / "a.txt") == text);
        CHECK(folder.entry_count() == 1);
    }
}

TEST_CASE("a write that fails halfway leaves the old file and no other file") {
    const ScratchFolder folder;
    put(folder / "a.txt", "old");
    std::string error;
    {
        const FileSizeLimit limit(10'000);
        error = machine_error_of([&] { write_file(folder / "a.txt", std::string(100'000, 'x')); });
    }
    CHECK(contains(error, (folder / "a.txt").string() + ": cannot write: File too large"));
    CHECK(content(folder / "a.txt") == "old");
    CHECK(folder.entry_count() == 1);
}

TEST_CASE("a folder that is missing or is a file is reported") {
    const ScratchFolder folder;
    put(folder / "file", "old");
    CHECK(contains(machine_error_of([&] { write_file(folder / "missing/a.txt", "new"); }),
                   "missing/a.txt: cannot write: No such file or directory"));
    CHECK(contains(machine_error_of([&] { write_file(folder / "file/a.txt", "new"); }), "Not a directory"));
    CHECK(contains(machine_error_of([&] { write_file(folder.path(), "new"); }), "Is a directory"));
    CHECK(content(folder / "file") == "old");
    CHECK(folder.entry_count() == 1);
}

TEST_CASE("an existing file keeps its permissions, and a new file follows the umask") {
    const ScratchFolder folder;
    const auto mode = [&] { return static_cast<unsigned>(fs::status(folder / "a.txt").permissions()); };
    const mode_t old_mask = ::umask(027);
    write_file(folder / "a.txt", "new");
    CHECK(mode() == 0640);
    REQUIRE(::chmod((folder / "a.txt").c_str(), 0604) == 0);
    write_file(folder / "a.txt", "newer");
    CHECK(mode() == 0604);
    CHECK(content(folder / "a.txt") == "newer");
    ::umask(old_mask);
}

TEST_CASE("a link is followed and remains a link") {
    const ScratchFolder folder;
    fs::create_directory(folder / "inner");
    put(folder / "inner/a.txt", "old");
    fs::create_symlink("inner/a.txt", folder / "link");
    write_file(folder / "link", "new");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(content(folder / "inner/a.txt") == "new");
}

TEST_CASE("a device is written to, not replaced") {
    write_file("/dev/null", "gone");
    CHECK(fs::is_character_file("/dev/null"));
    CHECK(contains(machine_error_of([] { write_file("/dev/full", "more"); }), "No space left on device"));
    CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("the longest possible file name can be written") {
    const ScratchFolder folder;
    const std::string name(255, 'n');
    write_file(folder / name, "new");
    CHECK(content(folder / name) == "new");
}

TEST_CASE("a link to a missing file creates that file, and links in a circle are an error") {
    const ScratchFolder folder;
    fs::create_symlink("new.txt", folder / "link");
    fs::create_symlink("link", folder / "link-to-link");
    write_file(folder / "link-to-link", "new");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(fs::is_symlink(folder / "link-to-link"));
    CHECK(content(folder / "new.txt") == "new");

    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    CHECK(contains(machine_error_of([&] { write_file(folder / "a", "new"); }),
                   (folder / "a").string() + ": cannot write: Too many levels of symbolic links"));
}

TEST_CASE("the next write removes the file of a killed process, but not the file of a running process") {
    const ScratchFolder folder;
    put(folder / ".interleaf-0", "left");
    put(folder / ".interleaf-1", "in use");
    put(folder / ".interleaf-2", "left");
    {
        const FileDescriptor living(folder / ".interleaf-1", O_RDONLY);
        REQUIRE(::flock(living.number(), LOCK_EX) == 0);
        fs::rename(folder / ".interleaf-2", folder / ".interleaf-7");
        write_file(folder / "a.txt", "new");
        CHECK_FALSE(fs::exists(folder / ".interleaf-0"));
        put(folder / ".interleaf-0", "left again");
        const TemporaryFile first(folder.path(), 0600);
        const TemporaryFile second(folder.path(), 0600);
        REQUIRE(second.is_open());
        CHECK(content(folder / ".interleaf-0").empty());
        CHECK(content(folder / ".interleaf-1") == "in use");
        CHECK(content(folder / ".interleaf-2").empty());
    }
    CHECK(content(folder / "a.txt") == "new");
    CHECK(folder.entry_count() == 3);  // .interleaf-7 remains until there are that many writers
}

TEST_CASE("a file of another user or program is left alone, whatever its name") {
    const ScratchFolder folder;
    fs::create_directory(folder / ".interleaf-0");
    REQUIRE(::mkfifo((folder / ".interleaf-1").c_str(), 0600) == 0);
    put(folder / "theirs", "theirs");
    fs::create_symlink("theirs", folder / ".interleaf-2");
    write_file(folder / "a.txt", "new");
    CHECK(content(folder / "a.txt") == "new");
    CHECK(content(folder / "theirs") == "theirs");
    CHECK(folder.entry_count() == 5);
}

TEST_CASE("a write-protected file or folder is reported and unchanged") {
    const ScratchFolder folder;
    fs::create_directory(folder / "locked");
    put(folder / "locked/a.txt", "old");
    put(folder / "a.txt", "old");
    fs::permissions(folder.path(), fs::perms::all);
    fs::permissions(folder / "a.txt", fs::perms::others_read | fs::perms::owner_read);
    fs::permissions(folder / "locked", fs::perms::others_read | fs::perms::others_exec |
                                           fs::perms::owner_read | fs::perms::owner_exec);
    const uid_t user = ::geteuid();
    if (user == 0) REQUIRE(::seteuid(65534) == 0);  // root can write everywhere
    const std::string file_error = machine_error_of([&] { write_file(folder / "a.txt", "new"); });
    const std::string folder_error = machine_error_of([&] { write_file(folder / "locked/b.txt", "new"); });
    REQUIRE(::seteuid(user) == 0);
    CHECK(file_error == (folder / "a.txt").string() + ": cannot write: Permission denied");
    CHECK(folder_error == (folder / "locked/b.txt").string() + ": cannot write: Permission denied");
    CHECK(content(folder / "a.txt") == "old");
    CHECK(content(folder / "locked/a.txt") == "old");
    fs::permissions(folder / "locked", fs::perms::owner_all);
    CHECK(folder.entry_count() == 2);
}

TEST_CASE("a file that only its owner may read is private while it is written, too") {
    const ScratchFolder folder;
    const mode_t old_mask = ::umask(0);
    const TemporaryFile temporary(folder.path(), 0600);
    ::umask(old_mask);
    CHECK(fs::status(folder / ".interleaf-0").permissions() ==
          (fs::perms::owner_read | fs::perms::owner_write));
}

}  // namespace interleaf
