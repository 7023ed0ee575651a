// The parts of modal windows, which stand in front of all others: frame, buttons and keyboard. Dear ImGui's
// own keyboard navigation is off in them, so each modal window keeps its focus itself.
#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

/// Begins a window in the middle of \p area. Everything else is dimmed and gets no input.
/// \param size  the preferred size
/// \return whether the window is shown; if so, draw its content and call end_modal()
bool begin_modal(const char* name, const Rect& area, glm::vec2 size);

/// \param closing  whether this was the last frame of the window
void end_modal(bool closing);

struct ModalButton {
    const char* label;
    float width;
    bool is_main = false;          ///< Enter presses this button
    bool is_focused = false;       ///< has the keyboard focus
    bool has_accelerator = false;  ///< its first letter presses it, and is underlined
};

/// \return whether it was clicked
bool modal_button(const ModalButton& button);

/// The last row of a dialog that can be canceled: at its right end the main button, which Enter presses, and Cancel.
/// \param label  of the main button
/// \return       true if the user has clicked the main button, false for Cancel; none for neither
std::optional<bool> main_and_cancel(const char* label, bool is_main_focused, bool is_cancel_focused);

/// The preferred width of a button with this label.
float modal_button_width(const std::string& label);

/// Draws the frame of the keyboard focus around the last item.
void draw_focus();

enum class KeyRepeat { no, yes };

/// \param key  a GLFW key
bool is_key_pressed(int key, KeyRepeat repeat = KeyRepeat::no);

/// Whether Enter was pressed, on the main keyboard or the keypad.
bool is_enter_pressed();

/// The letters typed in this frame, in UTF-8, without letters typed with Ctrl or Alt.
std::string typed_letters();

}  // namespace interleaf
