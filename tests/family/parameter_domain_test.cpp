// Tests of the parameter domain (paper, equation (5)).
#include "family/parameter_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "numbers.h"
#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"

using namespace interleaf;

namespace {

/// The paper's figure 8: four corners and the middle. Key numbers equal vertex numbers.
ParameterDomain square() {
    return {{{{-1, -1}, 0}, {{1, -1}, 1}, {{1, 1}, 2}, {{-1, 1}, 3}, {{0, 0}, 4}},
            {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

/// A domain that is not convex and has a hole: the square ring between (0,0)-(3,3) and (1,1)-(2,2), without
/// its last part. It has clockwise and counter-clockwise triangles.
ParameterDomain hook() {
    return {{{{0, 0}, 0},
             {{3, 0}, 1},
             {{3, 3}, 2},
             {{0, 3}, 3},
             {{1, 1}, 4},
             {{2, 1}, 5},
             {{2, 2}, 6},
             {{1, 2}, 7}},
            {{0, 1, 5}, {0, 4, 5}, {1, 2, 6}, {1, 5, 6}, {2, 3, 7}, {2, 7, 6}}};
}

/// The vertices of a fan around the origin, all of them corners of a regular polygon.
ParameterDomain fan(unsigned count) {
    std::vector<DomainVertex> vertices{{{0.1, 0.2}, 0}};
    std::vector<Triangle> triangles;
    for (unsigned i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * i / count;
        vertices.push_back({{0.1 + std::cos(angle), 0.2 + std::sin(angle)}, i + 1});
        triangles.push_back({0, i + 1, (i + 1) % count + 1});
    }
    return {std::move(vertices), std::move(triangles)};
}

glm::dvec2 blend(const ParameterDomain& domain, const DomainPoint& point) {
    glm::dvec2 at(0);
    for (int corner = 0; corner < 3; ++corner) {
        const Index vertex = domain.triangles()[point.triangle][static_cast<unsigned>(corner)];
        at += point.barycentric[corner] * domain.vertices()[vertex].at;
    }
    return at;
}

void check_is_barycentric(const DomainPoint& point) {
    for (int corner = 0; corner < 3; ++corner) CHECK(point.barycentric[corner] >= 0);
    const double sum = point.barycentric.x + point.barycentric.y + point.barycentric.z;
    CHECK(sum == doctest::Approx(1).epsilon(1e-15));
}

/// Minimum distance of \p point from a fine grid in every triangle.
double sampled_distance(const ParameterDomain& domain, const glm::dvec2& point) {
    constexpr int parts = 200;
    double least = infinity;
    for (const auto& [a, b, c] : domain.triangles()) {
        for (int i = 0; i <= parts; ++i) {
            for (int j = 0; i + j <= parts; ++j) {
                const glm::dvec2 at =
                    (double(i) * domain.vertices()[a].at + double(j) * domain.vertices()[b].at +
                     double(parts - i - j) * domain.vertices()[c].at) /
                    double(parts);
                least = std::min(least, glm::distance(at, point));
            }
        }
    }
    return least;
}

/// The weight of each key, 0 for keys that are not active.
std::vector<double> dense_values(const Weights& weights, std::size_t key_count) {
    std::vector<double> values(key_count, 0);
    for (const Weight& weight : weights) values[weight.key] = weight.value;
    return values;
}

}  // namespace

TEST_CASE("the box of vertices has their least and greatest coordinates") {
    const ParameterDomain domain = hook();
    const DomainBox box = box_of(domain.vertices());
    CHECK(box.low == glm::dvec2(0, 0));
    CHECK(box.high == glm::dvec2(3, 3));
    CHECK(box_of(domain.vertices().subspan(5, 1)).low == glm::dvec2(2, 1));
    CHECK(box_of(domain.vertices().subspan(5, 1)).high == glm::dvec2(2, 1));
}

TEST_CASE(
    "locate gives the nearest point of the domain, inside and outside, even if the domain is not convex") {
    const unsigned seed = 5;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-2.5, 4.5);
    for (const ParameterDomain& domain : {square(), hook(), fan(7)}) {
        for (int i = 0; i < 40; ++i) {
            const glm::dvec2 point(coordinate(random), coordinate(random));
            CAPTURE(point.x);
            CAPTURE(point.y);
            const DomainPoint found = domain.locate(point);
            check_is_barycentric(found);
            CHECK(glm::distance(blend(domain, found), found.at) < 1e-14);
            // Every point of the domain has a grid point within 0.02, and no grid point is nearer than the
            // nearest point.
            const double sampled = sampled_distance(domain, point);
            CHECK(glm::distance(point, found.at) <= sampled + 1e-12);
            CHECK(glm::distance(point, found.at) >= sampled - 0.02);
        }
    }
}

TEST_CASE("a point inside stays where it is, to the last bit") {
    const glm::dvec2 point(0.3, 0.4);
    const DomainPoint found = square().locate(point);
    CHECK(found.at == point);
    CHECK(found.triangle == 2);
    const auto weights = dense_values(square().weights(found), 5);
    CHECK(weights[2] == doctest::Approx(0.35));
    CHECK(weights[3] == doctest::Approx(0.05));
    CHECK(weights[4] == doctest::Approx(0.6));
}

TEST_CASE(
    "a vertex of the domain gives its key weight 1 exactly, and its neighbors stay active with weight 0") {
    for (const ParameterDomain& domain : {square(), hook(), fan(7)}) {
        for (const DomainVertex& vertex : domain.vertices()) {
            const Weights weights = domain.weights(domain.locate(vertex.at));
            CHECK(weights.size() == 3);
            for (const Weight& weight : weights) CHECK(weight.value == (weight.key == vertex.key ? 1 : 0));
        }
    }
}

TEST_CASE("weights are continuous across every edge") {
    const unsigned seed = 11;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-2, 4);
    for (const ParameterDomain& domain : {square(), fan(7)}) {
        std::size_t crossings = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 from(coordinate(random), coordinate(random));
            glm::dvec2 a = from;
            glm::dvec2 b(coordinate(random), coordinate(random));
            const Index start = domain.locate(a).triangle;
            if (domain.locate(b).triangle == start) continue;
            ++crossings;
            // Bisects towards a point where the triangle changes.
            while (glm::distance(a, b) > 1e-10) {
                const glm::dvec2 middle = (a + b) / 2.0;
                (domain.locate(middle).triangle == start ? a : b) = middle;
            }
            const auto left = dense_values(domain.weights(domain.locate(a)), domain.vertices().size());
            const auto right = dense_values(domain.weights(domain.locate(b)), domain.vertices().size());
            for (std::size_t key = 0; key < left.size(); ++key)
                CHECK(std::abs(left[key] - right[key]) < 1e-7);
        }
        CHECK(crossings > 500);
    }
}

TEST_CASE("on a shared edge or vertex the current triangle is preferred, otherwise the lowest index") {
    for (const ParameterDomain& domain : {square(), hook(), fan(7)}) {
        const auto triangles = domain.triangles();
        for (Index t = 0; t < triangles.size(); ++t) {
            for (unsigned corner = 0; corner < 3; ++corner) {
                const Index v = triangles[t][corner];
                const Index w = triangles[t][(corner + 1) % 3];
                for (const double s : {0.0, 0.1, 1.0 / 3, 0.5, 0.7}) {
                    const glm::dvec2 at = (1 - s) * domain.vertices()[v].at + s * domain.vertices()[w].at;
                    CHECK(domain.locate(at, t).triangle == t);
                    const auto holds = [&](const Triangle& triangle) {
                        const auto has = [&](Index x) {
                            return std::find(triangle.begin(), triangle.end(), x) != triangle.end();
                        };
                        return has(v) && (s == 0 || has(w));
                    };
                    const auto lowest = std::find_if(triangles.begin(), triangles.end(), holds);
                    CHECK(domain.locate(at).triangle == static_cast<Index>(lowest - triangles.begin()));
                }
            }
        }
    }
}

TEST_CASE("a current triangle that is not nearest, or does not exist, is not preferred") {
    CHECK(square().locate({0, 0.5}, 0).triangle == 2);
    CHECK(square().locate({0, 0.5}, 99).triangle == 2);
    // Outside the domain, a corner is the nearest point of two triangles.
    CHECK(square().locate({5, 5}, 2).triangle == 2);
    CHECK(square().locate({5, 5}, 0).triangle == 1);
}

TEST_CASE("points far away are located, points that are not finite are rejected") {
    const double huge = std::numeric_limits<double>::max();
    CHECK(square().locate({1000, 2000}).at == glm::dvec2(1, 1));
    CHECK(square().locate({-1000, 0.5}).at == glm::dvec2(-1, 0.5));
    check_is_barycentric(square().locate({huge, huge}));
    check_is_barycentric(square().locate({-huge, 0}));
    CHECK_THROWS_AS(square().locate({std::nan(""), 0}), InputError);
    CHECK_THROWS_AS(square().locate({0, infinity}), InputError);
}

TEST_CASE("a key at several corners gets the sum of their weights") {
    const ParameterDomain domain({{{0, 0}, 7}, {{1, 0}, 3}, {{0, 1}, 7}}, {{0, 1, 2}});
    const Weights weights = domain.weights(domain.locate({0.25, 0.5}));
    CHECK(weights == Weights{{3, 0.25}, {7, 0.75}});
}

TEST_CASE("point_of is the inverse of weights") {
    const unsigned seed = 3;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1.2, 3.2);
    for (const ParameterDomain& domain : {square(), hook(), fan(7)}) {
        for (int i = 0; i < 500; ++i) {
            const DomainPoint point = domain.locate({coordinate(random), coordinate(random)});
            const auto found = domain.point_of(domain.weights(point));
            REQUIRE(found.has_value());
            CHECK(glm::distance(*found, point.at) < 1e-14);
        }
    }
}

TEST_CASE("point_of takes the keys of an edge or of a vertex alone") {
    CHECK(square().point_of({{0, 0.25}, {4, 0.75}}) == glm::dvec2(-0.25, -0.25));
    CHECK(square().point_of({{2, 1}}) == glm::dvec2(1, 1));
}

TEST_CASE("point_of returns none if the weights are no point of the domain") {
    CHECK_FALSE(square().point_of({}));
    CHECK_FALSE(square().point_of({{0, 0.5}, {2, 0.5}}));           // no edge joins them
    CHECK_FALSE(square().point_of({{0, 0.5}, {2, 0}, {4, 0.5}}));   // no triangle has all three
    CHECK_FALSE(square().point_of({{0, 0.5}, {4, 0.4}}));           // wrong sum
    CHECK_FALSE(square().point_of({{0, -0.5}, {1, 0.5}, {4, 1}}));  // negative
    CHECK_FALSE(square().point_of({{9, 1}}));                       // not in the domain
    CHECK_FALSE(square().point_of({{0, std::nan("")}, {4, 1}}));    // not a number
    const ParameterDomain twice({{{0, 0}, 7}, {{1, 0}, 3}, {{0, 1}, 7}}, {{0, 1, 2}});
    CHECK_FALSE(twice.point_of({{3, 0.5}, {7, 0.5}}));  // a key at two vertices
}

TEST_CASE("a domain is rejected unless its triangles share only vertices and whole edges") {
    using Vertices = std::vector<DomainVertex>;
    const auto refused = [](const Vertices& vertices, const std::vector<Triangle>& triangles,
                            const char* part) {
        CAPTURE(part);
        CHECK_THROWS_WITH_AS(ParameterDomain(vertices, triangles), doctest::Contains(part), InputError);
    };
    const Vertices corner = {{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 2}};

    refused(corner, {}, "no triangle");
    refused(corner, {{0, 1, 3}}, "refers to vertex 3, but there are only 3 vertices");
    refused({{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 2}, {{1, 1}, 3}}, {{0, 1, 2}},
            "vertex 3 belongs to no triangle");
    refused({{{0, 0}, 0}, {{infinity, 0}, 1}, {{0, 1}, 2}}, {{0, 1, 2}}, "vertex 1 is not finite");
    refused({{{0, 0}, 0}, {{1, 0}, 1}, {{0, std::nan("")}, 2}}, {{0, 1, 2}}, "vertex 2 is not finite");
    refused({{{0, 0}, 0}, {{0.1, 0.1}, 1}, {{0.3, 0.3}, 2}}, {{0, 1, 2}}, "triangle 0 has no area");
    refused(corner, {{0, 1, 2}, {0, 1, 1}}, "triangle 1 has no area");
    refused({{{1e300, 0}, 0}, {{-1e300, 0}, 1}, {{0, 1e300}, 2}}, {{0, 1, 2}}, "no area");
    refused(corner, {{0, 1, 2}, {2, 1, 0}}, "triangles 0 and 1 overlap");

    const Vertices star = {{{0, 0}, 0}, {{4, 0}, 1}, {{2, 4}, 2}, {{0, 3}, 3}, {{4, 3}, 4}, {{2, -1}, 5}};
    refused(star, {{0, 1, 2}, {3, 4, 5}}, "triangles 0 and 1 overlap");
    const Vertices nested = {{{0, 0}, 0}, {{9, 0}, 1}, {{0, 9}, 2}, {{1, 1}, 3}, {{2, 1}, 4}, {{1, 2}, 5}};
    refused(nested, {{0, 1, 2}, {3, 4, 5}}, "triangles 0 and 1 overlap");
    const Vertices same_side = {{{0, 0}, 0}, {{4, 0}, 1}, {{2, 4}, 2}, {{2, 1}, 3}};
    refused(same_side, {{0, 1, 2}, {0, 1, 3}}, "triangles 0 and 1 overlap");

    const Vertices hanging = {{{0, 0}, 0}, {{2, 0}, 1}, {{0, 2}, 2}, {{1, 0}, 3}, {{1, -1}, 4}};
    refused(hanging, {{0, 1, 2}, {0, 3, 4}}, "vertex 3 lies on triangle 0");
    const Vertices doubled = {{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 2}, {{0, 0}, 3}, {{-1, 0}, 4}, {{0, -1}, 5}};
    refused(doubled, {{0, 1, 2}, {3, 4, 5}}, "vertex 3 lies on triangle 0");
}

TEST_CASE("domains whose triangles touch along lines that rounding bends are accepted") {
    for (unsigned count = 3; count < 60; ++count) CHECK(fan(count).triangles().size() == count);
}

TEST_CASE("a point is located far from the origin, where rounding is coarser than the domain's own slack") {
    const unsigned seed = 11;
    CAPTURE(seed);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> unit(-1, 2);
    for (const double offset : {0.0, 1e4, 1e5, 1e6, 1e7}) {
        CAPTURE(offset);
        const ParameterDomain domain({{{offset, 0}, 0}, {{offset + 1, 0.3}, 1}, {{offset, 1}, 2}},
                                     {{0, 1, 2}});
        for (int i = 0; i < 3000; ++i) {
            const DomainPoint point = domain.locate({offset + unit(generator), unit(generator)});
            REQUIRE(point.triangle == 0);
            REQUIRE(point.barycentric.x + point.barycentric.y + point.barycentric.z == doctest::Approx(1));
        }
    }
}
