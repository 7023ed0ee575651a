// A key made by red-green refinement: a closed red forest and the surface its vertices lie on, refined by the
// error that make_key() in src/shapes uses for a tolerance.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

#include "red_forest.h"
#include <glm/vec3.hpp>

#include "shapes/surfaces.h"

namespace interleaf::bench {

struct RedGreenKey {
    RedForest forest;
    Surface surface;

    /// \pre \p vertex is one of the key's
    glm::dvec3 position(Index vertex) const { return surface(forest.complex().point(vertex)); }
};

/// The point of the key at the barycentric coordinates \p b of its leaf: linear in the leaf, or in each of
/// its two green triangles.
glm::dvec3 point_in_leaf(const RedGreenKey& key, Index leaf, const glm::dvec3& b);

/// Errors of the leaves of keys on one surface, measured once each.
class LeafErrors {
  public:
    LeafErrors(const RedComplex& complex, Surface surface) : complex_(&complex), surface_(surface) {}

    /// The largest LeafFit::apart of the triangles as which \p leaf is drawn.
    double error(Index leaf, unsigned line);

  private:
    const RedComplex* complex_;
    Surface surface_;
    std::vector<std::array<double, 4>> known_;  // for each node and line; negative: not yet
};

/// The key with no triangle, green or red, whose error is larger than \p most: in rounds, each of which
/// splits the leaves that have such a triangle, and closes.
RedGreenKey refined_to(double most, RedComplex& complex, Surface surface, LeafErrors& errors);

}  // namespace interleaf::bench
