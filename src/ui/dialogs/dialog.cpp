#include "ui/dialogs/dialog.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cassert>
#include <cctype>
#include <utility>

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "text/characters.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

float total_width(const std::vector<std::string>& buttons) {
    float width = -ImGui::GetStyle().ItemSpacing.x;
    for (const std::string& label : buttons)
        width += modal_button_width(label) + ImGui::GetStyle().ItemSpacing.x;
    return width;
}

}  // namespace

void Dialog::ask(Question question) {
    assert(!is_open() && question.buttons.size() >= 2 && question.default_button < question.buttons.size());
    question_ = std::move(question);
    pressed_.reset();
    focus_ = question_->entry ? question_->buttons.size() : question_->default_button;
    if (question_->entry) {
        entry_ = TextField();
        entry_.set(*question_->entry, question_->entry->size());
    }
    is_new_ = true;
}

std::optional<Answer> Dialog::show(const Rect& area) {
    if (!question_) return std::nullopt;
    const float margin = scaled(16);
    const float width = std::min(scaled(440), area.width - 2 * scaled(12));
    const float inner = width - 2 * margin;
    const bool stacked = total_width(question_->buttons) > inner;
    const float line = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y;
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    float height = 2 * scaled(14) + wrapped_height(question_->text, inner) + 2 * spacing +
                   line * static_cast<float>(stacked ? question_->buttons.size() : 1);
    if (!question_->detail.empty()) height += wrapped_height(question_->detail, inner) + spacing;
    if (question_->entry) height += line + ImGui::GetTextLineHeight() + spacing;

    if (begin_modal("question", area, {width, height})) {
        if (!std::exchange(is_new_, false)) read_keys();
        wrapped_text(question_->text, colors::text);
        if (!question_->detail.empty()) wrapped_text(question_->detail, colors::dim_text);
        if (question_->entry) show_entry(inner);
        ImGui::Dummy({0, spacing / 2});
        show_buttons(inner);
        end_modal(pressed_.has_value());
    }
    if (!pressed_) return std::nullopt;
    Answer answer{.button = *pressed_, .entry = entry_.text()};
    question_.reset();
    return answer;
}

void Dialog::read_keys() {
    const bool in_entry = focus_ == question_->buttons.size();
    const bool back = ImGui::GetIO().KeyShift;
    if (is_key_pressed(GLFW_KEY_ESCAPE)) press(last());
    if (is_key_pressed(GLFW_KEY_TAB, KeyRepeat::yes)) move_focus(back ? -1 : 1);
    if (in_entry) return;  // the field reports Enter
    if (is_enter_pressed() || is_key_pressed(GLFW_KEY_SPACE)) press(focus_);
    if (is_key_pressed(GLFW_KEY_LEFT, KeyRepeat::yes) && focus_ > 0) --focus_;
    if (is_key_pressed(GLFW_KEY_RIGHT, KeyRepeat::yes) && focus_ < last()) ++focus_;
    const std::string letter = folded(typed_letters());
    for (std::size_t i = 0; !letter.empty() && i <= last(); ++i) {
        if (has_accelerator(i) && folded(question_->buttons[i]).starts_with(letter)) press(i);
    }
}

void Dialog::move_focus(int by) {
    const auto places = static_cast<int>(question_->buttons.size() + (question_->entry ? 1 : 0));
    focus_ = static_cast<std::size_t>((static_cast<int>(focus_) + by + places) % places);
}

void Dialog::show_entry(float width) {
    const TextFieldResult result = entry_.show("##entry", "", width, focus_ == question_->buttons.size());
    if (result.clicked) focus_ = question_->buttons.size();
    if (result.entered) {
        press(question_->default_button);
        entry_.refocus();
    }
    const std::string wrong = fault();
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    draw_text(corner, width, colors::notice, wrong);
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
}

void Dialog::show_buttons(float width) {
    const bool stacked = total_width(question_->buttons) > width;
    if (!stacked) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + width - total_width(question_->buttons));
    for (std::size_t i = 0; i <= last(); ++i) {
        const std::string& label = question_->buttons[i];
        if (i > 0 && !stacked) ImGui::SameLine();
        ImGui::PushID(static_cast<int>(i));
        if (modal_button({.label = label.c_str(),
                          .width = stacked ? width : modal_button_width(label),
                          .is_main = i == question_->default_button,
                          .is_focused = i == focus_,
                          .has_accelerator = has_accelerator(i)}))
            press(i);
        ImGui::PopID();
    }
}

void Dialog::press(std::size_t button) {
    if (pressed_ || (button != last() && !fault().empty())) return;
    pressed_ = button;
}

bool Dialog::has_accelerator(std::size_t button) const {
    if (question_->entry) return false;
    const auto first = [&](std::size_t i) { return folded(question_->buttons[i].substr(0, 1)); };
    for (std::size_t i = 0; i <= last(); ++i)
        if (i != button && first(i) == first(button)) return false;
    return true;
}

std::string Dialog::fault() const {
    if (!question_->entry || !question_->fault) return "";
    return question_->fault(entry_.text());
}

}  // namespace interleaf
