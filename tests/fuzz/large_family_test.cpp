// Large files without content, which take the most memory or the most time for their size.
#include <string>

#include "fuzz/target.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

namespace interleaf::fuzz {

namespace {

constexpr std::string_view begin =
    R"({"format": "interleaf-family", "version": 1, "name": "f", "keys": [{"name": "a", "file": "a.ilh"}], )";

Outcome outcome_with(std::string_view members) {
    const std::string text = fmt::format("{}{}}}", begin, members);
    return outcome_of(std::as_bytes(std::span(text)));
}

/// A member that is an array of \p count times \p element.
/// \param element  ends with a comma
std::string array_of(std::string_view element, std::size_t count) {
    std::string text = "\"x\": [";
    for (std::size_t i = 0; i < count; ++i) text += element;
    return text + "0]";
}

}  // namespace

TEST_CASE("values that are small in the file take memory in proportion") {
    for (const std::string_view element : {"0,", "\"\",", "[],", "{},", "{\"\":0},"}) {
        CAPTURE(element);
        const bool is_structure = element.size() > 3 || element[0] == '[' || element[0] == '{';
        const Outcome most = outcome_with(array_of(element, is_structure ? 249'000 : 499'000));
        CHECK(most.fault == "");
        CHECK(most.accepted);
        const Outcome more = outcome_with(array_of(element, 2'000'000));
        CHECK(more.fault == "");
        CHECK_FALSE(more.accepted);
    }
}

TEST_CASE("deep nesting does no harm") {
    constexpr std::size_t depth = 400'000;
    const Outcome outcome =
        outcome_with(fmt::format("\"x\": {}{}", std::string(depth, '['), std::string(depth, ']')));
    CHECK(outcome.fault == "");
    CHECK(outcome.accepted);
}

TEST_CASE("a domain of the largest number of triangles, all apart, takes limited time") {
    std::string vertices;
    std::string triangles;
    for (unsigned i = 0; i < 4096; ++i) {
        const unsigned x = 3 * (i % 64);
        const unsigned y = 3 * (i / 64);
        const char* const comma = i == 0 ? "" : ",";
        vertices += fmt::format(
            R"({}{{"at":[{},{}],"key":"a"}},{{"at":[{},{}],"key":"a"}},{{"at":[{},{}],"key":"a"}})", comma, x,
            y, x + 1, y, x, y + 1);
        triangles += fmt::format("{}[{},{},{}]", comma, 3 * i, 3 * i + 1, 3 * i + 2);
    }
    const Outcome outcome = outcome_with(
        fmt::format(R"("domain": {{"vertices": [{}], "triangles": [{}]}})", vertices, triangles));
    CHECK(outcome.fault == "");
    CHECK(outcome.accepted);
}

}  // namespace interleaf::fuzz
