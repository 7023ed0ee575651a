// `interleaf render`: draws a picture of a morph, or a film of it, without a display.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/morph_selection.h"
#include "app/cli/output.h"
#include "app/document/viewpoint.h"
#include "render/display.h"

namespace interleaf {

struct PictureSize {
    int width = 1280;  ///< pixels
    int height = 720;
};

inline float aspect_of(const PictureSize& size) {
    return static_cast<float>(size.width) / static_cast<float>(size.height);
}

/// Numbers of frames, from the first to the last.
struct FrameRange {
    std::size_t first;
    std::size_t last;
};

/// What only a film has.
struct FilmOptions {
    std::optional<double> rate;        ///< frames per second
    std::optional<double> from;        ///< time; by default, where the timeline or the path begins
    std::optional<double> to;          ///< time; by default, where it ends
    std::optional<FrameRange> frames;  ///< the frames to draw; by default all
    std::optional<double> turn;        ///< degrees that the camera turns in the whole film
    bool is_loop = false;

    bool are_given() const { return rate || from || to || frames || turn || is_loop; }
};

struct RenderOptions {
    MorphSelection morph;
    Output output;
    PictureSize size;
    Viewpoint viewpoint;
    Display display;
    FilmOptions film;
};

/// The formats of pictures and films, without the dot of their extensions.
std::vector<std::string> render_formats();

/// Draws a film where the output is one (.mp4, .webm, .gif), or numbered pictures ("frame.####.png");
/// otherwise one picture.
/// \throw InputError, UsageError, MachineError
void run_render(const RenderOptions& options);

}  // namespace interleaf
