// Tests of the shortcuts that the settings change.
#include "app/window/shortcuts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

using namespace interleaf;

using Remarks = std::vector<std::string>;

TEST_CASE("the shortcuts of every command are read as they are written, in any case") {
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        const std::string text = text_of(command.shortcuts);
        CHECK(parse_shortcuts(text) == command.shortcuts);
    }
    CHECK(parse_shortcuts("") == CommandShortcuts{});
    CHECK(parse_shortcuts("alt+SHIFT+k") ==
          CommandShortcuts{{{GLFW_KEY_K, GLFW_MOD_ALT | GLFW_MOD_SHIFT}, {}}});
}

TEST_CASE("what is no shortcut is refused") {
    for (const char* text : {"Ctrl", "Ctrl+", "Ctrl+Ctrl+K", "Kk", "A or ", " or A", "A or B or C", "Hyper+K",
                             "ä", "\xff", " "}) {
        CAPTURE(text);
        CHECK_FALSE(parse_shortcuts(text));
    }
}

TEST_CASE("a command gets the shortcuts of the settings instead of its own") {
    Shortcuts shortcuts;
    CHECK(shortcuts.change({{"Play", "J or Ctrl+J"}, {"Reload shaders", ""}}).empty());
    CHECK(shortcuts.find({GLFW_KEY_J, 0}) == &command_of(CommandId::play));
    CHECK(shortcuts.find({GLFW_KEY_J, GLFW_MOD_CONTROL}) == &command_of(CommandId::play));
    CHECK(shortcuts.find({GLFW_KEY_SPACE, 0}) == nullptr);
    CHECK(shortcuts.find({GLFW_KEY_F5, 0}) == nullptr);
    CHECK(shortcuts.text(command_of(CommandId::play)) == "J or Ctrl+J");
    CHECK(shortcuts.text(command_of(CommandId::reload_shaders)).empty());
    CHECK(table_shortcuts().find({GLFW_KEY_SPACE, 0}) == &command_of(CommandId::play));
}

TEST_CASE("a command loses a shortcut that the settings give to another one, and that is told") {
    Shortcuts shortcuts;
    CHECK(shortcuts.change({{"Play", "W"}}) == Remarks{"shortcuts: W is for Play, so Wireframe loses it"});
    CHECK(shortcuts.find({GLFW_KEY_W, 0}) == &command_of(CommandId::play));
    CHECK(shortcuts.text(command_of(CommandId::wireframe)) == "1");

    Shortcuts exchanged;
    CHECK(exchanged.change({{"Play", "W"}, {"Wireframe", "Space"}}).empty());
    CHECK(exchanged.find({GLFW_KEY_SPACE, 0}) == &command_of(CommandId::wireframe));

    Shortcuts twice;
    CHECK(twice.change({{"Save", "J"}, {"Open", "J"}}) ==
          Remarks{"shortcuts: J is for Open..., so Save loses it"});
    CHECK(twice.find({GLFW_KEY_J, 0}) == &command_of(CommandId::open));
}

TEST_CASE("entries that cannot be understood have no effect, and are told one line each") {
    Shortcuts shortcuts;
    CHECK(shortcuts.change({{"Plai", "J"}, {"Save", "Strg+S"}}).size() == 2);
    for (const Command& command : commands())
        CHECK(shortcuts.text(command) == table_shortcuts().text(command));
}
