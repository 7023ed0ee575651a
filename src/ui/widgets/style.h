// The look of the user interface: spacing, the two sizes of its typeface, and the elements that all panels share.
// theme.h has the colors.
#pragma once

#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <imgui.h>

#include "ui/widgets/rect.h"
#include "ui/widgets/theme.h"

namespace interleaf {

/// Sets Dear ImGui's style and makes the fonts.
/// \param scale  scale of the user interface
/// \param density  framebuffer pixels per screen coordinate
void apply_style(float scale, float density);

/// Converts \p length from scale 1 to screen coordinates at the current scale.
float scaled(float length);

/// The font for headings, legends and marks.
ImFont* small_font();

/// Dear ImGui's identifier of the OpenGL texture \p name.
ImTextureID texture_id(unsigned name);

ImU32 to_color(glm::vec3 color, float alpha = 1);
ImVec2 to_imgui(glm::vec2 point);
glm::vec2 from_imgui(ImVec2 point);

/// Begins a window that fills \p rect. Call end_panel() to end it.
void begin_panel(const char* name, const Rect& rect);
void end_panel();

/// An area for the mouse alone, which the keyboard does not reach.
/// \return whether it was pressed
bool mouse_area(const char* name, glm::vec2 size, ImGuiButtonFlags flags = 0);

/// Whether a panel has the keyboard, so that the focus is visible.
bool shows_focus();

/// Adds the gap between two parts of a panel.
void section_gap();

/// Shows a heading above a part of a panel, with \p remark at its right end.
void heading(std::string_view title, std::string_view remark = {});

/// Draws \p text from \p position on. An ellipsis cuts it off at \p max_width.
void draw_text(glm::vec2 position, float max_width, ImU32 color, std::string_view text);

/// Width and height of \p text in the current font.
glm::vec2 text_size(std::string_view text);

/// Shows \p text, wrapped to the width of the window.
void wrapped_text(std::string_view text, ImU32 color);

/// Height of \p text when it is wrapped to \p width; 0 if it is empty.
float wrapped_height(std::string_view text, float width);

}  // namespace interleaf
