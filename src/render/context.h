// OpenGL 3.3 core contexts: a GLFW window, and EGL without a display. Either one is current in its thread
// from construction on, with the GL functions loaded and KHR_debug messages collected where the driver has
// them. One of them at a time; what was made in it goes before it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "hierarchy/error.h"

struct GLFWwindow;

namespace interleaf {

/// EGL on the surfaceless platform: draws into an OffscreenTarget, needs no display.
class EglContext {
  public:
    /// \throw MachineError saying which step failed
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
    /// \param width, height  in screen coordinates
    /// \throw DisplayError
    Window(const std::string& title, int width, int height, bool visible = true);
    ~Window();
    Window(Window&& other) noexcept;
    Window& operator=(Window&& other) noexcept;

    GLFWwindow* handle() const;

    /// Size of its framebuffer, pixels.
    glm::ivec2 framebuffer_size() const;

    /// What has been drawn since the last swap, 8-bit RGBA, top row first.
    std::vector<std::uint8_t> read_rgba() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The KHR_debug messages of the current context of severity low and above since the last call, oldest first.
/// A driver may keep only the first few (Mesa ten) between two calls.
std::vector<std::string> take_debug_messages();

}  // namespace interleaf
