// A line of text to edit, in a window that keeps the keyboard focus itself.
#pragma once

#include <functional>
#include <string>
#include <string_view>

struct ImGuiInputTextCallbackData;

namespace interleaf {

/// Whether a text field can hold \p text and return it unchanged.
bool is_editable(std::string_view text);

struct TextFieldResult {
    bool entered = false;  ///< Enter was pressed in the field
    bool tabbed = false;   ///< Tab was pressed in the field and completed nothing
    bool clicked = false;  ///< the field was clicked, so it wants the focus
};

class TextField {
  public:
    /// Maps a text to its completion by Tab.
    using Completion = std::function<std::string(const std::string&)>;

    const std::string& text() const { return text_; }

    /// \param selected  number of bytes to select at the start of the text when the field gets the focus, so
    ///     that typing replaces them; the cursor goes behind them
    void set(std::string text, std::size_t selected = 0);

    /// Makes the field take the focus again, for example after a message about the entered text.
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
    std::size_t selected_ = 0;   ///< bytes still to be selected in the widget; at most the size of the text
    bool is_set_now_ = false;    ///< set() was called in this frame
    bool was_active_ = false;    ///< the widget was active in the previous frame
    bool has_new_text_ = false;  ///< the widget does not know text_ yet
    bool had_focus_ = false;
};

}  // namespace interleaf
