#include "sequence/sequences_of_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/measure.h"
#include "hierarchy/morph.h"
#include "sequence/deformation_flow.h"
#include "shapes/leaf_triangles.h"

namespace interleaf {

void check_sequence(const Family& family, int euler) {
    CHECK(check(family).empty());
    std::vector<const Hierarchy*> keys;
    for (const Key& key : family.keys) {
        CAPTURE(key.name);
        CHECK(check(*key.hierarchy).empty());
        CHECK(euler_number(leaf_triangles(*key.hierarchy)) == euler);
        keys.push_back(&*key.hierarchy);
    }
    CHECK(check_constraints(keys).empty());
    for (std::size_t i = 0; i + 1 < family.keys.size(); ++i) {
        CAPTURE(i);
        const UnionMesh mesh = unite(family, {{i, 0.5}, {i + 1, 0.5}});
        CHECK(mesh.leaf_count() >= keys[i]->leaf_count());
        CHECK(mesh.leaf_count() >= keys[i + 1]->leaf_count());
        const Hierarchy blend = morphed_hierarchy(mesh, std::array{0.5F, 0.5F});
        CHECK(check(blend).empty());
        CHECK(euler_number(leaf_triangles(blend)) == euler);
    }
}

void check_same_bits(const Family& family, const Family& other) {
    CHECK(family.timeline == other.timeline);
    REQUIRE(family.keys.size() == other.keys.size());
    for (std::size_t i = 0; i < family.keys.size(); ++i) {
        CAPTURE(i);
        const Hierarchy& one = *family.keys[i].hierarchy;
        const Hierarchy& two = *other.keys[i].hierarchy;
        CHECK(one.bits == two.bits);
        CHECK(one.midpoints == two.midpoints);
        CHECK(one.positions == two.positions);
        CHECK(one.fields.at(0).values == two.fields.at(0).values);
    }
}

std::vector<std::size_t> leaf_counts(const Family& family) {
    std::vector<std::size_t> counts;
    for (const Key& key : family.keys) counts.push_back(key.hierarchy->leaf_count());
    return counts;
}

double neck_radius(const Hierarchy& key) {
    double radius = std::numeric_limits<double>::infinity();
    for (const glm::dvec3 position : key.positions)
        radius = std::min(radius, std::hypot(position.x, position.z));
    return radius;
}

double exact_neck(double distance) {
    double low = distance / 2 / 1.19967864;  // the least value of c cosh(d / 2c), where u tanh(u) = 1
    double high = 1;
    REQUIRE(low * std::cosh(distance / 2 / low) < 1);
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (middle * std::cosh(distance / 2 / middle) < 1 ? low : high) = middle;
    }
    return low;
}

void check_ball(const Hierarchy& key) {
    const std::vector<Triangle> triangles = leaf_triangles(key);
    const double radius = flow_ball_radius;
    const double volume = 4 * std::numbers::pi / 3 * std::pow(radius, 3);
    CHECK(measure(triangles, key.positions).volume / volume == doctest::Approx(1).epsilon(0.005));

    // Each direction from the center meets one leaf, so the distance along it bounds the distance of both
    // surfaces from each other. A chord is farthest from its sphere at a corner of a leaf or inside, near the
    // middle of the leaf or of an edge.
    double solid_angle = 0;
    double farthest = 0;
    for (const Triangle& triangle : triangles) {
        std::array<glm::dvec3, 3> corners{};
        for (unsigned k = 0; k < 3; ++k)
            corners[k] = glm::dvec3(key.positions[triangle[k]]) - flow_ball_center;
        const auto& [a, b, c] = corners;
        for (const glm::dvec3& point :
             {a, b, c, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0})
            farthest = std::max(farthest, std::abs(glm::length(point) - radius));
        const double determinant = glm::dot(a, glm::cross(b, c));
        CHECK(determinant > 0);
        solid_angle += 2 * std::atan2(determinant, glm::length(a) * glm::length(b) * glm::length(c) +
                                                       glm::dot(a, b) * glm::length(c) +
                                                       glm::dot(b, c) * glm::length(a) +
                                                       glm::dot(c, a) * glm::length(b));
    }
    CHECK(solid_angle == doctest::Approx(4 * std::numbers::pi));
    CHECK(farthest < 0.01 * radius);
}

}  // namespace interleaf
