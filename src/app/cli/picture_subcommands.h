// The subcommands that draw: `view` in a window, `render` into files.
#pragma once

#include "app/cli/shared_options.h"

namespace interleaf {

void add_view(CLI::App& program);
void add_render(CLI::App& program);

}  // namespace interleaf
