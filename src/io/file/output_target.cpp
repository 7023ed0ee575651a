#include "io/file/output_target.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/file/safe_write.h"

namespace interleaf {

void write_output(const OutputTarget& target, std::span<const std::byte> bytes) {
    if (!target.file.empty()) {
        write_file(target.file, bytes);
    } else if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() ||
               std::fflush(stdout) != 0) {
        throw MachineError(fmt::format("standard output: {}", std::strerror(errno)));
    }
}

void write_output(const OutputTarget& target, std::string_view text) {
    write_output(target, std::as_bytes(std::span(text)));
}

}  // namespace interleaf
