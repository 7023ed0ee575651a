// A key made by red-green refinement: a closed red forest and the surface of its vertices. The refinement
// uses the same error as make_key() in src/shapes does for a tolerance.
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

    /// \pre  \p vertex is a vertex of the key
    glm::dvec3 position(Index vertex) const { return surface(forest.complex().point(vertex)); }
};

/// The point of the key at the barycentric coordinates \p b of its leaf: linear in the leaf, or in each of
/// its two green triangles.
glm::dvec3 point_in_leaf(const RedGreenKey& key, Index leaf, const glm::dvec3& b);

/// Errors of the leaves of keys on one surface, each measured once.
class LeafErrors {
  public:
    LeafErrors(const RedComplex& complex, Surface surface) : complex_(&complex), surface_(surface) {}

    /// The largest LeafFit::apart of the triangles that \p leaf is drawn as.
    double error(Index leaf, unsigned line);

  private:
    const RedComplex* complex_;
    Surface surface_;
    std::vector<std::array<double, 4>> known_;  // by node and line; negative if not measured yet
};

/// The key without any triangle, green or red, whose error exceeds \p most. Works in rounds: each splits the
/// leaves with such a triangle, and closes.
RedGreenKey refined_to(double most, RedComplex& complex, Surface surface, LeafErrors& errors);

}  // namespace interleaf::bench
