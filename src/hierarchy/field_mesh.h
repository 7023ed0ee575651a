// A triangle mesh with fields, as a program for numerics writes it: one step of a series. It is the plain data
// that passes from the readers (io) to the recovery of a hierarchy (sequence).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// Values per point or per triangle.
struct MeshField {
    std::string name;
    std::size_t components = 1;  ///< per point or triangle, at least 1
    std::vector<double> values;  ///< point after point, with the components of a point together; any doubles
    std::string unit{};          ///< as the file has it; empty for none
    bool operator==(const MeshField&) const = default;
};

/// The name of a component as a scalar of its own: "velocity y", or the name of a field of one component.
std::string component_name(const MeshField& field, std::size_t component);

struct FieldMesh {
    std::vector<glm::dvec3> points;  ///< as in the file; points may be doubled, and may belong to no triangle

    /// In the order of the file, with the corners in the order of the file: that order can mark the newest
    /// vertex of a bisection. Two triangles in a row stand for a quadrilateral (cell_of).
    std::vector<std::array<Index, 3>> triangles;

    std::vector<Index> cell_of;  ///< per triangle, the number of its cell in the file, from 0
    std::vector<MeshField> point_fields;
    std::vector<MeshField> triangle_fields;
    std::optional<double> time{};  ///< of the step, finite; none if the file has no time
    bool operator==(const FieldMesh&) const = default;
};

}  // namespace interleaf
