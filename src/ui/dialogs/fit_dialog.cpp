#include "ui/dialogs/fit_dialog.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/choice.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

constexpr const char* limits[] = {"Leaves", "Tolerance"};
constexpr const char* limit_tips[] = {"At most so many leaves", "As many leaves as the tolerance needs"};
constexpr const char* axes[] = {"x", "y", "z"};
constexpr const char* ups[] = {"X", "Y", "Z"};

float label_width() {
    return scaled(72);
}

float number_width() {
    return scaled(84);
}

/// Shows the label of a row. The next item stands beside it.
void row_label(const char* text) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float inset = ImGui::GetStyle().FramePadding.y;
    draw_text({corner.x, corner.y + inset}, label_width(), colors::dim_text, text);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + label_width());
}

/// Shows a remark behind the last item of a row, as far as there is room.
void row_remark(const std::string& text) {
    ImGui::SameLine();
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float room = ImGui::GetContentRegionAvail().x;
    const float inset = ImGui::GetStyle().FramePadding.y;
    draw_text({corner.x, corner.y + inset}, room, colors::dim_text, text);
    ImGui::Dummy({0, ImGui::GetFrameHeight()});
}

/// Number of rows below the tiles, including the buttons.
int row_count(const FitOfferShown& shown) {
    constexpr int always = 5;  // limit, roots, up, turn, buttons
    return always + int{shown.can_be_matched} + int{shown.can_be_placed} + int{!shown.parts_remark.empty()} +
           int{!shown.holes_remark.empty()};
}

}  // namespace

void FitDialog::open(FitChoices choices) {
    open(choices.turns.size(), false, false);
    choices_ = std::move(choices);
    focus(Place::fit);
    has_focus_moved_ = false;
    select_mesh(0);
}

void FitDialog::open(std::size_t mesh_count, bool can_be_placed, bool matches_parts) {
    assert(!is_open_ && mesh_count > 0);
    *this = FitDialog();
    choices_.turns.resize(mesh_count);
    choices_.ups.assign(mesh_count, 1);
    choices_.match_parts = matches_parts;
    choices_.same_size = choices_.same_center = can_be_placed;
    is_open_ = is_new_ = true;
    focus(Place::number);
    has_focus_moved_ = false;
    select_mesh(0);
}

std::optional<bool> FitDialog::show(const Rect& area, const FitOfferShown& shown) {
    if (!is_open_) return std::nullopt;
    fault_ = shown.fault;
    const float room = area.width - 2 * scaled(12);
    const float width = std::min(scaled(shown.meshes.size() > 2 ? 780 : 560), room);
    const float inner = width - 2 * scaled(16);
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float line = ImGui::GetFrameHeight() + spacing;
    const float without_tiles = 2 * scaled(14) + wrapped_height(shown.text, inner) +
                                wrapped_height(shown.detail, inner) + ImGui::GetTextLineHeight() +
                                static_cast<float>(row_count(shown)) * line + 7 * spacing;
    tile_side_ = scaled(tile_sides.front());
    for (const float side : tile_sides)
        if (without_tiles + tile_height(scaled(side)) <= area.height - 2 * scaled(12))
            tile_side_ = scaled(side);

    if (begin_modal("fit", area, {width, without_tiles + tile_height(tile_side_)})) {
        if (!std::exchange(is_new_, false)) read_keys(shown);
        // In a small window the rows scroll; the fault and the buttons stay visible.
        const float below = ImGui::GetTextLineHeight() + line + spacing;
        ImGui::PushStyleColor(ImGuiCol_ChildBg, IM_COL32(0, 0, 0, 0));
        ImGui::BeginChild("rows", {0, ImGui::GetContentRegionAvail().y - below}, false,
                          ImGuiWindowFlags_NoNav);
        wrapped_text(shown.text, colors::text);
        wrapped_text(shown.detail, colors::dim_text);
        ImGui::Dummy({0, std::round(spacing / 2)});
        show_meshes(shown);
        ImGui::Dummy({0, std::round(spacing / 2)});
        show_limit(shown);
        show_roots(shown);
        if (shown.can_be_matched) show_matching(shown);
        if (shown.can_be_placed) show_placing();
        show_up(shown);
        show_turn(shown);
        show_changes(shown);
        ImGui::EndChild();
        ImGui::PopStyleColor();
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        draw_text(corner, inner, colors::notice, shown.fault);
        ImGui::Dummy({inner, ImGui::GetTextLineHeight()});
        if (const auto pressed = main_and_cancel("Fit", focus_ == Place::fit, focus_ == Place::cancel))
            press(*pressed, shown);
        end_modal(pressed_.has_value());
    }
    if (pressed_) is_open_ = false;
    return std::exchange(pressed_, std::nullopt);
}

std::string_view FitDialog::row() const {
    constexpr std::string_view names[] = {"limit",   "number", "roots",  "match", "landmarks",
                                          "size",    "center", "meshes", "up",    "axis",
                                          "degrees", "parts",  "holes",  "fit",   "cancel"};
    return names[static_cast<std::size_t>(focus_)];
}

// ---- keyboard ----

void FitDialog::read_keys(const FitOfferShown& shown) {
    if (is_key_pressed(GLFW_KEY_ESCAPE)) press(false, shown);
    const bool back = ImGui::GetIO().KeyShift;
    if (is_key_pressed(GLFW_KEY_TAB, KeyRepeat::yes)) move_focus(back ? -1 : 1, shown);
    if (is_key_pressed(GLFW_KEY_UP, KeyRepeat::yes)) move_focus(-1, shown);
    if (is_key_pressed(GLFW_KEY_DOWN, KeyRepeat::yes)) move_focus(1, shown);
    if (focus_ == Place::number || focus_ == Place::degrees)
        return;  // these read Enter and arrows themselves
    if (is_enter_pressed() && focus_ == Place::landmarks)
        wants_landmarks_ = true;
    else if (is_enter_pressed())
        press(focus_ != Place::cancel, shown);
    if (is_key_pressed(GLFW_KEY_LEFT, KeyRepeat::yes)) step_choice(-1, shown);
    if (is_key_pressed(GLFW_KEY_RIGHT, KeyRepeat::yes)) step_choice(1, shown);
    if (!is_key_pressed(GLFW_KEY_SPACE)) return;
    if (focus_ == Place::fit || focus_ == Place::cancel)
        press(focus_ == Place::fit, shown);
    else
        step_choice(1, shown);
}

void FitDialog::move_focus(int by, const FitOfferShown& shown) {
    constexpr int places = static_cast<int>(Place::cancel) + 1;
    const auto is_passed = [&](Place place) {
        return (place == Place::roots && shown.roots.size() < 2) ||
               (place == Place::meshes && shown.meshes.size() < 2) ||
               ((place == Place::match || place == Place::landmarks) && !shown.can_be_matched) ||
               ((place == Place::size || place == Place::center) && !shown.can_be_placed) ||
               (place == Place::parts && shown.parts_remark.empty()) ||
               (place == Place::holes && shown.holes_remark.empty());
    };
    Place place = focus_;
    do place = static_cast<Place>((static_cast<int>(place) + by + places) % places);
    while (is_passed(place));
    focus(place);
}

/// Moves the focus to \p place. A number that gets the focus is selected as a whole.
void FitDialog::focus(Place place) {
    focus_ = place;
    has_focus_moved_ = true;
    if (place == Place::number) number_.set(number_text(), number_text().size());
    std::string degrees = choices_.turns[mesh_].degrees;
    if (place == Place::degrees) degrees_.set(degrees, degrees.size());
}

void FitDialog::scroll_to_focus(Place place) {
    if (focus_ == place && std::exchange(has_focus_moved_, false)) ImGui::SetScrollHereY();
}

void FitDialog::mark_focus(Place place) {
    scroll_to_focus(place);
    if (focus_ == place) draw_focus();
}

/// Goes to the next or the previous choice in the focused row, and wraps around at the ends.
void FitDialog::step_choice(int by, const FitOfferShown& shown) {
    const auto step = [by](std::size_t at, std::size_t count) {
        return (at + count + static_cast<std::size_t>(by + 1) - 1) % count;
    };
    FitChoices::Turn& turn = choices_.turns[mesh_];
    if (focus_ == Place::limit) {
        choices_.by_tolerance = !choices_.by_tolerance;
        number_.set(number_text());
    }
    if (focus_ == Place::roots) choices_.roots = step(choices_.roots, shown.roots.size());
    if (focus_ == Place::meshes) select_mesh(step(mesh_, shown.meshes.size()));
    if (focus_ == Place::match) choices_.match_parts = !choices_.match_parts;
    if (focus_ == Place::landmarks) wants_landmarks_ = true;
    if (focus_ == Place::size) choices_.same_size = !choices_.same_size;
    if (focus_ == Place::center) choices_.same_center = !choices_.same_center;
    if (focus_ == Place::parts) choices_.keep_largest = !choices_.keep_largest;
    if (focus_ == Place::holes) choices_.fill_holes = !choices_.fill_holes;
    if (focus_ == Place::up) choices_.ups[mesh_] = step(choices_.ups[mesh_], 3);
    if (focus_ == Place::axis) turn.axis = static_cast<int>(step(static_cast<std::size_t>(turn.axis), 3));
    if (focus_ == Place::fit || focus_ == Place::cancel) focus(by < 0 ? Place::fit : Place::cancel);
}

void FitDialog::select_mesh(std::size_t mesh) {
    mesh_ = mesh;
    degrees_.set(choices_.turns[mesh_].degrees);
}

void FitDialog::press(bool fit, const FitOfferShown& shown) {
    if (!pressed_ && (!fit || shown.fault.empty())) pressed_ = fit;
}

// ---- rows ----

void FitDialog::show_meshes(const FitOfferShown& shown) {
    const auto result = fit_tiles(shown.meshes, mesh_, first_tile_, tile_side_, focus_ == Place::meshes);
    scroll_to_focus(Place::meshes);
    if (!result.clicked || shown.meshes.size() < 2) return;
    select_mesh(*result.clicked);
    focus(Place::meshes);
}

void FitDialog::show_number(TextField& field, const char* name, float width, Place place, std::string& text,
                            const FitOfferShown& shown) {
    const TextFieldResult result = field.show(name, "", width, focus_ == place);
    text = field.text();
    scroll_to_focus(place);
    if (result.clicked) focus_ = place;
    if (!result.entered) return;
    press(true, shown);
    field.refocus();
}

void FitDialog::show_limit(const FitOfferShown& shown) {
    row_label("Limit");
    const std::size_t now = choice("limit", limits, choices_.by_tolerance ? 1 : 0, scaled(180), limit_tips);
    mark_focus(Place::limit);
    if (now != static_cast<std::size_t>(choices_.by_tolerance)) {
        choices_.by_tolerance = now == 1;
        focus(Place::number);
    }
    ImGui::SameLine();
    show_number(number_, "##number", number_width(), Place::number, number_text(), shown);
    row_remark(choices_.by_tolerance ? "% of the box diagonal" : shown.meshes.size() > 1 ? "each" : "");
}

void FitDialog::show_roots(const FitOfferShown& shown) {
    row_label("Roots");
    if (shown.roots.size() < 2) {
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        const float room = ImGui::GetContentRegionAvail().x;
        draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, room, colors::text,
                  fmt::format("{}: {}", shown.roots.front(), shown.roots_remark));
        ImGui::Dummy({room, ImGui::GetFrameHeight()});
        return;
    }
    std::vector<const char*> labels;
    labels.reserve(shown.roots.size());
    for (const std::string& name : shown.roots) labels.push_back(name.c_str());
    const std::size_t now =
        choice("roots", labels, choices_.roots, std::min(scaled(320), ImGui::GetContentRegionAvail().x));
    tooltip("The root triangles that the keys bisect; keys of one family share them");
    mark_focus(Place::roots);
    if (now != std::exchange(choices_.roots, now)) focus(Place::roots);
}

void FitDialog::show_toggle(const char* label, bool& value, Place place, const char* tip) {
    if (ImGui::Checkbox(label, &value)) focus(place);
    tooltip(tip);
    mark_focus(place);
}

void FitDialog::show_matching(const FitOfferShown& shown) {
    row_label("Match");
    show_toggle("Match parts", choices_.match_parts, Place::match,
                "Let parts that look alike correspond, such as limbs");
    ImGui::SameLine(0, scaled(16));
    if (ImGui::Button("Landmarks...", {modal_button_width("Landmarks..."), 0})) {
        focus(Place::landmarks);
        wants_landmarks_ = true;
    }
    tooltip("Name points that correspond on two meshes");
    mark_focus(Place::landmarks);
    row_remark(shown.landmarks.empty() ? "points that correspond" : shown.landmarks);
}

void FitDialog::show_placing() {
    row_label("Place");
    show_toggle("Same size", choices_.same_size, Place::size, "Scale all meshes to the same size");
    ImGui::SameLine(0, scaled(16));
    show_toggle("Same center", choices_.same_center, Place::center, "Move all meshes to the same center");
}

void FitDialog::show_up(const FitOfferShown& shown) {
    row_label("Up");
    std::size_t& up = choices_.ups[mesh_];
    const std::size_t now = choice("up", ups, up, scaled(180));
    tooltip("The axis of the mesh that points up");
    mark_focus(Place::up);
    if (now != std::exchange(up, now)) focus(Place::up);
    row_remark(shown.meshes.size() == 1 ? "is up" : fmt::format("is up in {}", shown.meshes[mesh_].name));
}

/// Shows the changes of the clean-up that are so large that the user must allow them.
void FitDialog::show_changes(const FitOfferShown& shown) {
    if (!shown.parts_remark.empty()) {
        row_label("Parts");
        show_toggle("Keep only the largest", choices_.keep_largest, Place::parts,
                    "Leave out all other parts of the mesh");
        row_remark(shown.parts_remark);
    }
    if (!shown.holes_remark.empty()) {
        row_label("Holes");
        show_toggle("Fill", choices_.fill_holes, Place::holes, "Close the holes of the mesh");
        row_remark(shown.holes_remark);
    }
}

void FitDialog::show_turn(const FitOfferShown& shown) {
    row_label("Turn");
    FitChoices::Turn& turn = choices_.turns[mesh_];
    const std::size_t now = choice("axis", axes, static_cast<std::size_t>(turn.axis), scaled(180));
    tooltip("The axis that the mesh is turned about, by the degrees beside it");
    mark_focus(Place::axis);
    if (static_cast<int>(now) != std::exchange(turn.axis, static_cast<int>(now))) focus(Place::axis);
    ImGui::SameLine();
    show_number(degrees_, "##degrees", number_width(), Place::degrees, turn.degrees, shown);
    row_remark(shown.meshes.size() == 1 ? "degrees"
                                        : fmt::format("degrees, for {}", shown.meshes[mesh_].name));
}

}  // namespace interleaf
