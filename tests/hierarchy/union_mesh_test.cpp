#include "hierarchy/union_mesh.h"

#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/literal.h"
#include "hierarchy/morph.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

std::vector<Node> nodes_of(const UnionMesh& mesh) {
    std::vector<unsigned> levels;
    for (const LeafTag tag : mesh.tags) levels.push_back(tag.level());
    return nodes_of_levels(levels);
}

std::set<Node> literal_union(const RandomFamily& family) {
    std::set<Node> bisected;
    for (const Hierarchy& key : family.keys) bisected.merge(bisected_nodes(key));
    return bisected;
}

/// The connectivity of the union as a key; positions do not matter.
Hierarchy united(const Hierarchy& a, const Hierarchy& b) {
    return morphed_hierarchy(unite(std::vector<const Hierarchy*>{&a, &b}), std::vector<float>{0.5F, 0.5F});
}

bool same_connectivity(const Hierarchy& a, const Hierarchy& b) {
    return a.roots == b.roots && a.bits == b.bits && a.midpoints == b.midpoints;
}

}  // namespace

TEST_CASE("the union is the literal union of the sets of paths, so it is minimal, 10,200 hierarchies") {
    for_random_families(10200, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        const std::vector<Node> nodes = nodes_of(mesh);
        REQUIRE(nodes == leaf_nodes(literal_union(family), family.roots.triangle_count()));

        // The vertices are those of the infinite complex: one per point, no matter from which side and in
        // which key it is requested.
        InfiniteComplex complex(family.roots);
        std::map<Index, Index> names;
        for (std::size_t t = 0; t < nodes.size(); ++t) {
            const Triangle expected = complex.triangle(nodes[t]);
            for (std::size_t k = 0; k < 3; ++k)
                REQUIRE(names.try_emplace(mesh.triangles[t][k], expected[k]).first->second == expected[k]);
        }
        std::set<Index> distinct;
        for (const auto& [vertex, name] : names) distinct.insert(name);
        REQUIRE(names.size() == mesh.vertex_count());
        REQUIRE(distinct.size() == mesh.vertex_count());
    });
}

TEST_CASE("the union conforms, 10,200 hierarchies") {
    for_random_families(10200, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        InfiniteComplex complex(family.roots);
        REQUIRE(triangulation_violations(complex, nodes_of(mesh),
                                         family.marking == Marking::compatible ? 1 : 2) ==
                std::vector<std::string>{});
        REQUIRE(check(morphed_hierarchy(mesh, std::vector<float>{0.2F, 0.3F, 0.5F})) ==
                std::vector<std::string>{});
    });
}

TEST_CASE(
    "the union is commutative, associative, idempotent, and its keys are neutral elements, 10,200 "
    "hierarchies") {
    for_random_families(10200, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const auto& [a, b, c] = std::tie(family.keys[0], family.keys[1], family.keys[2]);
        const Hierarchy ab = united(a, b);
        REQUIRE(same_connectivity(ab, united(b, a)));
        REQUIRE(same_connectivity(united(ab, c), united(a, united(b, c))));
        REQUIRE(same_connectivity(united(a, a), a));
        REQUIRE(same_connectivity(united(ab, a), ab));
        const UnionMesh all = unite(family.key_pointers());
        REQUIRE(same_connectivity(united(ab, c), morphed_hierarchy(all, std::vector<float>{1, 0, 0})));
    });
}

TEST_CASE("the origin of a leaf is the set of keys in which it is a node") {
    for_random_families(3000, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        const std::vector<Node> nodes = nodes_of(mesh);
        std::vector<std::set<Node>> bisected;
        for (const Hierarchy& key : family.keys) bisected.push_back(bisected_nodes(key));
        for (std::size_t t = 0; t < nodes.size(); ++t) {
            KeySet expected = 0;
            Node parent = nodes[t];
            if (parent.level > 0) {
                --parent.level;
                parent.path &= (std::uint64_t{1} << parent.level) - 1;
            }
            for (std::size_t key = 0; key < bisected.size(); ++key)
                if (nodes[t].level == 0 || bisected[key].contains(parent)) expected |= key_bit(key);
            REQUIRE(mesh.origins[t] == expected);
        }
    });
}

TEST_CASE("every vertex of a key is in the union at the key's own position, and owned by it") {
    for_random_families(3000, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        std::size_t owned = 0;
        for (std::size_t key = 0; key < family.keys.size(); ++key) {
            const Buffer<Index>& own = mesh.own_vertices[key];
            REQUIRE(own.size() == family.keys[key].vertex_count());
            for (std::size_t v = 0; v < own.size(); ++v) {
                REQUIRE(mesh.positions[key][own[v]] == family.keys[key].positions[v]);
                REQUIRE((mesh.vertices[own[v]].keys & key_bit(key)) != 0);
            }
            owned += own.size();
        }
        std::size_t owners = 0;
        for (const VertexOrigin& vertex : mesh.vertices)
            owners += static_cast<std::size_t>(std::popcount(vertex.keys));
        REQUIRE(owners == owned);
    });
}

TEST_CASE("tags mark the leaf edges that lie on root edges") {
    for_random_families(2000, 2, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        // Literally: a leaf edge lies on a root edge if both its ends do, and on the same one.
        std::vector<std::set<std::pair<Index, Index>>> on(mesh.vertex_count());
        const Index root_count = family.roots.vertex_count();
        for (const auto& [a, b, c] : family.roots.triangles())
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                on[from].insert(std::minmax(from, to));
                on[to].insert(std::minmax(from, to));
            }
        for (std::size_t v = root_count; v < mesh.vertex_count(); ++v) {
            const auto [a, b] = mesh.vertices[v].edge;
            std::set_intersection(on[a].begin(), on[a].end(), on[b].begin(), on[b].end(),
                                  std::inserter(on[v], on[v].end()));
        }
        for (std::size_t t = 0; t < mesh.leaf_count(); ++t)
            for (unsigned k = 0; k < 3; ++k) {
                const auto& p = on[mesh.triangles[t][(k + 1) % 3]];
                const auto& q = on[mesh.triangles[t][(k + 2) % 3]];
                std::vector<std::pair<Index, Index>> common;
                std::set_intersection(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(common));
                REQUIRE(mesh.tags[t].on_root_edge(k) == !common.empty());
            }
    });
}

TEST_CASE("more keys than a key set has bits are united as well") {
    Random random(5);
    const RootComplex roots = octahedron();
    std::vector<Hierarchy> keys;
    for (unsigned n = 0; n < 80; ++n) keys.push_back(random_key(roots, random));
    std::vector<const Hierarchy*> pointers;
    Hierarchy pairwise = keys[0];
    for (const Hierarchy& key : keys) {
        pointers.push_back(&key);
        pairwise = united(pairwise, key);
    }
    const UnionMesh mesh = unite(pointers);
    CHECK(same_connectivity(pairwise, morphed_hierarchy(mesh, std::vector<float>(80, 0.0F))));
    for (std::size_t key = 0; key < keys.size(); ++key)
        for (std::size_t v = 0; v < keys[key].vertex_count(); ++v)
            REQUIRE(mesh.positions[key][mesh.own_vertices[key][v]] == keys[key].positions[v]);
}

TEST_CASE("reused buffers give the same union") {
    UnionMesh reused;
    for_random_families(300, 3, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        unite(family.key_pointers(), reused);
        const UnionMesh fresh = unite(family.key_pointers());
        REQUIRE(reused.triangles == fresh.triangles);
        REQUIRE(reused.origins == fresh.origins);
        REQUIRE(reused.positions == fresh.positions);
        REQUIRE(reused.own_vertices == fresh.own_vertices);
    });
}

TEST_CASE("keys over different roots are rejected") {
    const Hierarchy a = unrefined(octahedron(), std::vector<glm::vec3>(6));
    const Hierarchy b = unrefined(torus(3, 3), std::vector<glm::vec3>(9));
    CHECK_THROWS_AS(unite(std::vector<const Hierarchy*>{&a, &b}), InputError);
    CHECK_THROWS_AS(unite(std::vector<const Hierarchy*>{}), InputError);
}
