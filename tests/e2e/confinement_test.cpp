// Test that a confined program can do no harm.
#include "e2e/confinement.h"

#include <filesystem>
#include <fstream>
#include <functional>

#include "e2e/person.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace interleaf;

namespace {

namespace fs = std::filesystem;

/// Whether \p act returns true in a separate process that can write only in \p folder.
bool holds_confined(const fs::path& folder, const std::function<bool()>& act) {
    const pid_t process = fork();
    if (process == 0) _exit(confine_writes(std::span(&folder, 1), {}) && act() ? 0 : 1);
    int status = -1;
    waitpid(process, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

TEST_CASE("a confined program writes, renames and removes only in its folder") {
    if (!can_confine_writes()) return;  // random_window reports this
    const ScratchFolder own;
    const ScratchFolder other;
    const fs::path file = other.path() / "file";
    std::ofstream(file) << "text";
    const auto can_write = [](const fs::path& path) { return std::ofstream(path).put('x').flush().good(); };
    std::error_code error;
    CHECK(holds_confined(own.path(), [&] {
        fs::create_directories(own.path() / "a" / "b", error);
        fs::rename(own.path() / "a" / "b", own.path() / "c", error);
        return !error && can_write(own.path() / "c" / "new") && fs::remove_all(own.path() / "c", error) == 2;
    }));
    CHECK(holds_confined(own.path(), [&] {
        return !can_write(file) && !can_write(other.path() / "new") &&
               !fs::create_directory(other.path() / "folder", error) && !fs::remove(file, error) &&
               truncate(file.c_str(), 0) != 0 && std::ifstream(file).get() == 't';
    }));
    CHECK(holds_confined(own.path(), [&] {
        fs::rename(file, own.path() / "taken", error);
        return static_cast<bool>(error);
    }));
    CHECK(fs::file_size(file) == 4);
    CHECK(can_write(file));  // this process is not confined
}
