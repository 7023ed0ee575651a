// Writes triangle meshes as Wavefront OBJ and as PLY.
#pragma once

#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "family/field_scale.h"
#include "hierarchy/field.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The text of a Wavefront OBJ file. Reading it gives exactly the same floats. Each face begins with the
/// vertex opposite its refinement edge.
/// \param fields  the color field "color", or else the first color field, gives the colors of the vertices;
///                OBJ has no place for other fields
/// \param origin  is added to all positions, in double precision
std::string obj_text(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                     std::span<const Field> fields = {}, const glm::dvec3& origin = glm::dvec3(0));

/// The bytes of a binary little-endian PLY file.
/// \param fields  become properties of the vertices: a float for a scalar, three bytes for a color;
///                docs/file-formats.md describes the names
/// \param origin  is added to all positions; unless it is 0, positions are written as doubles
/// \param scales  their offsets are added to the fields, which then are doubles
std::string ply_bytes(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                      std::span<const Field> fields = {}, const glm::dvec3& origin = glm::dvec3(0),
                      std::span<const FieldScale> scales = {});

}  // namespace interleaf
