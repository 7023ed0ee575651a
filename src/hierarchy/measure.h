// Measurements of an indexed triangle mesh, for `interleaf info` and for tests.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

struct Box {
    glm::vec3 min{0};
    glm::vec3 max{0};
    float diagonal() const;
    glm::vec3 center() const;
    bool operator==(const Box&) const = default;
};

Box bounding_box(std::span<const glm::vec3> positions);

/// The extent that a camera looks at: everything lies in the box, and in the sphere about the box's center.
struct Extent {
    Box box;
    float radius = 0;
};

/// The extent of the box alone: the sphere passes through the box's corners.
Extent extent_of(const Box& box);

/// The box of all positions of \p parts, and the smallest sphere about its center that contains them.
Extent extent_of(std::span<const std::span<const glm::vec3>> parts);
Extent extent_of(std::span<const glm::vec3> positions);

struct Measures {
    double area = 0;  ///< in squared units of the positions
    /// The enclosed volume, for closed meshes. It is positive if the triangles are counter-clockwise seen
    /// from outside.
    double volume = 0;
    double min_angle = 0;  ///< smallest angle of any triangle, in degrees
};

Measures measure(std::span<const Triangle> triangles, std::span<const glm::vec3> positions);

/// Vertices - edges + faces of any indexed mesh; isolated vertices do not count.
int euler_number(std::span<const Triangle> triangles);

/// Whether each edge belongs to exactly two triangles that traverse it in opposite directions.
bool is_closed_manifold(std::span<const Triangle> triangles);

}  // namespace interleaf
