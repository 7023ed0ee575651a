// A k-d tree (Bentley 1975) that returns the nearest point to a query and removes it from the tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace interleaf {

class PointTree {
  public:
    /// \param points  must outlive the tree
    explicit PointTree(std::span<const glm::dvec3> points);

    /// Removes the remaining point that is nearest to \p at, and returns its index.
    ///
    /// If several points are equally near, the choice is arbitrary but deterministic. The search looks at 200
    /// points at most. So if very many points are about equally near, the result is one of the nearest, not
    /// necessarily the nearest.
    /// \pre  a point remains
    std::size_t take_nearest(const glm::dvec3& at);

  private:
    struct Query {
        glm::dvec3 at;
        double least;
        std::optional<std::size_t> nearest;  ///< the place of the nearest point
        int looks;
    };

    // The points at the places from begin to end form a subtree, whose node is the point in the middle. The
    // subtree's axis is that of its largest extent. Points before the node are at most as large along that
    // axis, points behind it at least as large.
    static std::size_t middle(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }
    void build(std::size_t begin, std::size_t end);
    int longest_axis(std::size_t begin, std::size_t end) const;
    void search(std::size_t begin, std::size_t end, Query& query) const;

    std::span<const glm::dvec3> points_;
    std::vector<std::size_t> order_;  ///< the point at each place
    /// By the place of its node: the number of remaining points in the subtree.
    std::vector<std::size_t> left_;
    std::vector<std::uint8_t> axis_;  ///< by the place of its node: the subtree's axis
    std::vector<bool> is_taken_;      ///< by place
};

}  // namespace interleaf
