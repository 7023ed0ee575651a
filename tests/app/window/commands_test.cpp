// Tests of the command table: that keys, menus and help can come from it, and what its commands do.
#include "app/window/commands.h"

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "app/sample_family.h"

using namespace interleaf;

namespace {

ViewerState sample_state() {
    return ViewerState(sample_family());
}

/// Presses a key at wall time \p now.
void press(ViewerState& state, Shortcut shortcut, double now = 0) {
    const Command* const command = find_command(shortcut);
    REQUIRE(command != nullptr);
    command->run(state, now);
}

}  // namespace

TEST_CASE("the user guide lists every command with its keys") {
    std::ifstream file(USER_GUIDE);
    const std::string guide{std::istreambuf_iterator<char>(file), {}};
    for (const Command& command : commands()) {
        const std::string row =
            fmt::format("| {} | {} | {} |\n", shortcut_text(command), command.name, command.description);
        CAPTURE(row);
        CHECK(guide.find(row) != std::string::npos);
    }
}

TEST_CASE("every command can be found in a menu and in the help, and by its keys") {
    std::set<std::string_view> names;
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        CHECK_FALSE(command.menu.empty());
        CHECK_FALSE(command.description.empty());
        const bool acts = command.run != nullptr;
        CHECK(acts);
        CHECK(names.insert(command.name).second);
        CHECK(command.shortcuts[0].keyboard_key != 0);
        for (const Shortcut shortcut : command.shortcuts) {
            if (shortcut.keyboard_key != 0) CHECK(find_command(shortcut) == &command);
        }
    }
}

TEST_CASE("shortcuts are written differently if they differ") {
    std::set<std::string> texts;
    for (const Command& command : commands()) CHECK(texts.insert(shortcut_text(command)).second);
    CHECK(texts.contains("Space"));
    CHECK(texts.contains("Ctrl+Q"));
    CHECK(texts.contains("W or 1"));
    CHECK(texts.contains("F1 or H"));
}

TEST_CASE("the commands of one menu stand in a row") {
    std::set<std::string_view> menus;
    std::string_view menu;
    for (const Command& command : commands()) {
        if (command.menu != menu) CHECK(menus.insert(command.menu).second);
        menu = command.menu;
    }
}

TEST_CASE("no command has a key that is not in the table, nor one with other modifiers") {
    CHECK(find_command({}) == nullptr);
    CHECK(find_command({GLFW_KEY_U, 0}) == nullptr);
    CHECK(find_command({GLFW_KEY_Q, 0}) == nullptr);
    CHECK(find_command({GLFW_KEY_W, GLFW_MOD_CONTROL}) == nullptr);
}

TEST_CASE("what is on or off changes with its command and comes back with the second") {
    for (const Command& command : commands()) {
        if (command.is_on == nullptr) continue;
        CAPTURE(command.name);
        ViewerState state = sample_state();
        const bool before = command.is_on(state);
        command.run(state, 0);
        CHECK(command.is_on(state) != before);
        command.run(state, 0);
        CHECK(command.is_on(state) == before);
    }
}

TEST_CASE("each line key switches its own lines") {
    ViewerState state = sample_state();
    Display expected;
    press(state, {GLFW_KEY_W});
    expected.wireframe = true;
    CHECK(state.session.display == expected);
    press(state, {GLFW_KEY_2});
    expected.refinement_edges = true;
    CHECK(state.session.display == expected);
    press(state, {GLFW_KEY_E});
    expected.root_edges = true;
    CHECK(state.session.display == expected);
    press(state, {GLFW_KEY_S});
    expected.shading = Shading::flat;
    CHECK(state.session.display == expected);
}

TEST_CASE("colorings come round, that by a field where there is one") {
    for (const std::size_t count : {4u, 5u}) {
        ViewerState state = sample_state();
        if (count == 5) state.session.display.field = "height";
        std::set<Coloring> seen;
        for (std::size_t i = 0; i < count; ++i) {
            seen.insert(state.session.display.coloring);
            press(state, {GLFW_KEY_C});
        }
        CHECK(seen.size() == count);
        CHECK(state.session.display.coloring == Coloring::plain);
    }
}

TEST_CASE("the arrows step by a hundredth of the timeline, Home and End go to its ends") {
    ViewerState state = sample_state();
    press(state, {GLFW_KEY_RIGHT});
    CHECK(state.session.time() == doctest::Approx(0.05));
    press(state, {GLFW_KEY_RIGHT});
    CHECK(state.session.time() == doctest::Approx(0.1));
    press(state, {GLFW_KEY_LEFT});
    CHECK(state.session.time() == doctest::Approx(0.05));
    press(state, {GLFW_KEY_END});
    CHECK(state.session.time() == 5);
    press(state, {GLFW_KEY_LEFT, GLFW_MOD_CONTROL});
    CHECK(state.session.time() == 4);
    press(state, {GLFW_KEY_PAGE_DOWN});
    CHECK(state.session.time() == 5);
    press(state, {GLFW_KEY_HOME});
    CHECK(state.session.time() == 0);
}

TEST_CASE("no command fails without timeline and domain") {
    Family family = sample_family();
    family.timeline.reset();
    family.domain.reset();
    ViewerState state(std::move(family));
    for (const Command& command : commands()) run_command(command, state, 0);
    CHECK(state.session.weights() == Weights{{0, 1}});
    CHECK(state.session.time() == 0);
}

TEST_CASE("Escape closes a message before it closes the help") {
    ViewerState state = sample_state();
    press(state, {GLFW_KEY_F1});
    state.message = {"something is wrong", nullptr};
    press(state, {GLFW_KEY_ESCAPE});
    CHECK(state.message.empty());
    CHECK(state.help_shown);
    press(state, {GLFW_KEY_ESCAPE});
    CHECK_FALSE(state.help_shown);
    CHECK(state.file_wish == FileWish::none);
}

TEST_CASE("quitting, viewing all and reloading are wishes") {
    ViewerState state = sample_state();
    state.view_target = ViewTarget::none;
    press(state, {GLFW_KEY_F});
    CHECK(state.view_target == ViewTarget::surface);
    press(state, {GLFW_KEY_F5});
    CHECK(state.reload_wanted);
    press(state, {GLFW_KEY_Q, GLFW_MOD_CONTROL});
    CHECK(state.file_wish == FileWish::quit);
}

TEST_CASE(
    "only a document with keys that were fitted here can be compared with meshes, and not edited meanwhile") {
    ViewerState state = sample_state();
    const Command& compare_command = command_named("Compare with mesh");
    CHECK_FALSE(is_enabled(compare_command, state));
    run_command(compare_command, state, 0);
    CHECK_FALSE(state.is_comparing);

    for (const std::size_t key : {1U, 3U}) {
        FitComparison comparison;
        comparison.mesh_name = state.document.family().keys[key].name;
        comparison.key = state.document.family().keys[key].hierarchy;
        state.comparisons.push_back(std::make_shared<const FitComparison>(std::move(comparison)));
    }
    state.selected_key = 3;
    CHECK(is_enabled(command_named("Keep blend"), state));
    run_command(compare_command, state, 0);
    CHECK(state.is_comparing);
    CHECK(state.compared == state.comparisons[1]);
    for (const char* name : {"Keep blend", "Undo", "Rename family", "Remove key", "Play", "Step forward"})
        CHECK_FALSE(is_enabled(command_named(name), state));
    for (const char* name : {"Open", "Save", "Quit", "Wireframe", "Frame model", "Keys and mouse"})
        CHECK(is_enabled(command_named(name), state));

    const Coloring before = state.session.display.coloring;
    run_command(command_named("Next coloring"), state, 0);
    CHECK_FALSE(state.compares_colors);
    CHECK(state.session.display.coloring == before);

    state.message.text = "something";
    state.help_shown = true;
    run_command(command_named("Dismiss"), state, 0);
    CHECK(state.message.empty());
    CHECK(state.help_shown);
    run_command(command_named("Dismiss"), state, 0);
    CHECK_FALSE(state.help_shown);
    CHECK(state.is_comparing);
    run_command(command_named("Dismiss"), state, 0);
    CHECK_FALSE(state.is_comparing);
}
