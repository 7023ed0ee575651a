// The parameter domain: a triangulated region of the plane with a key at each vertex (paper, section 4.2,
// equation (5), figure 8). A point of the domain blends the three keys of its triangle by its barycentric
// coordinates.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "family/weights.h"
#include "hierarchy/triangle.h"

namespace interleaf {

struct DomainVertex {
    glm::dvec2 at;
    std::size_t key;  ///< index of the key in its family
    bool operator==(const DomainVertex&) const = default;
};

/// Corners of an upright rectangle in the plane.
struct DomainBox {
    glm::dvec2 low;
    glm::dvec2 high;
};

/// The bounding box of \p vertices.
/// \pre there is a vertex
DomainBox box_of(std::span<const DomainVertex> vertices);

/// A point of the domain and its location in a triangle.
struct DomainPoint {
    glm::dvec2 at;   ///< the point itself, or the nearest point of the domain if it was outside
    Index triangle;  ///< the triangle that contains it

    /// Barycentric coordinates in that triangle, in the order of its vertices; not negative, sum 1.
    glm::dvec3 barycentric;
};

class ParameterDomain {
  public:
    /// \param triangles  triples of vertex indices, in either orientation, with a nonzero area
    /// \throw InputError unless positions are finite, indices are valid, each vertex is used, no triangle is
    ///     degenerate, no two triangles overlap, and triangles share only whole edges or vertices
    ParameterDomain(std::vector<DomainVertex> vertices, std::vector<Triangle> triangles);

    /// The domain with \p vertex at \p at. The result is the same as that of the constructor, but usually
    /// takes less time.
    /// \throw InputError as the constructor does
    ParameterDomain with_vertex_at(Index vertex, glm::dvec2 at) const;

    std::span<const DomainVertex> vertices() const { return vertices_; }
    std::span<const Triangle> triangles() const { return triangles_; }

    /// The triangle of \p point and the coordinates in it. A point outside is replaced by the nearest point
    /// of the domain.
    /// \param current  preferred on an edge or vertex that several triangles share, if it is one of them; so
    ///     dragging does not change the union needlessly. Otherwise the lowest index counts.
    /// \throw InputError if \p point is not finite
    DomainPoint locate(glm::dvec2 point, Index current = no_index) const;

    /// The weights of a point: those of its three keys, zeros included. A key at several of the corners gets
    /// their sum.
    Weights weights(const DomainPoint& point) const;

    /// The point with the given weights, if it is unique: every key of \p weights is at exactly one vertex,
    /// these vertices are corners of one triangle, and the values are barycentric coordinates (not negative,
    /// sum 1). None otherwise.
    std::optional<glm::dvec2> point_of(const Weights& weights) const;

    bool operator==(const ParameterDomain&) const = default;

  private:
    std::vector<DomainVertex> vertices_;
    std::vector<Triangle> triangles_;
};

}  // namespace interleaf
