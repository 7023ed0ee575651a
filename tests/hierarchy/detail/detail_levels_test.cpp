#include "hierarchy/detail/detail_levels.h"

#include <algorithm>
#include <array>
#include <span>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/detail/vertex_errors.h"
#include "hierarchy/morph.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// Two levels and the weight between them.
struct DetailPair {
    Hierarchy coarse;
    Hierarchy fine;
    float blend;
};

DetailPair detail_pair(const Hierarchy& hierarchy, std::span<const float> errors,
                       std::span<const DetailLevel> levels, const DetailPlace& place) {
    return {cut(hierarchy, errors, levels[place.coarse].threshold),
            cut(hierarchy, errors, levels[place.fine].threshold), place.blend};
}

/// What a continuous view of one key takes.
struct Detailed {
    explicit Detailed(const Hierarchy& hierarchy)
        : key(hierarchy), errors(vertex_errors(key)), levels(detail_levels(CutSizes(key, errors))) {}

    const Hierarchy& key;
    std::vector<float> errors;
    std::vector<DetailLevel> levels;

    /// The surface at \p detail as a function on the vertices of the whole key.
    Buffer<glm::vec3> surface(double detail) const {
        const DetailPair pair = detail_pair(key, errors, levels, detail_place(levels.size(), detail));
        const UnionMesh mesh = unite(std::array{&pair.coarse, &pair.fine, &key});
        return morph(mesh, std::array{1 - pair.blend, pair.blend, 0.0F});
    }
};

float farthest(const Buffer<glm::vec3>& a, const Buffer<glm::vec3>& b) {
    float result = 0;
    for (std::size_t v = 0; v < a.size(); ++v) result = std::max(result, glm::distance(a[v], b[v]));
    return result;
}

/// Whether \p stream is the surface of \p level: its own vertices where they are, means elsewhere.
bool is_surface_of(const UnionMesh& mesh, std::size_t number, const Hierarchy& level,
                   const Buffer<glm::vec3>& positions) {
    std::vector<bool> is_own(mesh.vertex_count(), false);
    for (std::size_t v = 0; v < level.vertex_count(); ++v) {
        const Index own = mesh.own_vertices[number][v];
        is_own[own] = true;
        if (positions[own] != level.positions[v]) return false;
    }
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const auto& [a, b] = mesh.vertices[v].edge;
        if (!is_own[v] && glm::distance(positions[v], 0.5F * (positions[a] + positions[b])) > 1e-6F)
            return false;
    }
    return true;
}

}  // namespace

TEST_CASE("levels run from the roots to the whole hierarchy, with more leaves and less distance") {
    for_random_families(2000, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Detailed detailed(family.keys[0]);
        const std::vector<DetailLevel>& levels = detailed.levels;
        REQUIRE(levels.front().leaves == family.roots.triangle_count());
        REQUIRE(levels.back().leaves == detailed.key.leaf_count());
        REQUIRE(levels.back().distance == 0);
        for (std::size_t n = 1; n < levels.size(); ++n) {
            REQUIRE(levels[n].leaves > levels[n - 1].leaves);
            REQUIRE(levels[n].distance <= levels[n - 1].distance);
        }
        for (const DetailLevel& level : levels) {
            const Hierarchy surface = cut(detailed.key, detailed.errors, level.threshold);
            REQUIRE(surface.leaf_count() == level.leaves);
            REQUIRE(check(surface).empty());
        }
    });
}

TEST_CASE("the union of two levels of one key is the finer one, and the morph ends at both") {
    for_random_families(500, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Detailed detailed(family.keys[0]);
        for (std::size_t n = 0; n + 1 < detailed.levels.size(); ++n) {
            const DetailPair pair =
                detail_pair(detailed.key, detailed.errors, detailed.levels, {n, n + 1, 0.25F});
            const UnionMesh mesh = unite(std::array<const Hierarchy*, 2>{&pair.coarse, &pair.fine});
            const Hierarchy between = morphed_hierarchy(mesh, std::array{0.75F, 0.25F});
            REQUIRE(check(between).empty());
            REQUIRE(between.bits == pair.fine.bits);
            REQUIRE(between.midpoints == pair.fine.midpoints);
            REQUIRE(is_surface_of(mesh, 0, pair.coarse, morph(mesh, std::array{1.0F, 0.0F})));
            REQUIRE(morph(mesh, std::array{0.0F, 1.0F}) == pair.fine.positions);
        }
    });
}

TEST_CASE("the surface changes continuously with the detail") {
    for_random_families(60, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Detailed detailed(family.keys[0]);
        const std::size_t transitions = detailed.levels.size() - 1;
        if (transitions == 0) return;
        // The speed within a transition is the distance of its levels.
        float speed = 0;
        for (std::size_t n = 0; n < transitions; ++n) {
            const double begin = double(n) / double(transitions), end = double(n + 1) / double(transitions);
            speed = std::max(speed, farthest(detailed.surface(begin), detailed.surface(end)));
        }
        constexpr int steps = 200;
        Buffer<glm::vec3> before = detailed.surface(0);
        for (int step = 1; step <= steps; ++step) {
            const Buffer<glm::vec3> now = detailed.surface(double(step) / steps);
            const float bound = speed * static_cast<float>(transitions) / steps;
            REQUIRE(farthest(before, now) <= 1.001F * bound + 1e-6F);
            before = now;
        }
        REQUIRE(before == detailed.key.positions);
    });
}

TEST_CASE("where one transition ends the next begins, to the last bit") {
    for_random_families(200, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Detailed detailed(family.keys[0]);
        const auto surface = [&](std::size_t coarse, float blend) {
            const DetailPair pair =
                detail_pair(detailed.key, detailed.errors, detailed.levels, {coarse, coarse + 1, blend});
            const UnionMesh mesh = unite(std::array{&pair.coarse, &pair.fine, &detailed.key});
            return morph(mesh, std::array{1 - blend, blend, 0.0F});
        };
        for (std::size_t n = 0; n + 2 < detailed.levels.size(); ++n)
            REQUIRE(surface(n, 1) == surface(n + 1, 0));
    });
}

TEST_CASE("two levels of two different keys morph, and the morph passes the checker") {
    Random random(20260616);
    for_random_families(1000, 2, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        const auto level_of = [&](const Hierarchy& key) {
            const Detailed detailed(key);
            const std::size_t level = random.below(detailed.levels.size());
            return cut(key, detailed.errors, detailed.levels[level].threshold);
        };
        const Hierarchy a = level_of(family.keys[0]), b = level_of(family.keys[1]);
        const UnionMesh mesh = unite(std::array<const Hierarchy*, 2>{&a, &b});
        REQUIRE(check(morphed_hierarchy(mesh, std::array{0.3F, 0.7F})).empty());
        REQUIRE(is_surface_of(mesh, 0, a, morph(mesh, std::array{1.0F, 0.0F})));
        REQUIRE(is_surface_of(mesh, 1, b, morph(mesh, std::array{0.0F, 1.0F})));
        const Buffer<glm::vec3> middle = morph(mesh, std::array{0.5F, 0.5F});
        for (std::size_t v = 0; v < middle.size(); ++v)
            REQUIRE(glm::distance(middle[v], 0.5F * (mesh.positions[0][v] + mesh.positions[1][v])) <= 1e-6F);
    });
}

TEST_CASE("the place of a detail lies between two levels, the ends are kept") {
    CHECK(detail_place(1, 0.5).fine == 0);
    const DetailPlace begin = detail_place(5, -1), end = detail_place(5, 2), middle = detail_place(5, 0.375);
    CHECK(begin.coarse == 0);
    CHECK(begin.blend == 0);
    CHECK(end.fine == 4);
    CHECK(end.blend == 1);
    CHECK(middle.coarse == 1);
    CHECK(middle.blend == 0.5F);
}
