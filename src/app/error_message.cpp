#include "app/error_message.h"

#include <cstdio>

#include <fmt/format.h>

namespace interleaf {

void print_error(std::string_view text) {
    fmt::print(stderr, "interleaf: {}\n", text);
}

}  // namespace interleaf
