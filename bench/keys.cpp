#include "keys.h"

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "shapes/icosahedron.h"

namespace interleaf::bench {

namespace {

/// Refines the leaves that \p choose selects, in rounds, until there are \p leaves leaves.
Hierarchy refined_sphere(Index leaves, const std::function<bool(const AdaptiveMesh&, Index leaf)>& choose) {
    const Hierarchy roots = icosahedron();
    const AdaptiveMesh* self = nullptr;
    AdaptiveMesh mesh(roots.roots, roots.positions, [&](Index a, Index b, Index) {
        return glm::normalize(self->positions()[a] + self->positions()[b]);
    });
    self = &mesh;
    std::vector<Index> marks;
    while (mesh.leaf_count() < leaves) {
        marks.clear();
        for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf)
            if (choose(mesh, leaf)) marks.push_back(leaf);
        for (const Index leaf : marks) {
            if (mesh.leaf_count() >= leaves) break;
            mesh.refine({&leaf, 1});
        }
    }
    return mesh.freeze();
}

}  // namespace

Hierarchy random_key(Index leaves, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    return refined_sphere(leaves, [&](const AdaptiveMesh&, Index) { return random() % 4 == 0; });
}

Hierarchy local_key(Index leaves, std::size_t place) {
    const glm::vec3 center = icosahedron().positions[place];
    return refined_sphere(leaves, [&](const AdaptiveMesh& mesh, Index leaf) {
        return std::ranges::any_of(mesh.vertices(leaf), [&](Index vertex) {
            return glm::distance(mesh.positions()[vertex], center) < 0.5F;
        });
    });
}

}  // namespace interleaf::bench
