#include "fit/correspondence/even_mesh.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <span>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/correspondence/coarsening.h"
#include "fit/mesh/half_edge_mesh.h"

namespace interleaf {
namespace {

/// Edges longer than this multiple of the even edge are halved.
constexpr double long_part = 1.4;

/// Maximum number of added vertices, per wanted vertex. Only needles need so many.
constexpr std::size_t max_added_per_vertex = 8;

struct SplitCandidate {
    double squared_length;
    Index low;
    Index high;
    Index half_edge;
    bool operator<(const SplitCandidate& other) const {
        return std::tie(squared_length, other.low, other.high) < std::tie(other.squared_length, low, high);
    }
};

/// Numbers the vertices anew that triangles use.
/// \param mesh  its triangles may use only some of its vertices
void leave_out_unused_vertices(const SphereMesh& mesh, CoarsenedMesh& result) {
    std::vector<Index> number(mesh.positions.size(), no_index);
    for (const Triangle& triangle : result.mesh.triangles)
        for (const Index vertex : triangle) number[vertex] = 0;
    for (Index vertex = 0; vertex < number.size(); ++vertex) {
        if (number[vertex] == no_index) continue;
        number[vertex] = static_cast<Index>(result.vertices.size());
        result.vertices.push_back(vertex);
        result.mesh.positions.push_back(mesh.positions[vertex]);
        result.mesh.points.push_back(mesh.points[vertex]);
    }
    for (Triangle& triangle : result.mesh.triangles)
        for (Index& vertex : triangle) vertex = number[vertex];
    for (const SphereLandmark& landmark : mesh.landmarks)
        result.mesh.landmarks.push_back({number[landmark.vertex], landmark.direction});
}

}  // namespace

double even_edge(double vertices) {
    return std::sqrt(2 / (std::sqrt(3.0) * vertices));
}

std::vector<Triangle> triangles_in(const HalfEdgeMesh& mesh) {
    std::vector<Triangle> triangles;
    for (Index t = 0; t < mesh.triangle_capacity(); ++t)
        if (mesh.has_triangle(t))
            triangles.push_back({mesh.origin(3 * t), mesh.origin(3 * t + 1), mesh.origin(3 * t + 2)});
    return triangles;
}

std::vector<std::array<Index, 2>> split_long_edges(SphereMesh& mesh, std::size_t vertices,
                                                   ProgressMeter& meter) {
    const double longest = long_part * even_edge(double(vertices));
    const std::size_t max_added = max_added_per_vertex * vertices;
    HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
    std::priority_queue<SplitCandidate> queue;
    const auto note = [&](Index half_edge) {
        const Index a = half_edges.origin(half_edge);
        const Index b = half_edges.target(half_edge);
        const glm::dvec3 edge = mesh.positions[b] - mesh.positions[a];
        const double squared = glm::dot(edge, edge);
        if (squared > longest * longest)
            queue.push(
                {squared, std::min(a, b), std::max(a, b), a < b ? half_edge : half_edges.twin(half_edge)});
    };
    for (Index h = 0; h < 3 * half_edges.triangle_capacity(); ++h)
        if (half_edges.origin(h) < half_edges.target(h)) note(h);
    std::vector<std::array<Index, 2>> halved;
    while (halved.size() < max_added && !queue.empty()) {
        const SplitCandidate edge = queue.top();
        queue.pop();
        meter.step(10);
        if (half_edges.origin(edge.half_edge) != edge.low || half_edges.target(edge.half_edge) != edge.high)
            continue;
        const Index middle = half_edges.split(edge.half_edge);
        halved.push_back({edge.low, edge.high});
        mesh.positions.push_back(mesh.positions[edge.low] / 2.0 + mesh.positions[edge.high] / 2.0);
        mesh.points.push_back(glm::normalize(mesh.points[edge.low] + mesh.points[edge.high]));
        half_edges.for_spokes(middle, [&](Index spoke) {
            note(spoke);
            note(HalfEdgeMesh::next(spoke));  // the split may have given the edge other half-edges
        });
    }
    mesh.triangles = triangles_in(half_edges);
    return halved;
}

SurfaceMesh with_middles(const SurfaceMesh& mesh, std::span<const std::array<Index, 2>> halved,
                         const std::vector<Triangle>& triangles) {
    SurfaceMesh fine{.positions = mesh.positions, .triangles = triangles, .colors = {}};
    fine.positions.reserve(mesh.positions.size() + halved.size());
    for (const auto& [a, b] : halved)
        fine.positions.push_back(fine.positions[a] / 2.0 + fine.positions[b] / 2.0);
    return fine;
}

CoarsenedMesh coarsened(const SphereMesh& mesh, std::size_t vertices, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("making an even mesh", 0);
    HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
    std::vector<char> are_held(mesh.positions.size(), 0);
    for (const SphereLandmark& landmark : mesh.landmarks) are_held[landmark.vertex] = 1;
    std::vector<Index> collapses =
        coarsen(half_edges, vertices,
                {.positions = mesh.positions, .points = mesh.points, .are_held = are_held}, meter);
    CoarsenedMesh result{
        .mesh = {}, .vertices = {}, .half_edges = std::move(half_edges), .collapses = std::move(collapses)};
    result.mesh.triangles = triangles_in(result.half_edges);
    leave_out_unused_vertices(mesh, result);
    return result;
}

}  // namespace interleaf
