// Tests of adaptive parameter domains, with the star over two of its constants.
#include "sequence/adaptive_domain.h"

#include <algorithm>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/core.h>

#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "hierarchy/union_mesh.h"
#include "shapes/blend_error.h"
#include "shapes/shapes.h"

using namespace interleaf;

namespace {

constexpr double tolerance = 0.08;  ///< distance
constexpr DomainBox box{{0.2, 10}, {1.2, 40}};

/// The star whose arm and sharpness are \p at.
Shape star_at(const glm::dvec2& at) {
    return with_constants(*find_shape("star"), {0.62, at.x, at.y});
}

ComputedSurfaces stars() {
    return {.key =
                [](const glm::dvec2& at) {
                    return Key{fmt::format("{}, {}", at.x, at.y), make_key(star_at(at), {{}, 0.005})};
                },
            .distance =
                [](const glm::dvec2& at, const UnionMesh& mesh, std::span<const glm::vec3> positions) {
                    return distance_from(star_at(at), mesh, positions) / tolerance;
                }};
}

/// The family over a regular grid of parameters, \p parts intervals per side.
Family uniform_family(const ComputedSurfaces& surfaces, Index parts) {
    Family family;
    std::vector<DomainVertex> vertices;
    std::vector<Triangle> triangles;
    for (Index row = 0; row <= parts; ++row)
        for (Index column = 0; column <= parts; ++column) {
            const glm::dvec2 at = box.low + glm::dvec2(column, row) / double(parts) * (box.high - box.low);
            const Index vertex = static_cast<Index>(vertices.size());
            vertices.push_back({at, vertex});
            family.keys.push_back(surfaces.key(at));
            if (row == parts || column == parts) continue;
            const Index above = vertex + parts + 1;
            triangles.push_back({vertex, vertex + 1, above + 1});
            triangles.push_back({vertex, above + 1, above});
        }
    family.domain.emplace(std::move(vertices), std::move(triangles));
    return family;
}

/// The distance of the blend at \p parameter.
double distance_at(const Family& family, const glm::dvec2& parameter, const ComputedSurfaces& surfaces) {
    const Weights weights = family.domain->weights(family.domain->locate(parameter));
    const UnionMesh mesh = unite(family, weights);
    return surfaces.distance(parameter, mesh, morph(mesh, weight_values(weights)));
}

/// The largest distance at random parameters, as a part of the tolerance.
double largest_distance(const Family& family, const ComputedSurfaces& surfaces, int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0, 1);
    double largest = 0;
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 parts(part(random), part(random));
        largest = std::max(largest, distance_at(family, box.low + parts * (box.high - box.low), surfaces));
    }
    return largest;
}

}  // namespace

TEST_CASE("an adaptive domain meets its tolerance everywhere, with fewer keys than a uniform one that does") {
    constexpr unsigned seed = 1;
    const ComputedSurfaces surfaces = stars();
    const Family family = adapt_domain(surfaces, {.box = box});
    CHECK(check(family).empty());
    CHECK(largest_distance(family, surfaces, 200, seed) <= 1);
    Index parts = 1;
    while (largest_distance(uniform_family(surfaces, parts), surfaces, 200, seed) > 1) ++parts;
    const std::size_t uniform = std::size_t{parts + 1} * (parts + 1);
    MESSAGE("seed " << seed << ": " << family.keys.size() << " keys, " << uniform << " in a uniform domain");
    CHECK(family.keys.size() < uniform);
}

TEST_CASE("at the vertices of the domain the blend is the key, as near as keys are") {
    const ComputedSurfaces surfaces = stars();
    const Family family = adapt_domain(surfaces, {.box = box});
    for (const DomainVertex& vertex : family.domain->vertices())
        CHECK(distance_at(family, vertex.at, surfaces) < 0.5);
}

TEST_CASE("a tolerance that needs too many keys is refused") {
    CHECK_THROWS_AS(adapt_domain(stars(), {.box = box, .max_keys = 5}), InputError);
}

TEST_CASE("progress may end the work") {
    struct Ended {};
    CHECK_THROWS_AS(adapt_domain(stars(), {.box = box},
                                 [](std::size_t keys) {
                                     if (keys == 3) throw Ended();
                                 }),
                    Ended);
}
