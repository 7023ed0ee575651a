// A key under the refine brush: leaves near a point of its surface are bisected to a level, or coarsened to a
// level. Closure keeps the key conforming, so a stroke may also bisect leaves outside the brush.
//
// The brush touches the leaves that meet a ball and that are connected to the leaf under the pointer by leaves
// that meet the ball. So it does not reach through a thin part of the body. All of these leaves that are coarser
// than the level are bisected, level by level, coarsest first. Under a compatible marking, every other bisection
// is then due to closure alone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/hierarchy.h"
#include "render/pick.h"

namespace interleaf {

/// The ball of the brush.
struct BrushTouch {
    Index leaf;  ///< the leaf under the pointer
    glm::vec3 center;
    float radius;
};

/// What the brush has done to a key so far.
struct BrushFigures {
    std::size_t leaves_before = 0;
    std::size_t leaves = 0;
    std::size_t by_closure = 0;  ///< bisections of leaves that the brush did not mark
    bool is_full = false;        ///< a touch was cut short at max_brushed_leaves
};

/// The brush refines no key beyond this number of leaves.
inline constexpr std::size_t max_brushed_leaves = 2'000'000;

class BrushedKey {
  public:
    /// The position of a new vertex. \p middle is the middle of its edge, \p length the length of that edge.
    using PlaceVertex = std::function<glm::vec3(const glm::vec3& middle, float length)>;

    /// \param place  null for the middle of the edge
    /// \pre \p key passes check()
    explicit BrushedKey(const Hierarchy& key, PlaceVertex place = nullptr);
    BrushedKey(const BrushedKey&) = delete;  // the mesh refers to this object
    BrushedKey& operator=(const BrushedKey&) = delete;
    ~BrushedKey() = default;

    /// Where \p ray meets the surface first; none if it does not.
    std::optional<BrushTouch> touch(const Ray& ray, float radius);

    /// Bisects the touched leaves until none is coarser than \p level.
    /// \throw InputError as AdaptiveMesh::refine() does
    void refine(const BrushTouch& touch, unsigned level);

    /// Removes the midpoints around which all leaves are touched and finer than \p level, until there are none.
    void coarsen(const BrushTouch& touch, unsigned level);

    const BrushFigures& figures() const { return figures_; }
    const AdaptiveMesh& mesh() const { return mesh_; }

    /// The key with its fields. New vertices have the mean of the values at the ends of their edges; colors are
    /// averaged in linear light.
    Hierarchy freeze() const { return mesh_.freeze(fields_); }

  private:
    glm::vec3 place_midpoint(Index a, Index b, Index midpoint);
    bool meets(Index leaf, const BrushTouch& touch) const;
    std::vector<Index> touched_leaves(const BrushTouch& touch);
    bool mark(Index leaf);
    bool is_marked(Index leaf) const { return leaf < marks_.size() && marks_[leaf] == touch_; }
    void follow_count();

    std::vector<Field> fields_;
    PlaceVertex place_;
    AdaptiveMesh mesh_;
    BrushFigures figures_;
    std::vector<Triangle> triangles_;   ///< by leaf, degenerate in free places; empty if it must be made
    std::vector<std::uint32_t> marks_;  ///< by leaf: the number of the touch that has marked it last
    std::uint32_t touch_ = 0;           ///< number of the present touch
};

}  // namespace interleaf
