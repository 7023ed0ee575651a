// Large files without content, which take the most memory for their size.
#include <cmath>
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

TEST_CASE("polygons of the largest number of corners, without area, take limited time") {
    std::string text;
    std::string face = "f";
    for (int corner = 1; corner <= 100'000; ++corner) {
        text += fmt::format("v {} 0 0\n", corner);
        face += fmt::format(" {}", corner);
    }
    const Outcome outcome = outcome_of_text(text + repeated(face + "\n", 1'000'000));
    CHECK(outcome.fault == "");
    CHECK_FALSE(outcome.accepted);
}

TEST_CASE(
    "polygons of the largest number of corners, at few places, take memory in proportion and limited time") {
    for (const std::string corners : {" 1 2", " 1 2 3", " 1 2 3 4 5 6 7"}) {
        CAPTURE(corners);
        std::string face = "f";
        const std::size_t turns = 100'000 / (corners.size() / 2);
        for (std::size_t turn = 0; turn < turns; ++turn) face += corners;
        std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 1 0\nv 2 2 1\nv 0 2 0\n";
        const Outcome outcome = outcome_of_text(text + repeated(face + "\n", size));
        CHECK(outcome.fault == "");
        CHECK_FALSE(outcome.accepted);
    }
}

TEST_CASE("a polygon of the largest number of corners, with only ears or few ears, takes limited time") {
    for (const bool is_comb : {false, true}) {
        std::string text;
        std::string face = "f";
        constexpr int corners = 100'000;
        for (int corner = 0; corner < corners; ++corner) {
            const double angle = 6.283185307179586 * corner / corners;
            const double radius = corner * 7919 % 1000 + 10;
            if (is_comb)
                text += fmt::format("v {} {} 0\n", corner < 2 ? corner * corners : corners - corner,
                                    corner < 2 ? -1 : corner % 2 * 50);
            else
                text +=
                    fmt::format("v {:.8f} {:.8f} 0\n", radius * std::cos(angle), radius * std::sin(angle));
            face += fmt::format(" {}", corner + 1);
        }
        const Outcome outcome = outcome_of_text(text + face + "\n");
        CHECK(outcome.fault == "");
        CHECK(outcome.accepted);
    }
}

}  // namespace interleaf::fuzz
