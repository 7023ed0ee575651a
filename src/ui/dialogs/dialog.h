// A question in the middle of the window, answered by one of a few buttons; with a line of text to edit, if
// asked for.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

struct Question {
    std::string text;                  ///< "Save changes to Five keys before closing?"
    std::string detail;                ///< what it means, smaller; may be empty
    std::vector<std::string> buttons;  ///< two or three, the last one leaves all as it is
    std::size_t default_button = 0;    ///< what Enter does at first

    std::optional<std::string> entry;  ///< a text to edit, and what it is at first
    /// What is wrong with an entry, so that no button but the last can be pressed; "" for nothing.
    std::function<std::string(const std::string&)> fault;
};

struct Answer {
    std::size_t button;
    std::string entry;
};

/// Enter presses the focused button, or the default button if the entry has the focus. Esc presses the last
/// button. Left, Right and Tab move the focus. Without an entry, a letter presses the button that begins with
/// it, if only one does.
class Dialog {
  public:
    /// \pre  it is not open
    void ask(Question question);

    bool is_open() const { return question_.has_value(); }

    /// Draws the dialog, if it is open, in the middle of \p area. Call it in every frame,
    /// from the same place.
    /// \return the answer, once
    std::optional<Answer> show(const Rect& area);

  private:
    void read_keys();
    void move_focus(int by);
    void show_entry(float width);
    void show_buttons(float width);
    void press(std::size_t button);
    bool has_accelerator(std::size_t button) const;
    std::string fault() const;
    std::size_t last() const { return question_->buttons.size() - 1; }

    std::optional<Question> question_;
    std::optional<std::size_t> pressed_;
    TextField entry_;
    std::size_t focus_ = 0;  ///< a button; behind them all, the entry
    bool is_new_ = false;    ///< the keys that opened it are still down
};

}  // namespace interleaf
