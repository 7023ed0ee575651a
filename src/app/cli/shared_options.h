// Options that several subcommands share. Beside its source, this is the only file that includes CLI11.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/morph_selection.h"
#include "app/cli/output.h"
#include "io/hierarchy/hierarchy_file.h"
#include "render/display.h"

namespace interleaf {

/// An option whose value \p take parses and keeps. A UsageError of \p take gets the option's name.
CLI::Option* add_text_option(CLI::App& command, const std::string& name, const std::string& description,
                             std::function<void(const std::string&)> take);

/// The help of files that the viewer opens.
std::string viewed_help();

/// Several files of a family, keys or meshes.
CLI::Option* add_family_or_keys(CLI::App& command, const std::string& name, const std::string& help,
                                std::vector<std::filesystem::path>& family);

/// FAMILY, --at, --time and --weights.
void add_morph_selection(CLI::App& command, MorphSelection& morph);

/// --output and --format, one of the names in \p formats.
void add_output(CLI::App& command, Output& output, const std::vector<std::string>& formats);

/// --compress and --bits.
void add_form(CLI::App& command, HierarchyFileOptions& form);

/// --show, --shading, --color, --color-map and --range.
void add_display(CLI::App& command, Display& display);

}  // namespace interleaf
