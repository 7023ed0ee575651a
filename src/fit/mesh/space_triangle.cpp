#include "fit/mesh/space_triangle.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

/// The square of the distance of the origin from the segment that starts at \p a and runs along \p edge.
double squared_distance_to_segment(const glm::dvec3& a, const glm::dvec3& edge) {
    const double squared_length = glm::dot(edge, edge);
    const double t = squared_length > 0 ? glm::clamp(-glm::dot(a, edge) / squared_length, 0.0, 1.0) : 0.0;
    const glm::dvec3 nearest = a + t * edge;
    return glm::dot(nearest, nearest);
}

}  // namespace

double doubled_area(const TriangleCorners& corners) {
    return glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

LongTriangle::LongTriangle(const TriangleCorners& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& from = corners[(i + 1) % 3];
        const glm::dvec3& to = corners[(i + 2) % 3];
        const double length = glm::distance(from, to);
        if (i > 0 && length <= length_) continue;
        begin_ = from;
        end_ = to;
        apex_ = corners[i];
        length_ = length;
    }
    if (length_ > 0)
        apex_part_ = glm::clamp(glm::dot(apex_ - begin_, end_ - begin_) / (length_ * length_), 0.0, 1.0);
}

glm::dvec3 LongTriangle::on_other_sides(double part) const {
    if (part < apex_part_) return begin_ + part / apex_part_ * (apex_ - begin_);
    if (apex_part_ < 1) return end_ + (1 - part) / (1 - apex_part_) * (apex_ - end_);
    return apex_;
}

glm::dvec3 unit_normal(const TriangleCorners& corners) {
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

double squared_distance_to_triangle(const glm::dvec3& point, const TriangleCorners& corners) {
    const glm::dvec3 a = corners[0] - point;  // shifted so that the point is the origin
    const glm::dvec3 b = corners[1] - point;
    const glm::dvec3 c = corners[2] - point;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double squared_length = glm::dot(normal, normal);
    const double at_a = glm::dot(glm::cross(b, c), normal);
    const double at_b = glm::dot(glm::cross(c, a), normal);
    const double at_c = glm::dot(glm::cross(a, b), normal);
    if (squared_length > 0 && at_a >= 0 && at_b >= 0 && at_c >= 0) {
        const double height = glm::dot(a, normal);
        return height * height / squared_length;
    }
    return std::min({squared_distance_to_segment(a, b - a), squared_distance_to_segment(b, c - b),
                     squared_distance_to_segment(c, a - c)});
}

glm::dvec3 nearest_place(const glm::dvec3& point, const TriangleCorners& corners) {
    const glm::dvec3 a = corners[0] - point;
    const glm::dvec3 b = corners[1] - point;
    const glm::dvec3 c = corners[2] - point;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const glm::dvec3 inside(glm::dot(glm::cross(b, c), normal), glm::dot(glm::cross(c, a), normal),
                            glm::dot(glm::cross(a, b), normal));
    const double sum = inside.x + inside.y + inside.z;
    if (sum > 0 && inside.x >= 0 && inside.y >= 0 && inside.z >= 0) return inside / sum;

    glm::dvec3 nearest(1, 0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 3; ++side) {
        const int from = (side + 1) % 3;
        const int to = (side + 2) % 3;
        const glm::dvec3 edge = corners[std::size_t(to)] - corners[std::size_t(from)];
        const glm::dvec3 start = corners[std::size_t(from)] - point;
        const double squared = glm::dot(edge, edge);
        const double part = squared > 0 ? glm::clamp(-glm::dot(start, edge) / squared, 0.0, 1.0) : 0;
        const glm::dvec3 offset = start + part * edge;
        if (glm::dot(offset, offset) >= least) continue;
        least = glm::dot(offset, offset);
        nearest = glm::dvec3(0);
        nearest[from] = 1 - part;
        nearest[to] = part;
    }
    return nearest;
}

}  // namespace interleaf
