#include "keys.h"

#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "shapes/icosahedron.h"

namespace interleaf::bench {

Hierarchy random_sphere_key(Index leaves, std::uint64_t seed) {
    const Hierarchy roots = icosahedron();
    AdaptiveMesh* self = nullptr;
    AdaptiveMesh mesh(roots.roots, roots.positions, [&](Index a, Index b) {
        return glm::normalize(self->positions()[a] + self->positions()[b]);
    });
    self = &mesh;
    std::mt19937_64 random(seed);
    std::vector<Index> marks;
    while (mesh.leaf_count() < leaves) {
        marks.clear();
        for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf)
            if (random() % 4 == 0) marks.push_back(leaf);
        mesh.refine(marks);
    }
    return mesh.freeze();
}

}  // namespace interleaf::bench
