// Tests of films. They need ffmpeg.
#include "io/film/film_encoder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>

#include "hierarchy/progress.h"

using namespace interleaf;

namespace {

constexpr int side = 32;

/// A frame of one gray, 0 to 255.
std::vector<std::uint8_t> gray_frame(std::uint8_t gray) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * side * side, gray);
    for (std::size_t pixel = 3; pixel < rgba.size(); pixel += 4) rgba[pixel] = 255;
    return rgba;
}

void make_film(const std::filesystem::path& file, int frames) {
    FilmEncoder encoder(file, *film_format_with_extension(file.extension().string()), {side, side, 25});
    for (int frame = 0; frame < frames; ++frame)
        encoder.add(gray_frame(static_cast<std::uint8_t>(10 * frame)));
    encoder.finish();
}

/// The grays in the middle of all frames of \p film, as ffmpeg decodes them.
std::vector<int> decoded_grays(const std::filesystem::path& film, const ScratchFolder& folder) {
    const std::filesystem::path raw = folder.path() / "frames.raw";
    const std::string command = "ffmpeg -nostdin -loglevel error -y -i '" + film.string() +
                                "' -fps_mode passthrough -f rawvideo -pix_fmt gray '" + raw.string() + "'";
    REQUIRE(std::system(command.c_str()) == 0);  // NOLINT(concurrency-mt-unsafe): one thread
    const std::string bytes = content(raw);
    std::vector<int> grays;
    for (std::size_t at = side * side / 2 + side / 2; at < bytes.size(); at += side * side)
        grays.push_back(static_cast<unsigned char>(bytes[at]));
    return grays;
}

}  // namespace

TEST_CASE("a film of each format has all frames, in order, to the accuracy of its codec") {
    for (const FilmFormat& format : film_formats()) {
        CAPTURE(format.extension);
        const ScratchFolder folder;
        const std::filesystem::path film = folder.path() / ("film" + std::string(format.extension));
        make_film(film, 12);
        const std::vector<int> grays = decoded_grays(film, folder);
        REQUIRE(grays.size() == 12);
        for (int frame = 0; frame < 12; ++frame)
            CHECK(std::abs(grays[static_cast<std::size_t>(frame)] - 10 * frame) <= 4);
    }
}

TEST_CASE("the same frames make the same bytes") {
    const ScratchFolder folder;
    for (const char* name : {"a.mp4", "b.mp4"}) make_film(folder.path() / name, 5);
    CHECK(content(folder.path() / "a.mp4") == content(folder.path() / "b.mp4"));
}

TEST_CASE("without finish() the target stays as it was, and no other file remains") {
    const ScratchFolder folder;
    const std::filesystem::path film = folder.path() / "film.mp4";
    std::ofstream(film) << "old";
    {
        FilmEncoder encoder(film, *film_format_with_extension(".mp4"), {side, side, 25});
        encoder.add(gray_frame(100));
    }
    CHECK(content(film) == "old");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a film is cancelled while ffmpeg finishes, and the target stays as it was") {
    const ScratchFolder folder;
    const std::filesystem::path film = folder.path() / "film.webm";
    std::ofstream(film) << "old";
    constexpr int large = 1024;
    FilmEncoder encoder(film, *film_format_with_extension(".webm"), {large, large, 25});
    // Noise, which takes VP9 long.
    std::vector<std::uint8_t> frame(std::size_t{4} * large * large);
    std::uint32_t noise = 1;
    for (int n = 0; n < 6; ++n) {
        for (std::uint8_t& byte : frame)
            byte = static_cast<std::uint8_t>((noise = 1664525 * noise + 7) >> 24);
        encoder.add(frame);
    }
    std::future<void> finished = std::async(std::launch::async, [&encoder] { encoder.finish(); });
    encoder.cancel();
    CHECK_THROWS_AS(finished.get(), Cancelled);
    CHECK(content(film) == "old");
}

TEST_CASE("an encoder that fails says why, and leaves the target as it was") {
    const ScratchFolder folder;
    const std::filesystem::path film = folder.path() / "film.webm";
    std::ofstream(film) << "old";
    FilmEncoder encoder(film, {".nonsense", "", false, 240}, {side, side, 25});
    const std::string error = machine_error_of([&] {
        for (int frame = 0; frame < 100; ++frame) encoder.add(gray_frame(0));
        encoder.finish();
    });
    CHECK(contains(error, film.string()));
    CHECK(contains(error, "ffmpeg: "));
    CHECK(content(film) == "old");
}

TEST_CASE("sides that a format cannot have, and rates that no player keeps up with, are refused") {
    const FilmFormat& h264 = *film_format_with_extension(".mp4");
    const FilmFormat& gif = *film_format_with_extension(".gif");
    CHECK_THROWS_AS(require_encodable(h264, {33, 32, 25}), UsageError);
    CHECK_THROWS_AS(require_encodable(h264, {32, 33, 25}), UsageError);
    CHECK_NOTHROW(require_encodable(gif, {33, 33, 25}));
    CHECK_THROWS_AS(require_encodable(gif, {32, 32, 60}), UsageError);
    CHECK_THROWS_AS(require_encodable(h264, {32, 32, 0}), UsageError);
    CHECK(film_format_with_extension(".avi") == nullptr);
}

TEST_CASE("without ffmpeg the message says what to do") {
    const std::string path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): one thread
    ::setenv("PATH", "/nonexistent", 1);           // NOLINT(concurrency-mt-unsafe)
    const ScratchFolder folder;
    const std::string error = machine_error_of([&] { make_film(folder.path() / "a.mp4", 1); });
    ::setenv("PATH", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    CHECK(contains(error, "there is no ffmpeg"));
    CHECK(contains(error, "frame.####.png"));
}
