// Tests of numbers as text.
#include "ui/number_text.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("thousands are grouped") {
    CHECK(grouped(0) == "0");
    CHECK(grouped(999) == "999");
    CHECK(grouped(1000) == "1,000");
    CHECK(grouped(34612) == "34,612");
    CHECK(grouped(123456) == "123,456");
    CHECK(grouped(1234567890) == "1,234,567,890");
}
