#include "app/cli/render_film.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/cli/error_message.h"
#include "app/cli/held_interrupts.h"
#include "app/cli/progress_line.h"
#include "app/pictures/blend_painter.h"
#include "app/pictures/film.h"
#include "family/family_time.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "io/film/film_encoder.h"
#include "io/film/png_bytes.h"
#include "render/context.h"

namespace interleaf {
namespace {

constexpr double default_rate = 30;

/// What drives the blend; none where one blend is chosen, or the only key shown.
std::optional<TimeSource> source_of(const MorphSelection& morph, const Family& family) {
    if (morph.weights || morph.at || morph.time) return std::nullopt;
    if (morph.along) require_source(family, *morph.along);
    return morph.along ? morph.along : source_of_time(family);
}

/// The times from --from to --to.
TimeRange range_of(const FilmOptions& options, const Family& family, std::optional<TimeSource> source) {
    if (!source && !options.to)
        throw UsageError("--to: the blend does not change; expected the end of the film in seconds");
    const TimeRange whole = source ? interval_of(family, *source) : TimeRange{0, 0};
    const TimeRange range{options.from.value_or(whole.begin), options.to.value_or(whole.end)};
    if (range.end < range.begin)
        throw UsageError(
            fmt::format("--to: expected at least {}, where the film begins, got {}", range.begin, range.end));
    return range;
}

Film film_of(const RenderOptions& options, const Family& family) {
    Film film;
    film.source = source_of(options.morph, family);
    if (!film.source) film.still = selected_weights(options.morph, family);
    film.is_loop = options.film.is_loop;
    film.camera = camera_on(family, options.viewpoint, aspect_of(options.size));
    film.turn = static_cast<float>(options.film.turn.value_or(0));
    const TimeRange range = range_of(options.film, family, film.source);
    try {
        film.frames = frames_in(range, options.film.rate.value_or(default_rate), film.is_loop);
    } catch (const InputError& error) {
        throw UsageError(fmt::format("--fps: {}", error.what()));
    }
    return film;
}

FrameRange wanted_frames(const FilmOptions& options, const Film& film) {
    const FrameRange all{0, film.frames.count - 1};
    const FrameRange wanted = options.frames.value_or(all);
    if (wanted.last > all.last)
        throw UsageError(
            fmt::format("--frames: the film has the frames 0 to {}, got {}", all.last, wanted.last));
    return wanted;
}

/// Says if a frame has too many active keys to turn.
void remark_on_keys(const Film& film, const Family& family, const FrameRange& wanted,
                    const std::string& target) {
    if (family.blend == BlendKind::straight) return;
    std::size_t most_keys = 0;
    for (std::size_t number = wanted.first; number <= wanted.last; ++number)
        most_keys = std::max(most_keys, weights_of_frame(film, family, number).size());
    if (const auto remark = remark_on_straight(family.blend, most_keys))
        print_error(fmt::format("{}: {}", target, *remark));
}

using FrameReceiver = std::function<void(std::size_t number, std::vector<std::uint8_t> rgba)>;

/// \return whether all frames were painted, without an interrupt
bool paint_frames(BlendPainter& painter, const Film& film, const Family& family, const FrameRange& wanted,
                  const HeldInterrupts& interrupts, const FrameReceiver& receive) {
    for (std::size_t number = wanted.first; number <= wanted.last; ++number)
        painter.require_field(weights_of_frame(film, family, number));
    ProgressLine progress;
    const std::size_t count = wanted.last - wanted.first + 1;
    for (std::size_t number = wanted.first; number <= wanted.last; ++number) {
        if (interrupts.is_waiting()) return false;
        progress.show(fmt::format("frame {} of {}", number - wanted.first + 1, count),
                      static_cast<double>(number - wanted.first) / static_cast<double>(count));
        receive(number, painter.paint(weights_of_frame(film, family, number), camera_of_frame(film, number)));
    }
    return true;
}

/// Waits for ffmpeg, which may take long after the last frame, unless an interrupt comes.
void finish(FilmEncoder& encoder, const HeldInterrupts& interrupts) {
    constexpr std::chrono::milliseconds between_looks{50};
    std::future<void> finished = std::async(std::launch::async, [&encoder] { encoder.finish(); });
    while (finished.wait_for(between_looks) != std::future_status::ready)
        if (interrupts.is_waiting()) encoder.cancel();
    try {
        finished.get();
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
}

}  // namespace

bool has_frame_number(const std::string& target) {
    return std::filesystem::path(target).filename().string().find('#') != std::string::npos;
}

std::string numbered(const std::string& target, std::size_t number) {
    const std::size_t last = target.find_last_of('#');
    const std::size_t before = target.find_last_not_of('#', last);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    return fmt::format("{}{:0{}}{}", target.substr(0, first), number, last + 1 - first,
                       target.substr(last + 1));
}

void render_film(const RenderOptions& options, const std::string& format, const Family& family) {
    const Film film = film_of(options, family);
    const FrameRange wanted = wanted_frames(options.film, film);
    const auto [width, height] = options.size;
    const FilmPicture picture{width, height, film.frames.rate};
    const std::string& target = options.output.target;
    const FilmFormat* const film_format = film_format_with_extension("." + format);
    if (film_format != nullptr) require_encodable(*film_format, picture);

    remark_on_keys(film, family, wanted, target);
    const HeldInterrupts interrupts;
    const EglContext context;
    BlendPainter painter(family, width, height, options.display);
    if (film_format == nullptr) {
        paint_frames(painter, film, family, wanted, interrupts,
                     [&](std::size_t number, const std::vector<std::uint8_t>& rgba) {
                         write_output({numbered(target, number)}, png_bytes(rgba, width, height));
                     });
    } else {
        FilmEncoder encoder(target, *film_format, picture);
        if (paint_frames(painter, film, family, wanted, interrupts,
                         [&](std::size_t, std::vector<std::uint8_t> rgba) { encoder.add(std::move(rgba)); }))
            finish(encoder, interrupts);
    }
}

}  // namespace interleaf
