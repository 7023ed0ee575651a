// The manual page, made from the commands and options that --help prints.
#pragma once

#include <string>
#include <string_view>

#include "app/cli/shared_options.h"

namespace interleaf {

/// The page in the man macros of roff: man(7).
std::string manual_page(const CLI::App& program, std::string_view version);

}  // namespace interleaf
