#include "hierarchy/morph.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/level_map.h"
#include "hierarchy/literal.h"
#include "hierarchy/measure.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// The literal position of corner \p corner of the union's leaf \p node in \p key, by the paper's section
/// 3.3: go up to the node of the key's leaf that contains it, compose the level maps of equation (1), and
/// weight the positions of that leaf's vertices.
struct LiteralPositions {
    explicit LiteralPositions(const Hierarchy& hierarchy) : key(hierarchy) {
        const std::vector<Leaf> leaves = leaves_of(hierarchy);
        const std::vector<Node> nodes =
            leaf_nodes(bisected_nodes(hierarchy), hierarchy.roots.triangle_count());
        for (std::size_t n = 0; n < nodes.size(); ++n) triangles[nodes[n]] = leaves[n].vertices;
    }

    /// False if the key is bisected further than the node: then the node belongs to the key but is no leaf of
    /// it.
    bool covers(const Node& node) const { return ancestor(node) != triangles.end(); }

    std::array<glm::dvec3, 3> corners(const Node& node) const {
        const auto& [leaf, vertices] = *ancestor(node);
        const glm::dmat3 map = level_map(node.path >> leaf.level, node.level - leaf.level);
        std::array<glm::dvec3, 3> result{};
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < 3; ++k)
                result[static_cast<std::size_t>(c)] +=
                    map[c][k] * glm::dvec3(key.positions[vertices[static_cast<std::size_t>(k)]]);
        return result;
    }

    std::map<Node, Triangle>::const_iterator ancestor(Node node) const {
        while (true) {
            const auto found = triangles.find(node);
            if (found != triangles.end() || node.level == 0) return found;
            --node.level;
            node.path &= (std::uint64_t{1} << node.level) - 1;
        }
    }

    const Hierarchy& key;
    std::map<Node, Triangle> triangles;
};

}  // namespace

TEST_CASE("positions agree with the literal composition of level maps, 10,200 hierarchies") {
    for_random_families(10200, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        std::vector<unsigned> levels;
        for (const LeafTag tag : mesh.tags) levels.push_back(tag.level());
        const std::vector<Node> nodes = nodes_of_levels(levels);
        std::vector<LiteralPositions> literal;
        std::vector<float> weights;
        for (const Hierarchy& key : family.keys) {
            literal.emplace_back(key);
            weights.push_back(static_cast<float>(4 * random.unit() - 2));  // any real weights, used as given
        }
        const Buffer<glm::vec3> positions = morph(mesh, weights);
        double worst = 0;
        for (std::size_t t = 0; t < nodes.size(); ++t) {
            std::array<glm::dvec3, 3> expected{};
            for (std::size_t key = 0; key < literal.size(); ++key) {
                REQUIRE(literal[key].covers(nodes[t]));
                const auto corners = literal[key].corners(nodes[t]);
                for (std::size_t c = 0; c < 3; ++c)
                    expected[c] += static_cast<double>(weights[key]) * corners[c];
            }
            for (std::size_t c = 0; c < 3; ++c)
                worst =
                    std::max(worst, glm::distance(expected[c], glm::dvec3(positions[mesh.triangles[t][c]])));
        }
        REQUIRE(worst < 1e-5);
    });
}

TEST_CASE("weight 1 on a key gives that key's surface: positions, area and volume") {
    for_random_families(3000, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<float> weights(3, 0.0F);
            weights[k] = 1;
            const Buffer<glm::vec3> positions = morph(mesh, weights);
            const Hierarchy& key = family.keys[k];
            for (std::size_t v = 0; v < key.vertex_count(); ++v)
                REQUIRE(positions[mesh.own_vertices[k][v]] == key.positions[v]);
            std::vector<Triangle> triangles;
            for (const Leaf& leaf : leaves_of(key)) triangles.push_back(leaf.vertices);
            const Measures own = measure(triangles, key.positions);
            const Measures blended = measure(mesh.triangles, positions);
            REQUIRE(blended.area == doctest::Approx(own.area).epsilon(1e-5));
            if (family.roots.boundary_edge_count() == 0)
                REQUIRE(std::abs(blended.volume - own.volume) < 1e-5);
        }
    });
}

TEST_CASE("the morphed hierarchy is a sound key with the morph's surface") {
    for_random_families(3000, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        const std::vector<float> weights = {0.3F, -0.5F, 1.1F};
        const Hierarchy key = morphed_hierarchy(mesh, weights);
        REQUIRE(check(key).empty());
        const std::vector<Leaf> leaves = leaves_of(key);
        const Buffer<glm::vec3> positions = morph(mesh, weights);
        REQUIRE(leaves.size() == mesh.leaf_count());
        for (std::size_t t = 0; t < leaves.size(); ++t)
            for (std::size_t c = 0; c < 3; ++c)
                REQUIRE(key.positions[leaves[t].vertices[c]] == positions[mesh.triangles[t][c]]);
    });
}
