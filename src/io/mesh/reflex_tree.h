// The corners at which a polygon turns right, in a tree of boxes in the plane (Bentley 1975), so that corners
// inside a triangle are found fast.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hierarchy/triangle.h"
#include "io/mesh/polygon_plane.h"

namespace interleaf {

class ReflexTree {
  public:
    /// \param points   the corners of the polygon; they must outlive the tree
    /// \param corners  the numbers of the corners that the tree holds
    ReflexTree(std::span<const PlanePoint> points, std::vector<Index> corners);

    /// Removes a corner, if the tree holds it.
    void remove(Index corner);

    /// Whether a point on a side of a triangle, up to rounding, counts as inside the triangle.
    enum class Border { inside, outside };

    /// Whether a corner of the tree lies inside the triangle \p a, \p b, \p c, but not at a corner of the
    /// triangle.
    /// \pre the triangle turns left
    bool has_inside(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, Border border) const;

  private:
    /// The box of the corners in a range. The middle corner divides the range between the two children.
    struct Node {
        PlanePoint least;
        PlanePoint most;
        std::size_t count;  ///< corners that are not removed
    };
    struct Range {
        std::size_t begin;
        std::size_t end;
        std::size_t node;  ///< its children are 2 node + 1 and 2 node + 2
    };

    void build(Range range);

    std::span<const PlanePoint> points_;
    std::vector<Index> corners_;
    std::vector<std::size_t>
        place_;  ///< by corner: its index in corners_, or their number if it is not there
    std::vector<Node> nodes_;
};

}  // namespace interleaf
