#include "io/file/folder_lock.h"

#include <cerrno>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>

#include "hierarchy/error.h"

namespace interleaf {

FolderLock::FolderLock(const std::filesystem::path& folder) : descriptor_(folder, O_RDONLY | O_DIRECTORY) {
    using namespace std::chrono_literals;
    constexpr auto longest = 10s;
    constexpr auto pause = 20ms;
    if (!descriptor_.is_open()) throw_system_error(folder, "cannot write");
    const auto end = std::chrono::steady_clock::now() + longest;
    while (::flock(descriptor_.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        if (std::chrono::steady_clock::now() > end)
            throw MachineError(
                fmt::format("{}: cannot write: another program is saving into it", folder.string()));
        std::this_thread::sleep_for(pause);
    }
}

}  // namespace interleaf
