// Tests of numbers in texts.
#include "text/parsed_number.h"

#include <cstdint>

#include <doctest/doctest.h>

namespace interleaf {

TEST_CASE("a number is the whole of its text") {
    CHECK(parsed_number<int>("-12") == -12);
    CHECK(parsed_number<unsigned>("007") == 7);
    CHECK(parsed_number<std::uint64_t>("18446744073709551615") == UINT64_MAX);
    CHECK(parsed_number<double>("2.5e3") == 2500);
    for (const char* text : {"", " 1", "1 ", "+1", "1x", "x", "-", "--1", "0x10", "4294967296"}) {
        CAPTURE(text);
        CHECK_FALSE(parsed_number<unsigned>(text));
    }
    CHECK_FALSE(parsed_number<unsigned>("-1"));
    CHECK_FALSE(parsed_number<int>("1.0"));
    CHECK_FALSE(parsed_number<double>("1e999"));
}

TEST_CASE("the error says whether a text is no number or a number out of range") {
    int number = 5;
    CHECK(parse_all("12", number) == std::errc());
    CHECK(number == 12);
    CHECK(parse_all("1x", number) == std::errc::invalid_argument);
    CHECK(parse_all("", number) == std::errc::invalid_argument);
    CHECK(parse_all("99999999999", number) == std::errc::result_out_of_range);
}

}  // namespace interleaf
