#include "red_green_key.h"

#include <algorithm>
#include <array>
#include <vector>

#include "shapes/leaf_fit.h"

namespace interleaf::bench {

glm::dvec3 point_in_leaf(const RedGreenKey& key, Index leaf, const glm::dvec3& b) {
    const RedComplex& complex = key.forest.complex();
    const RedNode& node = complex.node(leaf);
    const unsigned line = key.forest.green_line(leaf);
    glm::dvec3 part = b;
    glm::dvec3 point(0);
    if (line != no_line) {
        // The smaller of the two coordinates beside the line is transferred to the line's end, twice, because
        // the end is their mean.
        const int left = static_cast<int>(line + 1) % 3;
        const int right = static_cast<int>(line + 2) % 3;
        const double smaller = std::min(b[left], b[right]);
        part[left] -= smaller;
        part[right] -= smaller;
        point = 2 * smaller * key.position(complex.edge(node.edges[line]).midpoint);
    }
    for (int corner = 0; corner < 3; ++corner)
        if (part[corner] != 0)
            point += part[corner] * key.position(node.vertices[static_cast<unsigned>(corner)]);
    return point;
}

double LeafErrors::error(Index leaf, unsigned line) {
    if (leaf >= known_.size()) known_.resize(complex_->node_count(), {-1, -1, -1, -1});
    double& error = known_[leaf][line];
    if (error < 0) {
        for (const auto& [a, b, c] : triangles_of_leaf(*complex_, leaf, line)) {
            const std::array corners = {complex_->point(a), complex_->point(b), complex_->point(c)};
            error = std::max(error, measure_fit(unit_sphere, surface_, corners).apart);
        }
    }
    return error;
}

RedGreenKey refined_to(double most, RedComplex& complex, Surface surface, LeafErrors& errors) {
    RedGreenKey key{RedForest(complex), surface};
    while (true) {
        std::vector<Index> marked;
        for (const Index leaf : key.forest.leaves())
            if (errors.error(leaf, key.forest.green_line(leaf)) > most) marked.push_back(leaf);
        if (marked.empty()) return key;
        for (const Index leaf : marked) key.forest.split(leaf);
        key.forest.close();
    }
}

}  // namespace interleaf::bench
