#include "sequence/catenoid.h"

#include <cmath>

#include <doctest/doctest.h>

#include "hierarchy/measure.h"
#include "sequence/sequences_of_keys.h"
#include "shapes/leaf_triangles.h"

namespace interleaf {
namespace {

double area_of(const Hierarchy& key) {
    return measure(leaf_triangles(key), key.positions).area;
}

const Family& catenoid() {
    static const Family family = make_catenoid({.steps = {.steps = 8, .tolerance = 0.001}});
    return family;
}

const Family& collapse() {
    static const Family family = make_catenoid({.steps = {.steps = 8, .tolerance = 0.002}, .distance = 1.45});
    return family;
}

TEST_CASE("every key of the film is a cylinder in topology, and consecutive keys unite") {
    check_sequence(catenoid(), 0);
    check_sequence(collapse(), 0);
}

TEST_CASE("the film becomes the catenoid: its neck within 0.2 % of the exact one, its area within 0.1 %") {
    const double neck = exact_neck(1);
    CHECK(neck == doctest::Approx(0.8483).epsilon(0.0001));
    const Hierarchy& last = *catenoid().keys.back().hierarchy;
    CHECK(neck_radius(last) == doctest::Approx(neck).epsilon(0.002));
    CHECK(area_of(last) ==
          doctest::Approx(3.14159265 * neck * (1 + neck * std::sinh(1 / neck))).epsilon(0.001));
    const std::vector<std::size_t> counts = leaf_counts(catenoid());
    CHECK(counts.back() > counts.front());
}

TEST_CASE("the catenoid's neck is exact to 0.2 % at other distances of the rings, too") {
    for (const double distance : {0.5, 1.2}) {
        CAPTURE(distance);
        const Family family =
            make_catenoid({.steps = {.steps = 2, .tolerance = 0.001}, .distance = distance});
        CHECK(neck_radius(*family.keys.back().hierarchy) ==
              doctest::Approx(exact_neck(distance)).epsilon(0.002));
    }
}

TEST_CASE("the film's area shrinks from key to key") {
    for (const Family* family : {&catenoid(), &collapse()}) {
        for (std::size_t i = 1; i < family->keys.size(); ++i) {
            CAPTURE(i);
            // Refinement may add a little, as it puts vertices on the arcs over their edges.
            CHECK(area_of(*family->keys[i].hierarchy) < area_of(*family->keys[i - 1].hierarchy) + 1e-4);
        }
    }
}

TEST_CASE("the neck of a collapsing film narrows from key to key, to a tenth of the rings") {
    const std::vector<Key>& keys = collapse().keys;
    CHECK(neck_radius(*keys.front().hierarchy) == doctest::Approx(1));
    for (std::size_t i = 1; i < keys.size(); ++i)
        CHECK(neck_radius(*keys[i].hierarchy) < neck_radius(*keys[i - 1].hierarchy));
    CHECK(neck_radius(*keys.back().hierarchy) < 0.12);
    CHECK(neck_radius(*keys.back().hierarchy) > 0.05);
    const std::vector<std::size_t> counts = leaf_counts(collapse());
    CHECK(counts.back() > 2 * counts.front());
    CHECK(counts.back() < 20 * counts.front());
}

TEST_CASE("the neck narrows in every step, also in many steps and at other distances") {
    for (const double distance : {1.6, 2.0, 2.7}) {
        CAPTURE(distance);
        const Family family =
            make_catenoid({.steps = {.steps = 60, .tolerance = 0.01}, .distance = distance});
        CHECK(family.keys.size() == 61);
        for (std::size_t i = 1; i < family.keys.size(); ++i) {
            CAPTURE(i);
            CHECK(neck_radius(*family.keys[i].hierarchy) < neck_radius(*family.keys[i - 1].hierarchy));
        }
        CHECK(neck_radius(*family.keys.back().hierarchy) <= narrowest_neck);
    }
}

TEST_CASE("rings of all distances that are allowed give sound films, also with the coarsest tolerance") {
    for (const double distance : {0.2, 1.0, 3.0}) {
        CAPTURE(distance);
        check_sequence(make_catenoid({.steps = {.steps = 2, .tolerance = 0.05}, .distance = distance}), 0);
    }
}

TEST_CASE("the rings of every key are the rings, and its vertices lie between them") {
    for (const Key& key : catenoid().keys) {
        CAPTURE(key.name);
        for (const glm::dvec3 position : key.hierarchy->positions) {
            CHECK(std::abs(position.y) <= 0.5);
            if (std::abs(position.y) == 0.5)
                CHECK(std::hypot(position.x, position.z) == doctest::Approx(1).epsilon(1e-6));
        }
    }
}

TEST_CASE("the mean curvature is half on the cylinder, and vanishes on the catenoid") {
    const auto curvatures = [](const Key& key) {
        REQUIRE(key.hierarchy->fields.size() == 1);
        CHECK(key.hierarchy->fields[0].name == "mean curvature");
        return key.hierarchy->fields[0].values;
    };
    for (const float curvature : curvatures(catenoid().keys.front()))
        CHECK(curvature == doctest::Approx(0.5).epsilon(0.15));
    for (const float curvature : curvatures(catenoid().keys.back())) CHECK(std::abs(curvature) < 0.01);
}

TEST_CASE("two runs of the film give the same bits") {
    const CatenoidOptions options{.steps = {.steps = 4, .tolerance = 0.01}, .distance = 1.4};
    check_same_bits(make_catenoid(options), make_catenoid(options));
}

}  // namespace
}  // namespace interleaf
