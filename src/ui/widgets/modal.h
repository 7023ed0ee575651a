// What the windows that stand in front of all others are made of: their frame, their buttons, and the
// keyboard. Dear ImGui's own keyboard navigation is off everywhere, so each of them keeps its focus itself.
#pragma once

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
    bool is_main = false;          ///< what Enter does
    bool is_focused = false;       ///< by the keyboard
    bool has_accelerator = false;  ///< its first letter presses it, and is underlined
};

/// \return whether it was clicked
bool modal_button(const ModalButton& button);

/// The width a button with this label wants.
float modal_button_width(const std::string& label);

/// Marks the last item as the one with the keyboard focus.
void draw_focus();

enum class KeyRepeat { no, yes };

/// \param key  a key of GLFW
bool is_key_pressed(int key, KeyRepeat repeat = KeyRepeat::no);

/// Enter, of either part of the keyboard.
bool is_enter_pressed();

/// The letters typed in this frame, UTF-8; without those typed with Ctrl or Alt.
std::string typed_letters();

}  // namespace interleaf
