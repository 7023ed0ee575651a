#include "fit/correspondence/finished_map.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/sphere_map/relaxation.h"
#include "fit/sphere_map/rest_shape.h"

namespace interleaf {
namespace {

/// Rest shapes are blended by this towards equilateral.
constexpr double finished_blend = 0.1;

/// Per vertex, a third of the area of its triangles.
std::vector<double> areas_at_vertices(std::span<const Triangle> triangles,
                                      std::span<const glm::dvec3> places) {
    constexpr double least = 1e-12;
    std::vector<double> areas(places.size(), least);
    for (const auto& [a, b, c] : triangles) {
        const double third = glm::length(glm::cross(places[b] - places[a], places[c] - places[a])) / 6;
        for (const Index vertex : {a, b, c}) areas[vertex] += third;
    }
    return areas;
}

/// How far a triangle's shape on the sphere is from its shape in space: conformal distortion (MIPS), 1 for similar
/// triangles.
double shape_distortion(const std::array<glm::dvec3, 3>& in_space,
                        const std::array<glm::dvec3, 3>& on_sphere) {
    const auto cotangents = rest_cotangents(in_space[0], in_space[1], in_space[2], finished_blend);
    double stretch = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 side = on_sphere[(k + 1) % 3] - on_sphere[k];
        stretch += cotangents[k] * glm::dot(side, side);
    }
    const double doubled_area =
        glm::dot(on_sphere[0], glm::cross(on_sphere[1] - on_sphere[0], on_sphere[2] - on_sphere[0]));
    constexpr double least_area = 1e-300;
    return stretch / (2 * std::max(doubled_area, least_area));
}

/// 1 per vertex within \p rings rings of triangles about a triangle with a larger distortion than \p worst, else 0.
std::vector<char> vertices_of_bad_shapes(const SphereMesh& body, std::span<const glm::dvec3> points,
                                         double worst, int rings) {
    std::vector<char> are_bad(points.size(), 0);
    for (const auto& [a, b, c] : body.triangles)
        if (shape_distortion({body.positions[a], body.positions[b], body.positions[c]},
                             {points[a], points[b], points[c]}) > worst)
            are_bad[a] = are_bad[b] = are_bad[c] = 1;
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<char> inner = are_bad;
        for (const auto& [a, b, c] : body.triangles)
            if (inner[a] || inner[b] || inner[c]) are_bad[a] = are_bad[b] = are_bad[c] = 1;
    }
    return are_bad;
}

/// The vertices of a collapsed mesh, on their way back.
class Return {
  public:
    Return(const SphereMesh& body, CoarsenedMesh& coarse, std::span<const glm::dvec3> on_sphere)
        : coarse_(coarse),
          points_(body.points),
          area_(areas_at_vertices(body.triangles, body.positions)),
          density_(body.points.size(), 1),
          relaxation_(coarse.half_edges, body.positions, area_, points_, Keeps::shapes) {
        const std::vector<double> before = areas_at_vertices(coarse.mesh.triangles, coarse.mesh.positions);
        const std::vector<double> after = areas_at_vertices(coarse.mesh.triangles, on_sphere);
        for (std::size_t v = 0; v < on_sphere.size(); ++v) {
            const Index vertex = coarse.vertices[v];
            points_[vertex] = on_sphere[v];
            density_[vertex] = after[v] / before[v];
            area_[vertex] *= density_[vertex];
        }
        for (const SphereLandmark& landmark : body.landmarks) relaxation_.pin(landmark.vertex);
        relaxation_.update_shapes(finished_blend);
    }
    Return(const Return&) = delete;
    Return& operator=(const Return&) = delete;

    /// Relaxes whenever the mesh has grown by a third.
    /// \return false if there is no room for a vertex
    bool run(ProgressMeter& meter) {
        constexpr double growth = 1.3;
        constexpr int sweeps = 5;
        std::size_t count = coarse_.vertices.size();
        std::size_t relaxed = 0;
        while (!coarse_.collapses.empty()) {
            meter.step(100);
            const bool has_room = place_next();
            if (has_room) ++count;
            if (has_room && double(count) < growth * double(relaxed)) continue;
            if (!has_room && relaxed == count) return false;
            relaxation_.sweep(sweeps, meter);
            relaxed = count;
        }
        return true;
    }

    std::vector<glm::dvec3> points() && { return std::move(points_); }

  private:
    /// Undoes the last collapse, unless there is no room for the vertex.
    bool place_next() {
        const Index half_edge = coarse_.collapses.back();
        const Index vertex = coarse_.half_edges.origin(half_edge);
        const Index kept = coarse_.half_edges.origin(coarse_.half_edges.twin(half_edge));
        density_[vertex] = density_[kept];
        coarse_.half_edges.undo_collapse(half_edge);
        const double own_area = area_[vertex];
        area_[vertex] *= density_[vertex];
        relaxation_.update_shapes_at(vertex, finished_blend);
        if (!relaxation_.put_into_kernel(vertex, points_[kept])) {
            coarse_.half_edges.collapse(half_edge);
            area_[vertex] = own_area;
            relaxation_.update_shapes_at(kept, finished_blend);
            return false;
        }
        relaxation_.relax_star(vertex);
        coarse_.collapses.pop_back();
        return true;
    }

    CoarsenedMesh& coarse_;
    std::vector<glm::dvec3> points_;
    std::vector<double> area_;     ///< per vertex, wanted on the sphere; in space for vertices that are away
    std::vector<double> density_;  ///< per vertex, area on the sphere over area in space
    Relaxation relaxation_;
};

}  // namespace

std::vector<glm::dvec3> finished_map(const SphereMesh& body, CoarsenedMesh& coarse,
                                     std::span<const glm::dvec3> on_sphere, ProgressMeter& meter) {
    Return vertices(body, coarse, on_sphere);
    if (!vertices.run(meter)) return {};
    return std::move(vertices).points();
}

bool restore_shapes(const SphereMesh& body, double worst, int sweeps, std::vector<glm::dvec3>& points,
                    ProgressMeter& meter) {
    constexpr int rings = 2;
    constexpr int sweeps_of_untangling = 200;
    for (const SphereLandmark& landmark : body.landmarks) points[landmark.vertex] = landmark.direction;
    const HalfEdgeMesh half_edges(static_cast<Index>(points.size()), body.triangles);
    const std::vector<double> areas = areas_at_vertices(body.triangles, points);
    Relaxation relaxation(half_edges, body.positions, areas, points, Keeps::shapes);
    relaxation.update_shapes(finished_blend);
    for (const SphereLandmark& landmark : body.landmarks) relaxation.pin(landmark.vertex);
    if (!body.landmarks.empty()) relaxation.untangle(sweeps_of_untangling, meter);
    const std::vector<char> are_bad = vertices_of_bad_shapes(body, points, worst, rings);
    for (Index v = 0; v < points.size(); ++v)
        if (!are_bad[v]) relaxation.pin(v);
    relaxation.sweep(sweeps, meter);
    return std::ranges::find(are_bad, char{1}) != are_bad.end();
}

}  // namespace interleaf
