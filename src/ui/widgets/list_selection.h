// Which rows of a list are selected, and where its cursor is: what clicks and arrows do, alone and with Shift
// and Ctrl, as people know it from their desktop.
#pragma once

#include <cstddef>
#include <vector>

namespace interleaf {

enum class SelectionStep {
    only,    ///< the row, and no other
    toggle,  ///< Ctrl: this row as well, or no longer
    extend,  ///< Shift: all rows from the last row chosen without it
    look,    ///< Ctrl and an arrow: only the cursor moves
};

class ListSelection {
  public:
    /// Nothing selected, the cursor on the first of \p rows.
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
