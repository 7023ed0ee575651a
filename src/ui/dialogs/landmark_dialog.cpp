#include "ui/dialogs/landmark_dialog.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"

namespace interleaf {
namespace {

/// How far a key moves the slider.
constexpr float slider_step = 0.1F;

/// How far a key turns a mesh, as a drag in heights of the picture does: 5 degrees.
constexpr float turn_step = 5.0F / 180;

/// How far a key moves a landmark, in heights of the picture.
constexpr float move_step = 0.01F;

constexpr float zoom_step = 1.12F;

constexpr const char* hint =
    "Click a point, then its partner on the other mesh. Drag a number to move it, drag elsewhere to turn.";
constexpr const char* keys_help =
    "Up, Down: select    F2: rename    Delete: remove    Ctrl+Z, Ctrl+Y: undo, redo\n"
    "Left, Right: choose a picture    Page Up, Page Down: show another mesh on the right\n"
    "N: next proposal    Space: accept it    Insert: set a point in the middle of the picture\n"
    "Shift + arrows: turn    Ctrl + arrows: move the selected point    Ctrl + -, +: zoom\n"
    "S: swap sides    C: checker    T: turn together    -, +: move the blend\n"
    "Ctrl+O, Ctrl+S: load or save landmarks of the mesh\n"
    "Enter: use the landmarks    Esc: leave them as they were";

float column_width(float window_width) {
    return std::clamp(0.25F * window_width, scaled(196), scaled(300));
}

/// The arrow keys that were just pressed, x to the right, y down.
glm::vec2 pressed_arrows(KeyRepeat repeat) {
    const auto along = [&](int back, int forth) {
        return (is_key_pressed(forth, repeat) ? 1.0F : 0.0F) - (is_key_pressed(back, repeat) ? 1.0F : 0.0F);
    };
    return {along(GLFW_KEY_LEFT, GLFW_KEY_RIGHT), along(GLFW_KEY_UP, GLFW_KEY_DOWN)};
}

/// 1 if plus was just pressed, -1 if minus was, on the main keyboard or the keypad.
float pressed_sign() {
    const auto is_either_pressed = [](int key, int keypad) {
        return is_key_pressed(key, KeyRepeat::yes) || is_key_pressed(keypad, KeyRepeat::yes);
    };
    return (is_either_pressed(GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD) ? 1.0F : 0.0F) -
           (is_either_pressed(GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT) ? 1.0F : 0.0F);
}

/// A button that is dimmed, and does nothing, unless \p is_enabled.
bool small_button(const char* label, float width, bool is_enabled, const char* tip) {
    ImGui::BeginDisabled(!is_enabled);
    const bool is_pressed = ImGui::Button(label, {width, 0});
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", tip);
    return is_pressed;
}

}  // namespace

bool LandmarkDialogResult::is_any() const {
    return sides[0].is_any() || sides[1].is_any() || blend.is_any() || selected || other || name || closes ||
           side || steps_proposal != 0 || accepts_proposal || removes || swaps || undoes || redoes || loads ||
           saves;
}

void LandmarkDialog::open() {
    assert(!is_open_);
    *this = LandmarkDialog();
    is_open_ = is_new_ = true;
}

LandmarkDialogResult LandmarkDialog::show(const Rect& area, const LandmarkDialogShown& shown) {
    LandmarkDialogResult result;
    if (!is_open_) return result;
    if (begin_modal("landmarks", area, {area.width, area.height})) {
        const bool is_new = std::exchange(is_new_, false);
        if (!is_new) read_keys(shown, result);
        const glm::vec2 room = from_imgui(ImGui::GetContentRegionAvail());
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float column = column_width(room.x);
        const float foot = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y;
        side_size_ = {std::floor((room.x - column - 2 * gap) / 2), room.y - foot};
        for (std::size_t side = 0; side < 2; ++side) {
            LandmarkPictureShown picture = shown.sides[side];
            picture.is_active = side == side_;
            result.sides[side] =
                landmark_picture(side == 0 ? "first" : "other", side_size_, picture, holds_[side]);
            if (result.sides[side].is_any()) side_ = side;
            if (result.sides[side].is_any()) edits_name_ = false;
            ImGui::SameLine();
        }
        if (!is_new && !edits_name_ && !result.sides[side_].is_any())
            result.sides[side_] = read_picture_keys(shown.sides[side_]);
        ImGui::PushStyleColor(ImGuiCol_ChildBg, IM_COL32(0, 0, 0, 0));
        ImGui::BeginChild("column", {column, side_size_.y}, false, ImGuiWindowFlags_NoNav);
        show_column(shown, result);
        ImGui::EndChild();
        ImGui::PopStyleColor();
        show_foot(shown, result);
        end_modal(result.closes.has_value());
    }
    if (result.closes) is_open_ = false;
    return result;
}

// ---- keyboard ----

void LandmarkDialog::read_keys(const LandmarkDialogShown& shown, LandmarkDialogResult& result) {
    const bool has_control = ImGui::GetIO().KeyCtrl;
    if (edits_name_) {
        if (is_key_pressed(GLFW_KEY_ESCAPE)) {
            edits_name_ = false;
            named_.reset();
        }
        return;
    }
    if (is_key_pressed(GLFW_KEY_ESCAPE)) result.closes = false;
    if (is_enter_pressed()) result.closes = true;
    if (has_control && is_key_pressed(GLFW_KEY_Z, KeyRepeat::yes))
        (ImGui::GetIO().KeyShift ? result.redoes : result.undoes) = true;
    if (has_control && is_key_pressed(GLFW_KEY_Y, KeyRepeat::yes)) result.redoes = true;
    if (has_control && is_key_pressed(GLFW_KEY_O)) result.loads = side_;
    if (has_control && is_key_pressed(GLFW_KEY_S) && shown.can_save[side_]) result.saves = side_;
    if (has_control) return;
    if (is_key_pressed(GLFW_KEY_DELETE) || is_key_pressed(GLFW_KEY_BACKSPACE)) result.removes = true;
    if (is_key_pressed(GLFW_KEY_F2)) edits_name_ = shown.selected.has_value();
    const std::size_t count = shown.rows.size();
    const glm::vec2 arrows = ImGui::GetIO().KeyShift ? glm::vec2(0) : pressed_arrows(KeyRepeat::yes);
    if (count > 0 && arrows.y > 0) result.selected = shown.selected ? (*shown.selected + 1) % count : 0;
    if (count > 0 && arrows.y < 0)
        result.selected = shown.selected ? (*shown.selected + count - 1) % count : count - 1;
    if (arrows.x != 0) result.side = side_ = arrows.x > 0 ? 1 : 0;
    const std::size_t others = shown.others.size();
    if (others > 1 && is_key_pressed(GLFW_KEY_PAGE_DOWN)) result.other = (shown.other + 1) % others;
    if (others > 1 && is_key_pressed(GLFW_KEY_PAGE_UP)) result.other = (shown.other + others - 1) % others;
    if (is_key_pressed(GLFW_KEY_N, KeyRepeat::yes)) result.steps_proposal = ImGui::GetIO().KeyShift ? -1 : 1;
    if (is_key_pressed(GLFW_KEY_SPACE)) result.accepts_proposal = true;
    if (is_key_pressed(GLFW_KEY_S)) result.swaps = shown.can_swap;
    if (is_key_pressed(GLFW_KEY_C)) has_checker_ = !has_checker_;
    if (is_key_pressed(GLFW_KEY_T)) turns_together_ = !turns_together_;
    blend_ = std::clamp(blend_ + slider_step * pressed_sign(), 0.0F, 1.0F);
}

/// What the keyboard does in \p picture, as if the mouse did it there.
LandmarkPictureInput LandmarkDialog::read_picture_keys(const LandmarkPictureShown& picture) const {
    LandmarkPictureInput input;
    input.pointer = glm::vec2(0.5F);
    const ImGuiIO& io = ImGui::GetIO();
    if (is_key_pressed(GLFW_KEY_INSERT)) input.is_clicked = true;
    const glm::vec2 arrows = pressed_arrows(KeyRepeat::yes);
    if (io.KeyShift) input.orbit = turn_step * arrows;
    if (!io.KeyCtrl) return input;
    input.zoom = std::pow(zoom_step, pressed_sign());
    const auto mark = std::ranges::find_if(picture.marks, &LandmarkMark::is_selected);
    if (arrows == glm::vec2(0) || mark == picture.marks.end() || mark->is_hidden) return input;
    input.dragged = mark->index;
    input.drag_begins = pressed_arrows(KeyRepeat::no) != glm::vec2(0);
    input.pointer = mark->place + move_step * arrows / glm::vec2(side_size_.x / side_size_.y, 1);
    return input;
}

// ---- the column ----

void LandmarkDialog::show_column(const LandmarkDialogShown& shown, LandmarkDialogResult& result) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float line = ImGui::GetFrameHeight() + spacing;
    const float room = ImGui::GetContentRegionAvail().y;
    const float width = ImGui::GetContentRegionAvail().x;
    if (shown.others.size() > 1) {
        ImGui::SetNextItemWidth(width);
        if (ImGui::BeginCombo("##other", shown.others[shown.other].c_str())) {
            for (std::size_t k = 0; k < shown.others.size(); ++k) {
                const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
                ImGui::PushID(static_cast<int>(k));
                if (ImGui::Selectable("", k == shown.other)) result.other = k;
                draw_text(corner, ImGui::GetItemRectSize().x, colors::text, shown.others[k]);
                ImGui::PopID();
            }
            ImGui::EndCombo();
        }
    }
    blend_size_ = {width, std::round(std::min(width, 0.36F * room))};
    const float below = 5 * line + blend_size_.y + spacing;
    show_rows(shown, result, std::max(ImGui::GetContentRegionAvail().y - below, 2 * line));
    show_name(shown, result);
    show_edits(shown, result);
    show_blend(shown, result);
}

void LandmarkDialog::show_rows(const LandmarkDialogShown& shown, LandmarkDialogResult& result, float height) {
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colors::well);
    ImGui::BeginChild("rows", {0, height}, false, ImGuiWindowFlags_NoNav);
    const float left = scaled(6);
    for (std::size_t k = 0; k < shown.rows.size(); ++k) {
        const LandmarkRow& row = shown.rows[k];
        ImGui::PushID(static_cast<int>(k));
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        const float width = ImGui::GetContentRegionAvail().x;
        if (ImGui::Selectable("", shown.selected == k, 0, {0, ImGui::GetTextLineHeight()}))
            result.selected = k;
        const float radius = scaled(4);
        ImGui::GetWindowDrawList()->AddCircleFilled(
            {corner.x + left + radius, corner.y + ImGui::GetTextLineHeight() / 2}, radius, row.color);
        std::string label = fmt::format("{}", k + 1);
        if (label != row.name) label += "  " + row.name;
        const float begin = left + 2 * radius + scaled(6);
        const float state = row.state.empty() ? 0 : std::min(text_size(row.state).x, 0.5F * width);
        draw_text({corner.x + begin, corner.y}, width - begin - state - scaled(8), colors::text, label);
        draw_text({corner.x + width - state - scaled(2), corner.y}, state, colors::notice, row.state);
        ImGui::PopID();
    }
    const auto tell = [&](const std::string& text, ImU32 color) {
        ImGui::Indent(left);
        wrapped_text(text, color);
        ImGui::Unindent(left);
    };
    if (shown.rows.empty())
        tell("No landmarks yet. Hollow points are proposals: click them to use them.", colors::dim_text);
    for (const std::string& warning : shown.warnings) tell(warning, colors::notice);
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void LandmarkDialog::show_name(const LandmarkDialogShown& shown, LandmarkDialogResult& result) {
    if (!shown.selected) {
        named_.reset();
        edits_name_ = false;
        draw_text(from_imgui(ImGui::GetCursorScreenPos()), ImGui::GetContentRegionAvail().x, colors::dim_text,
                  shown.rows.empty() ? "" : "Select a landmark to rename it.");
        ImGui::Dummy({0, ImGui::GetFrameHeight()});
        return;
    }
    const std::string& name = shown.rows[*shown.selected].name;
    if (named_ != shown.selected || (!edits_name_ && name_.text() != name)) {
        named_ = shown.selected;
        name_.set(name, name.size());
    }
    const TextFieldResult field =
        name_.show("##landmark name", "name", ImGui::GetContentRegionAvail().x, edits_name_);
    if (field.clicked) edits_name_ = true;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Name of the landmark (F2)");
    if (!field.entered && !field.tabbed) return;
    edits_name_ = false;
    if (shown.name_fault.empty()) result.name = name_.text();
}

void LandmarkDialog::show_edits(const LandmarkDialogShown& shown, LandmarkDialogResult& result) const {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const float third = std::floor((room - 2 * gap) / 3);
    if (small_button("Undo", third, shown.can_undo, "Ctrl+Z")) result.undoes = true;
    ImGui::SameLine();
    if (small_button("Redo", third, shown.can_redo, "Ctrl+Y")) result.redoes = true;
    ImGui::SameLine();
    if (small_button("Delete", third, shown.selected.has_value(), "Delete")) result.removes = true;
    const float half = std::floor((room - gap) / 2);
    if (small_button("Swap sides", half, shown.can_swap, "Exchanges left and right on the second mesh (S)"))
        result.swaps = true;
    ImGui::SameLine();
    if (small_button("Accept next", half, true, "Sets a point at the marked proposal (N, Space)"))
        result.accepts_proposal = true;
    const std::string mesh = shown.sides[side_].title;
    if (small_button("Load...", half, true,
                     fmt::format("Landmarks of {} from a file (Ctrl+O)", mesh).c_str()))
        result.loads = side_;
    ImGui::SameLine();
    if (small_button("Save...", half, shown.can_save[side_],
                     fmt::format("Landmarks of {} to a file (Ctrl+S)", mesh).c_str()))
        result.saves = side_;
}

void LandmarkDialog::show_blend(const LandmarkDialogShown& shown, LandmarkDialogResult& result) {
    result.blend = landmark_picture("blend", blend_size_, shown.blend, holds_[2]);
    const float checker =
        ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + text_size("Checker").x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - checker - ImGui::GetStyle().ItemSpacing.x);
    ImGui::SliderFloat("##half way", &blend_, 0, 1, "", ImGuiSliderFlags_NoInput);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("From the first mesh to the second (-, +)");
    ImGui::SameLine();
    ImGui::Checkbox("Checker", &has_checker_);
}

void LandmarkDialog::show_foot(const LandmarkDialogShown& shown, LandmarkDialogResult& result) {
    const float use = modal_button_width("Use landmarks");
    const float cancel = modal_button_width("Cancel");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const float together =
        ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + text_size("Turn together").x;
    const float help = modal_button_width("Keys");
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const bool is_faulty = edits_name_ && !shown.name_fault.empty();
    draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y},
              room - use - cancel - together - help - 5 * gap, is_faulty ? colors::notice : colors::dim_text,
              is_faulty ? shown.name_fault : hint);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - use - cancel - together - help - 3 * gap);
    ImGui::Checkbox("Turn together", &turns_together_);
    ImGui::SameLine();
    modal_button({.label = "Keys", .width = help});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", keys_help);
    ImGui::SameLine();
    if (modal_button({.label = "Use landmarks", .width = use, .is_main = true})) result.closes = true;
    ImGui::SameLine();
    if (modal_button({.label = "Cancel", .width = cancel})) result.closes = false;
}

}  // namespace interleaf
