// Points from which the nearest to a place is taken, one after the other: a k-d tree (Bentley 1975).
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

    /// The index of the point that is nearest to \p at, of those that are left; of equally near ones any, but
    /// always the same. It is left no more. Looks at 200 points at most, so where very many are about as far
    /// away it takes one of the nearest.
    /// \pre  a point is left
    std::size_t take_nearest(const glm::dvec3& at);

  private:
    struct Query {
        glm::dvec3 at;
        double least;
        std::optional<std::size_t> nearest;  ///< its place
        int looks;
    };

    // The points of the places from begin to end make a subtree: the one in the middle is its node, those
    // before it are no greater along the subtree's axis, that of its greatest extent, those behind it no
    // less.
    static std::size_t middle(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }
    void build(std::size_t begin, std::size_t end);
    int longest_axis(std::size_t begin, std::size_t end) const;
    void search(std::size_t begin, std::size_t end, Query& query) const;

    std::span<const glm::dvec3> points_;
    std::vector<std::size_t> order_;  ///< the point at each place
    std::vector<std::size_t> left_;   ///< by the place of its node, how many points of a subtree are left
    std::vector<std::uint8_t> axis_;  ///< likewise its axis
    std::vector<bool> is_taken_;      ///< by place
};

}  // namespace interleaf
