#include "fit/sphere_map/progressive_mapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "fit/sphere_map/decimation.h"

namespace interleaf {
namespace {

/// The fraction of the whole time that the collapses take.
constexpr double collapse_part = 0.1;

}  // namespace

ProgressiveMapping::ProgressiveMapping(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                       const ProgressiveOptions& options, ProgressMeter& meter)
    : mesh_(mesh),
      positions_(positions),
      options_(options),
      meter_(meter),
      vertex_area_(solid_angles_wanted(mesh, positions)),
      points_(mesh.vertex_capacity()),
      relaxation_(mesh, positions, vertex_area_, points_, options.keeps) {}

void ProgressiveMapping::collapse(std::span<const char> kept) {
    meter_.enter("collapsing edges", 0);
    collapses_ = decimate(mesh_, positions_, meter_, collapse_part, kept);
    gather_areas();
    meter_.enter("mapping to the sphere", collapse_part);
    place_tetrahedron();
    restored_ = 4;
    relaxed_ = 0;
}

bool ProgressiveMapping::raise(std::size_t count) {
    count = std::min<std::size_t>(count, mesh_.vertex_capacity());
    while (restored_ < count) {
        if (double(restored_) >= options_.growth * double(relaxed_)) relax_all();
        if (restore_next()) continue;
        // Vertices added since the last relaxation may crowd the neighborhood.
        if (relaxed_ == restored_) return false;
        relax_all();
    }
    relax_all();
    return true;
}

std::string ProgressiveMapping::failure() const {
    return fmt::format("no room on the sphere for vertex {}, after {} of {}", mesh_.origin(collapses_.back()),
                       restored_, mesh_.vertex_capacity());
}

void ProgressiveMapping::restore_mesh() {
    for (; !collapses_.empty(); collapses_.pop_back()) mesh_.undo_collapse(collapses_.back());
}

/// A removed vertex leaves its area to the vertex onto which it moved, so that the sphere has room for a limb
/// before the limb's vertices return.
void ProgressiveMapping::gather_areas() {
    for (const Index half_edge : collapses_) {
        double& kept = vertex_area_[mesh_.origin(mesh_.twin(half_edge))];
        other_area_.push_back(kept);
        kept += vertex_area_[mesh_.origin(half_edge)];
    }
}

/// Puts the four remaining vertices at the corners of a regular tetrahedron.
void ProgressiveMapping::place_tetrahedron() {
    const double height = 1 / std::sqrt(3.0);
    const std::array<glm::dvec3, 4> corners = {glm::dvec3(1, 1, 1) * height, glm::dvec3(-1, -1, 1) * height,
                                               glm::dvec3(1, -1, -1) * height,
                                               glm::dvec3(-1, 1, -1) * height};
    Index triangle = 0;
    while (!mesh_.has_triangle(triangle)) ++triangle;
    // Seen from corner 3, corners 0, 1, 2 run clockwise; so they run counter-clockwise from outside.
    for (Index k = 0; k < 3; ++k) points_[mesh_.origin(3 * triangle + k)] = corners[k];
    points_[mesh_.origin(HalfEdgeMesh::previous(mesh_.twin(3 * triangle)))] = corners[3];
}

/// Restores the last collapsed vertex, or changes nothing if there is no room for the vertex.
bool ProgressiveMapping::restore_next() {
    const Index half_edge = collapses_.back();
    const Index vertex = mesh_.origin(half_edge);
    const Index kept = mesh_.origin(mesh_.twin(half_edge));
    std::swap(vertex_area_[kept], other_area_.back());
    mesh_.undo_collapse(half_edge);
    relaxation_.update_shapes_at(vertex, blend_);
    // The vertex onto which it had moved is in the closure of the kernel, because all triangles in the place
    // of the star belonged to that vertex.
    if (!relaxation_.put_into_kernel(vertex, points_[kept])) {
        mesh_.collapse(half_edge);
        std::swap(vertex_area_[kept], other_area_.back());
        relaxation_.update_shapes_at(kept, blend_);
        return false;
    }
    relaxation_.relax_star(vertex);
    if (options_.crowded > 0 && relaxation_.min_share(vertex) < options_.crowded)
        relaxation_.relax_around(vertex, options_.moves_where_crowded, meter_);
    collapses_.pop_back();
    other_area_.pop_back();
    ++restored_;
    meter_.set_part(collapse_part +
                    (0.9 - collapse_part) * double(restored_) / double(mesh_.vertex_capacity()));
    meter_.step(100);
    return true;
}

/// Coarse meshes only resemble the surface, so their shapes count less.
void ProgressiveMapping::relax_all() {
    constexpr double coarse_blend = 10;
    constexpr double max_blend = 0.5;
    blend_ = std::min(max_blend, options_.blend + coarse_blend / double(restored_));
    relaxation_.update_shapes(blend_);
    relaxation_.sweep(options_.sweeps, meter_);
    relaxed_ = restored_;
}

}  // namespace interleaf
