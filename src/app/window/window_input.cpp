#include "app/window/window_input.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>

#include "app/brushing/brush_stroke.h"

namespace interleaf {
namespace {

/// What pressing and releasing Alt stands for.
constexpr Shortcut menu_shortcut{GLFW_KEY_F10, 0};

/// The modifiers come first, as they were when \p key was pressed. By the next frame they may be released.
void add_press(std::vector<int>& keys, int key, int modifiers) {
    const bool is_modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
    if (!is_modifier) {
        if ((modifiers & GLFW_MOD_CONTROL) != 0) keys.push_back(GLFW_KEY_LEFT_CONTROL);
        if ((modifiers & GLFW_MOD_SHIFT) != 0) keys.push_back(GLFW_KEY_LEFT_SHIFT);
        if ((modifiers & GLFW_MOD_ALT) != 0) keys.push_back(GLFW_KEY_LEFT_ALT);
    }
    keys.push_back(key);
}

/// Whether a question or a dialog is to open, which may be about a key of the present document.
bool asks(const ViewerState& state) {
    return state.question.has_value() || state.file_wish != FileWish::none || state.film_wish.has_value();
}

/// Whether a menu or a search field is to open, which takes the keys that follow.
bool opens_field(const ViewerState& state) {
    return state.search_wanted || state.find_wanted || state.menu_wanted;
}

}  // namespace

GLFWwindow* watch_input(GLFWwindow* window, WindowInput& input) {
    glfwSetWindowUserPointer(window, &input);
    glfwSetKeyCallback(window, [](GLFWwindow* source, int key, int, int action, int modifiers) {
        auto& seen = *static_cast<WindowInput*>(glfwGetWindowUserPointer(source));
        const bool is_alt = key == GLFW_KEY_LEFT_ALT;
        // GLFW also releases the keys of a window that loses the focus.
        const bool is_tapped = is_alt && action == GLFW_RELEASE && seen.is_alt_alone &&
                               glfwGetWindowAttrib(source, GLFW_FOCUSED) == GLFW_TRUE;
        if (is_tapped && seen.shortcuts.find(menu_shortcut) == &command_of(CommandId::open_menu))
            seen.pressed.push_back(menu_shortcut);
        if (action != GLFW_REPEAT)
            seen.is_alt_alone = is_alt && action == GLFW_PRESS && (modifiers & ~GLFW_MOD_ALT) == 0;
        if (action == GLFW_RELEASE) return;
        if (action == GLFW_PRESS) add_press(seen.keyboard_keys, key, modifiers);
        const Shortcut shortcut{key, modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT)};
        const Command* const command = seen.shortcuts.find(shortcut);
        if (command == nullptr || (action == GLFW_REPEAT && !command->repeats)) return;
        seen.pressed.push_back(shortcut);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* source, int, int, int) {
        static_cast<WindowInput*>(glfwGetWindowUserPointer(source))->is_alt_alone = false;
    });
    glfwSetScrollCallback(window, [](GLFWwindow* source, double, double) {
        static_cast<WindowInput*>(glfwGetWindowUserPointer(source))->is_alt_alone = false;
    });
    glfwSetDropCallback(window, [](GLFWwindow* source, int count, const char** paths) {
        auto& dropped = static_cast<WindowInput*>(glfwGetWindowUserPointer(source))->dropped;
        dropped.assign(paths, paths + count);
    });
    return window;
}

bool is_pointer_over(const Rect& rect, GLFWwindow* window) {
    double x = 0;
    double y = 0;
    glfwGetCursorPos(window, &x, &y);
    return x >= rect.x && x < rect.right() && y >= rect.y && y < rect.bottom();
}

bool belongs_to_panel(Shortcut shortcut) {
    if ((shortcut.modifiers & ~GLFW_MOD_SHIFT) != 0) return false;
    switch (shortcut.keyboard_key) {
        case GLFW_KEY_LEFT:
        case GLFW_KEY_RIGHT:
        case GLFW_KEY_UP:
        case GLFW_KEY_DOWN:
        case GLFW_KEY_SPACE:
        case GLFW_KEY_TAB:
        case GLFW_KEY_ESCAPE:
        case GLFW_KEY_HOME:
        case GLFW_KEY_END:
        case GLFW_KEY_PAGE_UP:
        case GLFW_KEY_PAGE_DOWN:
            return true;
        default:
            return false;
    }
}

bool belongs_to_domain(Shortcut shortcut, const ViewerState& state) {
    if (!state.domain_has_focus || state.is_comparing || !state.document.family().domain) return false;
    if ((shortcut.modifiers & ~GLFW_MOD_SHIFT) != 0) return false;
    switch (shortcut.keyboard_key) {
        case GLFW_KEY_LEFT:
        case GLFW_KEY_RIGHT:
        case GLFW_KEY_UP:
        case GLFW_KEY_DOWN:
            return true;
        case GLFW_KEY_DELETE:
            return state.edits_domain && state.selected_path_point.has_value();
        default:
            return false;
    }
}

bool belongs_to_brush(Shortcut shortcut, const ViewerState& state) {
    const bool is_bracket =
        shortcut.keyboard_key == GLFW_KEY_LEFT_BRACKET || shortcut.keyboard_key == GLFW_KEY_RIGHT_BRACKET;
    return is_bracket && (shortcut.modifiers & ~GLFW_MOD_SHIFT) == 0 && brushed_key(state).has_value();
}

std::vector<Shortcut> run_pressed(std::span<const Shortcut> pressed, const Shortcuts& shortcuts,
                                  ViewerState& state, double now) {
    for (auto next = pressed.begin(); next != pressed.end(); ++next) {
        if (asks(state) || opens_field(state)) return {next, pressed.end()};
        if (!belongs_to_domain(*next, state) && !belongs_to_brush(*next, state))
            run_command(*shortcuts.find(*next), state, now);
    }
    return {};
}

}  // namespace interleaf
