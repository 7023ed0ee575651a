// The selected rows of a list, and its cursor. Clicks and arrow keys, alone and with Shift and Ctrl, act as
// in other desktop programs.
#pragma once

#include <cstddef>
#include <vector>

namespace interleaf {

enum class SelectionStep {
    only,    ///< selects only the row
    toggle,  ///< Ctrl: selects the row too, or deselects it
    extend,  ///< Shift: selects all rows from the last row chosen without Shift
    look,    ///< Ctrl and an arrow: moves only the cursor
};

class ListSelection {
  public:
    /// Selects nothing, and puts the cursor on the first of \p rows.
    /// \param several  whether more than one row may be selected
    void reset(std::size_t rows, bool several);

    /// Moves the cursor to \p row.
    /// \pre row < size()
    void step(std::size_t row, SelectionStep step);

    void select_all();
    void clear();

    std::size_t size() const { return selected_.size(); }
    std::size_t cursor() const { return cursor_; }
    bool is_selected(std::size_t row) const { return selected_[row]; }
    std::size_t count() const { return count_; }

    /// The selected rows from top to bottom.
    std::vector<std::size_t> rows() const;

  private:
    void set(std::size_t row, bool selected);

    std::vector<bool> selected_;
    std::size_t count_ = 0;
    std::size_t cursor_ = 0;
    std::size_t anchor_ = 0;
    bool several_ = false;
};

}  // namespace interleaf
