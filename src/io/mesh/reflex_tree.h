// The corners of a polygon at which it turns right, sorted so that those inside a triangle are found fast: a
// tree of boxes in the plane (Bentley 1975).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hierarchy/triangle.h"
#include "io/mesh/polygon_plane.h"

namespace interleaf {

class ReflexTree {
  public:
    /// \param points   corners of the polygon; they must outlive this
    /// \param corners  numbers of those that the tree holds
    ReflexTree(std::span<const PlanePoint> points, std::vector<Index> corners);

    /// Takes a corner out, where the tree holds it.
    void remove(Index corner);

    /// Whether what lies on a triangle's sides, or may but for rounding, counts as inside.
    enum class Border { inside, outside };

    /// Whether a corner lies inside the triangle \p a, \p b, \p c, which turns left, but not at one of its
    /// corners.
    bool has_inside(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, Border border) const;

  private:
    /// The corners from begin to end; the middle one parts them into the two nodes below.
    struct Node {
        PlanePoint least;
        PlanePoint most;
        std::size_t count;  ///< not removed
    };
    struct Range {
        std::size_t begin;
        std::size_t end;
        std::size_t node;  ///< its children are 2 node + 1 and 2 node + 2
    };

    void build(Range range);

    std::span<const PlanePoint> points_;
    std::vector<Index> corners_;
    std::vector<std::size_t> place_;  ///< in corners_, by corner; their number where it is not among them
    std::vector<Node> nodes_;
};

}  // namespace interleaf
