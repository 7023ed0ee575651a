// `interleaf render`: films and numbered pictures.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

namespace interleaf {
namespace {

constexpr const char* film_size = "64x36";

/// What ffprobe says about the frames of \p film: "width,height,rate,frames".
std::string probe(const std::filesystem::path& film, const ScratchFolder& folder) {
    const std::filesystem::path answer = folder.path() / "answer";
    const std::string command = fmt::format(
        "ffprobe -v error -count_frames -show_entries "
        "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 '{}' > '{}'",
        film.string(), answer.string());
    REQUIRE(std::system(command.c_str()) == 0);  // NOLINT(concurrency-mt-unsafe): one thread
    return content(answer);
}

TEST_CASE("a film has the size, the rate and the frames that are asked for") {
    const ScratchFolder folder;
    const Outcome outcome = run_interleaf({"render", "-o", folder / "film.mp4", "--size", film_size, "--fps",
                                           "10", "--from", "1", "--to", "2.5", "--turn", "90"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(probe(folder / "film.mp4", folder) == "64,36,10/1,16\n");
}

/// The pixels of a frame of \p file, a film or a picture, as ffmpeg decodes them: 8 bits each of red, green and
/// blue.
std::string pixels(const std::filesystem::path& file, int frame, const ScratchFolder& folder) {
    const std::filesystem::path raw = folder.path() / "pixels";
    const std::string command = fmt::format(
        "ffmpeg -nostdin -loglevel error -y -i '{}' -vf 'select=eq(n\\,{}),scale=in_color_matrix=bt709' "
        "-frames:v 1 -f rawvideo -pix_fmt rgb24 '{}'",
        file.string(), frame, raw.string());
    REQUIRE(std::system(command.c_str()) == 0);  // NOLINT(concurrency-mt-unsafe): one thread
    return content(raw);
}

TEST_CASE("a frame of a film is the picture of its time, to the accuracy of the codec") {
    const ScratchFolder folder;
    const char* const size = "320x180";
    REQUIRE(
        run_interleaf({"render", "-o", folder / "a.mp4", "--size", size, "--fps", "4", "--to", "2"}).status ==
        0);
    const auto mean_difference = [&](int frame, const char* time) {
        REQUIRE(run_interleaf({"render", "-o", folder / "a.png", "--size", size, "--time", time}).status ==
                0);
        const std::string film = pixels(folder / "a.mp4", frame, folder);
        const std::string still = pixels(folder / "a.png", 0, folder);
        REQUIRE(film.size() == std::size_t{3} * 320 * 180);
        REQUIRE(still.size() == film.size());
        double sum = 0;
        for (std::size_t i = 0; i < film.size(); ++i)
            sum += std::abs(static_cast<unsigned char>(film[i]) - static_cast<unsigned char>(still[i]));
        return sum / static_cast<double>(film.size());
    };
    const double own = mean_difference(5, "1.25");
    CAPTURE(own);
    CHECK(own < 2);
    CHECK(mean_difference(5, "1.75") > 3 * own);
}

TEST_CASE("a numbered picture has the same bytes whoever draws it, and as a single picture of its time") {
    const ScratchFolder folder;
    const auto draw = [&](const char* name, const char* frames) {
        const Outcome outcome = run_interleaf(
            {"render", "-o", folder / name, "--size", film_size, "--fps", "4", "--frames", frames});
        REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    };
    draw("all.###.png", "5:8");
    draw("one.#.png", "7:7");
    CHECK(std::filesystem::exists(folder / "all.005.png"));
    CHECK(std::filesystem::exists(folder / "all.008.png"));
    CHECK_FALSE(std::filesystem::exists(folder / "all.004.png"));
    CHECK(content(folder / "all.007.png") == content(folder / "one.7.png"));
    REQUIRE(
        run_interleaf({"render", "-o", folder / "still.png", "--size", film_size, "--time", "1.75"}).status ==
        0);
    CHECK(content(folder / "all.007.png") == content(folder / "still.png"));
}

TEST_CASE("a blend that does not change is turned for as long as --to says") {
    const ScratchFolder folder;
    const Outcome outcome = run_interleaf({"render", "-o", folder / "turn.#.png", "--size", film_size, "--at",
                                           "0.3,0.4", "--fps", "2", "--to", "2", "--turn", "360", "--loop"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(std::filesystem::exists(folder / "turn.3.png"));
    CHECK_FALSE(std::filesystem::exists(folder / "turn.4.png"));
    CHECK(content(folder / "turn.0.png") != content(folder / "turn.1.png"));
}

TEST_CASE("a film that cannot be made is refused before anything is written") {
    const ScratchFolder folder;
    const auto refusal = [&](std::vector<std::string> options, int status) {
        options.insert(options.begin(), "render");
        const Outcome outcome = run_interleaf(options);
        CHECK(outcome.status == status);
        CHECK(is_one_message(outcome.errors));
        CHECK_FALSE(std::filesystem::exists(folder / "a.mp4"));
        return outcome.errors;
    };
    const std::string film = folder / "a.mp4";
    CHECK(contains(refusal({"-o", film, "--size", "63x36"}, 2), "even"));
    CHECK(contains(refusal({"-o", film, "--frames", "3:900"}, 2), "0 to 300"));
    CHECK(contains(refusal({"-o", film, "--frames", "3"}, 2), "A:B"));
    CHECK(contains(refusal({"-o", film, "--from", "3", "--to", "2"}, 2), "--to"));
    CHECK(contains(refusal({"-o", film, "--time", "1"}, 2), "--to"));
    CHECK(contains(refusal({"-o", film, "--fps", "0"}, 2), "--fps"));
    CHECK(contains(refusal({"-o", "-", "--format", "mp4"}, 2), "needs a file"));
    CHECK(contains(refusal({"-o", folder / "a.png", "--fps", "25"}, 2), "frame.####.png"));
    CHECK(contains(refusal({"-o", folder / "no folder" / "a.mp4", "--size", film_size}, 3), "no folder"));
}

TEST_CASE("on a full disk a film fails with its name and the words of ffmpeg, and leaves nothing") {
    const ScratchFolder folder;
    const Outcome outcome =
        run_interleaf({"render", "-o", folder / "a.mp4", "--size", "320x180", "--to", "1"},
                      {.standard_output = {}, .max_file_size = 3000, .display = {}});
    CHECK(outcome.status == 3);
    CHECK(is_one_message(outcome.errors));
    CHECK(contains(outcome.errors, (folder / "a.mp4").string() + ": ffmpeg: "));
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a film that is interrupted leaves nothing, and an ignored interrupt has no effect") {
    const ScratchFolder folder;
    const auto status_after = [&](const char* signal, const char* end) {
        // Interrupts the program once it writes the film, beside its later place.
        const std::string command = fmt::format(
            "'{0}' render -o '{1}/a.mp4' --size 320x180 --to {2} & p=$!; "
            "while kill -0 $p && ! [ -e '{1}/.interleaf-0' ]; do sleep 0.01; done; kill -{3} $p; wait $p",
            INTERLEAF_PROGRAM, folder.path().string(), end, signal);
        return std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe): one thread
    };
    CHECK(status_after("TERM", "100") != 0);
    CHECK(std::filesystem::is_empty(folder.path()));
    CHECK(status_after("INT", "1") == 0);  // the shell lets jobs in the background ignore it
    CHECK(std::filesystem::exists(folder / "a.mp4"));
}

TEST_CASE("without ffmpeg a film is the machine's fault, and a film of one key needs an end") {
    const ScratchFolder folder;
    const std::string path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): one thread
    ::setenv("PATH", "/nonexistent", 1);           // NOLINT(concurrency-mt-unsafe)
    const Outcome outcome =
        run_interleaf({"render", "-o", folder / "a.mp4", "--size", film_size, "--to", "1"});
    ::setenv("PATH", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    CHECK(outcome.status == 3);
    CHECK(is_one_message(outcome.errors));
    CHECK(contains(outcome.errors, "frame.####.png"));
    CHECK(std::filesystem::is_empty(folder.path()));

    REQUIRE(run_interleaf({"make", "star", "--leaves", "200", "-o", folder / "star.ilh"}).status == 0);
    const Outcome still = run_interleaf({"render", folder / "star.ilh", "-o", folder / "a.mp4"});
    CHECK(still.status == 2);
    CHECK(contains(still.errors, "--to: the blend does not change"));
}

}  // namespace
}  // namespace interleaf
