#include "hierarchy/leaf_path.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/level_map.h"
#include "hierarchy/literal.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("paths agree with the literal walk, 10,200 hierarchies") {
    for_random_families(10200, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        std::vector<unsigned> levels;
        for (const LeafTag tag : mesh.tags) levels.push_back(tag.level());
        const std::vector<Node> nodes = nodes_of_levels(levels);
        const std::vector<LeafPath> paths = leaf_paths(mesh.tags);
        REQUIRE(paths.size() == nodes.size());
        for (std::size_t t = 0; t < paths.size(); ++t)
            REQUIRE(paths[t] == LeafPath{static_cast<Index>(nodes[t].root), nodes[t].path});
    });
}

TEST_CASE("a path of 64 levels is followed to its end") {
    // Down the first children, then back up: leaves of level 64, 64, 63, ..., 1, and then the next root.
    std::vector<LeafTag> tags = {LeafTag(64, 0, {0, 0, 0})};
    for (unsigned level = 64; level > 0; --level) tags.emplace_back(level, 0, std::array<unsigned, 3>{});
    tags.emplace_back(0, 0, std::array<unsigned, 3>{});
    const std::vector<LeafPath> paths = leaf_paths(tags);
    CHECK(paths[0] == LeafPath{0, 0});
    for (unsigned level = 64; level > 0; --level)
        CHECK(paths[65 - level] == LeafPath{0, std::uint64_t{1} << (level - 1)});
    CHECK(paths.back() == LeafPath{1, 0});
}

TEST_CASE("the level map of a leaf's path maps the leaf's corners to their places in the root") {
    // Keys that are flat in each root. Their vertices are images of barycentric coordinates, which are
    // dyadic, so the arithmetic is exact.
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex root(3, {{0, 1, 2}});
        AdaptiveMesh mesh(root, std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
        refine_at_random(mesh, random, 10, 200);
        const Hierarchy key = mesh.freeze();
        const UnionMesh alone = unite(std::vector<const Hierarchy*>{&key});
        const std::vector<LeafPath> paths = leaf_paths(alone.tags);
        for (std::size_t t = 0; t < paths.size(); ++t) {
            const glm::dmat3 corners = level_map(paths[t].path, alone.tags[t].level());
            for (int c = 0; c < 3; ++c)
                REQUIRE(corners[c] ==
                        glm::dvec3(alone.positions[0][alone.triangles[t][static_cast<std::size_t>(c)]]));
        }
    }
}
