// The bytes of a VTK XML file of one surface: a .vtp (polygons) or a .vtu (unstructured grid). The arrays follow
// the XML, raw and little endian, compressed by zlib, with sizes of 64 bits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "family/field_scale.h"
#include "hierarchy/field.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

enum class VtkDataSet : std::uint8_t { polygons, grid };

struct VtkSurface {
    std::span<const Triangle> triangles;
    std::span<const glm::vec3> positions;  ///< one per vertex
    glm::dvec3 origin{0};                  ///< is added to all positions; unless it is 0, they become doubles

    /// Per vertex: a float for a scalar, three bytes for a color; "u x", "u y" (and "u z") become a vector "u".
    std::span<const Field> fields{};

    std::span<const FieldScale>
        scales{};                     ///< offsets, which make fields doubles, and units, as VTK's UNITS_LABEL
    std::span<const LeafTag> tags{};  ///< per triangle: its level and its root
    std::span<const KeySet> leaf_origins{};  ///< per triangle: the keys in which it is a node
    std::optional<double> time{};
};

std::string vtk_bytes(const VtkSurface& surface, VtkDataSet data_set);

/// \p text as the value of an attribute of XML.
std::string xml_escaped(std::string_view text);

}  // namespace interleaf
