// Dear ImGui on a GLFW window: set up, fed and drawn.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

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

    /// Begins a frame with the input that has come since the last one. Panels that are shown from here on
    /// read it, but are not drawn.
    /// \param pressed  GLFW's keys that were pressed since: those that have been
    /// released again, too
    void begin_frame(std::span<const int> pressed);

    /// Begins to draw the frame: its panels are shown once more, from the state that the input has led to.
    /// Mouse and keys are where they were, but do nothing new. Dear ImGui reads and draws a panel in one
    /// call; without this second pass, a panel would be drawn before the panels after it have been read.
    /// \pre begin_frame() has been called
    void begin_drawing();

    /// Draws the frame over what the window shows.
    /// \pre begin_drawing() has been called
    void end_frame();

    /// Ends a frame in which an exception was thrown, wherever that was: nothing is drawn of it, and the next
    /// one can begin. After end_frame(), and before begin_frame(), it does nothing.
    void abandon_frame();

    /// Whether the mouse did something in this frame, or keys are left for the next frame, so that the next
    /// frame may look different.
    bool has_input() const;

    /// Where this frame has the pointer, in screen coordinates of the window.
    glm::vec2 pointer() const;

    /// Whether this frame has any button of the mouse down.
    bool is_button_down() const;

    /// Whether a text field receives the typed text.
    bool takes_text() const;

    /// Whether a menu, or the list of a box of choices, is or was open in this frame: it has the keyboard.
    /// Arrows move in it, Enter and Space choose, Esc closes it.
    bool has_menu() const { return has_menu_; }

    /// The menu or question in front of all others, in screen coordinates; none unless it is shown.
    std::optional<Rect> popup() const;

    /// Framebuffer pixels per screen coordinate.
    float density() const { return density_; }

    float scale() const { return scale_; }

  private:
    void follow_display();
    void follow_menu();
    void give_keys_to_menu();
    void hold_taps(std::span<const int> pressed);
    void release_taps();

    GLFWwindow* window_;
    float scale_ = 0;  ///< of the user interface, in screen coordinates
    float density_ = 0;
    bool has_menu_ = false;
    bool has_mouse_input_ = false;
    std::vector<int> taps_;          ///< keys that are held down for this frame
    std::vector<int> waiting_taps_;  ///< those for the next ones, in order
};

}  // namespace interleaf
