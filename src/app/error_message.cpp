#include "app/error_message.h"

#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace interleaf {

void print_error(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f)
            line += fmt::format("\\x{:02x}", code);
        else
            line += c;
    }
    fmt::print(stderr, "interleaf: {}\n", line);
}

}  // namespace interleaf
