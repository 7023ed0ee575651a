// The text of shortcuts in menus and help.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "app/window/commands.h"

namespace interleaf {

namespace {

std::string keyboard_key_text(int key) {
    switch (key) {
        case GLFW_KEY_SPACE:
            return "Space";
        case GLFW_KEY_HOME:
            return "Home";
        case GLFW_KEY_END:
            return "End";
        case GLFW_KEY_LEFT:
            return "Left";
        case GLFW_KEY_RIGHT:
            return "Right";
        case GLFW_KEY_PAGE_UP:
            return "Page Up";
        case GLFW_KEY_PAGE_DOWN:
            return "Page Down";
        case GLFW_KEY_ESCAPE:
            return "Esc";
        case GLFW_KEY_BACKSPACE:
            return "Backspace";
        case GLFW_KEY_DELETE:
            return "Del";
        case GLFW_KEY_UP:
            return "Up";
        case GLFW_KEY_DOWN:
            return "Down";
        case GLFW_KEY_KP_ADD:
            return "Num +";
        case GLFW_KEY_KP_SUBTRACT:
            return "Num -";
        default:
            break;
    }
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return fmt::format("Num {}", key - GLFW_KEY_KP_0);
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
    return {static_cast<char>(key)};  // GLFW's numbers of letters and digits are their ASCII codes
}

std::string shortcut_text(Shortcut shortcut) {
    std::string text;
    if ((shortcut.modifiers & GLFW_MOD_CONTROL) != 0) text += "Ctrl+";
    if ((shortcut.modifiers & GLFW_MOD_SHIFT) != 0) text += "Shift+";
    if ((shortcut.modifiers & GLFW_MOD_ALT) != 0) text += "Alt+";
    return text + keyboard_key_text(shortcut.keyboard_key);
}

}  // namespace

std::string shortcut_text(const Command& command) {
    std::string text;
    for (const Shortcut shortcut : command.shortcuts) {
        if (shortcut.keyboard_key == 0) continue;
        if (!text.empty()) text += " or ";
        text += shortcut_text(shortcut);
    }
    return text;
}

}  // namespace interleaf
