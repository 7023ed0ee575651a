// Distances along a surface, approximately: those of the shortest paths over the edges of its mesh and, across
// each edge, over the diagonal of the two triangles laid flat. Paths are a few percent too long.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

class SurfaceGraph {
  public:
    /// \param triangles  closed and oriented, as HalfEdgeMesh needs them
    /// \param positions  one per vertex
    SurfaceGraph(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions);

    struct Link {
        Index vertex;
        double length;
    };
    std::span<const Link> links_of(Index vertex) const {
        return std::span(links_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
    }

    std::size_t vertex_count() const { return begin_.size() - 1; }

    /// The distance of each vertex from \p source (Dijkstra 1959).
    std::vector<double> distances_from(Index source) const;

  private:
    std::vector<std::size_t> begin_;  // per vertex, its first link; then the number of links
    std::vector<Link> links_;
};

}  // namespace interleaf
