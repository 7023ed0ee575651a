#include "app/cli/command_line.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/cli/check_command.h"
#include "app/cli/error_message.h"
#include "app/cli/export_command.h"
#include "app/cli/family_command.h"
#include "app/cli/fit_command.h"
#include "app/cli/info_command.h"
#include "app/cli/make_command.h"
#include "app/cli/option_text.h"
#include "app/cli/render_command.h"
#include "app/cli/view_command.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

enum ExitStatus { done = 0, input_at_fault = 1, command_line_at_fault = 2, machine_at_fault = 3 };

constexpr const char* family_help =
    "A family.json, its folder, an .ilh or .obj file, or for several a pattern such as 'flow.*.obj' or the "
    "folder they are in; the built-in five keys if left out";

constexpr const char* viewed_help =
    "A family.json, its folder, or .ilh or .obj files, several making a new family; a pattern such as "
    "'flow.*.obj' stands for the files that match, a folder for the keys or meshes in it; or meshes to fit, "
    ".ply, .stl, .off, or .obj of different "
    "faces; the built-in five keys if left out";

/// Help without what its readers need not know: the types of names, and which options exclude which.
class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter() { column_width(34); }

    std::string make_option_opts(const CLI::Option* option) const override {
        return option->get_positional() || option->get_type_name().empty() ? ""
                                                                           : " " + option->get_type_name();
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        const std::string& text = option->get_description();
        if (option->get_required() && !option->get_positional()) return text + " (required)";
        return option->get_default_str().empty() ? text
                                                 : text + " (default " + option->get_default_str() + ")";
    }
};

/// Options whose value is a text of ours: \p take parses and keeps it, and its UsageError gets the option's
/// name.
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

void add_family(CLI::App& command, std::vector<std::filesystem::path>& family) {
    command.add_option_function<std::string>(
        "FAMILY", [&family](const std::string& path) { family = {path}; }, family_help);
}

/// The same, or several key files, which make a family.
CLI::Option* add_family_or_keys(CLI::App& command, const std::string& name, const std::string& help,
                                std::vector<std::filesystem::path>& family) {
    return command.add_option_function<std::vector<std::string>>(
        name, [&family](const std::vector<std::string>& paths) { family.assign(paths.begin(), paths.end()); },
        help);
}

void add_morph_selection(CLI::App& command, MorphSelection& morph) {
    add_family(command, morph.family);
    CLI::Option* at =
        add_text_option(command, "--at", "A point of the parameter domain, or the nearest to one outside",
                        [&morph](const std::string& text) { morph.at = parse_point(text); });
    CLI::Option* time =
        add_text_option(command, "--time", "A time on the timeline, seconds, or the nearest to one outside",
                        [&morph](const std::string& text) { morph.time = parse_number(text); });
    CLI::Option* weights =
        add_text_option(command, "--weights", "Weights of keys, used as given",
                        [&morph](const std::string& text) { morph.weights = parse_weights(text); });
    const std::string group = "Which morph (one of these; time 0, or the only key, if left out)";
    at->type_name("U,V")->group(group)->excludes(time)->excludes(weights);
    time->type_name("T")->group(group)->excludes(weights);
    weights->type_name("KEY=W,...")->group(group);
}

void add_output(CLI::App& command, Output& output, const std::string& files, const std::string& formats) {
    command
        .add_option("-o,--output", output.target,
                    fmt::format("The file to write, {}; - for standard output", files))
        ->required()
        ->type_name("FILE");
    command
        .add_option("--format", output.format,
                    fmt::format("{}; goes by the extension of FILE if left out", formats))
        ->type_name("NAME");
}

void add_form(CLI::App& command, HierarchyFileOptions& form) {
    CLI::Option* compress =
        command.add_flag("--compress", form.compressed, "Write .ilh files in the compressed form");
    add_text_option(command, "--bits",
                    "With --compress, round coordinates to N bits of the box's longest side, 8 to 24",
                    [&form](const std::string& text) { form.rounding_bits = parse_bits(text); })
        ->type_name("N")
        ->needs(compress);
}

void add_display(CLI::App& command, Display& display) {
    add_text_option(command, "--show", "Edges shown: wireframe, refinement-edges, root-edges",
                    [&display](const std::string& text) { parse_shown_edges(text, display); })
        ->type_name("NAME,...");
    add_text_option(command, "--shading", "How the surface is shaded: smooth or flat",
                    [&display](const std::string& text) { display.shading = parse_shading(text); })
        ->type_name("NAME")
        ->default_str("smooth");
    CLI::Option* color = add_text_option(
        command, "--color", fmt::format("Color: {}, or a field of the keys", colorings_in_words()),
        [&display](const std::string& text) { parse_coloring(text, display); });
    color->type_name("NAME")->default_str("plain");
    add_text_option(command, "--color-map", "Colors of a scalar field: viridis, magma or coolwarm",
                    [&display](const std::string& text) { display.scale.map = parse_color_map(text); })
        ->type_name("NAME")
        ->default_str("viridis")
        ->needs(color);
    add_text_option(command, "--range",
                    "Values with the first and the last color; those of all keys if left out",
                    [&display](const std::string& text) {
                        display.scale.range = parse_range(text);
                        display.range_locked = true;
                    })
        ->type_name("MIN,MAX")
        ->needs(color);
}

void add_view(CLI::App& program) {
    const auto options = std::make_shared<ViewOptions>();
    CLI::App* command = program.add_subcommand("view", "Open the viewer");
    add_family_or_keys(*command, "FAMILY", viewed_help, options->family);
    add_text_option(*command, "--size", "Size of the window; as it was last if left out",
                    [options](const std::string& text) {
                        const PictureSize size = parse_size(text);
                        options->viewer.size = glm::ivec2(size.width, size.height);
                    })
        ->type_name("WxH");
    CLI::Option* at =
        add_text_option(*command, "--at", "Begin at this point of the parameter domain",
                        [options](const std::string& text) { options->viewer.at = parse_point(text); });
    at->type_name("U,V");
    add_text_option(*command, "--time", "Begin at this time of the timeline, seconds",
                    [options](const std::string& text) { options->viewer.time = parse_number(text); })
        ->type_name("T")
        ->excludes(at);
    add_display(*command, options->viewer.display);
    command
        ->add_option_function<std::string>(
            "--picture", [options](const std::string& path) { options->viewer.picture = path; },
            "Write a PNG of the window, then close it")
        ->type_name("FILE");
    command
        ->add_option_function<std::string>(
            "--trace", [options](const std::string& path) { options->viewer.trace = path; },
            "A file that gets one JSON line at every change of state")
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
    add_output(*command, options->output, "OUT.png", "png");
    add_text_option(*command, "--size", "Size of the picture in pixels",
                    [options](const std::string& text) { options->size = parse_size(text); })
        ->type_name("WxH")
        ->default_str(fmt::format("{}x{}", options->size.width, options->size.height));
    add_display(*command, options->display);
    const Viewpoint& viewpoint = options->viewpoint;
    add_text_option(*command, "--camera", "Where it is seen from, in degrees; at zoom 1 all keys fit in",
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
    CLI::App* command = program.add_subcommand("export", "Write a morph as a mesh or as a key");
    add_morph_selection(*command, options->morph);
    add_output(*command, options->output, "OUT.obj, OUT.ply or OUT.ilh", "obj, ply or ilh");
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
            "A family.json, its folder, an .ilh or .obj file, or a pattern for several")
        ->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->final_callback([options] { run_info(*options); });
    command->footer("Example:\n  interleaf info star.ilh --json");
}

void add_check(CLI::App& program, CheckResult& result) {
    const auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command =
        program.add_subcommand("check", "Check every invariant of keys and constraints (B) of families");
    command->add_option("FILE", *files, "family.json files, their folders, .ilh or .obj files, patterns")
        ->required();
    command->final_callback([files, &result] {
        result = run_check(std::vector<std::filesystem::path>(files->begin(), files->end()));
    });
    command->footer(
        "Exit status 0 when all are sound; 1 otherwise, with every violation named; 3 when one cannot be "
        "read.\n\n"
        "Example:\n  interleaf check assets/families/five-keys/*.ilh");
}

void add_make(CLI::App& program) {
    const auto options = std::make_shared<MakeOptions>();
    CLI::App* command = program.add_subcommand("make", "Make a key from a formula");
    CLI::Option* name = command->add_option("SHAPE", options->name, "What to make; see --list");
    CLI::Option* output =
        command->add_option("-o,--output", options->output,
                            "The .ilh file to write, a folder for five-keys; - for standard output");
    output->type_name("FILE");
    CLI::Option* leaves =
        add_text_option(*command, "--leaves", "At most this many leaves, and as near as closure allows",
                        [options](const std::string& text) { options->budget.leaves = parse_count(text); });
    leaves->type_name("N")->default_str("20000");
    add_text_option(*command, "--tolerance",
                    "Largest distance from the surface, as a fraction of the box diagonal",
                    [options](const std::string& text) { options->budget.tolerance = parse_number(text); })
        ->type_name("E")
        ->excludes(leaves);
    add_form(*command, options->form);
    CLI::Option* list = command->add_flag("--list")->description("List the shapes");
    name->excludes(list);
    command->final_callback([options, name, output, list] {
        if (*list) return list_shapes();
        if (!*name) throw UsageError("make: SHAPE is required; --list shows them");
        if (!*output) throw UsageError("make: --output is required");
        run_make(*options);
    });
    command->footer(
        "Examples:\n"
        "  interleaf make star --leaves 5000 -o star.ilh\n"
        "  interleaf make bone --tolerance 0.001 -o bone.ilh --compress --bits 16\n"
        "  interleaf make five-keys -o assets/families/five-keys");
}

void add_family_command(CLI::App& program) {
    const auto options = std::make_shared<FamilyOptions>();
    CLI::App* command = program.add_subcommand("family", "Make a family folder from keys");
    add_family_or_keys(*command, "KEY",
                       ".ilh files, whose roots are put over those of the first, or .obj files with the same "
                       "faces; or a pattern",
                       options->keys)
        ->required();
    command
        ->add_option_function<std::string>(
            "-o,--output", [options](const std::string& folder) { options->output = folder; },
            "The folder to write")
        ->required()
        ->type_name("FOLDER");
    add_form(*command, options->form);
    command->final_callback([options] { run_family(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf family sphere.ilh star.ilh bone.ilh -o three-keys\n"
        "  interleaf family 'flow.*.obj' -o flow");
}

void add_fit(CLI::App& program) {
    const auto options = std::make_shared<FitCommandOptions>();
    CLI::App* command = program.add_subcommand("fit", "Make keys from meshes, closed and without handles");
    command
        ->add_option_function<std::vector<std::string>>(
            "MESH",
            [options](const std::vector<std::string>& files) {
                options->meshes.assign(files.begin(), files.end());
            },
            "Meshes: .obj, .ply, .stl or .off files; several make a family")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "The .ilh file to write, - for standard output; a folder for several meshes")
        ->required()
        ->type_name("FILE");
    CLI::Option* leaves =
        add_text_option(*command, "--leaves", "At most this many leaves, and as near as closure allows",
                        [options](const std::string& text) { options->leaves = parse_count(text); });
    leaves->type_name("N")->default_str("20000");
    add_text_option(*command, "--tolerance",
                    "Largest distance between key and mesh, as a fraction of the box diagonal",
                    [options](const std::string& text) { options->tolerance = parse_number(text); })
        ->type_name("E")
        ->excludes(leaves);
    command
        ->add_option("--roots", options->roots,
                     "Root triangles: cube, icosahedron, octahedron, or an .obj file around its middle")
        ->type_name("NAME")
        ->default_str("cube");
    command
        ->add_option_function<std::vector<std::string>>(
            "--rotate",
            [options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options->rotations.push_back(parse_axis_turn(text));
            },
            "Turn a mesh's parts over the roots; positions stay; once for each mesh")
        ->allow_extra_args(false)
        ->type_name("AXIS,DEGREES");
    command
        ->add_option_function<std::vector<std::string>>(
            "--up",
            [options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options->ups.push_back(parse_up(text));
            },
            "The axis of a mesh that points up: x, y or z; once for each mesh")
        ->allow_extra_args(false)
        ->type_name("AXIS");
    command->add_flag("--same-size", options->placing.same_size,
                      "Scale all meshes to the first one's size, the square root of the area");
    command->add_flag("--same-center", options->placing.same_center,
                      "Move all meshes to where the first one's area has its centroid");
    command->add_flag("--keep-largest", options->keep_largest,
                      "Of several parts keep the largest, even where over 2 % of the area is lost");
    command->add_flag("--fill-holes", options->fill_holes,
                      "Fill holes, even where that adds over 5 % to the area");
    add_text_option(*command, "--report", "Print the report as json", [options](const std::string& text) {
        if (text != "json") throw UsageError(fmt::format("expected json, got '{}'", text));
        options->json = true;
    })->type_name("json");
    add_form(*command, options->form);
    command->final_callback([options] { run_fit(*options); });
    command->footer(
        "Examples:\n"
        "  interleaf fit bunny.ply -o bunny.ilh\n"
        "  interleaf fit bunny.ply cow.obj --rotate x,90 --rotate x,0 -o bunny-and-cow");
}

/// `interleaf help [COMMAND]`: what --help says, of the program or of a command.
void add_help(CLI::App& program) {
    const auto name = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("help", "Say how a command is used");
    command->add_option("COMMAND", *name, "Which; all of them, in short, if left out");
    command->final_callback([name, &program] {
        if (name->empty()) {
            // App::help() would speak of the command in use.
            const auto text =
                program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal);
            fmt::print("{}", text);
            return;
        }
        try {
            fmt::print("{}", program.get_subcommand(*name)->help(program.get_name()));
        } catch (const CLI::OptionNotFound&) {
            throw UsageError(fmt::format("help: there is no command '{}'", *name));
        }
    });
}

/// `interleaf [FAMILY...]`: what is not a command is a family to view.
void add_bare_view(CLI::App& program) {
    const auto options = std::make_shared<ViewOptions>();
    add_family_or_keys(program, "FAMILY", viewed_help, options->family);
    program.final_callback([options, &program] {
        if (!program.get_subcommands().empty()) return;
        std::error_code error;
        if (!options->family.empty() && !options->family.front().has_extension() &&
            !std::filesystem::exists(options->family.front(), error)) {
            throw UsageError(
                fmt::format("{}: neither a command nor a file", options->family.front().string()));
        }
        run_view(*options);
    });
}

/// Parses the command line and runs the command it names.
ExitStatus run(CLI::App& program, int argument_count, const char* const* arguments) {
    CheckResult checked = CheckResult::sound;
    add_view(program);
    add_render(program);
    add_export(program);
    add_info(program);
    add_check(program, checked);
    add_make(program);
    add_family_command(program);
    add_fit(program);
    add_help(program);
    add_bare_view(program);
    program.parse(argument_count, arguments);
    if (checked == CheckResult::unread) return machine_at_fault;
    return checked == CheckResult::sound ? done : input_at_fault;
}

/// Help, the version, or what is wrong with the command line.
ExitStatus answer(const CLI::App& program, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        std::ostringstream text;
        program.exit(error, text, text);
        fmt::print("{}", text.str());
        return done;
    }
    print_error(error.what());
    return command_line_at_fault;
}

ExitStatus run_and_report(int argument_count, const char* const* arguments) {
    CLI::App program("Interpolates between triangle surfaces that have different meshes.", "interleaf");
    program.formatter(std::make_shared<HelpFormatter>());
    program.set_help_flag("-h,--help", "Print this help and exit");
    program.set_version_flag("--version", "interleaf " INTERLEAF_VERSION, "Print the version and exit");
    program.require_subcommand(0, 1);
    program.footer(
        "Exit status: 0 done, 1 the input is at fault, 2 the command line is, 3 the machine is.\n\n"
        "Examples:\n"
        "  interleaf                      open the viewer on the built-in five keys\n"
        "  interleaf star.ilh             open it on a key\n"
        "  interleaf render --help        say how to draw without a display");
    try {
        return run(program, argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return answer(program, error);
    } catch (const InputError& error) {
        print_error(error.what());
        return input_at_fault;
    } catch (const UsageError& error) {
        print_error(error.what());
        return command_line_at_fault;
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
        return machine_at_fault;
    } catch (const std::exception& error) {
        print_error(error.what());
        return machine_at_fault;
    }
}

}  // namespace

int run_command_line(int argument_count, const char* const* arguments) {
    const ExitStatus status = run_and_report(argument_count, arguments);
    if (status == machine_at_fault || std::fflush(stdout) == 0) return status;
    print_error(fmt::format("standard output: {}", std::strerror(errno)));
    return machine_at_fault;
}

}  // namespace interleaf
