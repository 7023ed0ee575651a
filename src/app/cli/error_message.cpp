#include "app/cli/error_message.h"

#include <cstdio>

#include <fmt/core.h>

#include "text/shown_text.h"

namespace interleaf {

void print_error(std::string_view text) {
    fmt::print(stderr, "interleaf: {}\n", shown_text(text));
}

}  // namespace interleaf
