#include "app/window/window_input.h"

// GLFW must not bring OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>

namespace interleaf {

GLFWwindow* watch_input(GLFWwindow* window, WindowInput& input) {
    glfwSetWindowUserPointer(window, &input);
    glfwSetKeyCallback(window, [](GLFWwindow* source, int key, int, int action, int modifiers) {
        if (action == GLFW_RELEASE) return;
        auto& seen = *static_cast<WindowInput*>(glfwGetWindowUserPointer(source));
        if (action == GLFW_PRESS) seen.keyboard_keys.push_back(key);
        const Shortcut shortcut{key, modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT)};
        const Command* const command = find_command(shortcut);
        if (command == nullptr || (action == GLFW_REPEAT && !command->repeats)) return;
        seen.pressed.push_back(shortcut);
    });
    glfwSetDropCallback(window, [](GLFWwindow* source, int count, const char** paths) {
        auto& dropped = static_cast<WindowInput*>(glfwGetWindowUserPointer(source))->dropped;
        dropped.assign(paths, paths + count);
    });
    return window;
}

}  // namespace interleaf
