#include "app/cli/shared_options.h"

#include <utility>

#include <fmt/core.h>

#include "app/cli/option_text.h"
#include "hierarchy/error.h"
#include "io/formats.h"
#include "io/text/joined_text.h"

namespace interleaf {
namespace {

std::string family_help() {
    return fmt::format(
        "A family.json, its folder, or {} files, of which several make a new family; a pattern such as "
        "'flow.*.obj' stands for the files that match it; by default, the built-in five keys",
        extensions_in_words(&Format::holds_key));
}

void add_family(CLI::App& command, std::vector<std::filesystem::path>& family) {
    add_family_or_keys(command, "FAMILY", family_help(), family);
}

}  // namespace

std::string viewed_help() {
    return fmt::format(
        "A family.json, its folder, or {} files, of which several make a new family; or meshes to fit: "
        "{} files, or {} files with different faces; or the steps of a series: {} files. A pattern such as "
        "'flow.*.obj' stands for the files "
        "that match it, a folder for the keys or meshes in it. By default, the built-in five keys.",
        extensions_in_words(&Format::holds_key), joined(extensions_of(&Format::holds_mesh_alone), ", "),
        extensions_in_words(&Format::holds_mesh_as_key), joined(extensions_of(&Format::holds_series), ", "));
}

CLI::Option* add_text_option(CLI::App& command, const std::string& name, const std::string& description,
                             std::function<void(const std::string&)> take) {
    const auto named_take = [name, take = std::move(take)](const std::string& text) {
        try {
            take(text);
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("{}: {}", name, error.what()));
        }
    };
    return command.add_option_function<std::string>(name, named_take, description);
}

CLI::Option* add_family_or_keys(CLI::App& command, const std::string& name, const std::string& help,
                                std::vector<std::filesystem::path>& family) {
    return command.add_option_function<std::vector<std::string>>(
        name, [&family](const std::vector<std::string>& paths) { family.assign(paths.begin(), paths.end()); },
        help);
}

void add_morph_selection(CLI::App& command, MorphSelection& morph) {
    add_family(command, morph.family);
    CLI::Option* at = add_text_option(
        command, "--at", "A point of the parameter domain; a point outside moves to the nearest inside",
        [&morph](const std::string& text) { morph.at = parse_point(text); });
    CLI::Option* time =
        add_text_option(command, "--time",
                        "A time on the timeline or the path, in the unit of its times; a time outside moves "
                        "to the nearest end",
                        [&morph](const std::string& text) { morph.time = parse_number(text); });
    CLI::Option* weights =
        add_text_option(command, "--weights", "Weights of keys, used as given",
                        [&morph](const std::string& text) { morph.weights = parse_weights(text); });
    CLI::Option* along = add_along(command, morph.along);
    const std::string group = "Which blend (one of these; by default time 0, or the only key)";
    at->type_name("U,V")->group(group)->excludes(time)->excludes(weights);
    time->type_name("T")->group(group)->excludes(weights);
    along->group(group)->excludes(at)->excludes(weights);
    weights->type_name("KEY=W,...")->group(group);
}

CLI::Option* add_along(CLI::App& command, std::optional<TimeSource>& along) {
    return add_text_option(command, "--along",
                           "What the time belongs to: the keys of the timeline, or the path through the "
                           "parameter domain; by default what the family says",
                           [&along](const std::string& text) { along = parse_time_source(text); })
        ->type_name("keys|path");
}

void add_output(CLI::App& command, Output& output, const std::vector<std::string>& formats) {
    std::vector<std::string> files;
    files.reserve(formats.size());
    for (const std::string& format : formats) files.push_back("OUT." + format);
    command
        .add_option("-o,--output", output.target,
                    fmt::format("The file to write, {}; - for standard output", either_of(files)))
        ->required()
        ->type_name("FILE");
    command
        .add_option("--format", output.format,
                    fmt::format("{}; by default, the extension of FILE", either_of(formats)))
        ->type_name("NAME");
}

void add_form(CLI::App& command, HierarchyFileOptions& form) {
    CLI::Option* compress =
        command.add_flag("--compress", form.compressed, "Write .ilh files in the compressed form");
    add_text_option(command, "--bits",
                    "With --compress, round coordinates to N bits (8 to 24) of the longest side of the box",
                    [&form](const std::string& text) { form.rounding_bits = parse_bits(text); })
        ->type_name("N")
        ->needs(compress);
}

void add_units(CLI::App& command, std::vector<NamedUnit>& units,
               std::function<void(const std::string&)> take_time_unit) {
    command
        .add_option_function<std::vector<std::string>>(
            "--unit",
            [&units](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) units.push_back(parse_unit(text));
            },
            "The unit of a field, shown with its values; once per field")
        ->type_name("FIELD=TEXT")
        ->allow_extra_args(false);
    add_text_option(command, "--time-unit", "The unit of the timeline's times, such as ms",
                    std::move(take_time_unit))
        ->type_name("TEXT");
}

void add_display(CLI::App& command, Display& display) {
    add_text_option(command, "--show", "Edges to show: " + shown_edges_in_words(),
                    [&display](const std::string& text) { parse_shown_edges(text, display); })
        ->type_name("NAME,...");
    add_text_option(command, "--line-width", "Width of edges, pixels",
                    [&display](const std::string& text) { display.line_width = parse_line_width(text); })
        ->type_name("W")
        ->default_str(fmt::format("{}", display.line_width));
    add_text_option(
        command, "--shading",
        fmt::format("Shading: smooth or flat; by default, flat for keys of at most {} leaves", few_leaves),
        [&display](const std::string& text) { display.shading = parse_shading(text); })
        ->type_name("NAME");
    command.add_flag_callback(
        "--no-occlusion", [&display] { display.occlusion = false; }, "Do not darken hollows");
    command.add_flag_callback(
        "--ground", [&display] { display.ground = true; }, "Show a ground with the surface's soft shadow");
    add_text_option(command, "--material", "Material of a plain surface: " + materials_in_words(),
                    [&display](const std::string& text) { display.material = parse_material(text); })
        ->type_name("NAME")
        ->default_str("clay");
    CLI::Option* color = add_text_option(
        command, "--color", fmt::format("Color: {}, or a field of the keys", colorings_in_words()),
        [&display](const std::string& text) { parse_coloring(text, display); });
    color->type_name("NAME")->default_str("plain");
    add_text_option(command, "--color-map", "Colors of a scalar field: " + color_maps_in_words(),
                    [&display](const std::string& text) { display.scale.map = parse_color_map(text); })
        ->type_name("NAME")
        ->default_str("viridis")
        ->needs(color);
    add_text_option(command, "--range",
                    "Values of the first and the last color; by default, the range of all keys",
                    [&display](const std::string& text) {
                        display.wanted_range = parse_range(text);
                        display.range_locked = true;
                    })
        ->type_name("MIN,MAX")
        ->needs(color);
    command
        .add_flag("--log-scale", display.scale.is_logarithmic,
                  "Color equal factors of a scalar by equal steps, if its range is above 0")
        ->needs(color);
    add_text_option(command, "--height",
                    "Raise flat keys by a scalar; its range becomes PART of their size, 0.25 by default",
                    [&display](const std::string& text) { parse_height(text, display); })
        ->type_name("FIELD[,PART]");
    add_text_option(
        command, "--arrows",
        "Draw arrows of a vector, whose components are these scalars; a comma in a name is written \\,",
        [&display](const std::string& text) { parse_arrows(text, display); })
        ->type_name("X,Y[,Z]");
}

void add_theme(CLI::App& command, const std::string& meaning, std::function<void(Theme)> choose) {
    add_text_option(command, "--theme", meaning, [choose = std::move(choose)](const std::string& text) {
        choose(parse_theme(text));
    })->type_name("NAME");
}

}  // namespace interleaf
