// Tests of Trace: the lines of its file.
#include "app/window/trace.h"

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "app/sample_family.h"

using namespace interleaf;

namespace {

std::vector<nlohmann::json> lines_of(const std::filesystem::path& path) {
    std::vector<nlohmann::json> lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) lines.push_back(nlohmann::json::parse(line));
    return lines;
}

}  // namespace

TEST_CASE("a trace repeats what OpenGL has complained of, each message once, and writes changes only") {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "trace";
    const ViewerState state(sample_family());
    WindowResult shown;
    shown.family = state.document.snapshot();
    const Camera camera;
    Trace trace(path);
    std::size_t frame = 0;
    const auto record = [&](std::vector<std::string> messages) {
        ++frame;
        trace.record(frame, 0.1 * static_cast<double>(frame), state, {},
                     {.shown = shown,
                      .eye = {},
                      .camera = camera,
                      .pointer = {},
                      .follows_camera = false,
                      .rests = true,
                      .button_down = false,
                      .is_asking = false,
                      .takes_text = false,
                      .popup = {},
                      .browsed = {},
                      .picture_row = {},
                      .offer = nullptr,
                      .landmarks = nullptr,
                      .opengl_messages = std::move(messages)});
    };
    record({});
    record({});
    record({"invalid enum", "invalid value"});
    record({"invalid enum"});
    record({});
    record({"out of memory"});

    const std::vector<nlohmann::json> lines = lines_of(path);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0]["frame"] == 1);
    CHECK(lines[0]["opengl_messages"].empty());
    CHECK(lines[0]["document"]["keys"] == nlohmann::json{"a", "b", "c", "d", "e"});
    CHECK(lines[1]["frame"] == 3);
    CHECK(lines[1]["opengl_messages"] == nlohmann::json{"invalid enum", "invalid value"});
    CHECK(lines[2]["frame"] == 6);
    CHECK(lines[2]["opengl_messages"] == nlohmann::json{"invalid enum", "invalid value", "out of memory"});
}
