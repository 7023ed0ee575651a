#include "app/cli/subcommands.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/cli/export_command.h"
#include "app/cli/family_command.h"
#include "app/cli/fit_command.h"
#include "app/cli/info_command.h"
#include "app/cli/landmarks_command.h"
#include "app/cli/lod_command.h"
#include "app/cli/make_command.h"
#include "app/cli/option_text.h"
#include "app/cli/render_command.h"
#include "app/cli/view_command.h"
#include "hierarchy/error.h"
#include "io/formats.h"

namespace interleaf {
namespace {

void add_view(CLI::App& program) {
    const auto options = std::make_shared<ViewOptions>();
    CLI::App* command = program.add_subcommand("view", "Open the viewer");
    add_family_or_keys(*command, "FAMILY", viewed_help(), options->family);
    add_text_option(*command, "--size", "Size of the window; by default its last size",
                    [options](const std::string& text) {
                        const PictureSize size = parse_size(text);
                        options->viewer.size = glm::ivec2(size.width, size.height);
                    })
        ->type_name("WxH");
    CLI::Option* at =
        add_text_option(*command, "--at", "Begin at this point of the parameter domain",
                        [options](const std::string& text) { options->viewer.at = parse_point(text); });
    at->type_name("U,V");
    add_text_option(*command, "--time", "Begin at this time of the timeline or the path, seconds",
                    [options](const std::string& text) { options->viewer.time = parse_number(text); })
        ->type_name("T")
        ->excludes(at);
    add_along(*command, options->along)->excludes(at);
    add_display(*command, options->viewer.display);
    command
        ->add_option_function<std::string>(
            "--picture", [options](const std::string& path) { options->viewer.picture = path; },
            "Write a PNG of the window, then close it")
        ->type_name("FILE");
    command
        ->add_option_function<std::string>(
            "--trace", [options](const std::string& path) { options->viewer.trace = path; },
            "Write one JSON line per change of state to this file")
        ->type_name("FILE");
    command
        ->add_option_function<std::string>(
            "--stats", [options](const std::string& path) { options->viewer.stats = path; },
            "Write the duration of every frame to this file, a JSON line per frame")
        ->type_name("FILE");
    command->final_callback([options] { run_view(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf view assets/families/five-keys\n"
        "  interleaf view --at 0.3,0.4 --show wireframe --picture window.png");
}

void add_render(CLI::App& program) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* command = program.add_subcommand("render", "Draw a picture; needs no display");
    add_morph_selection(*command, options->morph);
    add_output(*command, options->output, {"png"});
    add_text_option(*command, "--size", "Size of the picture in pixels",
                    [options](const std::string& text) { options->size = parse_size(text); })
        ->type_name("WxH")
        ->default_str(fmt::format("{}x{}", options->size.width, options->size.height));
    add_display(*command, options->display);
    const Viewpoint& viewpoint = options->viewpoint;
    add_text_option(*command, "--camera",
                    "Direction of view in degrees; at zoom 1 all keys fit into the picture",
                    [options](const std::string& text) { options->viewpoint = parse_viewpoint(text); })
        ->type_name("AZIMUTH,ELEVATION[,ZOOM]")
        ->default_str(fmt::format("{},{},{}", viewpoint.azimuth, viewpoint.elevation, viewpoint.zoom));
    command->final_callback([options] { run_render(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf render --at 0.3,0.4 -o a.png\n"
        "  interleaf render star.ilh --show wireframe,refinement-edges --color level -o star.png\n"
        "  interleaf render --weights star=1.5,sphere=-0.5 --camera 0,90,2 --format png -o - > b.png");
}

void add_export(CLI::App& program) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = program.add_subcommand("export", "Write a blend as a mesh or as a key");
    add_morph_selection(*command, options->morph);
    add_output(*command, options->output, format_names(&Format::is_exported));
    add_form(*command, options->form);
    command->final_callback([options] { run_export(*options); });
    command->footer(
        "Each face begins with the vertex opposite its refinement edge.\n\n"
        "Examples:\n"
        "  interleaf export --at 0.3,0.4 -o u.obj\n"
        "  interleaf export --time 1.5 -o between.ilh --compress");
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

void add_family_command(CLI::App& program) {
    const auto options = std::make_shared<FamilyOptions>();
    CLI::App* command = program.add_subcommand("family", "Make a family folder from keys");
    add_family_or_keys(
        *command, "KEY",
        fmt::format("Keys: {} files, which get the roots of the first file, or {} files with the same faces; "
                    "or a pattern",
                    extensions_in_words(&Format::holds_key_alone),
                    extensions_in_words(&Format::holds_mesh_as_key)),
        options->keys)
        ->required();
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
    add_form(*command, options->form);
    command->final_callback([options] { run_family(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf family sphere.ilh star.ilh bone.ilh -o three-keys\n"
        "  interleaf family 'flow.*.obj' -o flow\n"
        "  interleaf family flow --interpolation b-spline -o smooth-flow");
}

void add_fit(CLI::App& program) {
    const auto options = std::make_shared<FitCommandOptions>();
    CLI::App* command = program.add_subcommand("fit", "Make keys from closed meshes without handles");
    command
        ->add_option_function<std::vector<std::string>>(
            "MESH",
            [options](const std::vector<std::string>& files) {
                options->meshes.assign(files.begin(), files.end());
            },
            fmt::format("Meshes: {} files; several meshes make a family",
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
        if (text != "json") throw UsageError(fmt::format("expected json, got '{}'", text));
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
    add_landmarks(program);
    add_lod(program);
}

}  // namespace interleaf
