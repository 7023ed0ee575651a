#include "text/value_text.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("values have the digits that tell them apart within their range") {
    CHECK(value_text(0.123456, 1) == "0.1235");
    CHECK(value_text(123456, 0) == "1.235e+05");
    CHECK(value_text(300.05, 0.2) == "300.05");
    CHECK(value_text(300.05123, 0.2) == "300.0512");
    CHECK(value_text(-299.95, 0.2) == "-299.95");
    CHECK(value_text(1e9 + 0.25, 1) == "1000000000.25");
    CHECK(value_text(1, 1e-30) == "1");
    CHECK(value_text(0, 0.2) == "0");
    CHECK(value_text(5, 100) == "5");
}

TEST_CASE("a unit stands behind a value, and in brackets behind a name") {
    CHECK(with_unit("3.5", "m/s") == "3.5 m/s");
    CHECK(with_unit("3.5", "") == "3.5");
    CHECK(title_with_unit("speed", "m/s") == "speed (m/s)");
    CHECK(title_with_unit("speed", "") == "speed");
}
