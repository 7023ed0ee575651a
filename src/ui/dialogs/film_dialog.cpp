#include "ui/dialogs/film_dialog.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <glm/common.hpp>
#include <imgui.h>

#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {
namespace {

enum class RowOf : std::uint8_t { both, film, picture };

struct TextRow {
    const char* label;
    const char* remark;
    const char* tip;
    std::string FilmChoices::*text;
    RowOf of;
};

struct CheckRow {
    const char* label;
    const char* tip;
    bool FilmChoices::*flag;
    RowOf of;
};

constexpr TextRow text_rows[] = {
    {"Size", "pixels", "Width and height, such as 1280x720", &FilmChoices::size, RowOf::both},
    {"Scale", "times the size, with wider lines",
     "2 draws twice as many pixels in each direction, for print and sharp screens", &FilmChoices::scale,
     RowOf::picture},
    {"Rate", "frames per second", "30 is usual; 60 is smoother, and the file larger", &FilmChoices::rate,
     RowOf::film},
    {"From", "on the timeline or path", "The time that the first frame shows", &FilmChoices::begin,
     RowOf::film},
    {"To", "on the timeline or path", "The time at which the film ends", &FilmChoices::end, RowOf::film},
    {"Turn", "degrees of the camera in the whole film", "360 turns once around the surface",
     &FilmChoices::turn, RowOf::film}};
constexpr CheckRow check_rows[] = {
    {"Loop: leave out a last frame that equals the first", "For a film that is repeated without a break",
     &FilmChoices::is_loop, RowOf::film},
    {"Transparent background", "Draw only the surface, to be laid over a page or another picture",
     &FilmChoices::is_transparent, RowOf::picture},
    {"Edges, as the window shows them",
     "Draw the wireframe, the refinement edges and the root edges that are switched on",
     &FilmChoices::has_edges, RowOf::picture},
    {"Legend of the colors", "Draw at the right side what the colors mean", &FilmChoices::has_legend,
     RowOf::both}};
constexpr std::string_view row_names[] = {"size", "scale",       "rate",  "begin",  "end",  "turn",
                                          "loop", "transparent", "edges", "legend", "make", "cancel"};
constexpr std::size_t first_check_row = std::size(text_rows);
constexpr std::size_t edges_row = first_check_row + 2;
constexpr std::size_t legend_row = first_check_row + 3;
constexpr std::size_t make_row = first_check_row + std::size(check_rows);
constexpr std::size_t cancel_row = make_row + 1;
static_assert(cancel_row + 1 == std::size(row_names));

/// Whether the dialog has \p row for this offer.
bool is_row_of(std::size_t row, const FilmOfferShown& shown) {
    if (row >= make_row) return true;
    if (row == edges_row && !shown.shows_edges) return false;
    if (row == legend_row && !shown.offers_legend) return false;
    const RowOf of = row < first_check_row ? text_rows[row].of : check_rows[row - first_check_row].of;
    return of == RowOf::both || (of == RowOf::film) == shown.is_film;
}

std::size_t rows_of(const FilmOfferShown& shown) {
    std::size_t count = 0;
    for (std::size_t row = 0; row < make_row; ++row) count += is_row_of(row, shown) ? 1 : 0;
    return count;
}

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
    const auto rows = static_cast<float>(rows_of(shown) + 1);
    const float without_preview = 2 * scaled(14) + 2 * (ImGui::GetTextLineHeight() + spacing) + rows * line;
    const float room = std::max(area.height - 2 * scaled(12) - without_preview, scaled(60));
    preview_width_ = std::round(std::min({inner, room * shown.aspect, scaled(240) * shown.aspect}));
    const float preview_height = std::round(preview_width_ / shown.aspect);
    if (begin_modal("film", area, {width, without_preview + preview_height + spacing})) {
        if (!std::exchange(is_new_, false)) read_keys(shown);
        ImGui::TextUnformatted(shown.title.c_str());
        show_preview(shown);
        for (std::size_t row = 0; row < make_row; ++row) {
            if (!is_row_of(row, shown)) continue;
            if (row < first_check_row)
                show_text_row(row, shown);
            else
                show_check_row(row);
        }
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        const bool is_faulty = !shown.fault.empty();
        draw_text(corner, inner, is_faulty ? colors::notice : colors::dim_text,
                  is_faulty ? shown.fault : shown.detail);
        ImGui::Dummy({inner, ImGui::GetTextLineHeight()});
        const char* const label = shown.is_film ? "Make film" : "Save picture";
        if (const auto pressed = main_and_cancel(label, focus_ == make_row, focus_ == cancel_row))
            press(*pressed, shown);
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
    if (focus_ < make_row) {
        bool& flag = choices_.*check_rows[focus_ - first_check_row].flag;
        flag = !flag;
    } else
        press(focus_ == make_row, shown);
}

void FilmDialog::move_focus(int by, const FilmOfferShown& shown) {
    constexpr std::size_t count = std::size(row_names);
    std::size_t row = focus_;
    do row = (row + count + static_cast<std::size_t>(by + 1) - 1) % count;
    while (!is_row_of(row, shown));
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
    if (choices_.is_transparent && !shown.is_film) draw_pattern(corner, {preview_width_, height});
    if (shown.preview != 0) list.AddImage(texture_id(shown.preview), to_imgui(corner), end);
    ImGui::Dummy({preview_width_, height});
}

/// The pattern that stands for transparency.
void FilmDialog::draw_pattern(glm::vec2 corner, glm::vec2 size) const {
    const float cell = scaled(8);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const glm::vec2 end = corner + size;
    list.AddRectFilled(to_imgui(corner), to_imgui(end), to_color(glm::vec3(0.80F)));
    for (int y = 0; static_cast<float>(y) * cell < size.y; ++y)
        for (int x = y % 2; static_cast<float>(x) * cell < size.x; x += 2) {
            const glm::vec2 at = corner + cell * glm::vec2(x, y);
            list.AddRectFilled(to_imgui(at), to_imgui(glm::min(at + cell, end)), to_color(glm::vec3(0.62F)));
        }
}

void FilmDialog::show_check_row(std::size_t row) {
    const CheckRow& check = check_rows[row - first_check_row];
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + film_label_width());
    if (ImGui::Checkbox(check.label, &(choices_.*check.flag))) focus(row);
    tooltip(check.tip);
    if (focus_ == row) draw_focus();
}

void FilmDialog::show_text_row(std::size_t row, const FilmOfferShown& shown) {
    row_text(text_rows[row].label, film_label_width());
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + film_label_width());
    const std::string name = fmt::format("##{}", row_names[row]);
    const TextFieldResult result = fields_[row].show(name.c_str(), "", scaled(96), focus_ == row);
    text_of(row) = fields_[row].text();
    tooltip(text_rows[row].tip);
    if (result.clicked) focus_ = row;
    if (result.entered) {
        press(true, shown);
        fields_[row].refocus();
    }
    ImGui::SameLine();
    row_text(text_rows[row].remark, ImGui::GetContentRegionAvail().x);
    ImGui::Dummy({0, ImGui::GetFrameHeight()});
}

}  // namespace interleaf
