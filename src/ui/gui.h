// Dear ImGui on a GLFW window: set up, fed and drawn.
#pragma once

#include <glm/vec2.hpp>

struct GLFWwindow;

namespace interleaf {

/// One at a time. Install own GLFW callbacks before it: it passes events on to them.
class Gui {
  public:
    /// \pre the window's context is current
    /// \throw MachineError when Dear ImGui cannot draw into it
    explicit Gui(GLFWwindow* window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Begins a frame with the input that has come since the last one.
    void begin_frame();

    /// Draws the frame over what the window shows.
    void end_frame();

    /// Whether this frame has seen the mouse do something, so that a next frame may look different.
    bool has_input() const;

    /// Where this frame has the pointer, in screen coordinates of the window.
    glm::vec2 pointer() const;

    /// Whether this frame has any button of the mouse down.
    bool is_button_down() const;

    /// Whether a text is being typed, so that keys are no commands.
    bool takes_text() const;

    /// Framebuffer pixels a screen coordinate.
    float density() const { return density_; }

    float scale() const { return scale_; }

  private:
    void follow_display();

    GLFWwindow* window_;
    float scale_ = 0;  ///< of the user interface, in screen coordinates
    float density_ = 0;
};

}  // namespace interleaf
