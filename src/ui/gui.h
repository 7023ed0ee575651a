// Runs Dear ImGui in a GLFW window: sets it up, passes the input to it, and draws it.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "ui/panel_keyboard.h"
#include "ui/widgets/appearance.h"
#include "ui/widgets/gui_state.h"
#include "ui/widgets/rect.h"

struct GLFWwindow;

namespace interleaf {

/// Only one object may exist at a time. Install your own GLFW callbacks before you create it: it passes
/// events on to them.
class Gui {
  public:
    /// \pre the window's context is current
    /// \throw MachineError when Dear ImGui cannot draw into it
    explicit Gui(GLFWwindow* window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Shows everything as \p appearance says from the next frame on, but for its sizes of panels.
    /// Closed sections are taken from \p appearance only once: afterwards the user closes and opens them.
    void follow(const Appearance& appearance);

    /// Tells the widgets the keys of commands by their names (command_keys.h).
    void set_command_keys(std::map<std::string, std::string, std::less<>> keys) {
        state_.command_keys = std::move(keys);
    }

    /// Titles of the sections that are closed now.
    std::vector<std::string> closed_sections() const;

    /// Begins a frame with the input since the last frame. Panels shown after this call read the input, but
    /// are not drawn.
    /// \param pressed  GLFW keys that were pressed since the last frame, including keys already released
    void begin_frame(std::span<const int> pressed);

    /// Begins to draw the frame: its panels are shown a second time, from the state after the input. Mouse
    /// and keys keep their state, but cause no new events. Dear ImGui reads and draws a panel in one call;
    /// without this second pass, a panel would be drawn before the panels after it have been read.
    /// \pre begin_frame() has been called
    void begin_drawing();

    /// Draws the frame over the content of the window.
    /// \pre begin_drawing() has been called
    void end_frame();

    /// Ends a frame in which an exception was thrown at any point. Draws nothing of the frame; the next frame
    /// can begin. Between end_frame() and begin_frame() it does nothing.
    void abandon_frame();

    /// Whether the mouse was used in this frame, or keys wait for the next frame. The next frame may then
    /// look different.
    bool has_input() const;

    /// Position of the pointer in this frame, in screen coordinates of the window.
    glm::vec2 pointer() const;

    /// Whether any mouse button is down in this frame.
    bool is_button_down() const;

    /// Whether a text field receives the typed text.
    bool takes_text() const;

    /// Whether a menu or the list of a combo box is or was open in this frame. It then receives the keyboard:
    /// arrows move in it, Enter and Space choose, Esc closes it.
    bool has_menu() const { return has_menu_; }

    /// The keyboard in the panels.
    PanelKeyboard& panel_keyboard() { return panel_keyboard_; }

    /// The rectangle of the frontmost menu or question, in screen coordinates; none if it is not shown.
    std::optional<Rect> popup() const;

    /// Framebuffer pixels per screen coordinate.
    float density() const { return density_; }

    float scale() const { return scale_; }

  private:
    void follow_display();
    void add_glyphs();
    void follow_menu();
    void give_keys();
    void hold_taps(std::span<const int> pressed);
    void release_taps();

    GLFWwindow* window_;
    GuiState state_;
    bool has_sections_ = false;  ///< whether state_ has the closed sections of the appearance
    float text_scale_ = 1;
    float scale_ = 0;  ///< scale of the user interface, in screen coordinates; includes text_scale_
    float density_ = 0;
    bool has_menu_ = false;
    PanelKeyboard panel_keyboard_;
    bool has_mouse_input_ = false;
    std::vector<int> taps_;          ///< keys held down for this frame
    std::vector<int> waiting_taps_;  ///< keys for the next frames, in order
};

}  // namespace interleaf
