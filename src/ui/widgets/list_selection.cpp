#include "ui/widgets/list_selection.h"

#include <algorithm>
#include <cassert>

namespace interleaf {

void ListSelection::reset(std::size_t rows, bool several) {
    selected_.assign(rows, false);
    count_ = cursor_ = anchor_ = 0;
    several_ = several;
}

void ListSelection::step(std::size_t row, SelectionStep step) {
    assert(row < size());
    cursor_ = row;
    if (step == SelectionStep::look && several_) return;
    if (step == SelectionStep::toggle && several_) {
        set(row, !selected_[row]);
        anchor_ = row;
        return;
    }
    clear();
    if (step == SelectionStep::extend && several_) {
        for (std::size_t i = std::min(anchor_, row); i <= std::max(anchor_, row); ++i) set(i, true);
        return;
    }
    set(row, true);
    anchor_ = row;
}

void ListSelection::select_all() {
    if (!several_) return;
    for (std::size_t row = 0; row < size(); ++row) set(row, true);
}

void ListSelection::clear() {
    selected_.assign(size(), false);
    count_ = 0;
}

std::vector<std::size_t> ListSelection::rows() const {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < size(); ++row)
        if (selected_[row]) rows.push_back(row);
    return rows;
}

void ListSelection::set(std::size_t row, bool selected) {
    if (selected_[row] != selected) count_ += selected ? 1 : static_cast<std::size_t>(-1);
    selected_[row] = selected;
}

}  // namespace interleaf
