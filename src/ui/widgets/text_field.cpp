#include "ui/widgets/text_field.h"

#include <algorithm>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "text/characters.h"
#include "ui/widgets/glyphs.h"
#include "ui/widgets/modal.h"

namespace interleaf {

namespace {

/// Clears Dear ImGui's undo steps. They belong to the previous text of the active or last active widget, and
/// Dear ImGui does not clear them: in another text, their positions may lie past the end.
void forget_steps() {
    ImStb::StbUndoState& steps = ImGui::GetCurrentContext()->InputTextState.Stb.undostate;
    steps.undo_point = 0;
    steps.undo_char_point = 0;
    steps.redo_point = STB_TEXTEDIT_UNDOSTATECOUNT;
    steps.redo_char_point = STB_TEXTEDIT_UNDOCHARCOUNT;
}

}  // namespace

bool is_editable(std::string_view text) {
    while (!text.empty()) {
        const auto character = first_character(text);
        // Dear ImGui holds 16 bits per character.
        if (!character || is_control(character->code) || character->code > 0xffff) return false;
        text.remove_prefix(character->size);
    }
    return true;
}

/// The data of the widget's callback.
struct TextField::Edit {
    TextField& field;
    const Completion& completion;
    bool tabbed = false;
};

void TextField::set(std::string text, std::size_t selected) {
    text_ = std::move(text);
    selected_ = std::min(selected, text_.size());
    has_new_text_ = true;
    is_set_now_ = true;
}

/// Takes the letters typed before the widget is active, which takes a frame or two.
void TextField::take_early_letters() {
    const std::string typed = typed_letters();
    if (typed.empty()) return;
    text_ = selected_ > 0 ? typed + text_.substr(selected_) : text_ + typed;
    selected_ = 0;
    has_new_text_ = true;
}

int TextField::edit(ImGuiInputTextCallbackData* data) {
    Edit& edit = *static_cast<Edit*>(data->UserData);
    const auto replace = [&](const std::string& text) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, text.data(), text.data() + text.size());
        forget_steps();
    };
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
        if (ImGui::GetIO().KeyShift) return 0;  // Shift+Tab goes to the previous part
        const std::string before(data->Buf, static_cast<std::size_t>(data->BufTextLen));
        const std::string after = edit.completion ? edit.completion(before) : before;
        edit.tabbed = after == before;
        if (!edit.tabbed) replace(after);
    } else if (std::exchange(edit.field.has_new_text_, false)) {
        // An active widget has its own copy of the text.
        const std::string& text = edit.field.text_;
        if (text != data->Buf) replace(text);
        // From now on the widget keeps the selection, because it changes the text.
        const std::size_t selected = std::exchange(edit.field.selected_, 0);
        data->SelectionStart = 0;
        data->SelectionEnd = data->CursorPos = selected > 0 ? static_cast<int>(selected) : data->BufTextLen;
        if (selected == 0) data->ClearSelection();
    }
    return 0;
}

TextFieldResult TextField::show(const char* name, const char* hint, float width, bool focused,
                                const Completion& completion) {
    // Do not take the focus while a mouse button is down: the pressed item would lose it, and the click with
    // it.
    const bool takes_focus = focused && !had_focus_ && !ImGui::IsAnyMouseDown();
    if (takes_focus) ImGui::SetKeyboardFocusHere();
    // Letters typed in the frame that called set() caused the call, and are not part of the text.
    if (!std::exchange(is_set_now_, false) && focused && !was_active_) take_early_letters();
    Edit edit{.field = *this, .completion = completion};
    if (has_new_text_) forget_steps();  // before the widget reads a Ctrl+Z that is already down
    need_glyphs(text_);
    // The callback may replace the widget's text by text_, although the widget also writes to text_.
    ImGui::SetNextItemWidth(width);
    TextFieldResult result;
    result.entered =
        ImGui::InputTextWithHint(name, hint, &text_,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways |
                                     ImGuiInputTextFlags_CallbackCompletion,
                                 &TextField::edit, &edit);
    result.tabbed = edit.tabbed;
    const bool is_active = ImGui::IsItemActive();
    was_active_ = is_active;
    result.clicked =
        !focused && is_active && ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (focused || is_active) draw_focus();
    if (!focused && is_active && !result.clicked) ImGui::ClearActiveID();
    // If a click beside the field has taken the keyboard from it, the field takes the keyboard back.
    const bool has_lost_it = had_focus_ && ImGui::IsItemDeactivated();
    had_focus_ = (takes_focus || (focused && had_focus_) || result.clicked) && !has_lost_it;
    return result;
}

}  // namespace interleaf
