// Tests of the natural order of names.
#include "text/natural_order.h"

#include <algorithm>
#include <random>
#include <vector>

#include <doctest/doctest.h>

namespace interleaf {

namespace {

bool before(std::string_view a, std::string_view b) {
    return NaturalName(a) < NaturalName(b);
}

}  // namespace

TEST_CASE("numbers in names are ordered by their value") {
    const std::vector<std::string> ordered = {"",
                                              "0",
                                              "1.9",
                                              "1.10",
                                              "07",
                                              "7",
                                              "08",
                                              "8",
                                              "a",
                                              "a0",
                                              "a01",
                                              "a1",
                                              "a2",
                                              "a2b3",
                                              "a2b10",
                                              "a10",
                                              "a99999999999999999999",
                                              "a100000000000000000000",
                                              "ab",
                                              "b",
                                              "flow",
                                              "flow.2",
                                              "flow.2.obj",
                                              "flow.9",
                                              "FLOW.10",
                                              "flow.10",
                                              "flow.10.obj"};
    for (std::size_t i = 0; i < ordered.size(); ++i)
        for (std::size_t j = 0; j < ordered.size(); ++j) {
            CAPTURE(ordered[i]);
            CAPTURE(ordered[j]);
            CHECK(before(ordered[i], ordered[j]) == (i < j));
        }
}

TEST_CASE("names that differ in leading zeros alone are in the order of their bytes") {
    CHECK(before("07", "7"));
    CHECK(before("a01", "a1"));
    CHECK(before("a00", "a000"));
    CHECK(before("a01b1", "a1b01"));
    CHECK_FALSE(before("a1", "a01"));
    CHECK_FALSE(before("a1", "a1"));
}

TEST_CASE("letters are ordered without regard to their case, names that differ in it alone by their bytes") {
    CHECK(before("a", "B"));
    CHECK(before("B", "c"));
    CHECK(before("ä", "Ö"));
    CHECK(before("A", "a"));
    CHECK_FALSE(before("a", "A"));
}

TEST_CASE("the natural order is a strict order of all texts") {
    constexpr unsigned seed = 5;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::vector<std::string> names;
    for (int i = 0; i < 160; ++i) {
        std::string name;
        for (auto size = random() % 5; size > 0; --size) name += "0129 aAb:/.-~\xff\xc3"[random() % 15];
        names.push_back(name);
    }
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    for (const auto& a : names) {
        CHECK_FALSE(before(a, a));
        for (const auto& b : names) {
            if (a != b) REQUIRE(before(a, b) != before(b, a));
            if (!before(a, b)) continue;
            for (const auto& c : names)
                if (before(b, c)) REQUIRE(before(a, c));
        }
    }
}

TEST_CASE("names of one series are the same without their numbers") {
    CHECK(without_numbers("flow.2.obj") == without_numbers("flow.010.obj"));
    CHECK(without_numbers("12a345") == "0a0");
    CHECK(without_numbers("flow.b.obj") == "flow.b.obj");
}

}  // namespace interleaf
