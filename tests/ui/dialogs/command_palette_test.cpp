// Tests of the command palette: its order, and the keyboard in it.
#include "ui/dialogs/command_palette.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

PaletteEntry possible(const char* name, const char* description = "") {
    return {.name = name, .group = "", .shortcut = "", .description = description, .obstacle = ""};
}

const std::vector<PaletteEntry> sample_entries{
    possible("Open"),
    {.name = "Play", .group = "Playback", .shortcut = "", .description = "", .obstacle = "no timeline"},
    possible("Play backward"),
    possible("Wireframe", "Show the edges"),
    possible("Root edges"),
};

/// Shows the palette, and is the keyboard.
class PaletteHand {
  public:
    PaletteHand() {
        ImGui::GetIO().KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
        palette_.open();
        for (int i = 0; i < 3; ++i) frame();
    }

    std::optional<std::size_t> frame() {
        gui_.begin_frame({0, 0}, false);
        const auto chosen = palette_.show({0, 24, 1280, 776}, sample_entries);
        gui_.end_frame();
        return chosen;
    }

    void type(std::string_view text) {
        for (const char letter : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
        frame();
        frame();
    }

    std::optional<std::size_t> press(int key) {
        ImGui::GetIO().KeysDown[key] = true;
        auto chosen = frame();
        ImGui::GetIO().KeysDown[key] = false;
        const auto later = frame();
        return chosen ? chosen : later;
    }

    bool is_open() const { return palette_.is_open(); }

  private:
    HeadlessGui gui_{{1280, 800}};
    CommandPalette palette_;
};

}  // namespace

TEST_CASE("without a search all entries come in their order, those that cannot be chosen last") {
    CHECK(ranked_entries("", sample_entries) == std::vector<std::size_t>{0, 2, 3, 4, 1});
}

TEST_CASE("a name that matches ranks before a description that does") {
    CHECK(ranked_entries("edges", sample_entries) == std::vector<std::size_t>{4, 3});
    CHECK(ranked_entries("play", sample_entries) == std::vector<std::size_t>{2, 1});
    CHECK(ranked_entries("playback play", sample_entries).front() == 1);
    CHECK(ranked_entries("no such thing", sample_entries).empty());
}

TEST_CASE("letters search, arrows select, Enter chooses and closes") {
    PaletteHand hand;
    hand.type("edges");
    CHECK_FALSE(hand.press(GLFW_KEY_DOWN));
    CHECK(hand.press(GLFW_KEY_ENTER) == 3u);
    CHECK_FALSE(hand.is_open());
}

TEST_CASE("the selection goes around, and a new search begins at its best entry") {
    PaletteHand hand;
    hand.press(GLFW_KEY_UP);
    hand.press(GLFW_KEY_UP);
    hand.type("o");
    CHECK(hand.press(GLFW_KEY_ENTER) == 0u);
}

TEST_CASE("an entry that cannot be chosen keeps the palette open, and so does a search without result") {
    PaletteHand hand;
    hand.type("playback play");
    CHECK_FALSE(hand.press(GLFW_KEY_ENTER));
    CHECK(hand.is_open());
    hand.type(" nothing");
    CHECK_FALSE(hand.press(GLFW_KEY_DOWN));
    CHECK_FALSE(hand.press(GLFW_KEY_ENTER));
    CHECK(hand.is_open());
}

TEST_CASE("Esc closes and chooses nothing") {
    PaletteHand hand;
    hand.type("open");
    CHECK_FALSE(hand.press(GLFW_KEY_ESCAPE));
    CHECK_FALSE(hand.is_open());
}
