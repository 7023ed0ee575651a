// OpenGL 3.3 core contexts: a GLFW window, and EGL without a display. A context is current in its thread from
// its construction on. Its GL functions are loaded, and it collects KHR_debug messages if the driver supports
// them. Only one context may exist at a time, and its objects must be destroyed before it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "hierarchy/error.h"

struct GLFWwindow;

namespace interleaf {

/// EGL on the surfaceless platform: draws into an OffscreenTarget and needs no display.
class EglContext {
  public:
    /// \throw MachineError naming the step that failed
    EglContext();
    ~EglContext();
    EglContext(EglContext&& other) noexcept;
    EglContext& operator=(EglContext&& other) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// No window can be opened: there is no display, or none with OpenGL 3.3.
struct DisplayError : MachineError {
    using MachineError::MachineError;
};

/// A GLFW window, shown or hidden.
class Window {
  public:
    /// \param width   in screen coordinates
    /// \param height  in screen coordinates
    /// \throw DisplayError if no window can be opened
    Window(const std::string& title, int width, int height, bool visible = true);
    ~Window();
    Window(Window&& other) noexcept;
    Window& operator=(Window&& other) noexcept;

    GLFWwindow* handle() const;

    /// Makes the window \p size, or so much smaller that it and its frame fit onto the screen with the pointer, beside
    /// panels of the desktop; screen coordinates.
    void resize_within_screen(glm::ivec2 size);

    /// Size of the framebuffer in pixels.
    glm::ivec2 framebuffer_size() const;

    /// The picture drawn since the last swap: 8-bit RGBA, top row first.
    std::vector<std::uint8_t> read_rgba() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The KHR_debug messages of the current context since the last call, of severity low and above, oldest
/// first. Between two calls, a driver may keep only the first few (Mesa: ten).
std::vector<std::string> take_debug_messages();

}  // namespace interleaf
