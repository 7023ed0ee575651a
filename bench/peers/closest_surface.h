// A triangle mesh that finds closest points, with CGAL's AABB tree (P. Alliez, S. Tayeb, C. Wormser), and the
// distance of another mesh from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf::bench {

using Points = std::vector<glm::dvec3>;

struct Mesh {
    std::vector<Triangle> triangles;
    Points points;
};

/// A mesh with its tree. The tree refers to the triangles, so the object must not move.
class ClosestSurface {
    using Kernel = CGAL::Simple_cartesian<double>;
    using Triangles = std::vector<Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  public:
    ClosestSurface(const std::vector<Triangle>& triangles, const Points& points) {
        triangles_.reserve(triangles.size());
        for (const auto& [i, j, k] : triangles)
            triangles_.emplace_back(to_cgal(points[i]), to_cgal(points[j]), to_cgal(points[k]));
        tree_.rebuild(triangles_.cbegin(), triangles_.cend());
        tree_.accelerate_distance_queries();
        // finishes the work that the tree defers to the first query
        tree_.closest_point(triangles_.front().vertex(0));
    }
    ClosestSurface(const ClosestSurface&) = delete;
    ClosestSurface& operator=(const ClosestSurface&) = delete;
    ~ClosestSurface() = default;

    double distance(const glm::dvec3& point) const {
        return std::sqrt(tree_.squared_distance(to_cgal(point)));
    }

    struct Location {
        std::size_t triangle;
        glm::dvec3 barycentric;
    };

    Location locate(const glm::dvec3& point) const {
        const auto [closest, triangle] = tree_.closest_point_and_primitive(to_cgal(point));
        const auto place = static_cast<std::size_t>(triangle - triangles_.cbegin());
        const glm::dvec3 a = from_cgal(triangle->vertex(0));
        const glm::dvec3 b = from_cgal(triangle->vertex(1));
        const glm::dvec3 c = from_cgal(triangle->vertex(2));
        const glm::dvec3 p = from_cgal(closest);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double whole = glm::dot(normal, normal);
        if (whole == 0) return {place, {1, 0, 0}};
        const double at_b = glm::dot(glm::cross(p - a, c - a), normal) / whole;
        const double at_c = glm::dot(glm::cross(b - a, p - a), normal) / whole;
        return {place, {1 - at_b - at_c, at_b, at_c}};
    }

  private:
    static Kernel::Point_3 to_cgal(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
    static glm::dvec3 from_cgal(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

    Triangles triangles_;
    Tree tree_;
};

/// The maximum distance of samples of a mesh from a surface, and the root mean square distance by area.
struct Distances {
    double largest = 0;
    double squares = 0;
    double area = 0;
};

/// Samples triangles at their corners and at the centroids of \p parts squared parts.
inline Distances distances(const Mesh& from, unsigned parts, const ClosestSurface& to) {
    Distances result;
    for (const glm::dvec3& point : from.points) result.largest = std::max(result.largest, to.distance(point));
    for (const auto& [i, j, k] : from.triangles) {
        const glm::dvec3 origin = from.points[i];
        const glm::dvec3 e = (from.points[j] - origin) / double(parts);
        const glm::dvec3 f = (from.points[k] - origin) / double(parts);
        const double area = glm::length(glm::cross(e, f)) / 2;
        for (unsigned row = 0; row < parts; ++row)
            for (unsigned place = 0; place < 2 * (parts - row) - 1; ++place) {
                const unsigned column = place / 2;
                const double third = place % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
                const glm::dvec3 sample = origin + (column + third) * e + (row + third) * f;
                const double distance = to.distance(sample);
                result.largest = std::max(result.largest, distance);
                result.squares += area * distance * distance;
                result.area += area;
            }
    }
    return result;
}

/// The distance of a mesh from a reference, as fractions of the diagonal of the reference's box.
struct Error {
    double largest;           ///< distance, in either direction
    double root_mean_square;  ///< of the distances of the reference from the mesh, by area
};

/// The surface that results are compared with.
class Reference {
    // The true blend has many small triangles, a result has fewer and larger ones.
    static constexpr unsigned parts_of_reference = 1;
    static constexpr unsigned parts_of_result = 4;

  public:
    explicit Reference(const Mesh& mesh) : mesh_(mesh), surface_(mesh.triangles, mesh.points) {
        glm::dvec3 low = mesh.points.front();
        glm::dvec3 high = low;
        for (const glm::dvec3& point : mesh.points) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        diagonal_ = glm::distance(low, high);
    }

    Error error_of(const Mesh& result) const {
        const Distances there = distances(result, parts_of_result, surface_);
        const Distances here =
            distances(mesh_, parts_of_reference, ClosestSurface(result.triangles, result.points));
        return {std::max(there.largest, here.largest) / diagonal_,
                std::sqrt(here.squares / here.area) / diagonal_};
    }

  private:
    Mesh mesh_;
    ClosestSurface surface_;
    double diagonal_;
};

}  // namespace interleaf::bench
