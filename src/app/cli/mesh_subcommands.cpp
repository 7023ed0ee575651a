#include "app/cli/mesh_subcommands.h"

#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/cli/fit_command.h"
#include "app/cli/import_command.h"
#include "app/cli/landmarks_command.h"
#include "app/cli/option_text.h"
#include "app/document/expected_text.h"
#include "io/formats.h"

namespace interleaf {

void add_fit(CLI::App& program) {
    const auto options = std::make_shared<FitCommandOptions>();
    CLI::App* command = program.add_subcommand("fit", "Make keys from closed meshes without handles");
    command
        ->add_option_function<std::vector<std::string>>(
            "MESH",
            [options](const std::vector<std::string>& files) {
                options->meshes.assign(files.begin(), files.end());
            },
            fmt::format("Meshes: {}, or VTK files; several meshes make a family",
                        extensions_in_words(&Format::holds_mesh)))
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "The .ilh file to write, or - for standard output; for several meshes, a folder")
        ->required()
        ->type_name("FILE");
    CLI::Option* leaves =
        add_text_option(*command, "--leaves", "At most N leaves, and as close to N as closure allows",
                        [options](const std::string& text) { options->leaves = parse_count(text); });
    leaves->type_name("N")->default_str("20000");
    add_text_option(*command, "--tolerance",
                    "Largest distance between key and mesh, as a fraction of the box diagonal",
                    [options](const std::string& text) { options->tolerance = parse_number(text); })
        ->type_name("E")
        ->excludes(leaves);
    CLI::Option* roots = command->add_option(
        "--roots", options->roots,
        fmt::format("Root triangles: cube, icosahedron, octahedron, or an {} file around its center",
                    extensions_in_words(&Format::holds_mesh_as_key)));
    roots->type_name("NAME")->default_str("cube");
    command
        ->add_option_function<std::vector<std::string>>(
            "--rotate",
            [options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options->rotations.push_back(parse_axis_turn(text));
            },
            "Turn the parts of a mesh over the roots; its positions stay; once per mesh")
        ->allow_extra_args(false)
        ->type_name("AXIS,DEGREES");
    command
        ->add_option_function<std::vector<std::string>>(
            "--up",
            [options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options->ups.push_back(parse_up(text));
            },
            "The axis of a mesh that points up: x, y or z; once per mesh")
        ->allow_extra_args(false)
        ->type_name("AXIS");
    add_text_option(*command, "--match",
                    "Whether like parts of the meshes come to like places of the roots: auto or none",
                    [options](const std::string& text) {
                        if (text != "auto" && text != "none") fail_expecting("auto or none", text);
                        options->matches = text == "auto";
                    })
        ->type_name("HOW")
        ->default_str("auto");
    command->add_flag("--same-size", options->placing.same_size,
                      "Scale all meshes to the size of the first, which is the square root of its area");
    command->add_flag("--same-center", options->placing.same_center,
                      "Move the centroid of the area of all meshes to that of the first");
    command
        ->add_option_function<std::vector<std::string>>(
            "--landmarks",
            [options](const std::vector<std::string>& files) {
                options->landmarks.assign(files.begin(), files.end());
            },
            "A file of named points of a mesh, see `landmarks`; equal names correspond; once per mesh")
        ->allow_extra_args(false)
        ->type_name("FILE");
    command
        ->add_option(
            "--onto", options->onto,
            "A family made with landmarks: new keys get its roots, and its landmarks in their places")
        ->type_name("FAMILY")
        ->excludes(roots);
    add_text_option(
        *command, "--place",
        "How landmarks place a mesh in space: similarity, rigid or keep; by default similarity, for "
        "three landmarks or more",
        [options](const std::string& text) { options->landmark_placing = parse_placing(text); })
        ->type_name("HOW");
    command->add_flag("--keep-largest", options->keep_largest,
                      "Keep only the largest of several parts, even if over 2 % of the area is lost");
    command->add_flag("--fill-holes", options->fill_holes,
                      "Fill holes, even if that adds over 5 % to the area");
    add_text_option(*command, "--report", "Print the report as JSON", [options](const std::string& text) {
        if (text != "json") fail_expecting("json", text);
        options->json = true;
    })->type_name("json");
    add_form(*command, options->form);
    command->final_callback([options] { run_fit(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf fit bunny.ply -o bunny.ilh\n"
        "  interleaf fit bunny.ply cow.obj --rotate x,90 --rotate x,0 -o bunny-and-cow\n"
        "  interleaf fit cow.obj camel.off --landmarks cow.json --landmarks camel.json -o cow-and-camel");
}

void add_landmarks(CLI::App& program) {
    const auto options = std::make_shared<LandmarksOptions>();
    CLI::App* command = program.add_subcommand("landmarks", "Propose landmarks of a mesh: its extremities");
    command
        ->add_option_function<std::string>(
            "MESH", [options](const std::string& file) { options->mesh = file; },
            fmt::format("A mesh: an {} file", extensions_in_words(&Format::holds_mesh)))
        ->required();
    command->add_option("-o,--output", options->output, "The .json file to write, or - for standard output")
        ->required()
        ->type_name("FILE");
    add_text_option(*command, "--max", "At most N landmarks",
                    [options](const std::string& text) { options->max_count = parse_count(text); })
        ->type_name("N")
        ->default_str("16");
    command->final_callback([options] { run_landmarks(*options); });
    command->footer(
        "Give the points that correspond on several meshes the same names, then fit them with "
        "--landmarks.\n\n"
        "Example:\n"
        "  interleaf landmarks cow.obj -o cow.json");
}

void add_import(CLI::App& program) {
    const auto options = std::make_shared<ImportOptions>();
    CLI::App* command = program.add_subcommand("import", "Make a family of a series of meshes from numerics");
    command
        ->add_option_function<std::vector<std::string>>(
            "SERIES",
            [options](const std::vector<std::string>& files) {
                options->series.assign(files.begin(), files.end());
            },
            "A .pvd or .series file; or .vtu, .pvtu, .vtp, .vtk or mesh files in the order of time, or a "
            "pattern")
        ->required();
    command->add_option("-o,--output", options->output, "The folder to write")
        ->required()
        ->type_name("FOLDER");
    add_text_option(
        *command, "--tolerance",
        "Sample the fields, instead of keeping the triangles of each step: the largest difference, "
        "as a part of a field's range",
        [options](const std::string& text) { options->choices.tolerance = parse_number(text); })
        ->type_name("E");
    add_text_option(*command, "--newest",
                    "The corner of a triangle that is the newest vertex; by default tried out",
                    [options](const std::string& text) { options->choices.newest = parse_corner(text); })
        ->type_name("first|second|last");
    command->add_option("--field", options->choices.fields, "A field that the keys get; by default all")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command
        ->add_option("--displacement", options->choices.displacement,
                     "A field that is added to the points, which themselves stay in place")
        ->type_name("NAME");
    add_text_option(
        *command, "--warp",
        "Move the points of flat steps across their plane, by FACTOR (1 by default) times a field",
        [options](const std::string& text) { options->choices.warp = parse_warp(text); })
        ->type_name("FIELD[,FACTOR]");
    command
        ->add_option_function<std::string>(
            "--roots", [options](const std::string& file) { options->choices.roots = file; },
            "An .ilh file whose roots are the roots of the keys")
        ->type_name("FILE");
    add_units(*command, options->choices.units,
              [options](const std::string& unit) { options->choices.time_unit = unit; });
    add_text_option(*command, "--every", "Take only every N-th step",
                    [options](const std::string& text) { options->every = parse_count(text); })
        ->type_name("N")
        ->default_str("1");
    command->add_flag("--json", options->json, "Print the report as JSON");
    add_form(*command, options->form);
    command->final_callback([options] { run_import(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf import run.pvd -o run\n"
        "  interleaf import 'step-*.vtk' --field u --tolerance 0.01 -o run --compress");
}

}  // namespace interleaf
