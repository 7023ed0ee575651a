#include "io/file/input_file.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hierarchy/error.h"

namespace interleaf {

// O_NONBLOCK keeps open() from waiting for the writer of a named pipe.
InputFile::InputFile(std::filesystem::path file)
    : path_(std::move(file)), descriptor_(path_, O_RDONLY | O_NONBLOCK) {
    if (!descriptor_.is_open()) throw_system_error(path_, "cannot open");
    struct stat status {};
    if (::fstat(descriptor_.number(), &status) != 0) throw_system_error(path_, "cannot read");
    if (!S_ISREG(status.st_mode))
        throw InputError(fmt::format("{}: is {}, expected a file", path_.string(),
                                     S_ISDIR(status.st_mode) ? "a folder" : "a device, pipe or socket"));
    size_ = static_cast<std::uint64_t>(status.st_size);
}

void InputFile::read(std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::read(descriptor_.number(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw_system_error(path_, "cannot read");
        if (count == 0) throw InputError(fmt::format("{}: became shorter while it was read", path_.string()));
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

std::string read_text(const std::filesystem::path& file, std::uint64_t size_limit) {
    InputFile input(file);
    if (input.size() > size_limit)
        throw InputError(
            fmt::format("{}: size: {} bytes, expected at most {}", file.string(), input.size(), size_limit));
    std::string text(input.size(), '\0');
    input.read(std::as_writable_bytes(std::span(text)));
    return text;
}

}  // namespace interleaf
