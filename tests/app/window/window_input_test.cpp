// Tests of the commands of keys that are pressed during one frame.
#include "app/window/window_input.h"

#include <array>
#include <span>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include "app/document/edit_commands.h"
#include "app/sample_family.h"
#include "app/window/shortcuts.h"

using namespace interleaf;

namespace {

constexpr Shortcut rename_keys{GLFW_KEY_F2, 0};
constexpr Shortcut undo_keys{GLFW_KEY_Z, GLFW_MOD_CONTROL};
constexpr Shortcut duplicate{GLFW_KEY_D, GLFW_MOD_CONTROL};
constexpr Shortcut search{GLFW_KEY_P, GLFW_MOD_CONTROL};
constexpr Shortcut brush{GLFW_KEY_X, 0};
constexpr Shortcut open_keys{GLFW_KEY_O, GLFW_MOD_CONTROL};

}  // namespace

TEST_CASE("keys of one frame run their commands in their order") {
    ViewerState state(sample_family());
    state.selected_key = 0;
    const std::size_t count = state.document.family().keys.size();
    const std::array pressed{duplicate, duplicate, undo_keys};
    CHECK(run_pressed(pressed, table_shortcuts(), state, 0).empty());
    CHECK(state.document.family().keys.size() == count + 1);
}

TEST_CASE("keys pressed after the one that asks a question do not change the document that it is about") {
    ViewerState state(sample_family());
    state.selected_key = state.document.family().keys.size() - 1;
    duplicate_key(state, 0);
    state.selected_key = state.document.family().keys.size() - 1;
    const auto before = state.document.snapshot();
    const std::array pressed{rename_keys, undo_keys};
    const std::vector<Shortcut> rest = run_pressed(pressed, table_shortcuts(), state, 0);
    CHECK(rest == std::vector{undo_keys});
    CHECK(state.document.snapshot() == before);
    REQUIRE(state.question);
    CHECK(state.question->fault("another").empty());

    // Nor do they after a click that asks it.
    CHECK(run_pressed(std::array{undo_keys}, table_shortcuts(), state, 0) == std::vector{undo_keys});
    CHECK(state.document.snapshot() == before);
}

TEST_CASE("letters pressed after the key that opens a search or a dialog run no command") {
    for (const Shortcut first : {search, open_keys}) {
        ViewerState state(sample_family());
        state.selected_key = 0;
        const std::array pressed{first, brush};
        CHECK(run_pressed(pressed, table_shortcuts(), state, 0) == std::vector{brush});
        CHECK_FALSE(state.brush.is_on);
    }
    // Nor do they after a click that opens it.
    ViewerState state(sample_family());
    state.selected_key = 0;
    state.search_wanted = true;
    CHECK(run_pressed(std::array{brush}, table_shortcuts(), state, 0) == std::vector{brush});
    CHECK_FALSE(state.brush.is_on);
}
