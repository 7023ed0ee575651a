// The bounding volume tree finds what a search through all boxes finds.
#include "fit/mesh/box_tree.h"

#include <limits>
#include <random>
#include <set>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

std::vector<SpaceBox> random_boxes(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> place(-1, 1);
    std::uniform_real_distribution<double> side(0, 0.1);
    std::vector<SpaceBox> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        // Many centers coincide, as the centers of equal triangles do.
        const glm::dvec3 low =
            i % 3 == 0 ? glm::dvec3(0.25) : glm::dvec3{place(random), place(random), place(random)};
        boxes.push_back({low, low + glm::dvec3{side(random), side(random), side(random)}});
    }
    return boxes;
}

}  // namespace

TEST_CASE("every box that contains a point is found, and the nearest box is the nearest") {
    for (const std::size_t count : {1U, 2U, 4U, 5U, 9U, 1000U}) {
        CAPTURE(count);
        std::mt19937 random(static_cast<unsigned>(count));
        std::uniform_real_distribution<double> place(-1.2, 1.2);
        const std::vector<SpaceBox> boxes = random_boxes(random, count);
        const BoxTree tree(boxes);
        for (int trial = 0; trial < 200; ++trial) {
            const glm::dvec3 point = trial % 4 == 0 ? boxes[static_cast<std::size_t>(trial) % count].max
                                                    : glm::dvec3{place(random), place(random), place(random)};
            std::set<Index> found;
            tree.find(point, [&](Index item) {
                if (boxes[item].contains(point)) found.insert(item);
                return false;
            });
            std::set<Index> expected;
            double least = std::numeric_limits<double>::infinity();
            for (Index item = 0; item < count; ++item) {
                if (boxes[item].contains(point)) expected.insert(item);
                least = std::min(least, boxes[item].squared_distance(point));
            }
            CHECK(found == expected);
            double nearest = std::numeric_limits<double>::infinity();
            tree.find_nearest(point, nearest, 0,
                              [&](Index item) { return boxes[item].squared_distance(point); });
            CHECK(nearest == least);
        }
    }
}

TEST_CASE("a search ends where it is told to") {
    std::mt19937 random(7);
    const std::vector<SpaceBox> boxes(100, SpaceBox{glm::dvec3(-1), glm::dvec3(1)});
    int visits = 0;
    CHECK(BoxTree(boxes).find(glm::dvec3(0), [&](Index) { return ++visits == 3; }));
    CHECK(visits == 3);
    CHECK_FALSE(BoxTree(boxes).find(glm::dvec3(2), [](Index) { return true; }));

    const std::vector<SpaceBox> many = random_boxes(random, 1000);
    const BoxTree tree(many);
    const glm::dvec3 outside(0, 0, 3);
    const auto calls_until = [&](double enough, double& nearest) {
        std::size_t calls = 0;
        nearest = std::numeric_limits<double>::infinity();
        // The items are farther away than their boxes, as triangles are.
        tree.find_nearest(outside, nearest, enough, [&](Index item) {
            ++calls;
            return many[item].squared_distance(outside) + 4;
        });
        return calls;
    };
    double least = 0;
    double near_enough = 0;
    double any = 0;
    const std::size_t all_calls = calls_until(0, least);
    CHECK(calls_until(1.5 * least, near_enough) < all_calls);
    CHECK(near_enough <= 1.5 * least);
    CHECK(calls_until(std::numeric_limits<double>::max(), any) < all_calls);
}
