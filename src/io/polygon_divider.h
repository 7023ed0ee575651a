// Divides polygons into triangles with tinyobjloader, which is given the polygons alone, some thousand
// corners at a time: it takes many times the memory of what it reads.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

class PolygonDivider {
  public:
    /// \p positions must outlive this; \p name stands for the file in messages.
    PolygonDivider(std::span<const glm::vec3> positions, std::string_view name)
        : positions_(positions), name_(name), local_(positions.size()) {}

    /// Writes the triangles of the polygon with \p corners to \p target, two fewer than corners; by finish()
    /// at the latest. \p face is its number for messages. \throw InputError if it, or a polygon before it,
    /// cannot be divided
    void divide(std::size_t face, std::span<const Index> corners, std::span<Triangle> target);

    /// \throw InputError if a polygon cannot be divided
    void finish();

  private:
    struct Polygon {
        std::size_t face;
        std::size_t begin;  ///< of its vertices
        std::size_t end;
        std::span<Triangle> target;
    };

    std::span<const glm::vec3> positions_;
    std::string_view name_;
    std::vector<Index> local_;  ///< by vertex: its place in vertices_, where that holds it

    // Of the polygons that wait:
    std::vector<Polygon> polygons_;
    std::vector<Index> vertices_;  ///< those of each polygon apart
    std::size_t corner_count_ = 0;
    std::string obj_;
};

}  // namespace interleaf
