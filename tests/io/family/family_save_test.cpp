// Saves of a family that meet an obstacle: a full disk, another process that saves, files that an earlier
// save left.
#include <algorithm>
#include <cstdlib>
#include <functional>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include "hierarchy/error.h"
#include "io/family/family_file.h"
#include "io/family/save_journal.h"
#include "io/file_size_limit.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/samples.h"

namespace interleaf {

namespace fs = std::filesystem;

namespace {

std::size_t entry_count(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

Family family_of_two(unsigned seed, int rounds) {
    std::mt19937 random(seed);
    Family family;
    family.name = "two";
    family.keys = {{"a", random_hierarchy(random, false, rounds)},
                   {"b", random_hierarchy(random, false, rounds)}};
    return family;
}

/// Runs \p action in a separate process.
/// \return the exit status of the process
pid_t start(const std::function<int()>& action) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) ::_exit(action());
    return child;
}

int exit_status(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("a family that does not fit the disk leaves the old family and nothing else") {
    const ScratchFolder folder;
    const Family old_family = family_of_two(1, 2);
    write_family(old_family, folder / "f");
    Family new_family = family_of_two(2, 5);
    std::mt19937 random(3);
    new_family.keys[1].hierarchy = random_hierarchy(random, false, 400);
    std::string error;
    {
        const FileSizeLimit limit(4000);  // enough for the first key
        error = machine_error_of([&] { write_family(new_family, folder / "f"); });
    }
    CHECK(error == (folder / "f/b-2.ilh").string() + ": cannot write: File too large");
    CHECK(is_same(read_family(folder / "f"), old_family));
    CHECK(entry_count(folder / "f") == 3);
}

TEST_CASE("a full disk is reported and keeps the old family") {
    if (::geteuid() != 0) {
        MESSAGE("only root can make a disk to fill");
        return;
    }
    const ScratchFolder folder;
    const int status = exit_status(start([&]() -> int {
        if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            ::mount("none", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
            return 77;
        const Family old_family = family_of_two(1, 2);
        write_family(old_family, folder / "f");
        const std::string error =
            machine_error_of([&] { write_family(family_of_two(2, 5000), folder / "f"); });
        if (error != (folder / "f/a-2.ilh").string() + ": cannot write: No space left on device") return 1;
        if (!is_same(read_family(folder / "f"), old_family)) return 2;
        return entry_count(folder / "f") == 3 ? 0 : 3;
    }));
    if (status == 77)
        MESSAGE("no disk to fill can be made here");
    else
        CHECK(status == 0);
}

TEST_CASE("several processes that save into one folder at the same time leave one whole family") {
    constexpr unsigned savers = 4;
    constexpr unsigned times = 25;
    const ScratchFolder folder(memory_folder());
    std::vector<Family> families;
    for (unsigned saver = 0; saver < savers; ++saver) families.push_back(family_of_two(saver, 3));
    std::vector<pid_t> children;
    for (const Family& family : families)
        children.push_back(start([&] {
            for (unsigned time = 0; time < times; ++time) write_family(family, folder / "f");
            return 0;
        }));
    for (const pid_t child : children) CHECK(exit_status(child) == 0);
    const Family family = read_family(folder / "f");
    CHECK(std::ranges::count_if(families, [&](const Family& one) { return is_same(one, family); }) == 1);
    CHECK(entry_count(folder / "f") == 3);
}

TEST_CASE("a save waits for another save to end") {
    const ScratchFolder folder;
    const Family family = family_of_two(1, 2);
    write_family(family, folder / "f");
    const pid_t holder = start([&] {
        const int descriptor = ::open((folder / "f").c_str(), O_RDONLY | O_DIRECTORY);
        if (::flock(descriptor, LOCK_EX) != 0) return 1;
        put(folder / "locked", "");
        ::usleep(100'000);
        put(folder / "released", "");
        return 0;
    });
    while (!fs::exists(folder / "locked")) ::usleep(1000);
    write_family(family, folder / "f");
    CHECK(fs::exists(folder / "released"));
    CHECK(exit_status(holder) == 0);
}

TEST_CASE("a file in the journal is removed if family.json does not name it and it is still the same file") {
    const ScratchFolder folder;
    const Family family = family_of_two(1, 2);
    write_family(family, folder.path());
    const auto mark = [&](const std::string& name) { return mark_of(name, folder.path()).value(); };
    const auto put_key = [&](std::string_view name, int rounds) {
        std::mt19937 random(7);
        write_hierarchy(random_hierarchy(random, false, rounds), folder / name);
    };
    put_key("left.ilh", 3);
    put_key("theirs.ilh", 4);
    put_key("changed.ilh", 5);
    put(folder / "notes.txt", "1234");
    begin_save(folder.path(), std::vector<KeyFileMark>{mark("left.ilh"),
                                                       mark("changed.ilh"),
                                                       mark("a.ilh"),
                                                       {"gone.ilh", 5, 5},
                                                       {"notes.txt", 4, 0x34333231},
                                                       {"../outside.ilh", 4, 0x34333231}});
    put_key("changed.ilh", 6);
    write_family(family, folder.path());
    CHECK_FALSE(fs::exists(folder / "left.ilh"));
    for (const std::string_view kept :
         {"theirs.ilh", "changed.ilh", "notes.txt", "a.ilh", "b.ilh", "family.json"}) {
        CAPTURE(kept);
        CHECK(fs::exists(folder / kept));
    }
    CHECK(folder.entry_count() == 6);
    CHECK(is_same(read_family(folder.path()), family));
}

TEST_CASE("a journal that leads out of the folder, or is malformed, does no harm") {
    const ScratchFolder folder;
    const Family family = family_of_two(1, 2);
    write_family(family, folder / "f");
    put(folder / "outside.ilh", "1234");
    fs::create_symlink("../outside.ilh", folder / "f/link.ilh");
    for (const std::string& journal :
         {std::string("34333231 4 ../outside.ilh\n34333231 4 link.ilh\n"), (folder / "outside.ilh").string(),
          std::string("34333231 4 ") + (folder / "outside.ilh").string(), std::string(2'000'000, 'x'),
          std::string("\n\n\0x \n", 6), std::string("ffffffffffffffffff -5 a.ilh")}) {
        put(folder / "f/.interleaf-save", journal);
        write_family(family, folder / "f");
        CHECK(content(folder / "outside.ilh") == "1234");
        CHECK(fs::is_symlink(folder / "f/link.ilh"));
        CHECK(is_same(read_family(folder / "f"), family));
    }
}

TEST_CASE("no key file is removed while family.json cannot be understood") {
    const ScratchFolder folder;
    const Family family = family_of_two(1, 2);
    write_family(family, folder.path());
    begin_save(folder.path(), std::vector<KeyFileMark>{mark_of("a.ilh", folder.path()).value(),
                                                       mark_of("b.ilh", folder.path()).value()});
    const std::string text = content(folder / "family.json");
    put(folder / "family.json", text.substr(0, text.size() / 2));
    finish_save(folder.path());
    put(folder / "family.json", text);
    CHECK(is_same(read_family(folder.path()), family));
}

}  // namespace interleaf
