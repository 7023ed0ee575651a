// A flat step as linear functions over triangles of the plane, with the two geometric questions that sampling
// asks: what is the value at a point, and how much do the functions differ from a linear function over a node.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sequence/series/step_mesh.h"

namespace interleaf {

/// A counter-clockwise triangle in the plane.
struct PlaneTriangle {
    std::array<glm::dvec2, 3> corners;

    /// Twice the area.
    double double_area() const;

    /// The barycentric coordinates of \p point. They are not finite if the triangle has no area.
    glm::dvec3 weights(const glm::dvec2& point) const;

    /// The point of the triangle that is nearest to \p point, in barycentric coordinates.
    glm::dvec3 nearest_weights(const glm::dvec2& point) const;

    /// Whether the interiors of both triangles meet, up to rounding.
    bool overlaps(const PlaneTriangle& other) const;
};

/// \p point in the plane across the axis \p axis, 0 to 2. Triangles that are counter-clockwise as seen from the
/// positive axis stay so.
glm::dvec2 in_plane(const glm::dvec3& point, unsigned axis);

/// A triangle of the roots or of their bisections, with the values of all scalars at its corners.
struct PlaneNode {
    PlaneTriangle triangle;
    std::array<const double*, 3> values;
};

class PlaneMesh {
  public:
    /// \param step    a flat step; must outlive the mesh
    /// \param axis    the axis across its plane
    /// \param scales  one per scalar: differences are multiplied by it
    PlaneMesh(const StepMesh& step, unsigned axis, std::span<const double> scales);

    std::size_t scalar_count() const { return scales_.size(); }
    std::size_t triangle_count() const { return triangles_.size(); }
    const PlaneTriangle& triangle(Index t) const { return triangles_[t]; }

    /// Writes the values of all scalars at \p point, from the triangle of \p near that holds it, or else from
    /// the nearest one.
    /// \param values  one per scalar
    /// \return the distance of \p point from that triangle; infinite if \p near is empty
    double evaluate(const glm::dvec2& point, std::span<const Index> near, double* values) const;

    /// The largest difference, over all scalars, between the functions of the triangles \p near and the linear
    /// function over \p node, where both are defined. It is found at the corners of the overlay.
    /// \param enough  the search may stop at a difference above this
    double difference(const PlaneNode& node, std::span<const Index> near, double enough) const;

    /// Whether a cell of \p near holds \p triangle up to rounding: a triangle, or a convex quadrilateral of two.
    bool is_held(const PlaneTriangle& triangle, std::span<const Index> near) const;

  private:
    void blend(Index t, const glm::dvec3& weights, double* values) const;
    double value(Index t, unsigned corner, std::size_t scalar) const;
    double difference(const PlaneNode& node, Index t, double least) const;
    bool holds(Index t, const glm::dvec2& point) const;

    std::vector<PlaneTriangle> triangles_;
    std::vector<Triangle> corners_;  ///< points of the step
    std::vector<double> values_;     ///< point after point
    std::vector<double> scales_;
    std::vector<Index> partner_;  ///< per triangle: the other one of its quadrilateral, or itself
    double rounding_;
};

}  // namespace interleaf
