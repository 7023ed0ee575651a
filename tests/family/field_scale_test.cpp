#include "family/field_scale.h"

#include <cmath>
#include <random>
#include <string>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE(
    "with their offset, floats keep values to a millionth of the range, and without one where there is "
    "none") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponents(-12, 12);
    std::uniform_real_distribution<double> parts(0, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        CAPTURE(trial);
        const double range = std::pow(10, exponents(random));
        const double low = (trial % 2 == 0 ? 1 : -1) * range * std::pow(10, exponents(random) / 3);
        const double high = low + range;
        const double offset = offset_for(low, high);
        const double value = low + (high - low) * parts(random);
        const double kept = double{static_cast<float>(value - offset)} + offset;
        CHECK(std::abs(kept - value) <= 1e-6 * range);
    }
}

TEST_CASE("an offset is a number of few digits, and only where it is needed") {
    CHECK(offset_for(299.9, 300.1) == 300);
    CHECK(offset_for(-300.1, -299.9) == -300);
    CHECK(offset_for(1e9 + 1, 1e9 + 9) == 1'000'000'005);
    CHECK(offset_for(101'300, 101'450) == 101'400);
    CHECK(offset_for(0, 1) == 0);
    CHECK(offset_for(3, 4) == 0);
    CHECK(offset_for(300, 300) == 0);
    CHECK(offset_for(1, std::nextafter(1, 2)) == 0);
    CHECK(offset_for(-1e308, 1e308) == 0);
    CHECK(offset_for(1e-309, 1.1e-309) == 0);  // smaller than the smallest power of ten that divides well
}

TEST_CASE("a field has one scale, and none that says nothing") {
    std::vector<FieldScale> scales;
    CHECK(scale_of(scales, "T") == FieldScale{.field = "T"});
    set_scale(scales, {"T", 300, "K"});
    set_scale(scales, {"p", 0, "Pa"});
    set_scale(scales, {"T", 300, ""});
    CHECK(scales == std::vector<FieldScale>{{"T", 300, ""}, {"p", 0, "Pa"}});
    set_scale(scales, {"T", 0, ""});
    set_scale(scales, {"u", 0, ""});
    CHECK(scales == std::vector<FieldScale>{{"p", 0, "Pa"}});
    CHECK(offset_sentence({"T", 300, "K"}) == "The values of T are the differences from 300 K.");
}

TEST_CASE("a unit is a short text without control characters") {
    CHECK(is_unit(""));
    CHECK(is_unit("m/s²"));
    CHECK_FALSE(is_unit("a\nb"));
    CHECK_FALSE(is_unit(std::string(65, 'm')));
}
