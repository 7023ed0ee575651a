// Tests of selecting rows: alone, with Ctrl, with Shift.
#include "ui/widgets/list_selection.h"

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

using Rows = std::vector<std::size_t>;

ListSelection list(std::size_t rows, bool several) {
    ListSelection selection;
    selection.reset(rows, several);
    return selection;
}

}  // namespace

TEST_CASE("at first nothing is selected, and the cursor is on the first row") {
    const ListSelection selection = list(5, true);
    CHECK(selection.rows().empty());
    CHECK(selection.cursor() == 0);
    CHECK(list(0, true).size() == 0);
}

TEST_CASE("a plain step selects only its row") {
    ListSelection selection = list(5, true);
    selection.step(3, SelectionStep::only);
    selection.step(1, SelectionStep::only);
    CHECK(selection.rows() == Rows{1});
    CHECK(selection.count() == 1);
}

TEST_CASE("Ctrl selects and deselects rows, and moving the cursor with Ctrl changes no row") {
    ListSelection selection = list(5, true);
    selection.step(1, SelectionStep::only);
    selection.step(3, SelectionStep::toggle);
    CHECK(selection.rows() == Rows{1, 3});
    selection.step(4, SelectionStep::look);
    CHECK(selection.rows() == Rows{1, 3});
    CHECK(selection.cursor() == 4);
    selection.step(1, SelectionStep::toggle);
    CHECK(selection.rows() == Rows{3});
    CHECK(selection.count() == 1);
}

TEST_CASE("Shift selects from the last row chosen without Shift, up and down") {
    ListSelection selection = list(6, true);
    selection.step(3, SelectionStep::only);
    selection.step(5, SelectionStep::extend);
    CHECK(selection.rows() == Rows{3, 4, 5});
    selection.step(2, SelectionStep::extend);
    CHECK(selection.rows() == Rows{2, 3});
    selection.step(0, SelectionStep::toggle);
    selection.step(1, SelectionStep::extend);
    CHECK(selection.rows() == Rows{0, 1});
    CHECK(selection.count() == 2);
}

TEST_CASE("a list that allows one selected row never has more") {
    ListSelection selection = list(4, false);
    for (const SelectionStep step :
         {SelectionStep::only, SelectionStep::toggle, SelectionStep::extend, SelectionStep::look}) {
        selection.step(1, SelectionStep::only);
        selection.step(2, step);
        CHECK(selection.rows() == Rows{2});
    }
    selection.select_all();
    CHECK(selection.count() == 1);
}

TEST_CASE("all rows can be selected, or none") {
    ListSelection selection = list(3, true);
    selection.select_all();
    CHECK(selection.rows() == Rows{0, 1, 2});
    selection.clear();
    CHECK(selection.count() == 0);
}
