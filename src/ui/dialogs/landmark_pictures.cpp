#include "ui/dialogs/landmark_pictures.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "ui/widgets/style.h"

namespace interleaf {
namespace {

float mark_radius() {
    return scaled(8);
}

/// Movements of the pointer below this are no drag.
float drag_threshold() {
    return scaled(4);
}

void draw_mark(ImDrawList& list, glm::vec2 at, const LandmarkMark& mark) {
    const float radius = mark_radius();
    const float opacity = mark.is_hidden ? 0.35F : 1;
    const auto faded = [&](ImU32 color, float by = 1) {
        ImVec4 parts = ImGui::ColorConvertU32ToFloat4(color);
        parts.w *= opacity * by;
        return ImGui::ColorConvertFloat4ToU32(parts);
    };
    if (mark.glows) {
        list.AddCircleFilled(to_imgui(at), 2.1F * radius, faded(colors::notice, 0.22F));
        list.AddCircleFilled(to_imgui(at), 1.5F * radius, faded(colors::notice, 0.35F));
    }
    list.AddCircleFilled(to_imgui(at), radius, faded(mark.color));
    list.AddCircle(to_imgui(at), radius, faded(mark.is_selected ? colors::white : colors::dark), 0,
                   scaled(mark.is_selected ? 2.5F : 1.2F));
    ImGui::PushFont(small_font());
    const glm::vec2 size = text_size(mark.text);
    list.AddText({std::round(at.x - size.x / 2), std::round(at.y - size.y / 2)}, faded(colors::dark),
                 mark.text.c_str());
    ImGui::PopFont();
}

void draw_proposal(ImDrawList& list, glm::vec2 at, bool is_chosen) {
    const float radius = mark_radius() * 0.75F;
    list.AddCircle(to_imgui(at), radius, colors::dark, 0, scaled(3.5F));
    list.AddCircle(to_imgui(at), radius, colors::white, 0, scaled(1.5F));
    if (is_chosen) list.AddCircle(to_imgui(at), 1.8F * radius, colors::accent, 0, scaled(2));
}

/// The nearest of \p places to \p pointer, within reach.
template <typename Places, typename PlaceOf>
std::optional<std::size_t> nearest_within_reach(const Places& places, glm::vec2 pointer, PlaceOf&& place_of) {
    std::optional<std::size_t> nearest;
    float least = 1.3F * mark_radius();
    for (std::size_t k = 0; k < places.size(); ++k) {
        const float distance = glm::distance(place_of(places[k]), pointer);
        if (distance >= least) continue;
        least = distance;
        nearest = k;
    }
    return nearest;
}

}  // namespace

LandmarkPictureInput landmark_picture(const char* name, glm::vec2 size, const LandmarkPictureShown& shown,
                                      LandmarkHold& hold) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    ImGui::InvisibleButton(name, to_imgui(size),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = to_imgui(corner + size);
    list.AddRectFilled(to_imgui(corner), end, colors::well, scaled(3));
    if (shown.texture != 0) list.AddImage(texture_id(shown.texture), to_imgui(corner), end);
    list.AddRect(to_imgui(corner), end, shown.is_active ? colors::accent : colors::faint_line, scaled(3), 0,
                 scaled(1.2F));
    list.PushClipRect(to_imgui(corner), end, true);
    const auto on_screen = [&](glm::vec2 place) { return corner + place * size; };
    for (std::size_t k = 0; k < shown.proposals.size(); ++k)
        draw_proposal(list, on_screen(shown.proposals[k]), shown.chosen_proposal == k);
    for (const LandmarkMark& mark : shown.marks)
        if (!mark.is_selected) draw_mark(list, on_screen(mark.place), mark);
    for (const LandmarkMark& mark : shown.marks)
        if (mark.is_selected) draw_mark(list, on_screen(mark.place), mark);
    draw_text({corner.x + scaled(8), corner.y + scaled(5)}, size.x - scaled(16), colors::text, shown.title);
    if (!shown.remark.empty()) {
        ImGui::PushFont(small_font());
        draw_text({corner.x + scaled(8), corner.y + size.y - ImGui::GetTextLineHeight() - scaled(5)},
                  size.x - scaled(16), colors::dim_text, shown.remark);
        ImGui::PopFont();
    }
    list.PopClipRect();

    LandmarkPictureInput input;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 pointer = from_imgui(io.MousePos);
    input.pointer = (pointer - corner) / size;
    if (ImGui::IsItemHovered()) input.zoom = std::pow(1.12F, io.MouseWheel);
    if (ImGui::IsItemActivated()) {
        const auto mark = nearest_within_reach(
            shown.marks, pointer, [&](const LandmarkMark& each) { return on_screen(each.place); });
        hold = {.pressed_at = pointer,
                .has_moved = false,
                .is_left = ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift,
                .mark = mark ? std::optional(shown.marks[*mark].index) : std::nullopt};
        input.selected = hold.mark;
    } else if (ImGui::IsItemActive()) {
        const bool moves = hold.has_moved || glm::distance(pointer, hold.pressed_at) > drag_threshold();
        const bool begins = moves && !hold.has_moved;
        hold.has_moved = moves;
        const glm::vec2 by = (begins ? pointer - hold.pressed_at : from_imgui(io.MouseDelta)) / size.y;
        if (moves && by != glm::vec2(0)) {
            if (hold.is_left && hold.mark) {
                input.dragged = hold.mark;
                input.drag_begins = begins;
            } else {
                (hold.is_left ? input.orbit : input.pan) = by;
            }
        }
    } else if (ImGui::IsItemDeactivated() && hold.is_left && !hold.has_moved && !hold.mark) {
        input.proposal = nearest_within_reach(shown.proposals, pointer, on_screen);
        input.is_clicked = !input.proposal;
    }
    return input;
}

}  // namespace interleaf
