// The text of shortcuts in menus, in the help and in the settings.
#define GLFW_INCLUDE_NONE

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "app/window/commands.h"
#include "text/characters.h"

namespace interleaf {

namespace {

std::string keyboard_key_text(int key) {
    switch (key) {
        case GLFW_KEY_SPACE:
            return "Space";
        case GLFW_KEY_TAB:
            return "Tab";
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

/// Whether keyboard_key_text() names \p key.
bool has_text(int key) {
    const bool is_letter = key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT;
    const bool is_named = key >= GLFW_KEY_ESCAPE && keyboard_key_text(key).size() > 1;
    return key == GLFW_KEY_SPACE || is_letter || is_named;
}

constexpr std::array<std::pair<std::string_view, int>, 3> modifier_names{
    {{"ctrl+", GLFW_MOD_CONTROL}, {"shift+", GLFW_MOD_SHIFT}, {"alt+", GLFW_MOD_ALT}}};

}  // namespace

std::string shortcut_text(Shortcut shortcut) {
    std::string text;
    if ((shortcut.modifiers & GLFW_MOD_CONTROL) != 0) text += "Ctrl+";
    if ((shortcut.modifiers & GLFW_MOD_SHIFT) != 0) text += "Shift+";
    if ((shortcut.modifiers & GLFW_MOD_ALT) != 0) text += "Alt+";
    return text + keyboard_key_text(shortcut.keyboard_key);
}

std::optional<Shortcut> parse_shortcut(std::string_view text) {
    const std::string whole = folded(text);
    std::string_view rest = whole;
    Shortcut shortcut;
    for (bool is_found = true; is_found;) {
        is_found = false;
        for (const auto& [name, modifier] : modifier_names) {
            if (!rest.starts_with(name) || (shortcut.modifiers & modifier) != 0) continue;
            rest.remove_prefix(name.size());
            shortcut.modifiers |= modifier;
            is_found = true;
        }
    }
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
        if (!has_text(key) || folded(keyboard_key_text(key)) != rest) continue;
        shortcut.keyboard_key = key;
        return shortcut;
    }
    return std::nullopt;
}

}  // namespace interleaf
