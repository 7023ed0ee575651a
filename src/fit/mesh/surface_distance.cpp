#include "fit/mesh/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace interleaf {
namespace {

/// A triangle is cut into strips whose length is the square root of this multiple of twice the mean area. The
/// square of the side of equilateral triangles of the mean area is 1.15 times twice that area.
constexpr double squared_strip_length = 4;

constexpr double max_strips = 32;

SpaceBox with_place(const SpaceBox& box, const glm::dvec3& place) {
    return {glm::min(box.min, place), glm::max(box.max, place)};
}

}  // namespace

SurfaceDistance::SurfaceDistance(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions)
    : triangles_(triangles), positions_(positions), tree_(boxes_of_strips()) {}

TriangleCorners SurfaceDistance::corners(Index triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    return {positions_[a], positions_[b], positions_[c]};
}

std::vector<SpaceBox> SurfaceDistance::boxes_of_strips() {
    double whole = 0;
    for (Index triangle = 0; triangle < triangles_.size(); ++triangle)
        whole += doubled_area(corners(triangle));
    const double strip_length = std::sqrt(squared_strip_length * whole / double(triangles_.size()));
    std::vector<SpaceBox> boxes;
    boxes.reserve(triangles_.size());
    triangle_of_box_.reserve(triangles_.size());
    for (Index triangle = 0; triangle < triangles_.size(); ++triangle) {
        const auto& [a, b, c] = corners(triangle);
        const LongTriangle along({a, b, c});
        const double strips =
            strip_length > 0 ? std::min(std::ceil(along.length() / strip_length), max_strips) : 1;
        if (strips <= 1) {
            boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
            triangle_of_box_.push_back(triangle);
        }
        for (double strip = 0; strips > 1 && strip < strips; ++strip) {
            const double begin = strip / strips;
            const double end = (strip + 1) / strips;
            SpaceBox box{along.on_side(begin), along.on_side(begin)};
            for (const glm::dvec3& place :
                 {along.on_side(end), along.on_other_sides(begin), along.on_other_sides(end)})
                box = with_place(box, place);
            if (begin <= along.apex_part() && along.apex_part() <= end) box = with_place(box, along.apex());
            boxes.push_back(box);
            triangle_of_box_.push_back(triangle);
        }
    }
    return boxes;
}

double SurfaceDistance::operator()(const glm::dvec3& point, Index& nearest, double enough) const {
    if (nearest == no_index) nearest = 0;
    double least = squared_distance_to_triangle(point, corners(nearest));
    tree_.find_nearest(point, least, enough * enough, [&](Index box) {
        const Index triangle = triangle_of_box_[box];
        const double distance = squared_distance_to_triangle(point, corners(triangle));
        if (distance < least) nearest = triangle;
        return distance;
    });
    return std::sqrt(least);
}

bool SurfaceDistance::is_within(const glm::dvec3& point, double distance, Index& near) const {
    const double enough = distance * distance;
    if (squared_distance_to_triangle(point, corners(near)) <= enough) return true;
    // Boxes that are farther away than this are not opened.
    double least = std::nextafter(enough, std::numeric_limits<double>::infinity());
    tree_.find_nearest(point, least, enough, [&](Index box) {
        const Index triangle = triangle_of_box_[box];
        const double squared = squared_distance_to_triangle(point, corners(triangle));
        if (squared <= enough) near = triangle;
        return squared;
    });
    return least <= enough;
}

glm::dvec3 SurfaceDistance::nearest_point(const glm::dvec3& point, Index& nearest) const {
    (*this)(point, nearest);
    const TriangleCorners found = corners(nearest);
    const glm::dvec3 place = nearest_place(point, found);
    return place[0] * found[0] + place[1] * found[1] + place[2] * found[2];
}

}  // namespace interleaf
