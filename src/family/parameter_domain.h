// The parameter domain: a triangulated region of the plane with a key at each vertex (paper, section 4.2,
// equation (5), figure 8). A point of it blends the three keys of its triangle by its barycentric
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

/// A point of the domain and where it lies.
struct DomainPoint {
    glm::dvec2 at;   ///< the point itself, or the nearest point of the domain when it was outside
    Index triangle;  ///< the triangle it lies in
    glm::dvec3
        barycentric;  ///< its coordinates there, in the order of the triangle's vertices; not negative, sum 1
};

class ParameterDomain {
  public:
    /// \param triangles  triples of vertex indices; either orientation, but of some area
    /// \throw InputError unless positions are finite, indices valid, each vertex used, no triangle
    /// degenerate, no two
    ///                   triangles overlap, and what triangles share is a vertex or a whole edge
    ParameterDomain(std::vector<DomainVertex> vertices, std::vector<Triangle> triangles);

    /// The domain with \p vertex at \p at: what constructing it gives, only quicker in most cases.
    /// \throw InputError as the constructor
    ParameterDomain with_vertex_at(Index vertex, glm::dvec2 at) const;

    std::span<const DomainVertex> vertices() const { return vertices_; }
    std::span<const Triangle> triangles() const { return triangles_; }

    /// The triangle of \p point and the coordinates there; the nearest domain point for a point outside. On
    /// an edge or vertex shared by several triangles \p current holds when it is one of them (no needless
    /// change of the union while dragging), otherwise the lowest index. \throw InputError if \p point is not
    /// finite
    DomainPoint locate(glm::dvec2 point, Index current = no_index) const;

    /// The weights of a point: its three keys, zeros included. A key at several of the corners gets their
    /// sum.
    Weights weights(const DomainPoint& point) const;

    /// The point with the given weights, where it is unique: every key of \p weights is at exactly one
    /// vertex, these are corners of one triangle, and the values are barycentric (not negative, sum 1). None
    /// otherwise.
    std::optional<glm::dvec2> point_of(const Weights& weights) const;

    bool operator==(const ParameterDomain&) const = default;

  private:
    std::vector<DomainVertex> vertices_;
    std::vector<Triangle> triangles_;
};

}  // namespace interleaf
