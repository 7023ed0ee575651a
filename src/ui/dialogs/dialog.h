// A question in the middle of the window. The user answers it by one of a few buttons and, if the question
// asks for it, by a line of text.
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
    std::string detail;                ///< the consequences, in dim text; may be empty
    std::vector<std::string> buttons;  ///< two or three; the last button changes nothing
    std::size_t default_button = 0;    ///< the button that Enter presses at first

    std::optional<std::string> entry;  ///< initial text of the entry; none if the question has no entry
    /// Returns what is wrong with an entry; "" if nothing is. A faulty entry disables all buttons but the
    /// last.
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
    /// \pre is_open() is false
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
    std::size_t focus_ = 0;  ///< index of a button; the number of buttons means the entry
    bool is_new_ = false;    ///< the keys that opened the dialog are still down
};

}  // namespace interleaf
