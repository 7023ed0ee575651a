// One step of a series, cleaned: a conforming, oriented manifold whose points are welded and used.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/field_mesh.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// A component of a point field, which becomes a scalar field of the keys.
struct SeriesScalar {
    std::string field;
    std::size_t component = 0;
    std::string name;  ///< "field", or "field x" for a component of a vector
};

/// What is read of each step.
struct SeriesFields {
    std::vector<SeriesScalar> scalars;

    /// The scalars that are the displacement, its first component first; no_index for a component that is
    /// missing, and for all three without a displacement.
    Triangle displacement = {no_index, no_index, no_index};
};

struct StepMesh {
    std::vector<glm::dvec3> points;   ///< where vertices are identified: without the displacement
    std::vector<Triangle> triangles;  ///< in the order of the file, with the corners in the order of the file
    std::vector<Triangle> neighbors;  ///< across the side opposite each corner; no_index at the boundary
    std::vector<bool> is_reversed;    ///< per triangle: whether the file runs around it clockwise
    std::vector<Index> cell_of;       ///< per triangle; empty if the file has triangles only
    std::vector<std::vector<double>> values;                 ///< values[scalar][point]
    Triangle displacement = {no_index, no_index, no_index};  ///< as in SeriesFields
    double shortest_edge = 0;
    double rounding = 0;  ///< the most by which two roundings of one coordinate to six digits differ
    std::optional<glm::dvec3> hanging;  ///< a hanging vertex, if there is one

    /// The corners of \p triangle counter-clockwise, with the corner \p first of the file at the front.
    Triangle oriented(Index triangle, unsigned first = 0) const {
        return turned_to(triangles[triangle], first, is_reversed[triangle]);
    }
    /// The neighbors of \p triangle across the sides opposite the corners of oriented().
    Triangle oriented_neighbors(Index triangle, unsigned first = 0) const {
        return turned_to(neighbors[triangle], first, is_reversed[triangle]);
    }
    /// Where the keys show \p point: with the displacement.
    glm::dvec3 position(Index point) const;

  private:
    static Triangle turned_to(const Triangle& of_corners, unsigned first, bool reversed) {
        const Index second = of_corners[(first + 1) % 3];
        const Index third = of_corners[(first + 2) % 3];
        return {of_corners[first], reversed ? third : second, reversed ? second : third};
    }
};

/// The scalars that the point fields of \p mesh give.
/// \param names         the fields that are wanted; all if empty
/// \param displacement  the name of the displacement; empty without one
/// \throw InputError  if a field is missing, or its name cannot be the name of a key's field
SeriesFields fields_of(const FieldMesh& mesh, std::span<const std::string> names,
                       const std::string& displacement);

/// Cleans \p mesh: welds equal points, drops unused points, orients the triangles. A flat mesh runs
/// counter-clockwise as seen from the positive axis, a closed one as seen from outside, any other as most of its
/// triangles do.
/// \param notes  receives a sentence if the values of welded points differ
/// \throw InputError  naming the place, if the mesh is no orientable manifold, is not finite, or lacks a field.
///     A hanging vertex is no error, but is named in the result. A vertex where triangles meet that share no
///     edge is not looked for: it stays a vertex of the roots, which are then no RootComplex.
StepMesh clean_step(const FieldMesh& mesh, const SeriesFields& fields, std::vector<std::string>& notes);

/// The axis, 0 to 2, along which all \p points are at one place; none if the points are not in such a plane.
std::optional<unsigned> flat_axis(std::span<const glm::dvec3> points);

/// Twice the area of a triangle, as a vector along its normal.
glm::dvec3 area_vector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// "(0.25, 1.5, 0)".
std::string text_of(const glm::dvec3& place);

}  // namespace interleaf
