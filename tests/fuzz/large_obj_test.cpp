// Large files that are all hollow: what takes most memory for its bytes.
#include <string>

#include "fuzz/target.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

namespace interleaf::fuzz {

namespace {

std::string repeated(const std::string& text, std::size_t bytes) {
    std::string result;
    while (result.size() < bytes) result += text;
    return result;
}

Outcome outcome_of_text(const std::string& text) {
    return outcome_of(std::as_bytes(std::span(text)));
}

constexpr std::size_t size = 8'000'000;

}  // namespace

TEST_CASE("a large file of nothing but faces, or of nothing but vertices, takes memory in proportion") {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const Outcome triangles = outcome_of_text(corners + repeated("f 1 2 3\n", size));
    CHECK(triangles.fault == "");
    CHECK_FALSE(triangles.accepted);
    const Outcome vertices = outcome_of_text(repeated("v 0 0 0\n", size) + corners + "f -1 -2 -3\n");
    CHECK(vertices.fault == "");
    CHECK(vertices.accepted);
}

TEST_CASE("polygons of the most corners, of no area, take no more than their time") {
    std::string text;
    std::string face = "f";
    for (int corner = 1; corner <= 1000; ++corner) {
        text += fmt::format("v {} 0 0\n", corner);
        face += fmt::format(" {}", corner);
    }
    const Outcome outcome = outcome_of_text(text + repeated(face + "\n", 100'000));
    CHECK(outcome.fault == "");
    CHECK_FALSE(outcome.accepted);
}

}  // namespace interleaf::fuzz
