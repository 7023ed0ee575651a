#include "app/cli/render_command.h"

#include <fmt/core.h>

#include "app/cli/error_message.h"
#include "app/cli/render_film.h"
#include "app/document/opening.h"
#include "app/pictures/blend_painter.h"
#include "hierarchy/error.h"
#include "io/film/film_encoder.h"
#include "io/film/png_bytes.h"
#include "render/context.h"

namespace interleaf {
namespace {

void render_picture(const RenderOptions& options, const Family& family) {
    const Weights weights = selected_weights(options.morph, family);
    if (const auto remark = remark_on_straight(family.blend, weights.size()))
        print_error(fmt::format("{}: {}", options.output.target, *remark));
    const auto [width, height] = options.size;
    const EglContext context;
    BlendPainter painter(family, width, height, options.display);
    write_output(
        target_of(options.output),
        png_bytes(painter.paint(weights, camera_on(family, options.viewpoint, aspect_of(options.size))),
                  width, height));
}

}  // namespace

std::vector<std::string> render_formats() {
    std::vector<std::string> formats = {"png"};
    for (const FilmFormat& format : film_formats()) formats.emplace_back(format.extension.substr(1));
    return formats;
}

void run_render(const RenderOptions& options) {
    const std::string format = format_of(options.output, render_formats());
    const bool is_numbered = has_frame_number(options.output.target);
    const bool is_film = format != "png" || is_numbered;
    if (options.display.transparent && format != "png")
        throw UsageError("--transparent: a film has a background; expected OUT.png or frame.####.png");
    if (is_film && options.output.target == "-") throw UsageError("-o -: a film needs a file");
    if (!is_film && options.film.are_given())
        throw UsageError(
            "--fps, --from, --to, --frames, --turn and --loop make films: expected a film such as out.mp4, "
            "or "
            "numbered pictures such as frame.####.png");
    const Family family = open_family(options.morph.family);
    if (is_film)
        render_film(options, format, family);
    else
        render_picture(options, family);
}

}  // namespace interleaf
