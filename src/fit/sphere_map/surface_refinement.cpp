#include "fit/sphere_map/surface_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "fit/mesh/unit_box.h"

namespace interleaf {
namespace {

/// The squared side of an equilateral triangle of area 1: 4 / sqrt(3).
constexpr double squared_side_of_unit_area = 2.309401076758503;

double area_of(const Triangle& triangle, std::span<const glm::dvec3> positions) {
    const auto& [a, b, c] = triangle;
    return glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) / 2;
}

class Refinement {
  public:
    Refinement(const SurfaceMesh& mesh, const RefinementOptions& options, ProgressMeter& meter)
        : options_(options),
          meter_(meter),
          mesh_(static_cast<Index>(mesh.positions.size()), mesh.triangles),
          positions_(in_unit_box(mesh.positions)),
          original_(mesh),
          original_positions_(positions_),
          result_(mesh.positions) {
        if (options.deviation > options.flatness)
            to_surface_.emplace(original_.triangles, original_positions_);
        double area = 0;
        for (const Triangle& triangle : mesh.triangles) area += area_of(triangle, positions_);
        longest_ = squared_side_of_unit_area * area / options.triangles;
    }

    SurfaceMesh run() {
        const std::size_t max_triangles = mesh_.triangle_capacity() + options_.max_added;
        for (Index half_edge = 0; half_edge < 3 * mesh_.triangle_capacity(); ++half_edge)
            changed_.push_back(half_edge);
        flip_all();
        for (Index half_edge = 0; half_edge < 3 * mesh_.triangle_capacity(); ++half_edge)
            note_length(half_edge);
        while (!long_edges_.empty() && mesh_.triangle_capacity() < max_triangles) {
            const LongEdge edge = long_edges_.top();
            long_edges_.pop();
            const auto [low, high] =
                std::minmax({mesh_.origin(edge.half_edge), mesh_.target(edge.half_edge)});
            if (low == edge.low && high == edge.high) halve(edge.half_edge);
        }
        SurfaceMesh fine;
        fine.positions = std::move(result_);
        fine.triangles.reserve(mesh_.triangle_capacity());
        for (Index triangle = 0; triangle < mesh_.triangle_capacity(); ++triangle)
            fine.triangles.push_back(
                {mesh_.origin(3 * triangle), mesh_.origin(3 * triangle + 1), mesh_.origin(3 * triangle + 2)});
        return fine;
    }

  private:
    struct LongEdge {
        double squared_length;
        Index low;
        Index high;
        Index half_edge;
        bool operator<(const LongEdge& other) const {
            return std::tie(squared_length, other.low, other.high) <
                   std::tie(other.squared_length, low, high);
        }
    };

    glm::dvec3 doubled_area(Index a, Index b, Index c) const {
        return glm::cross(positions_[b] - positions_[a], positions_[c] - positions_[a]);
    }

    void note_length(Index half_edge) {
        const auto [low, high] = std::minmax({mesh_.origin(half_edge), mesh_.target(half_edge)});
        const glm::dvec3 edge = positions_[high] - positions_[low];
        const double squared = glm::dot(edge, edge);
        if (mesh_.origin(half_edge) == low && squared > longest_)
            long_edges_.push({squared, low, high, half_edge});
        else if (mesh_.origin(half_edge) == high && squared > longest_)
            long_edges_.push({squared, low, high, mesh_.twin(half_edge)});
    }

    void halve(Index half_edge) {
        const Index a = mesh_.origin(half_edge);
        const Index b = mesh_.target(half_edge);
        const Index middle = mesh_.split(half_edge);
        if (to_surface_)
            push_on_surface((positions_[a] + positions_[b]) / 2.0);
        else {
            positions_.push_back((positions_[a] + positions_[b]) / 2.0);
            result_.push_back(result_[a] / 2.0 + result_[b] / 2.0);
        }
        Index spoke = mesh_.outgoing(middle);
        do {
            note_length(spoke);
            note_length(HalfEdgeMesh::next(spoke));
            changed_.push_back(HalfEdgeMesh::next(spoke));
            spoke = mesh_.rotated(spoke);
        } while (spoke != mesh_.outgoing(middle));
        flip_all();
        meter_.step(40);
    }

    /// Adds the vertex at the place of the surface that is nearest to \p middle.
    void push_on_surface(const glm::dvec3& middle) {
        (*to_surface_)(middle, nearest_);
        const auto& [a, b, c] = original_.triangles[nearest_];
        const glm::dvec3 place =
            nearest_place(middle, {original_positions_[a], original_positions_[b], original_positions_[c]});
        positions_.push_back(place[0] * original_positions_[a] + place[1] * original_positions_[b] +
                             place[2] * original_positions_[c]);
        result_.push_back(place[0] * result_[a] + place[1] * result_[b] + place[2] * result_[c]);
    }

    /// Flips the changed edges, and the edges that this changes in turn.
    void flip_all() {
        while (!changed_.empty()) {
            const Index half_edge = changed_.back();
            changed_.pop_back();
            meter_.step(4);
            if (!is_to_flip(half_edge)) continue;
            mesh_.flip(half_edge);
            note_length(half_edge);
            const Index twin = mesh_.twin(half_edge);
            for (const Index edge : {HalfEdgeMesh::next(half_edge), HalfEdgeMesh::previous(half_edge),
                                     HalfEdgeMesh::next(twin), HalfEdgeMesh::previous(twin)}) {
                note_length(edge);
                changed_.push_back(edge);
            }
        }
    }

    /// Whether an edge lies inside a flat face and is not Delaunay.
    bool is_to_flip(Index half_edge) {
        const Index a = mesh_.origin(half_edge);
        const Index b = mesh_.target(half_edge);
        const Index c = mesh_.origin(HalfEdgeMesh::previous(half_edge));
        const Index d = mesh_.origin(HalfEdgeMesh::previous(mesh_.twin(half_edge)));
        const glm::dvec3 abc = doubled_area(a, b, c);
        const glm::dvec3 bad = doubled_area(b, a, d);
        const glm::dvec3 adc = doubled_area(a, d, c);
        const glm::dvec3 bcd = doubled_area(b, c, d);
        const glm::dvec3 whole = abc + bad;
        if (!(glm::dot(adc, whole) > 0 && glm::dot(bcd, whole) > 0 && glm::dot(abc, whole) >= 0 &&
              glm::dot(bad, whole) >= 0))
            return false;
        // The distance between the two pairs of triangles is the distance between the diagonals.
        const glm::dvec3 ab = positions_[b] - positions_[a];
        const glm::dvec3 dc = positions_[c] - positions_[d];
        const glm::dvec3 across = glm::cross(ab, dc);
        const double volume = glm::dot(across, positions_[d] - positions_[a]);
        const double farthest = std::max(options_.flatness, options_.deviation);
        if (!(volume * volume <= farthest * farthest * glm::dot(across, across))) return false;
        // Delaunay: the angles at c and d add up to at most two right angles, so their cotangents add up to
        // at least 0.
        const glm::dvec3 ca = positions_[a] - positions_[c];
        const glm::dvec3 cb = positions_[b] - positions_[c];
        const glm::dvec3 da = positions_[a] - positions_[d];
        const glm::dvec3 db = positions_[b] - positions_[d];
        const double at_c = glm::dot(ca, cb) * glm::length(bad);
        const double at_d = glm::dot(da, db) * glm::length(abc);
        constexpr double sure = 1e-9;  // keeps rounding from flipping an edge back and forth
        const double size = glm::dot(ab, ab) * std::sqrt(glm::dot(bad, bad) + glm::dot(abc, abc));
        if (!(at_c + at_d < -sure * size) || mesh_.are_joined(c, d)) return false;
        if (!to_surface_ ||
            volume * volume <= options_.flatness * options_.flatness * glm::dot(across, across))
            return true;
        // Between triangles that are not in one plane, nothing proves that flips come to an end.
        constexpr std::size_t max_flips_per_triangle = 20;
        if (curved_flips_ >= max_flips_per_triangle * mesh_.triangle_capacity()) return false;
        const bool is_near =
            (*to_surface_)((positions_[c] + positions_[d]) / 2.0, nearest_, farthest) <= farthest;
        if (is_near) ++curved_flips_;
        return is_near;
    }

    const RefinementOptions options_;
    ProgressMeter& meter_;
    HalfEdgeMesh mesh_;
    std::vector<glm::dvec3> positions_;  // in the unit box
    const SurfaceMesh& original_;
    std::vector<glm::dvec3> original_positions_;
    std::optional<SurfaceDistance> to_surface_;
    Index nearest_ = no_index;
    std::size_t curved_flips_ = 0;    // across creases
    std::vector<glm::dvec3> result_;  // in the units of the input
    double longest_ = 0;              // squared length up to which an edge stays
    std::priority_queue<LongEdge> long_edges_;
    std::vector<Index> changed_;
};

}  // namespace

TriangleShapes triangle_shapes(const SurfaceMesh& mesh) {
    constexpr double equilateral_triangles = 750;
    constexpr double needle = 10;  // times as long as high
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
    double whole = 0;
    for (const Triangle& triangle : mesh.triangles) whole += area_of(triangle, positions);
    TriangleShapes shapes;
    if (!(whole > 0)) return shapes;
    const double squared_side = squared_side_of_unit_area * whole / equilateral_triangles;
    for (const Triangle& triangle : mesh.triangles) {
        double squared = 0;  // length of the longest side
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 side = positions[triangle[(k + 1) % 3]] - positions[triangle[k]];
            squared = std::max(squared, glm::dot(side, side));
        }
        const double area = area_of(triangle, positions);
        if (squared > squared_side) shapes.large += area / whole;
        if (squared > needle * 2 * area) shapes.needles += area / whole;
    }
    return shapes;
}

SurfaceMesh refine(const SurfaceMesh& mesh, const RefinementOptions& options, ProgressMeter& meter) {
    return Refinement(mesh, options, meter).run();
}

}  // namespace interleaf
