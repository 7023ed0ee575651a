// A GLFW window with its context.
#include <optional>
#include <span>

#include <fmt/core.h>
#include <glad/gl.h>
// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "render/context.h"
#include "render/debug_messages.h"
#include "render/read_pixels.h"

namespace interleaf {

struct Window::State {
    GLFWwindow* window = nullptr;

    State(const std::string& title, int width, int height, bool visible);
    ~State() { glfwTerminate(); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

namespace {

[[noreturn]] void fail_window(const char* step) {
    const char* description = nullptr;
    glfwGetError(&description);
    const std::string reason = description != nullptr ? description : step;
    glfwTerminate();
    throw DisplayError(fmt::format("cannot open a window: {}", reason));
}

void hint(bool visible) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    // The surface and its depth are drawn into an offscreen target; the window only receives the picture.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

/// The part of a screen that panels of the desktop leave free; screen coordinates.
struct WorkArea {
    glm::ivec2 corner{};
    glm::ivec2 size{};

    bool contains(glm::ivec2 point) const {
        return glm::all(glm::greaterThanEqual(point, corner)) &&
               glm::all(glm::lessThan(point, corner + size));
    }
};

/// That of the screen with the pointer, where desktops open windows; otherwise of the first screen, if there is any.
std::optional<WorkArea> work_area_for(GLFWwindow* window) {
    glm::ivec2 corner;
    glm::dvec2 pointer;  // from the corner
    glfwGetWindowPos(window, &corner.x, &corner.y);
    glfwGetCursorPos(window, &pointer.x, &pointer.y);
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    std::optional<WorkArea> first;
    for (GLFWmonitor* monitor : std::span(monitors, static_cast<std::size_t>(count))) {
        WorkArea area;
        glfwGetMonitorWorkarea(monitor, &area.corner.x, &area.corner.y, &area.size.x, &area.size.y);
        if (area.contains(corner + glm::ivec2(pointer))) return area;
        if (!first) first = area;
    }
    return first;
}

}  // namespace

Window::State::State(const std::string& title, int width, int height, bool visible) {
    if (glfwInit() == GLFW_FALSE) fail_window("glfwInit");
    hint(visible);
    window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window == nullptr) fail_window("glfwCreateWindow");
    glfwMakeContextCurrent(window);
    if (gladLoadGL(glfwGetProcAddress) == 0) fail_window("loading OpenGL 3.3");
    collect_debug_messages();
}

Window::Window(const std::string& title, int width, int height, bool visible)
    : state_(std::make_unique<State>(title, width, height, visible)) {}
Window::~Window() = default;
Window::Window(Window&& other) noexcept = default;
Window& Window::operator=(Window&& other) noexcept = default;

GLFWwindow* Window::handle() const {
    return state_->window;
}

void Window::resize_within_screen(glm::ivec2 size) {
    if (const auto area = work_area_for(state_->window)) {
        glm::ivec2 before;
        glm::ivec2 after;
        glfwGetWindowFrameSize(state_->window, &before.x, &before.y, &after.x, &after.y);
        size = glm::max(glm::min(size, area->size - before - after), glm::ivec2(1));
    }
    glfwSetWindowSize(state_->window, size.x, size.y);
}

glm::ivec2 Window::framebuffer_size() const {
    glm::ivec2 size;
    glfwGetFramebufferSize(state_->window, &size.x, &size.y);
    return size;
}

std::vector<std::uint8_t> Window::read_rgba() const {
    const glm::ivec2 size = framebuffer_size();
    return read_pixels(0, size.x, size.y);
}

}  // namespace interleaf
