// Tests of numbers as they are typed.
#include "app/document/typed_count.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("a count may be written with an exponent where that is a whole number") {
    CHECK(typed_count("20000") == 20'000);
    CHECK(typed_count("1e6") == 1'000'000);
    CHECK(typed_count("1E6") == 1'000'000);
    CHECK(typed_count("2.5e3") == 2'500);
    CHECK(typed_count("0") == 0);
    CHECK(typed_count("4294967295") == 4'294'967'295);
    for (const char* text : {"", "e6", "1e", "1.0", "2.5", "2.55e1", "-1", "-1e3", "1e6 ", "1e10",
                             "4294967296", "nan", "inf", "1e999"}) {
        CAPTURE(text);
        CHECK_FALSE(typed_count(text));
    }
}
