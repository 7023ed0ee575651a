#include "io/film/film_encoder.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "hierarchy/progress.h"

namespace interleaf {
namespace {

/// Frames that may wait for ffmpeg. More would take memory and win no time.
constexpr std::size_t max_waiting = 3;

constexpr std::array<FilmFormat, 3> film_table = {{
    {.extension = ".mp4", .title = "H.264 film", .has_even_sides = true, .max_rate = 240},
    {.extension = ".webm", .title = "VP9 film", .has_even_sides = true, .max_rate = 240},
    {.extension = ".gif", .title = "GIF animation", .has_even_sides = false, .max_rate = 50},
}};

/// The colors of high-definition television, stated in the file so that players need not guess.
constexpr const char* television_colors = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

std::vector<std::string> codec_arguments(std::string_view extension) {
    const std::vector<std::string> colors = {
        "-vf",   television_colors, "-color_range", "tv",          "-color_primaries",
        "bt709", "-color_trc",      "bt709",        "-colorspace", "bt709"};
    std::vector<std::string> arguments;
    if (extension == ".mp4") {
        arguments = {"-c:v", "libx264", "-preset", "fast", "-crf", "18", "-movflags", "+faststart"};
    } else if (extension == ".webm") {
        arguments = {"-c:v",    "libvpx-vp9", "-b:v",      "0",    "-crf",      "24",
                     "-row-mt", "1",          "-deadline", "good", "-cpu-used", "4"};
    } else {
        // A palette per frame: one palette of all frames would need all frames in memory.
        return {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=bayer",
                "-loop", "0"};
    }
    arguments.insert(arguments.end(), colors.begin(), colors.end());
    return arguments;
}

std::vector<std::string> encoder_arguments(const FilmFormat& format, const FilmPicture& picture,
                                           const std::filesystem::path& file) {
    const std::string extension(format.extension);
    // -xerror: otherwise a film that is cut off, as on a full disk, would count as success.
    std::vector<std::string> arguments = {"-nostdin",
                                          "-xerror",
                                          "-hide_banner",
                                          "-loglevel",
                                          "error",
                                          "-f",
                                          "rawvideo",
                                          "-pixel_format",
                                          "rgba",
                                          "-video_size",
                                          fmt::format("{}x{}", picture.width, picture.height),
                                          "-framerate",
                                          fmt::format("{}", picture.rate),
                                          "-i",
                                          "pipe:0"};
    const std::vector<std::string> codec = codec_arguments(extension);
    arguments.insert(arguments.end(), codec.begin(), codec.end());
    // The same frames give the same bytes: no date and no version of the encoder in the file.
    const std::vector<std::string> rest = {
        "-map_metadata", "-1", "-fflags",           "+bitexact", "-flags:v",
        "+bitexact",     "-f", extension.substr(1), "-y",        "file:" + file.string()};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    return arguments;
}

}  // namespace

std::span<const FilmFormat> film_formats() {
    return film_table;
}

const FilmFormat* film_format_with_extension(std::string_view extension) {
    const auto found = std::ranges::find(film_table, extension, &FilmFormat::extension);
    return found == film_table.end() ? nullptr : &*found;
}

void require_encodable(const FilmFormat& format, const FilmPicture& picture) {
    if (format.has_even_sides && (picture.width % 2 != 0 || picture.height % 2 != 0))
        throw UsageError(fmt::format("expected an even width and height for {}, got {}x{}", format.extension,
                                     picture.width, picture.height));
    if (!(picture.rate > 0 && picture.rate <= format.max_rate))
        throw UsageError(fmt::format("expected at most {} frames per second for {}, got {}", format.max_rate,
                                     format.extension, picture.rate));
}

FilmEncoder::FilmEncoder(const std::filesystem::path& file, const FilmFormat& format,
                         const FilmPicture& picture)
    : file_((require_encodable(format, picture), file)),
      film_(file),
      process_(encoder_arguments(format, picture, film_.path())),
      thread_([this] { pass_frames_on(); }) {}

FilmEncoder::~FilmEncoder() {
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
    }
    end_frames();
}

void FilmEncoder::pass_frames_on() {
    for (;;) {
        std::vector<std::uint8_t> frame;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return !waiting_.empty() || is_complete_; });
            if (waiting_.empty()) return;
            frame = std::move(waiting_.front());
            waiting_.pop_front();
        }
        changed_.notify_all();
        if (process_.write(frame)) continue;
        const std::lock_guard lock(mutex_);
        is_broken_ = true;
        changed_.notify_all();
        return;
    }
}

bool FilmEncoder::takes_frames() {
    const std::lock_guard lock(mutex_);
    return waiting_.size() < max_waiting || is_broken_;
}

void FilmEncoder::add(std::vector<std::uint8_t> rgba) {
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.size() < max_waiting || is_broken_; });
        if (is_broken_) throw_failure();
        waiting_.push_back(std::move(rgba));
    }
    changed_.notify_all();
}

void FilmEncoder::end_frames() {
    {
        const std::lock_guard lock(mutex_);
        is_complete_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void FilmEncoder::finish() {
    end_frames();
    const bool is_done = process_.finish();
    {
        const std::lock_guard lock(mutex_);
        if (is_cancelled_) throw Cancelled();
        if (!is_done || is_broken_) throw_failure();
    }
    film_.commit();
}

void FilmEncoder::cancel() {
    {
        const std::lock_guard lock(mutex_);
        is_cancelled_ = true;
    }
    process_.kill();
}

void FilmEncoder::throw_failure() const {
    const std::string message = process_.last_message();
    throw MachineError(fmt::format("{}: ffmpeg: {}", file_.string(),
                                   message.empty() ? "ended before the film was complete" : message));
}

}  // namespace interleaf
