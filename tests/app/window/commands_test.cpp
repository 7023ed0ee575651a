// Tests of the command table: shortcuts, menus and help from the table, and the effects of commands.
#include "app/window/commands.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "app/sample_family.h"
#include "app/window/shortcuts.h"

using namespace interleaf;

namespace {

ViewerState sample_state() {
    return ViewerState(sample_family());
}

constexpr std::array up_commands{CommandId::x_up, CommandId::y_up, CommandId::z_up};

/// Runs the command of \p shortcut at wall time \p now.
void press(ViewerState& state, Shortcut shortcut, double now = 0) {
    const Command* const command = table_shortcuts().find(shortcut);
    REQUIRE(command != nullptr);
    command->run(state, now);
}

}  // namespace

TEST_CASE("the user guide lists every command with its keys") {
    std::ifstream file(USER_GUIDE);
    const std::string guide{std::istreambuf_iterator<char>(file), {}};
    for (const Command& command : commands()) {
        const std::string row = fmt::format("| {} | {} | {} |\n", table_shortcuts().text(command),
                                            command.name, command.description);
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
            if (shortcut.keyboard_key != 0) CHECK(table_shortcuts().find(shortcut) == &command);
        }
    }
}

TEST_CASE("each id leads to its own command") {
    for (const Command& command : commands()) CHECK(&command_of(command.id) == &command);
    CHECK(command_of(CommandId::add_keys).name == "Add keys...");
}

TEST_CASE("the scope of a command says when it is enabled, whatever menu it is in") {
    ViewerState state = sample_state();
    CHECK(is_enabled(CommandId::play, state));
    CHECK_FALSE(is_enabled(CommandId::rename_key, state));
    state.selected_key = 1;
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        if (command.is_possible == nullptr) CHECK(is_enabled(command, state));
    }
    state.is_comparing = true;
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        const bool is_about_window = command.scope == CommandScope::window;
        if (command.is_possible == nullptr) CHECK(is_enabled(command, state) == is_about_window);
    }
}

TEST_CASE("shortcuts are written differently if they differ") {
    std::set<std::string> texts;
    for (const Command& command : commands()) CHECK(texts.insert(table_shortcuts().text(command)).second);
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
    CHECK(table_shortcuts().find({}) == nullptr);
    CHECK(table_shortcuts().find({GLFW_KEY_J, 0}) == nullptr);
    CHECK(table_shortcuts().find({GLFW_KEY_Q, 0}) == nullptr);
    CHECK(table_shortcuts().find({GLFW_KEY_W, GLFW_MOD_CONTROL}) == nullptr);
}

TEST_CASE("what is on or off changes with its command and comes back with the second") {
    for (const Command& command : commands()) {
        if (command.is_on == nullptr) continue;
        if (command.menu == "Blend") continue;  // a choice of several: the tests after this one
        if (std::ranges::find(up_commands, command.id) != up_commands.end()) continue;
        if (command.id == CommandId::follow_path) continue;  // needs a path: path_commands_test.cpp
        CAPTURE(command.name);
        ViewerState state = sample_state();
        const bool before = command.is_on(state);
        command.run(state, 0);
        CHECK(command.is_on(state) != before);
        command.run(state, 0);
        CHECK(command.is_on(state) == before);
    }
}

TEST_CASE("one of the drivers is on, the one whose command ran last") {
    using enum CommandId;
    for (const CommandId chosen : {drive_by_domain, drive_by_weights, show_one_key, drive_by_timeline}) {
        ViewerState state = sample_state();
        run_command(chosen, state, 0);
        for (const CommandId id : {drive_by_timeline, drive_by_domain, show_one_key, drive_by_weights})
            CHECK(command_of(id).is_on(state) == (id == chosen));
    }
}

TEST_CASE("one axis points up, that whose command ran last, Y at first") {
    ViewerState state = sample_state();
    CHECK(command_of(CommandId::y_up).is_on(state));
    for (const CommandId chosen : up_commands) {
        run_command(chosen, state, 0);
        for (const CommandId id : up_commands) CHECK(command_of(id).is_on(state) == (id == chosen));
    }
}

TEST_CASE("each display key switches its own part of the display") {
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
    press(state, {GLFW_KEY_A});
    expected.occlusion = false;
    CHECK(state.session.display == expected);
    press(state, {GLFW_KEY_S});
    expected.shading = Shading::smooth;  // at first, keys of so few leaves are flat
    CHECK(state.session.display == expected);
}

TEST_CASE("colorings come round, that by a field where there is one") {
    for (const bool has_fields : {false, true}) {
        const std::size_t count = colorings(has_fields).size();
        ViewerState state = sample_state();
        if (has_fields) state.session.display.field = "height";
        std::set<Coloring> seen;
        for (std::size_t i = 0; i < count; ++i) {
            seen.insert(state.session.display.coloring);
            press(state, {GLFW_KEY_C});
        }
        CHECK(seen.size() == count);
        CHECK(state.session.display.coloring == Coloring::plain);
    }
}

TEST_CASE("the arrows step by a frame, Home and End go to its ends") {
    ViewerState state = sample_state();
    state.session.frame_rate = 20;
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
    REQUIRE(state.session.weights().size() == 1);
    CHECK(state.session.weights().front().value == 1);
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
    constexpr auto compare_command = CommandId::compare_with_mesh;
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
    CHECK(is_enabled(CommandId::keep_blend, state));
    run_command(compare_command, state, 0);
    CHECK(state.is_comparing);
    CHECK(state.compared == state.comparisons[1]);
    using enum CommandId;
    for (const CommandId id : {keep_blend, undo, rename_family, remove_key, play, step_forward})
        CHECK_FALSE(is_enabled(id, state));
    for (const CommandId id : {open, save, quit, wireframe, frame_model, help}) CHECK(is_enabled(id, state));

    const Coloring before = state.session.display.coloring;
    run_command(CommandId::next_coloring, state, 0);
    CHECK_FALSE(state.compares_colors);
    CHECK(state.session.display.coloring == before);

    state.message.text = "something";
    state.help_shown = true;
    run_command(CommandId::dismiss, state, 0);
    CHECK(state.message.empty());
    CHECK(state.help_shown);
    run_command(CommandId::dismiss, state, 0);
    CHECK_FALSE(state.help_shown);
    CHECK(state.is_comparing);
    run_command(CommandId::dismiss, state, 0);
    CHECK_FALSE(state.is_comparing);
}
