// Tests of numbers as text.
#include "ui/widgets/number_text.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("a number rounded to a power of ten is the double that its digits mean") {
    CHECK(rounded_to_power(139 * 0.01, -2) == 1.39);
    CHECK(rounded_to_power(1.3849, -2) == 1.38);
    CHECK(rounded_to_power(-0.31, -1) == -0.3);
    CHECK(rounded_to_power(1234, 2) == 1200);
    CHECK(rounded_to_power(0, -5) == 0);
}

TEST_CASE("thousands are grouped") {
    CHECK(grouped(0) == "0");
    CHECK(grouped(999) == "999");
    CHECK(grouped(1000) == "1,000");
    CHECK(grouped(34612) == "34,612");
    CHECK(grouped(123456) == "123,456");
    CHECK(grouped(1234567890) == "1,234,567,890");
}
