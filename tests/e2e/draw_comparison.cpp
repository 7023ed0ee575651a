// Draws a picture for the documentation that needs a user: fits meshes in the window, and compares the first
// mesh with its key.
//   draw_comparison MESH... PICTURE.png   (docs/draw-pictures)
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "e2e/person.h"
#include "scratch_folder.h"
#include <X11/keysym.h>
#include <fmt/core.h>

#include "io/film/png_bytes.h"

namespace interleaf {
namespace {

using State = RunningViewer::State;

constexpr glm::ivec2 size{960, 640};

Picture compared(const std::vector<std::filesystem::path>& meshes) {
    const ScratchFolder home;
    const RunningViewer viewer(home.path(), meshes);
    viewer.wait_for("the offer to fit", [](const State& s) { return s["offer"].is_object(); });
    viewer.desktop().resize(viewer.window(), size);
    viewer.wait_for("the size", [](const State& s) { return s["window"] == State({size.x, size.y}); });
    viewer.press(XK_Return);
    viewer.wait_for("the fitted key",
                    [](const State& s) { return s["asking"] == false && s["notice"] == true; });
    viewer.press(XK_m);
    viewer.wait_for("the comparison", [](const State& s) { return s["comparing"] == true; });
    viewer.point_at({size.x / 2, size.y - 2});  // where nothing reacts to the pointer
    viewer.settled_picture();
    return viewer.desktop().picture(viewer.window(), {0, 0, size.x, size.y});
}

std::string png_of(const Picture& picture) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * picture.size());
    for (const std::uint32_t pixel : picture) {
        for (const int shift : {16, 8, 0}) rgba.push_back(static_cast<std::uint8_t>(pixel >> shift & 0xFF));
        rgba.push_back(0xFF);
    }
    return png_bytes(rgba, size.x, size.y);
}

}  // namespace
}  // namespace interleaf

int main(int count, char** arguments) {
    if (count < 3) {
        fmt::print(stderr, "usage: draw_comparison MESH... PICTURE.png\n");
        return 2;
    }
    try {
        const char* const target = arguments[count - 1];
        const std::string png =
            interleaf::png_of(interleaf::compared({arguments + 1, arguments + count - 1}));
        std::ofstream file(target, std::ios::binary);
        if (file << png << std::flush) return 0;
        fmt::print(stderr, "draw_comparison: cannot write {}\n", target);
    } catch (const std::exception& error) {
        fmt::print(stderr, "draw_comparison: {}\n", error.what());
    }
    return 1;
}
