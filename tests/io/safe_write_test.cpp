#include "io/safe_write.h"

#include <csignal>

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/scratch_folder.h"

namespace interleaf {

namespace fs = std::filesystem;

namespace {

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// While it lives, no file can be written beyond \p size bytes: what a full disk looks like.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t size) {
        ::getrlimit(RLIMIT_FSIZE, &old_limit_);
        old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{size, old_limit_.rlim_max};
        REQUIRE(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_limit_);
        std::signal(SIGXFSZ, old_handler_);
    }

  private:
    rlimit old_limit_{};
    void (*old_handler_)(int) = nullptr;
};

}  // namespace

TEST_CASE("a file is written whole and nothing else stays beside it") {
    const ScratchFolder folder;
    for (const std::string& text : {std::string("first"), std::string(), std::string(3'000'000, 'x')}) {
        write_file(folder / "a.txt", text);
        CHECK(content(folder / "a.txt") == text);
        CHECK(folder.entry_count() == 1);
    }
}

TEST_CASE("a write that fails half way leaves the old file and no other") {
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

TEST_CASE("a folder that is missing or a file says so") {
    const ScratchFolder folder;
    put(folder / "file", "old");
    CHECK(contains(machine_error_of([&] { write_file(folder / "missing/a.txt", "new"); }),
                   "missing/a.txt: cannot write: No such file or directory"));
    CHECK(contains(machine_error_of([&] { write_file(folder / "file/a.txt", "new"); }), "Not a directory"));
    CHECK(contains(machine_error_of([&] { write_file(folder.path(), "new"); }), "Is a directory"));
    CHECK(content(folder / "file") == "old");
    CHECK(folder.entry_count() == 1);
}

TEST_CASE("permissions of an existing file are kept, those of a new one follow the umask") {
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

TEST_CASE("a link is followed and stays a link") {
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

TEST_CASE("the longest file name there is can be written") {
    const ScratchFolder folder;
    const std::string name(255, 'n');
    write_file(folder / name, "new");
    CHECK(content(folder / name) == "new");
}

TEST_CASE("a temporary file left by another is passed over") {
    const ScratchFolder folder;
    const std::string stale = ".interleaf-" + std::to_string(::getpid()) + "-0";
    put(folder / stale, "theirs");
    write_file(folder / "a.txt", "new");
    CHECK(content(folder / "a.txt") == "new");
    CHECK(content(folder / stale) == "theirs");
}

}  // namespace interleaf
