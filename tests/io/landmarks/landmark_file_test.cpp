// Landmark files come back to the last bit, and faults in them are named with their places.
#include "io/landmarks/landmark_file.h"

#include <string>
#include <utility>
#include <vector>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/geometric.hpp>

using namespace interleaf;

namespace {

/// A file with these landmarks and whatever follows them.
std::string file_with(const std::string& landmarks, const std::string& rest = "") {
    return R"({"format": "interleaf-landmarks", "version": 1, "landmarks": [)" + landmarks + "]" + rest + "}";
}

std::string fault_of_text(const std::string& text) {
    return input_error_of([&] { parse_landmarks(text, "cow.json"); });
}

}  // namespace

TEST_CASE("landmarks are written and read to the last bit") {
    LandmarkSet set;
    set.landmarks = {{"nose", {0.1, -1e-300, 1.0 / 3}},
                     {"left ear \"é\"", {1e30, 0, -5}, glm::normalize(glm::dvec3(1, 2, 3))},
                     {"right ear", {7, 8, 9}, glm::dvec3(0, -1, 0)}};
    set.symmetric = {{"left ear \"é\"", "right ear"}};
    const LandmarkSet read = parse_landmarks(landmarks_text(set), "x");
    REQUIRE(read.landmarks.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(read.landmarks[k].name == set.landmarks[k].name);
        CHECK(read.landmarks[k].position == set.landmarks[k].position);
        CHECK(read.landmarks[k].direction == set.landmarks[k].direction);
    }
    CHECK(read.symmetric == set.symmetric);
    CHECK(landmarks_text(read) == landmarks_text(set));
}

TEST_CASE("directions of a few digits become unit vectors") {
    const LandmarkSet set = parse_landmarks(
        file_with(R"({"name": "a", "position": [0, 0, 0], "direction": [0.577, 0.577, 0.577]})"), "x");
    CHECK(glm::length(*set.landmarks[0].direction) == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("faults are named with file and place") {
    const std::string nose = R"({"name": "nose", "position": [0, 0, 0]})";
    const std::pair<std::string, std::string> cases[] = {
        {"", "cow.json: "},
        {"[]", "cow.json: document: is an array, expected an object"},
        {R"({"format": "interleaf-family"})", "cow.json: format: is \"interleaf-family\""},
        {R"({"format": "interleaf-landmarks", "version": 2})", "cow.json: version: is 2, expected 1"},
        {file_with(""), "landmarks: has 0 landmarks, expected 1 to 256"},
        {file_with(nose + "," + nose), "landmarks[1].name: is \"nose\", expected a name that no other"},
        {file_with(R"({"name": "", "position": [0, 0, 0]})"), "landmarks[0].name: is \"\""},
        {file_with(R"({"name": "a\u0007", "position": [0, 0, 0]})"), "landmarks[0].name"},
        {file_with(R"({"name": "a", "position": [0, 0]})"), "landmarks[0].position"},
        {file_with(R"({"name": "a", "position": [0, 1e31, 0]})"), "landmarks[0].position[1]: is 1e+31"},
        {file_with(R"({"name": "a", "position": [0, 1e999, 0]})"), "cow.json: line 1: "},
        {file_with(R"({"name": "a", "position": [0, 0, 0], "direction": [1, 1, 0]})"),
         "landmarks[0].direction: is an array, expected a vector of length 1"},
        {file_with(nose, R"(, "symmetric": [["nose"]])"), "symmetric[0]: is an array, expected two names"},
        {file_with(nose, R"(, "symmetric": [["nose", "ear"]])"), "symmetric[0][1]: is \"ear\""},
        {file_with(nose, R"(, "symmetric": [["nose", "nose"]])"), "symmetric[0][1]: is \"nose\""},
    };
    for (const auto& [text, fault] : cases) {
        CAPTURE(text);
        CHECK(contains(fault_of_text(text), fault));
    }
    std::string many = nose;
    for (int i = 0; i < 256; ++i) many += fmt::format(R"(,{{"name": "{}", "position": [0, 0, 0]}})", i);
    CHECK(contains(fault_of_text(file_with(many)), "has 257 landmarks"));
}

TEST_CASE("a landmark file larger than a mebibyte is refused unread") {
    const ScratchFolder folder;
    put(folder / "large.json", std::string((1 << 20) + 1, ' '));
    CHECK(contains(input_error_of([&] { read_landmarks(folder / "large.json"); }), "large.json"));
}
