// The subcommands that make keys of meshes: `fit`, `landmarks`, and `import` for series.
#pragma once

#include "app/cli/shared_options.h"

namespace interleaf {

void add_fit(CLI::App& program);
void add_landmarks(CLI::App& program);
void add_import(CLI::App& program);

}  // namespace interleaf
