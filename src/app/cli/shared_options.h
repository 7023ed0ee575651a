// Options that several subcommands share. Only this header and its source include CLI11.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/morph_selection.h"
#include "app/cli/output.h"
#include "family/field_units.h"
#include "io/hierarchy/hierarchy_file.h"
#include "render/display.h"
#include "ui/widgets/appearance.h"

namespace interleaf {

/// Adds an option whose value \p take parses and stores. If \p take throws UsageError, its message gets the
/// option's name.
CLI::Option* add_text_option(CLI::App& command, const std::string& name, const std::string& description,
                             std::function<void(const std::string&)> take);

/// The help text about the files that the viewer opens.
std::string viewed_help();

/// Adds an argument that takes several files: a family, keys or meshes.
CLI::Option* add_family_or_keys(CLI::App& command, const std::string& name, const std::string& help,
                                std::vector<std::filesystem::path>& family);

/// Adds FAMILY, --at, --time, --along and --weights.
void add_morph_selection(CLI::App& command, MorphSelection& morph);

/// Adds --along.
CLI::Option* add_along(CLI::App& command, std::optional<TimeSource>& along);

/// Adds --output and --format, whose value is one of \p formats.
void add_output(CLI::App& command, Output& output, const std::vector<std::string>& formats);

/// Adds --compress and --bits.
void add_form(CLI::App& command, HierarchyFileOptions& form);

/// Adds --unit and --time-unit.
void add_units(CLI::App& command, std::vector<NamedUnit>& units,
               std::function<void(const std::string&)> take_time_unit);

/// Adds --show, --shading, --no-occlusion, --ground, --material, --color, --color-map, --range, --height and --arrows.
void add_display(CLI::App& command, Display& display);

/// Adds --theme, whose value goes to \p choose.
void add_theme(CLI::App& command, const std::string& meaning, std::function<void(Theme)> choose);

}  // namespace interleaf
