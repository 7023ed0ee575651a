// A line of text to edit, in a window that keeps its keyboard focus itself.
#pragma once

#include <functional>
#include <string>
#include <string_view>

struct ImGuiInputTextCallbackData;

namespace interleaf {

/// Whether a text field can hold \p text and give it back unchanged.
bool is_editable(std::string_view text);

struct TextFieldResult {
    bool entered = false;  ///< Enter was pressed in it
    bool tabbed = false;   ///< Tab was pressed in it and completed nothing
    bool clicked = false;  ///< into, so that it wants the focus
};

class TextField {
  public:
    /// What Tab makes of a text.
    using Completion = std::function<std::string(const std::string&)>;

    const std::string& text() const { return text_; }

    /// \param selected  bytes at its begin to select as soon as it has the focus, so that typing replaces
    /// them; the cursor goes behind them
    void set(std::string text, std::size_t selected = 0);

    /// Takes the focus anew, as after a message about what was entered.
    void refocus() { had_focus_ = false; }

    /// \param focused  whether the field has the keyboard focus
    /// \param hint     shown while the field is empty
    TextFieldResult show(const char* name, const char* hint, float width, bool focused,
                         const Completion& completion = nullptr);

  private:
    struct Edit;
    static int edit(ImGuiInputTextCallbackData* data);
    void take_early_letters();

    std::string text_;
    std::size_t selected_ = 0;   ///< what the widget does not know yet; at most the text's size
    bool is_set_now_ = false;    ///< in this frame
    bool was_active_ = false;    ///< in the frame before
    bool has_new_text_ = false;  ///< that the widget does not know yet
    bool had_focus_ = false;
};

}  // namespace interleaf
