#include "ui/widgets/short_name.h"

#include <algorithm>

#include <imgui_internal.h>

#include "text/characters.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

constexpr std::string_view omission = "…";

/// The characters of \p text from \p begin on, \p size bytes or less: no character is cut.
std::string_view head_of(std::string_view text, std::size_t size) {
    while (size > 0 && size < text.size() && continues_character(text[size])) --size;
    return text.substr(0, size);
}

std::string_view tail_of(std::string_view text, std::size_t size) {
    std::size_t begin = text.size() - size;
    while (begin < text.size() && continues_character(text[begin])) ++begin;
    return text.substr(begin);
}

/// \p name with about \p kept bytes left of it.
std::string cut_to(std::string_view name, std::size_t kept) {
    std::string text(head_of(name, kept - kept / 2));
    text += omission;
    text += tail_of(name, kept / 2);
    return text;
}

}  // namespace

std::string shortened(std::string_view name, float max_width) {
    if (text_size(name).x <= max_width) return std::string(name);
    std::size_t fits = 0;  // bytes
    std::size_t too_many = name.size();
    while (fits + 1 < too_many) {
        const std::size_t middle = (fits + too_many) / 2;
        (text_size(cut_to(name, middle)).x <= max_width ? fits : too_many) = middle;
    }
    return cut_to(name, fits);
}

bool name_item(std::string_view name, float max_width, bool is_chosen) {
    const glm::vec2 size = text_size(shortened(name, max_width));
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    // As wide as the menu, which is at least as wide as the name.
    const bool is_pressed = ImGui::Selectable("##name", is_chosen, ImGuiSelectableFlags_SpanAvailWidth,
                                              {std::max(size.x, 1.0F), 0});
    if (ImGui::IsItemVisible()) draw_name(corner, max_width, colors::text, name);
    return is_pressed;
}

void draw_name(glm::vec2 position, float max_width, ImU32 color, std::string_view name) {
    const std::string text = shortened(name, max_width);
    draw_text(position, max_width + 1, color, text);
    if (text == name || !ImGui::IsWindowHovered()) return;
    const ImVec2 end{position.x + max_width, position.y + ImGui::GetTextLineHeight()};
    if (ImGui::IsMouseHoveringRect(to_imgui(position), end))
        ImGui::SetTooltip("%.*s", static_cast<int>(name.size()), name.data());
}

}  // namespace interleaf
