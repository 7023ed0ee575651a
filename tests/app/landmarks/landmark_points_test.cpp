// Tests of the landmarks that a person sets: pairs, names, mirrored sides, undo.
#include "app/landmarks/landmark_points.h"

#include <algorithm>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

constexpr std::size_t meshes = 2;

/// Points of a four-legged animal: nose, ears, hands, feet, tail; moved by \p offset.
std::vector<glm::dvec3> animal(const glm::dvec3& offset = {}) {
    std::vector<glm::dvec3> places = {{1, 0.6, 0},     {0.8, 0.9, 0.1}, {0.8, 0.9, -0.1}, {0.5, -1, 0.3},
                                      {0.5, -1, -0.3}, {-0.6, -1, 0.3}, {-0.6, -1, -0.3}, {-1, 0.4, 0.01}};
    for (glm::dvec3& place : places) place += offset;
    return places;
}

LandmarkPoints pairs_of(const std::vector<glm::dvec3>& first, const std::vector<glm::dvec3>& other) {
    LandmarkPoints points;
    for (std::size_t k = 0; k < first.size(); ++k) {
        add_place(points, meshes, 0, first[k], {});
        add_place(points, meshes, 1, other[k], {});
    }
    return points;
}

}  // namespace

TEST_CASE("a point without a partner gets one by the next click on the other mesh") {
    LandmarkPoints points;
    CHECK(add_place(points, meshes, 0, {1, 0, 0}, {}) == 0);
    CHECK_FALSE(is_paired(points[0], 1));
    CHECK(counting_landmarks(points, 0).empty());
    CHECK(add_place(points, meshes, 1, {2, 0, 0}, {}) == 0);
    CHECK(is_paired(points[0], 1));
    REQUIRE(counting_landmarks(points, 1).size() == 1);
    CHECK(counting_landmarks(points, 1).front().position == glm::dvec3(2, 0, 0));
    CHECK(counting_landmarks(points, 1).front().name == "1");

    // Two points in a row on one mesh: the selected one, else the last one, gets the partner.
    CHECK(add_place(points, meshes, 0, {3, 0, 0}, 0) == 1);
    CHECK(add_place(points, meshes, 0, {4, 0, 0}, 1) == 2);
    CHECK(add_place(points, meshes, 1, {5, 0, 0}, 1) == 1);
    CHECK(add_place(points, meshes, 1, {6, 0, 0}, {}) == 2);
    CHECK(points.size() == 3);
}

TEST_CASE("of three meshes, each counts the landmarks that it shares with the first") {
    LandmarkPoints points;
    add_place(points, 3, 0, {1, 0, 0}, {});
    add_place(points, 3, 2, {2, 0, 0}, {});
    CHECK(is_paired(points[0], 0));
    CHECK_FALSE(is_paired(points[0], 1));
    CHECK(is_paired(points[0], 2));
    CHECK(counting_landmarks(points, 0).size() == 1);
    CHECK(counting_landmarks(points, 1).empty());
}

TEST_CASE("names are not empty, can be printed, and belong to one landmark") {
    LandmarkPoints points = pairs_of(animal(), animal());
    points[2].name = "nose";
    CHECK(free_name(points) == "3");
    CHECK(fault_of_name(points, 2, "nose") == "");
    CHECK(fault_of_name(points, 0, "left ear") == "");
    CHECK(fault_of_name(points, 0, "nose") != "");
    CHECK(fault_of_name(points, 0, "") != "");
    CHECK(fault_of_name(points, 0, "a\nb") != "");
}

TEST_CASE("pairs that mirror each other are found, and swapping sides exchanges them on one mesh") {
    const std::vector<glm::dvec3> places = animal();
    std::vector<std::array<std::size_t, 2>> pairs = mirror_pairs(places);
    std::ranges::sort(pairs);
    CHECK(pairs == std::vector<std::array<std::size_t, 2>>{{1, 2}, {3, 4}, {5, 6}});
    CHECK(mirror_pairs({}).empty());
    CHECK(mirror_pairs({{0, 0, 0}, {1, 0, 0}}).empty());

    LandmarkPoints points = pairs_of(places, animal({5, 0, 0}));
    const LandmarkPoints before = points;
    CHECK(swap_sides(points, 1));
    CHECK(points[1].places[1] == before[2].places[1]);
    CHECK(points[1].places[0] == before[1].places[0]);
    CHECK(points[0].places[1] == before[0].places[1]);
    // The fit gets the exchanged places under the same names.
    CHECK(counting_landmarks(points, 1)[1].name == before[1].name);
    CHECK(counting_landmarks(points, 1)[1].position == *before[2].places[1]);
    CHECK(swap_sides(points, 1));
    CHECK(points == before);
}

TEST_CASE("landmarks of a file come to those of their names, or are new; those of a family stay") {
    LandmarkPoints points = pairs_of(animal(), animal());
    points[0].name = "nose";
    points[1].direction = glm::dvec3(0, 0, 1);
    points[1].name = "ear";
    const LandmarkPoints before = points;
    const std::vector<Landmark> file = {{"nose", {9, 0, 0}}, {"ear", {8, 0, 0}}, {"tail", {7, 0, 0}}};
    put_landmarks(points, meshes, 0, file);
    CHECK(points.size() == before.size() + 1);
    CHECK(points[0].places[0] == glm::dvec3(9, 0, 0));
    CHECK(points[0].places[1] == before[0].places[1]);
    CHECK(points[1] == before[1]);
    CHECK(points.back().name == "tail");
    CHECK_FALSE(points.back().places[1]);
    put_landmarks(points, meshes, 1, file);
    CHECK(points[1].places[1] == glm::dvec3(8, 0, 0));
    CHECK(is_paired(points.back(), 1));
    CHECK(landmarks_on(points, 1).size() == points.size());
}

TEST_CASE("every change of landmarks can be undone and redone; a drag is one step") {
    LandmarkHistory history;
    CHECK_FALSE(history.can_undo());
    LandmarkPoints one;
    add_place(one, meshes, 0, {1, 0, 0}, {});
    history.push(one);
    history.push(one);  // no change
    LandmarkPoints moved = one;
    moved[0].places[0] = {2, 0, 0};
    history.push(moved);
    moved[0].places[0] = {3, 0, 0};
    history.amend(moved);
    history.undo();
    CHECK(history.points() == one);
    history.redo();
    CHECK(history.points() == moved);
    CHECK_FALSE(history.can_redo());
    history.undo();
    history.undo();
    CHECK(history.points().empty());
    CHECK_FALSE(history.can_undo());
    history.push(moved);
    CHECK_FALSE(history.can_redo());
}
