#include "ui/dialogs/film_dialog.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {
namespace {

struct TextRow {
    const char* label;
    const char* remark;
    std::string FilmChoices::*text;
};

constexpr TextRow text_rows[] = {{"Size", "pixels", &FilmChoices::size},
                                 {"Rate", "frames per second", &FilmChoices::rate},
                                 {"From", "seconds", &FilmChoices::begin},
                                 {"To", "seconds", &FilmChoices::end},
                                 {"Turn", "degrees of the camera in the whole film", &FilmChoices::turn}};
constexpr std::string_view row_names[] = {"size", "rate", "begin", "end", "turn", "loop", "make", "cancel"};
constexpr std::size_t loop_row = std::size(text_rows);
constexpr std::size_t make_row = loop_row + 1;
constexpr std::size_t cancel_row = loop_row + 2;

float film_label_width() {
    return scaled(56);
}

/// Shows \p text at the height of a row's field.
void row_text(const char* text, float width) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, width, colors::dim_text, text);
}

}  // namespace

void FilmDialog::open(FilmChoices choices) {
    assert(!is_open_);
    *this = FilmDialog();
    choices_ = std::move(choices);
    for (std::size_t row = 0; row < text_row_count; ++row) fields_[row].set(text_of(row));
    is_open_ = is_new_ = true;
    focus(0);
}

std::string& FilmDialog::text_of(std::size_t row) {
    return choices_.*text_rows[row].text;
}

std::string_view FilmDialog::row() const {
    return row_names[focus_];
}

std::optional<bool> FilmDialog::show(const Rect& area, const FilmOfferShown& shown) {
    if (!is_open_) return std::nullopt;
    const float width = std::min(scaled(480), area.width - 2 * scaled(12));
    const float inner = width - 2 * scaled(16);
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float line = ImGui::GetFrameHeight() + spacing;
    const float rows = shown.is_film ? 7 : 2;
    const float without_preview = 2 * scaled(14) + 2 * (ImGui::GetTextLineHeight() + spacing) + rows * line;
    const float room = std::max(area.height - 2 * scaled(12) - without_preview, scaled(60));
    preview_width_ = std::round(std::min({inner, room * shown.aspect, scaled(240) * shown.aspect}));
    const float preview_height = std::round(preview_width_ / shown.aspect);
    if (begin_modal("film", area, {width, without_preview + preview_height + spacing})) {
        if (!std::exchange(is_new_, false)) read_keys(shown);
        ImGui::TextUnformatted(shown.title.c_str());
        show_preview(shown);
        show_text_row(0, shown);
        if (shown.is_film) {
            for (std::size_t row = 1; row < text_row_count; ++row) show_text_row(row, shown);
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + film_label_width());
            if (ImGui::Checkbox("Loop: leave out a last frame that equals the first", &choices_.is_loop))
                focus(loop_row);
            tooltip("A film that is repeated then does not show the same frame twice");
            if (focus_ == loop_row) draw_focus();
        }
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        const bool is_faulty = !shown.fault.empty();
        draw_text(corner, inner, is_faulty ? colors::notice : colors::dim_text,
                  is_faulty ? shown.fault : shown.detail);
        ImGui::Dummy({inner, ImGui::GetTextLineHeight()});
        show_buttons(shown);
        end_modal(pressed_.has_value());
    }
    if (pressed_) is_open_ = false;
    return std::exchange(pressed_, std::nullopt);
}

// ---- keyboard ----

void FilmDialog::read_keys(const FilmOfferShown& shown) {
    if (is_key_pressed(GLFW_KEY_ESCAPE)) press(false, shown);
    const bool back = ImGui::GetIO().KeyShift;
    if (is_key_pressed(GLFW_KEY_TAB, KeyRepeat::yes)) move_focus(back ? -1 : 1, shown);
    if (is_key_pressed(GLFW_KEY_UP, KeyRepeat::yes)) move_focus(-1, shown);
    if (is_key_pressed(GLFW_KEY_DOWN, KeyRepeat::yes)) move_focus(1, shown);
    if (focus_ < text_row_count) return;  // a text field reads Enter and the other arrows itself
    if (is_enter_pressed()) press(focus_ != cancel_row, shown);
    if (is_key_pressed(GLFW_KEY_LEFT) && focus_ == cancel_row) focus(make_row);
    if (is_key_pressed(GLFW_KEY_RIGHT) && focus_ == make_row) focus(cancel_row);
    if (!is_key_pressed(GLFW_KEY_SPACE)) return;
    if (focus_ == loop_row)
        choices_.is_loop = !choices_.is_loop;
    else
        press(focus_ == make_row, shown);
}

void FilmDialog::move_focus(int by, const FilmOfferShown& shown) {
    const auto is_passed = [&](std::size_t row) { return !shown.is_film && row > 0 && row < make_row; };
    constexpr std::size_t count = std::size(row_names);
    std::size_t row = focus_;
    do row = (row + count + static_cast<std::size_t>(by + 1) - 1) % count;
    while (is_passed(row));
    focus(row);
}

/// Moves the focus to \p row. A text that gets the focus is selected as a whole.
void FilmDialog::focus(std::size_t row) {
    focus_ = row;
    if (row < text_row_count) fields_[row].set(text_of(row), text_of(row).size());
}

void FilmDialog::press(bool makes, const FilmOfferShown& shown) {
    if (!pressed_ && (!makes || shown.fault.empty())) pressed_ = makes;
}

// ---- rows ----

void FilmDialog::show_preview(const FilmOfferShown& shown) {
    const float height = std::round(preview_width_ / shown.aspect);
    const float left = ImGui::GetCursorPosX();
    ImGui::SetCursorPosX(left + std::round((ImGui::GetContentRegionAvail().x - preview_width_) / 2));
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const ImVec2 end{corner.x + preview_width_, corner.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(to_imgui(corner), end, colors::well);
    if (shown.preview != 0) list.AddImage(texture_id(shown.preview), to_imgui(corner), end);
    ImGui::Dummy({preview_width_, height});
}

void FilmDialog::show_text_row(std::size_t row, const FilmOfferShown& shown) {
    row_text(text_rows[row].label, film_label_width());
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + film_label_width());
    const std::string name = fmt::format("##{}", row_names[row]);
    const TextFieldResult result = fields_[row].show(name.c_str(), "", scaled(96), focus_ == row);
    text_of(row) = fields_[row].text();
    if (result.clicked) focus_ = row;
    if (result.entered) {
        press(true, shown);
        fields_[row].refocus();
    }
    ImGui::SameLine();
    row_text(text_rows[row].remark, ImGui::GetContentRegionAvail().x);
    ImGui::Dummy({0, ImGui::GetFrameHeight()});
}

void FilmDialog::show_buttons(const FilmOfferShown& shown) {
    const char* const label = shown.is_film ? "Make film" : "Save picture";
    const float make = modal_button_width(label);
    const float cancel = modal_button_width("Cancel");
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - make - cancel - ImGui::GetStyle().ItemSpacing.x);
    if (modal_button({.label = label, .width = make, .is_main = true, .is_focused = focus_ == make_row}))
        press(true, shown);
    ImGui::SameLine();
    if (modal_button({.label = "Cancel", .width = cancel, .is_focused = focus_ == cancel_row}))
        press(false, shown);
}

}  // namespace interleaf
