#include "ui/dialogs/import_dialog.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"

namespace interleaf {
namespace {

struct ImportText {
    const char* label;
    const char* hint;
    const char* tooltip;
    std::string ImportDialogChoices::*text;
};

constexpr ImportText import_texts[] = {
    {"Every", "1", "Takes every N-th step of the series.", &ImportDialogChoices::every},
    {"Tolerance", "none: keep the triangles of the steps",
     "Samples the fields on new triangles: the largest difference, in percent of a field's range over all "
     "steps.",
     &ImportDialogChoices::tolerance},
    {"Roots", "none: find them in the steps", "A file .ilh whose roots are those of all keys.",
     &ImportDialogChoices::roots}};
constexpr std::size_t import_row = std::size(import_texts);
constexpr std::size_t import_cancel_row = import_row + 1;
constexpr std::size_t import_row_count = import_row + 2;
constexpr std::size_t max_field_rows = 4;

float import_label_width() {
    return scaled(92);
}

/// Shows the label of a row, and puts the cursor behind it.
void import_label(const char* label) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, import_label_width(), colors::dim_text,
              label);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + import_label_width());
}

/// Offers \p names and \p none, which stands for an empty name.
void choose_name(const char* id, std::string& chosen, std::span<const std::string> names, const char* none,
                 float width) {
    ImGui::SetNextItemWidth(width);
    if (names.empty()) ImGui::BeginDisabled();
    const bool is_open = ImGui::BeginCombo(id, "");
    const ImVec2 corner = ImGui::GetItemRectMin();
    if (!is_open)
        draw_text({corner.x + ImGui::GetStyle().FramePadding.x, corner.y + ImGui::GetStyle().FramePadding.y},
                  width - ImGui::GetFrameHeight() - scaled(6),
                  chosen.empty() ? colors::dim_text : colors::text, chosen.empty() ? none : chosen);
    if (is_open) {
        if (ImGui::Selectable(none, chosen.empty())) chosen.clear();
        for (const std::string& name : names) {
            const glm::vec2 place = from_imgui(ImGui::GetCursorScreenPos());
            ImGui::PushID(&name);
            if (ImGui::Selectable("", name == chosen)) chosen = name;
            draw_text(place, ImGui::GetItemRectSize().x, colors::text, name);
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    if (names.empty()) ImGui::EndDisabled();
}

void import_tooltip(const char* text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", text);
}

}  // namespace

void ImportDialog::open(ImportDialogChoices choices) {
    assert(!is_open_);
    *this = ImportDialog();
    choices_ = std::move(choices);
    for (std::size_t row = 0; row < text_row_count; ++row) texts_[row].set(choices_.*import_texts[row].text);
    is_open_ = is_new_ = true;
    focus(0);
}

std::optional<bool> ImportDialog::show(const Rect& area, const ImportDialogShown& shown) {
    if (!is_open_) return std::nullopt;
    const float width = std::min(scaled(480), area.width - 2 * scaled(12));
    const float inner = width - 2 * scaled(16);
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float line = ImGui::GetFrameHeight() + spacing;
    const auto field_rows =
        static_cast<float>(std::clamp<std::size_t>(shown.fields.size(), 1, max_field_rows));
    const float height =
        2 * scaled(14) + 3 * (ImGui::GetTextLineHeight() + spacing) + (7 + field_rows) * line;
    if (begin_modal("import", area, {width, height})) {
        if (!std::exchange(is_new_, false)) read_keys(shown);
        draw_text(from_imgui(ImGui::GetCursorScreenPos()), inner, colors::text, shown.title);
        ImGui::Dummy({inner, ImGui::GetTextLineHeight()});
        draw_text(from_imgui(ImGui::GetCursorScreenPos()), inner, colors::dim_text, shown.detail);
        ImGui::Dummy({inner, ImGui::GetTextLineHeight()});
        for (std::size_t row = 0; row < text_row_count; ++row) show_text_row(row, shown);
        show_choices(shown);
        show_fields(shown);
        draw_text(from_imgui(ImGui::GetCursorScreenPos()), inner, colors::notice, shown.fault);
        ImGui::Dummy({inner, ImGui::GetTextLineHeight()});
        if (const auto pressed = main_and_cancel("Import", focus_ == import_row, focus_ == import_cancel_row))
            press(*pressed, shown);
        end_modal(pressed_.has_value());
    }
    if (pressed_) is_open_ = false;
    return std::exchange(pressed_, std::nullopt);
}

void ImportDialog::read_keys(const ImportDialogShown& shown) {
    if (!ImGui::IsWindowFocused()) return;  // a list of names is open
    if (is_key_pressed(GLFW_KEY_ESCAPE)) press(false, shown);
    const std::size_t by = ImGui::GetIO().KeyShift ? import_row_count - 1 : 1;
    if (is_key_pressed(GLFW_KEY_TAB, KeyRepeat::yes)) focus((focus_ + by) % import_row_count);
    if (focus_ < text_row_count) return;  // a text field reads Enter and the arrows itself
    if (is_enter_pressed() || is_key_pressed(GLFW_KEY_SPACE)) press(focus_ == import_row, shown);
    if (is_key_pressed(GLFW_KEY_LEFT)) focus(import_row);
    if (is_key_pressed(GLFW_KEY_RIGHT)) focus(import_cancel_row);
}

/// Moves the focus to \p row. A text that gets the focus is selected as a whole.
void ImportDialog::focus(std::size_t row) {
    focus_ = row;
    if (row >= text_row_count) return;
    const std::string& text = choices_.*import_texts[row].text;
    texts_[row].set(text, text.size());
}

void ImportDialog::press(bool imports, const ImportDialogShown& shown) {
    if (!pressed_ && (!imports || shown.fault.empty())) pressed_ = imports;
}

void ImportDialog::show_text_row(std::size_t row, const ImportDialogShown& shown) {
    const ImportText& text = import_texts[row];
    import_label(text.label);
    const std::string id = fmt::format("##import-{}", row);
    const TextFieldResult result =
        texts_[row].show(id.c_str(), text.hint, ImGui::GetContentRegionAvail().x, focus_ == row);
    import_tooltip(text.tooltip);
    choices_.*text.text = texts_[row].text();
    if (result.clicked) focus_ = row;
    if (!result.entered) return;
    press(true, shown);
    texts_[row].refocus();
}

void ImportDialog::show_choices(const ImportDialogShown& shown) {
    constexpr const char* corners[] = {"try all three", "first corner", "second corner", "last corner"};
    import_label("Newest vertex");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##newest", corners[choices_.newest])) {
        for (std::size_t n = 0; n < std::size(corners); ++n)
            if (ImGui::Selectable(corners[n], n == choices_.newest)) choices_.newest = n;
        ImGui::EndCombo();
    }
    import_tooltip("The corner of each triangle that its last bisection has made.");

    import_label("Warp");
    const float factor_width = scaled(72);
    const float room = ImGui::GetContentRegionAvail().x;
    choose_name("##warp", choices_.warp, shown.scalars,
                shown.scalars.empty() ? "no scalar field" : "none: stay flat",
                room - factor_width - ImGui::GetStyle().ItemSpacing.x);
    import_tooltip("Moves the points of flat steps across their plane, by a factor times this field.");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(factor_width);
    if (choices_.warp.empty()) ImGui::BeginDisabled();
    ImGui::InputDouble("##factor", &choices_.factor, 0, 0, "%g");
    if (choices_.warp.empty()) ImGui::EndDisabled();
    import_tooltip("Factor of the warp");

    import_label("Displacement");
    choose_name("##displacement", choices_.displacement, shown.vectors,
                shown.vectors.empty() ? "no vector field" : "none: points are where they are",
                ImGui::GetContentRegionAvail().x);
    import_tooltip("A field that is added to the points, which themselves stay in place.");
}

void ImportDialog::show_fields(const ImportDialogShown& shown) {
    import_label("Fields");
    if (shown.fields.empty()) {
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, ImGui::GetContentRegionAvail().x,
                  colors::dim_text, "none");
        ImGui::Dummy({1, ImGui::GetFrameHeight()});
        return;
    }
    const auto rows = static_cast<float>(std::min(shown.fields.size(), max_field_rows));
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("##fields", {0, rows * (ImGui::GetFrameHeight() + spacing) - spacing});
    for (std::size_t n = 0; n < shown.fields.size() && n < choices_.are_wanted.size(); ++n) {
        bool is_wanted = choices_.are_wanted[n];
        ImGui::PushID(static_cast<int>(n));
        if (ImGui::Checkbox("##wanted", &is_wanted)) choices_.are_wanted[n] = is_wanted;
        import_tooltip("Whether the keys get this field.");
        ImGui::SameLine();
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, ImGui::GetContentRegionAvail().x,
                  colors::text, shown.fields[n]);
        ImGui::Dummy({1, ImGui::GetFrameHeight()});
        ImGui::PopID();
    }
    ImGui::EndChild();
}

}  // namespace interleaf
