// Tests of the adaptive mesh of a frozen key: the inverse of freezing.
#include <algorithm>
#include <string>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/checker.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

AdaptiveMesh mesh_of(const Hierarchy& key) {
    return AdaptiveMesh(key, [&key](Index a, Index b, Index) {
        const auto at = [&](Index vertex) {
            return vertex < key.vertex_count() ? key.positions[vertex] : glm::vec3(0);
        };
        return (at(a) + at(b)) * 0.5F;
    });
}

std::vector<std::uint64_t> paths(const AdaptiveMesh& mesh) {
    std::vector<std::uint64_t> found;
    for (const Index leaf : mesh.preorder())
        found.push_back(mesh.path(leaf) ^ std::uint64_t{mesh.level(leaf)} << 57);
    return found;
}

}  // namespace

TEST_CASE("the mesh of a key is sound, keeps the numbers of its vertices, and freezes to the same key") {
    for_random_families(trials(1000), 2, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        for (const Hierarchy& key : family.keys) {
            const AdaptiveMesh mesh = mesh_of(key);
            CHECK(mesh.violations() == std::vector<std::string>{});
            const Hierarchy frozen = mesh.freeze();
            CHECK(frozen.bits == key.bits);
            CHECK(frozen.midpoints == key.midpoints);
            CHECK(frozen.positions == key.positions);
            CHECK(std::ranges::equal(mesh.positions(), key.positions));
        }
    });
}

TEST_CASE("refinement goes on in the mesh of a key as in the mesh that the key was frozen from") {
    for (std::uint64_t seed = 0; seed < trials(300); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = marked(random_roots(random), Marking(random.below(3)), random);
        AdaptiveMesh original(roots, random_points(random, roots.vertex_count()));
        refine_at_random(original, random, 3, 200);
        const Hierarchy key = original.freeze();
        AdaptiveMesh again = mesh_of(key);
        REQUIRE(paths(again) == paths(original));
        const std::vector<Index> ours = again.preorder();
        const std::vector<Index> theirs = original.preorder();
        std::vector<Index> marks;
        std::vector<Index> same_marks;
        for (std::size_t n = 0; n < ours.size(); ++n) {
            if (!random.chance(0.2)) continue;
            marks.push_back(ours[n]);
            same_marks.push_back(theirs[n]);
        }
        again.refine(marks);
        original.refine(same_marks);
        CHECK(paths(again) == paths(original));
        CHECK(again.violations() == std::vector<std::string>{});
        again.coarsen(again.preorder());
        original.coarsen(original.preorder());
        CHECK(paths(again) == paths(original));
    }
}
