// Large files of each format without content, which take the most memory for their size.
#include <string>

#include "fuzz/target.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

namespace interleaf::fuzz {

namespace {

constexpr std::size_t size = 8'000'000;

std::string repeated(std::string_view text, std::size_t bytes) {
    std::string result;
    while (result.size() < bytes) result += text;
    return result;
}

void check_outcome(const std::string& text, bool accepted) {
    const Outcome outcome = outcome_of(std::as_bytes(std::span(text)));
    CHECK(outcome.fault == "");
    CHECK(outcome.accepted == accepted);
}

std::string ply(std::string_view format, std::string_view vertices, std::string_view elements) {
    return fmt::format(
        "ply\nformat {} 1.0\nelement vertex {}\nproperty char x\nproperty char y\nproperty char "
        "z\n{}end_header\n",
        format, vertices, elements);
}

}  // namespace

TEST_CASE("a binary PLY of the shortest faces, strips or vertices takes memory in proportion") {
    const std::string corners("\0\0\0\1\0\0\0\1\0", 9);
    const std::string face("\3\0\1\2", 4);
    check_outcome(ply("binary_little_endian", "3",
                      fmt::format("element face {}\nproperty list char char vertex_indices\n", size / 4)) +
                      corners + repeated(face, size),
                  true);
    const std::string count("\0\x12\x7a\0", 4);  // 8,000,000
    std::string strip = repeated(std::string("\0\1\2", 3), size);
    strip.resize(size);
    check_outcome(
        ply("binary_little_endian", "3", "element tristrips 1\nproperty list int char vertex_indices\n") +
            corners + count + strip,
        false);
    check_outcome(ply("binary_little_endian", std::to_string(size / 3),
                      "element face 1\nproperty list char char vertex_indices\n") +
                      repeated(corners, size).substr(0, size / 3 * 3) + face,
                  true);
}

TEST_CASE("a text PLY of the shortest faces or strips takes memory in proportion") {
    const std::string corners = "0 0 0 1 0 0 0 1 0\n";
    check_outcome(ply("ascii", "3",
                      fmt::format("element face {}\nproperty list char char vertex_indices\n", size / 8)) +
                      corners + repeated("3 0 1 2\n", size),
                  true);
    check_outcome(ply("ascii", "3", "element tristrips 1\nproperty list int char vertex_indices\n") +
                      corners + "3999999 " + repeated("0 1 2 ", size),
                  false);
    check_outcome(ply("ascii", "3", "element tristrips 1\nproperty list int char vertex_indices\n") +
                      corners + "999999 " + repeated("0 1 2 ", 2 * 999'999),
                  true);
}

TEST_CASE("an OFF of the shortest faces or vertices, or of long polygons, takes memory in proportion") {
    const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
    check_outcome("3 " + std::to_string(size / 8) + "\n" + corners + repeated("3 0 1 2\n", size), true);
    check_outcome(fmt::format("{} 1\n", size / 6 + 1) + repeated("0 0 0\n", size) + "3 0 1 2\n", true);
    std::string polygon = "100000";
    for (int corner = 0; corner < 50'000; ++corner) polygon += " 0 1";
    check_outcome("OFF 3 40\n" + corners + repeated(polygon + "\n", size), false);
}

TEST_CASE("an STL of text, and one in UTF-16, take memory in proportion") {
    const std::string facet = "facet normal\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
    check_outcome("solid\n" + repeated(facet, size) + "endsolid\n", true);
    check_outcome("solid\n" + repeated("vertex 0 0 0 vertex 0 0 1 vertex 0 1 0 endloop ", size), true);
    std::string utf16;
    for (const char c : "solid\n" + repeated(facet, size / 2)) utf16 += {c, '\0'};
    check_outcome(utf16, true);
}

}  // namespace interleaf::fuzz
