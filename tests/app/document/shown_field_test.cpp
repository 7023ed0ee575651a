// Which field is shown, and on what scale.
#include "app/document/shown_field.h"

#include <string>

#include <doctest/doctest.h>

#include "hierarchy/error.h"

using namespace interleaf;

namespace {

const std::vector<FamilyField> fields = {
    {{"color", FieldKind::color}, 0, 1}, {{"T", FieldKind::scalar}, -2, 7}, {{"p", FieldKind::scalar}, 1, 3}};

}  // namespace

TEST_CASE("a display without a field names the first, one with a field keeps it") {
    Display display;
    adapt_display(display, fields);
    CHECK(display.field == "color");
    CHECK(shown_field(display, fields) == nullptr);
    display.coloring = Coloring::field;
    CHECK(shown_field(display, fields) == &fields[0]);
    display.field = std::string("p");
    adapt_display(display, fields);
    CHECK(shown_field(display, fields) == &fields[2]);
    CHECK(display.scale.range == ValueRange{1, 3});
    display.field = std::string("of another family");
    adapt_display(display, fields);
    CHECK(display.field == "color");
}

TEST_CASE("a locked range stays, another follows the field") {
    Display display;
    display.field = std::string("T");
    adapt_display(display, fields);
    CHECK(display.scale.range == ValueRange{-2, 7});
    display.range_locked = true;
    display.field = std::string("p");
    adapt_display(display, fields);
    CHECK(display.scale.range == ValueRange{-2, 7});
    display.range_locked = false;
    adapt_display(display, fields);
    CHECK(display.scale.range == ValueRange{1, 3});
}

TEST_CASE("a locked range stays the range of shown values where fields have offsets") {
    std::vector<FamilyField> far = fields;
    far[1].offset = 300;
    Display display;
    display.field = std::string("T");
    adapt_display(display, far);
    CHECK(display.scale.range == ValueRange{-2, 7});
    CHECK(display.scale.offset == 300);
    display.range_locked = true;
    display.field = std::string("p");
    adapt_display(display, far);
    CHECK(display.scale.range == ValueRange{298, 307});
    CHECK(display.scale.offset == 0);
    display.field = std::string("T");
    adapt_display(display, far);
    CHECK(display.scale.range == ValueRange{-2, 7});
    CHECK(shown_value(far[1], 0.25) == "300.25");
}

TEST_CASE("where keys have no fields the surface is plain") {
    Display display;
    display.coloring = Coloring::field;
    display.field = std::string("T");
    adapt_display(display, {});
    CHECK(display.coloring == Coloring::plain);
    CHECK(display.field.empty());
    display.coloring = Coloring::checker;
    adapt_display(display, {});
    CHECK(display.coloring == Coloring::checker);
}

TEST_CASE("only a field that is to be shown must be there") {
    Display display;
    display.field = std::string("none");
    CHECK_NOTHROW(require_field(display, fields));
    display.coloring = Coloring::field;
    CHECK_THROWS_AS(require_field(display, fields), UsageError);
    CHECK_THROWS_AS(require_field(display, {}), UsageError);
    display.field = std::string("p");
    CHECK_NOTHROW(require_field(display, fields));
}

TEST_CASE("a wanted range keeps its digits where the field has an offset") {
    std::vector<FamilyField> far = fields;
    far[1].offset = 101'325;
    Display display;
    display.coloring = Coloring::field;
    display.field = std::string("T");
    display.range_locked = true;
    display.wanted_range = {101'324.999, 101'325.001};
    CHECK_NOTHROW(require_field(display, far));
    CHECK_THROWS_AS(require_field(display, fields), UsageError);
    adapt_display(display, far);
    CHECK(display.scale.range.min == doctest::Approx(-0.001));
    CHECK(display.scale.range.max == doctest::Approx(0.001));
    CHECK_FALSE(display.wanted_range);
    adapt_display(display, far);
    CHECK(display.scale.range.max == doctest::Approx(0.001));
    display.wanted_range = {0, 1e39};
    CHECK_THROWS_AS(require_field(display, far), UsageError);
}

TEST_CASE("a wanted range of a measured coloring is kept for that coloring, also without fields") {
    Display display;
    display.coloring = Coloring::curvature;
    display.wanted_range = {-2, 3};
    require_field(display, {});
    adapt_display(display, {});
    CHECK(display.kept_range() == ValueRange{-2, 3});
    CHECK_FALSE(display.wanted_range);
    display.coloring = Coloring::moved;
    CHECK_FALSE(display.kept_range());
    display.coloring = Coloring::curvature;
    CHECK(display.kept_range() == ValueRange{-2, 3});
    display.wanted_range = {1, 1e300};
    CHECK_THROWS_AS(require_field(display, {}), UsageError);
}
