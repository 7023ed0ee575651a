// The camera in the window: commands, the clipboard, and the command line that draws what is seen.
#include <array>
#include <cstdlib>
#include <memory>
#include <string>

#include "e2e/person.h"
#include "e2e/running_viewer.h"
#include "scratch_folder.h"
#include <X11/keysym.h>
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <stb/stb_image.h>

namespace interleaf {
namespace {

using State = RunningViewer::State;

struct DecodedPicture {
    int width = 0;
    int height = 0;
    std::vector<unsigned char> rgb;
};

DecodedPicture decode_file(const std::filesystem::path& file) {
    DecodedPicture picture;
    int channels = 0;
    const std::unique_ptr<unsigned char, decltype(&stbi_image_free)> pixels(
        stbi_load(file.c_str(), &picture.width, &picture.height, &channels, 3), stbi_image_free);
    REQUIRE(pixels != nullptr);
    const std::size_t size =
        3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.rgb.assign(pixels.get(), pixels.get() + size);
    return picture;
}

/// Fraction of the pixels that differ visibly, below the axes and the buttons at the top.
double difference_in_view(const Picture& seen, const DecodedPicture& drawn) {
    constexpr int top = 110;
    const auto width = static_cast<std::size_t>(drawn.width);
    REQUIRE(seen.size() * 3 == drawn.rgb.size());
    std::size_t differs = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (static_cast<int>(i / width) < top) continue;
        for (unsigned c = 0; c < 3; ++c) {
            const int in_window = static_cast<int>(seen[i] >> (16 - 8 * c) & 0xff);
            if (std::abs(in_window - drawn.rgb[3 * i + c]) > 4) {
                ++differs;
                break;
            }
        }
    }
    return static_cast<double>(differs) / static_cast<double>(seen.size());
}

std::string message_after(const State& state, const std::string& begin) {
    const std::string text = state["message"];
    return text.starts_with(begin) ? text.substr(begin.size()) : "";
}

TEST_CASE("a copied command draws what the window shows, and its view can be pasted") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.press(XK_w);
    viewer.press(XK_o, XK_Shift_L);
    viewer.press(XK_Left, XK_Alt_L);
    viewer.drag(view_middle(start), view_middle(start) + glm::vec2(90, 30));
    const State dragged = viewer.wait_for("a rolled, orthographic view", [&](const State& s) {
        const std::string view = s["view"];
        return view.find("roll=5") != std::string::npos && view.ends_with(",orthographic") &&
               s["button_down"] == false && s["eye"] != start["eye"];
    });
    viewer.turn_wheel(true);
    const State turned =
        viewer.wait_for("a nearer view", [&](const State& s) { return s["view"] != dragged["view"]; });
    const Picture picture = viewer.settled_picture();

    viewer.press(XK_c, XK_Control_L, XK_Alt_L);
    std::string command;
    viewer.wait_for("the copied command", [&](const State& s) {
        command = message_after(s, "Copied command: interleaf ");
        return !command.empty();
    });
    const ScratchFolder folder;
    REQUIRE(std::system(fmt::format("cd '{}' && '{}' {}", folder.path().string(), INTERLEAF_PROGRAM, command)
                            .c_str()) == 0);
    const DecodedPicture drawn = decode_file(folder / "picture.png");
    CHECK(difference_in_view(picture, drawn) < 0.002);

    viewer.press(XK_1, XK_Control_L);
    const State front = viewer.wait_for(
        "the front view", [](const State& s) { return s["view"].get<std::string>().starts_with("0,0,"); });
    CHECK(front["view"] != turned["view"]);
    viewer.press(XK_v, XK_Control_L, XK_Shift_L);
    viewer.wait_for("the pasted view", [&](const State& s) { return s["view"] == turned["view"]; });

    viewer.press(XK_s, XK_Shift_L);
    State spun;
    for (int turn = 0; turn < 2; ++turn)
        spun = viewer.wait_for("a spinning view", [&](const State& s) {
            return s["view"] != turned["view"] && (spun.is_null() || s["view"] != spun["view"]);
        });
    viewer.press(XK_s, XK_Shift_L);
}

TEST_CASE("a picture without background is saved as the window shows the surface") {
    const ScratchFolder folder;
    const RunningViewer viewer(folder.path());
    const Picture seen = viewer.settled_picture();
    viewer.press(XK_F12);
    wait_for_question(viewer);
    viewer.press(XK_Return);
    viewer.wait_for("the dialog", [](const State& s) { return s["picture_row"] == "size"; });
    viewer.settled_picture();
    for (const char* row : {"scale", "transparent"}) {
        viewer.press(XK_Down);
        viewer.wait_for("the next row", [row](const State& s) { return s["picture_row"] == row; });
    }
    viewer.press(XK_space);
    viewer.press(XK_Return);
    viewer.wait_for("the saved picture",
                    [](const State& s) { return !message_after(s, "Made Five keys.png in ").empty(); });
    const DecodedPicture saved = decode_file(folder / "Five keys.png");
    const State rect = viewer.state()["rects"]["view"];
    CHECK(saved.width == rect[2].get<int>());
    CHECK(saved.height == rect[3].get<int>());
    // Without its alpha, the surface is on black: only the background differs.
    const double changed = difference_in_view(seen, saved);
    CHECK(changed > 0.4);
    CHECK(changed < 0.8);
}

}  // namespace
}  // namespace interleaf
