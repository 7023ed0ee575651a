#include "io/file/file_descriptor.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "hierarchy/error.h"

namespace interleaf {

FileDescriptor::FileDescriptor(const std::filesystem::path& file, int flags, unsigned mode)
    : number_(::open(file.c_str(), flags | O_CLOEXEC, mode)) {}

bool FileDescriptor::close() {
    return number_ < 0 || ::close(std::exchange(number_, -1)) == 0;
}

void throw_system_error(const std::filesystem::path& file, std::string_view action) {
    const std::error_code error(errno, std::generic_category());
    throw MachineError(fmt::format("{}: {}: {}", file.string(), action, error.message()));
}

}  // namespace interleaf
