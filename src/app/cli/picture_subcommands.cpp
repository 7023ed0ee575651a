#include "app/cli/picture_subcommands.h"

#include <functional>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "app/cli/option_text.h"
#include "app/cli/render_command.h"
#include "app/cli/view_command.h"
#include "app/document/viewpoint.h"

namespace interleaf {
namespace {

/// \param take  receives the view
void add_camera(CLI::App& command, const std::function<void(const Viewpoint&)>& take) {
    add_text_option(
        command, "--camera",
        "Direction of view in degrees; at zoom 1 all keys fit into the picture. In the window, Copy view "
        "copies the present one",
        [take](const std::string& text) { take(parse_viewpoint(text)); })
        ->type_name(viewpoint_form)
        ->default_str(text_of(Viewpoint{}));
}

void add_film(CLI::App& command, FilmOptions& film) {
    const std::string group = "Films (for .mp4, .webm, .gif and numbered pictures)";
    add_text_option(command, "--fps", "Frames per second",
                    [&film](const std::string& text) { film.rate = parse_number(text); })
        ->type_name("N")
        ->default_str("30")
        ->group(group);
    add_text_option(command, "--from", "Begin at this time; by default, where the timeline begins",
                    [&film](const std::string& text) { film.from = parse_number(text); })
        ->type_name("T")
        ->group(group);
    add_text_option(command, "--to", "End at this time; by default, where the timeline ends",
                    [&film](const std::string& text) { film.to = parse_number(text); })
        ->type_name("T")
        ->group(group);
    add_text_option(command, "--frames",
                    "Draw only the frames A to B of the film; the first frame has the number 0",
                    [&film](const std::string& text) { film.frames = parse_frames(text); })
        ->type_name("A:B")
        ->group(group);
    add_text_option(command, "--turn",
                    "Turn the camera about the vertical axis, evenly during the whole film",
                    [&film](const std::string& text) { film.turn = parse_number(text); })
        ->type_name("DEGREES")
        ->group(group);
    command
        .add_flag("--loop", film.is_loop,
                  "The film will be repeated: leave out a last frame that equals the first")
        ->group(group);
}

}  // namespace

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
    add_text_option(*command, "--time", "Begin at this time of the timeline or the path",
                    [options](const std::string& text) { options->viewer.time = parse_number(text); })
        ->type_name("T")
        ->excludes(at);
    add_along(*command, options->viewer.along)->excludes(at);
    add_display(*command, options->viewer.display);
    add_theme(*command, "Colors of the window: dark or light; by default, as it was last",
              [options](Theme theme) { options->viewer.theme = theme; });
    add_camera(*command, [options](const Viewpoint& viewpoint) { options->viewer.viewpoint = viewpoint; });
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
    CLI::App* command = program.add_subcommand("render", "Draw a picture or a film; needs no display");
    add_morph_selection(*command, options->morph);
    add_output(*command, options->output, render_formats());
    add_text_option(*command, "--size", "Size of the picture in pixels",
                    [options](const std::string& text) { options->size = parse_size(text); })
        ->type_name("WxH")
        ->default_str(fmt::format("{}x{}", options->size.width, options->size.height));
    add_display(*command, options->display);
    command->add_flag("--legend", options->display.legend, "Draw at the right side what the colors mean");
    command->add_flag("--transparent", options->display.transparent, "Draw no background; only for .png");
    add_theme(*command, "Background of the picture: dark or light",
              [options](Theme theme) { options->display.light_background = theme == Theme::light; });
    add_camera(*command, [options](const Viewpoint& viewpoint) { options->viewpoint = viewpoint; });
    add_film(*command, options->film);
    command->final_callback([options] { run_render(*options); });
    command->footer(
        "Films need the program ffmpeg. Numbered pictures, frame.####.png, need no other program.\n\n"
        "Examples:\n"
        "  interleaf render --at 0.3,0.4 -o a.png\n"
        "  interleaf render star.ilh --show wireframe,refinement-edges --color level -o star.png\n"
        "  interleaf render --weights star=1.5,sphere=-0.5 --camera 0,90,2 --format png -o - > b.png\n"
        "  interleaf render -o film.mp4 --fps 60 --turn 90\n"
        "  interleaf render -o 'frame.####.png' --frames 30:59\n"
        "  interleaf render star.ilh --to 4 --turn 360 --loop -o star.gif --size 480x480");
}

}  // namespace interleaf
