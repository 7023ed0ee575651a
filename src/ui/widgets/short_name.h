// Names that may be too long for their place: cut in the middle, because names often differ at their end. The whole
// name appears beside the pointer.
#pragma once

#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <imgui.h>

namespace interleaf {

/// \p name, or its begin and its end around an ellipsis, at most \p max_width wide in the current font.
std::string shortened(std::string_view name, float max_width);

/// Draws \p name from \p position on, shortened to \p max_width. While the pointer is at a shortened name, a tooltip
/// shows the whole name.
void draw_name(glm::vec2 position, float max_width, ImU32 color, std::string_view name);

/// Shows an entry of a menu or of a list: a name, which may also hold what Dear ImGui hides in labels.
/// \pre  the present identifier differs from those of the entries beside it
/// \return whether it was chosen
bool name_item(std::string_view name, float max_width, bool is_chosen = false);

}  // namespace interleaf
