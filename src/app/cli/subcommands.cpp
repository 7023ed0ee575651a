#include "app/cli/subcommands.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/cli/export_command.h"
#include "app/cli/family_command.h"
#include "app/cli/info_command.h"
#include "app/cli/lod_command.h"
#include "app/cli/make_command.h"
#include "app/cli/mesh_subcommands.h"
#include "app/cli/option_text.h"
#include "app/cli/picture_subcommands.h"
#include "app/document/expected_text.h"
#include "hierarchy/error.h"
#include "io/formats.h"

namespace interleaf {
namespace {

void add_export(CLI::App& program) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command =
        program.add_subcommand("export", "Write a blend as a mesh or as a key, or the whole family");
    add_morph_selection(*command, options->morph);
    add_output(*command, options->output, format_names(&Format::is_exported));
    add_form(*command, options->form);
    add_text_option(
        *command, "--fps", "Of pvd: files per second of the time; by default one file per key",
        [options](const std::string& text) { options->series.frames_per_second = parse_number(text); })
        ->type_name("N");
    add_text_option(*command, "--every", "Of pvd: a file at every DT units of the time",
                    [options](const std::string& text) { options->series.time_step = parse_number(text); })
        ->type_name("DT");
    command
        ->add_option_function<std::string>(
            "--times", [options](const std::string& file) { options->times = file; },
            "Of pvd: a file at each of the times in FILE, a text of numbers that increase")
        ->type_name("FILE");
    add_text_option(*command, "--union",
                    "Of pvd: the union of all keys in all files, or that of the two keys of each interval",
                    [options](const std::string& text) {
                        if (text != "all" && text != "interval") fail_expecting("all or interval", text);
                        options->series.mesh = text == "all" ? SeriesUnion::all : SeriesUnion::interval;
                    })
        ->type_name("all|interval");
    command->add_flag("--segments", options->segments,
                      "Of glb: one mesh per interval of the timeline, for long timelines");
    command->final_callback([options] { run_export(*options); });
    command->footer(
        "Each face begins with the vertex opposite its refinement edge.\n\n"
        "Examples:\n"
        "  interleaf export --at 0.3,0.4 -o u.obj\n"
        "  interleaf export --time 1.5 -o between.ilh --compress\n"
        "  interleaf export family.json -o family.glb\n"
        "  interleaf export flow -o flow.pvd");
}

void add_info(CLI::App& program) {
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand("info", "Print the figures of a key, a family or a mesh");
    command
        ->add_option_function<std::string>(
            "FILE", [options](const std::string& path) { options->file = path; },
            fmt::format("A family.json, its folder, an {} file, or a pattern for several files",
                        extensions_in_words(&Format::holds_key_or_mesh)))
        ->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->final_callback([options] { run_info(*options); });
    command->footer("Example:\n  interleaf info star.ilh --json");
}

void add_check(CLI::App& program, CheckResult& result) {
    const auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command =
        program.add_subcommand("check", "Check every invariant of keys, and constraints (B) of families");
    command
        ->add_option("FILE", *files,
                     fmt::format("family.json files, their folders, {} files, or patterns",
                                 extensions_in_words(&Format::holds_key_or_mesh)))
        ->required();
    command->final_callback([files, &result] {
        result = run_check(std::vector<std::filesystem::path>(files->begin(), files->end()));
    });
    command->footer(
        "Exit status: 0 if all files are sound, 3 if a file cannot be read, otherwise 1. Prints every "
        "violation.\n\n"
        "Example:\n  interleaf check assets/families/five-keys/*.ilh");
}

void add_make(CLI::App& program) {
    const auto options = std::make_shared<MakeOptions>();
    CLI::App* command = program.add_subcommand("make", "Make a key from a formula, or a sequence");
    CLI::Option* name = command->add_option("SHAPE", options->name, "What to make; see --list");
    CLI::Option* output =
        command->add_option("-o,--output", options->output,
                            "The .ilh file to write, or - for standard output; for families, a folder");
    output->type_name("FILE");
    CLI::Option* leaves =
        add_text_option(*command, "--leaves", "At most N leaves, and as close to N as closure allows",
                        [options](const std::string& text) { options->budget.leaves = parse_count(text); });
    leaves->type_name("N")->default_str("20000");
    add_text_option(*command, "--tolerance",
                    "Largest distance from the surface, as a fraction of the box diagonal; of a sequence, of "
                    "its first key's, by default 0.0005",
                    [options](const std::string& text) { options->budget.tolerance = parse_number(text); })
        ->type_name("E")
        ->excludes(leaves);
    add_text_option(*command, "--steps", "Of flow and catenoid: the number of time steps, keys less one",
                    [options](const std::string& text) { options->steps = parse_count(text); })
        ->type_name("N")
        ->default_str("30");
    add_text_option(*command, "--distance",
                    "Of catenoid: between the rings, in radii; over 1.3255 the film collapses",
                    [options](const std::string& text) { options->distance = parse_number(text); })
        ->type_name("D")
        ->default_str("1");
    add_form(*command, options->form);
    CLI::Option* list = command->add_flag("--list")->description("List the shapes and sequences");
    name->excludes(list);
    command->final_callback([options, name, output, list] {
        if (*list) return list_shapes();
        if (!*name) throw UsageError("make: SHAPE is required; --list lists the shapes");
        if (!*output) throw UsageError("make: --output is required");
        run_make(*options);
    });
    command->footer(
        "Examples:\n"
        "  interleaf make star --leaves 5000 -o star.ilh\n"
        "  interleaf make bone --tolerance 0.001 -o bone.ilh --compress --bits 16\n"
        "  interleaf make five-keys -o assets/families/five-keys\n"
        "  interleaf make flow --steps 40 -o flow --compress\n"
        "  interleaf make catenoid --distance 1.45 -o collapse");
}

void add_adapt(CLI::App& command, AdaptOptions& adapt) {
    const std::string group = "Instead of keys: a domain that is refined where the shape needs it";
    command.add_option("--adapt", adapt.shape, "A shape with constants; make --list names them")
        ->type_name("SHAPE")
        ->group(group);
    command
        .add_option_function<std::vector<std::string>>(
            "--range",
            [&adapt](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) adapt.ranges.push_back(parse_constant_range(text));
            },
            "The range of a constant, an axis of the domain; two of these")
        ->type_name("NAME=A:B")
        ->allow_extra_args(false)
        ->group(group);
    add_text_option(command, "--tolerance",
                    "Largest distance of a blend from the shape, as a fraction of the family's box diagonal",
                    [&adapt](const std::string& text) { adapt.tolerance = parse_number(text); })
        ->type_name("E")
        ->group(group);
}

void add_family_command(CLI::App& program) {
    const auto options = std::make_shared<FamilyOptions>();
    CLI::App* command = program.add_subcommand("family", "Make a family folder from keys");
    add_family_or_keys(
        *command, "KEY",
        fmt::format("Keys: {} files, which get the roots of the first file, or {} files with the same faces; "
                    "or a pattern",
                    extensions_in_words(&Format::holds_key_alone),
                    extensions_in_words(&Format::holds_mesh_as_key)),
        options->keys);
    command
        ->add_option_function<std::string>(
            "-o,--output", [options](const std::string& folder) { options->output = folder; },
            "The folder to write")
        ->required()
        ->type_name("FOLDER");
    add_text_option(*command, "--interpolation", "How the timeline blends its keys: " + bases_in_words(),
                    [options](const std::string& text) { options->basis = parse_basis(text); })
        ->type_name("BASIS");
    add_text_option(*command, "--degree",
                    "Of bernstein: the degree of its pieces; without it, one piece for all keys",
                    [options](const std::string& text) { options->degree = parse_count(text); })
        ->type_name("N");
    add_text_option(*command, "--blend",
                    "How surfaces go from key to key: straight, or turning, which turns parts instead of "
                    "shrinking them",
                    [options](const std::string& text) { options->blend = parse_blend_kind(text); })
        ->type_name("KIND");
    add_adapt(*command, options->adapt);
    add_units(*command, options->units, [options](const std::string& unit) { options->time_unit = unit; });
    add_form(*command, options->form);
    command->final_callback([options] { run_family(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf family sphere.ilh star.ilh bone.ilh -o three-keys\n"
        "  interleaf family 'flow.*.obj' -o flow\n"
        "  interleaf family flow --interpolation b-spline -o smooth-flow\n"
        "  interleaf family arm-down.ilh arm-up.ilh --blend turning -o wave\n"
        "  interleaf family --adapt star --range arm=0.2:1.5 --range sharpness=12:40 --tolerance 0.01 -o "
        "stars");
}

void add_lod(CLI::App& program) {
    const auto options = std::make_shared<LodOptions>();
    CLI::App* command = program.add_subcommand("lod", "Cut keys to a level of detail");
    command
        ->add_option_function<std::string>(
            "FAMILY", [options](const std::string& path) { options->input = path; },
            fmt::format(
                "A family.json, its folder, an {} file, or for several files a pattern or their folder",
                extensions_in_words(&Format::holds_key)))
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "The .ilh file to write, - for standard output; a folder for a family")
        ->required()
        ->type_name("FILE");
    CLI::Option* leaves = add_text_option(
        *command, "--leaves", "At most this many leaves per key, as near as one threshold allows",
        [options](const std::string& text) { options->leaves = parse_count(text); });
    leaves->type_name("N");
    add_text_option(*command, "--tolerance",
                    "Largest distance from each key, as a fraction of its box diagonal",
                    [options](const std::string& text) { options->tolerance = parse_number(text); })
        ->type_name("E")
        ->excludes(leaves);
    add_form(*command, options->form);
    command->final_callback([options] { run_lod(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf lod star.ilh --tolerance 0.001 -o star-coarse.ilh\n"
        "  interleaf lod assets/families/five-keys --leaves 2000 -o five-coarse-keys");
}

}  // namespace

void add_subcommands(CLI::App& program, CheckResult& checked) {
    add_view(program);
    add_render(program);
    add_export(program);
    add_info(program);
    add_check(program, checked);
    add_make(program);
    add_family_command(program);
    add_fit(program);
    add_import(program);
    add_landmarks(program);
    add_lod(program);
}

}  // namespace interleaf
