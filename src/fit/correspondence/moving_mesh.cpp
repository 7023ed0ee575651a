#include "fit/correspondence/moving_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "fit/correspondence/coarsening.h"
#include "fit/mesh/space_triangle.h"
#include "fit/sphere_map/orientation.h"
#include "fit/sphere_map/rest_shape.h"
#include "fit/sphere_map/spherical_star.h"

namespace interleaf {
namespace {

/// Rest shapes are blended by this towards equilateral.
constexpr double shape_blend = 0.05;

/// The factor by which the mesh grows from one relaxation to the next.
constexpr double level_growth = 1.25;

double doubled_area_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::length(glm::cross(b - a, c - a));
}

}  // namespace

MatchWeights weights_at(double vertices) {
    constexpr double coarsest = 100;
    constexpr int steps_per_level = 4;
    // From 100 to 8,000 vertices, in 20 steps, positions fall to a third, normals to a half, outwardness to a
    // quarter.
    constexpr double position_factor = 0.946;
    constexpr double normal_factor = 0.966;
    constexpr double outwardness_factor = 0.933;
    constexpr int max_steps = 20;
    MatchWeights weights;
    int steps = 0;
    for (double count = coarsest; steps < max_steps && count * level_growth <= vertices;
         count *= level_growth, ++steps) {
        weights.position *= position_factor;
        weights.normal *= normal_factor;
        weights.outwardness *= outwardness_factor;
    }
    weights.level = std::min(std::size_t(steps / steps_per_level), smoothing_levels - 1);
    return weights;
}

MovingMesh::MovingMesh(const MatchedBody& moving, const MatchedBody& onto, ProgressMeter& meter)
    : moving_(moving),
      onto_(onto),
      meter_(meter),
      mesh_(static_cast<Index>(moving.positions().size()), moving.triangles()),
      count_(moving.positions().size()),
      cotangent_(3 * moving.triangles().size()),
      rest_area_(moving.triangles().size()),
      mass_(count_),
      is_active_(count_),
      is_held_(count_) {
    places_.on_mesh.resize(count_);
    places_.in_space.resize(count_);
    places_.on_sphere.resize(count_);
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t) update_shape(t);
    put_at_own_points();
}

void MovingMesh::put_at(std::span<const glm::dvec3> points) {
    Index guess = no_index;
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v) {
        const MeshPoint place = onto_.locate(points[v], guess);
        guess = place.triangle;
        places_.on_mesh[v] = place;
        places_.in_space[v] = onto_.position(place);
        places_.on_sphere[v] = points[v];
    }
    hold_landmarks();
    rotation_ = glm::dmat3(1);
    linear_ = glm::dmat3(1);
    offset_ = glm::dvec3(0);
}

/// Puts landmarks at those of the other body with the same directions. Both maps have them there, up to a
/// small part of a triangle, so there is nearly always room.
void MovingMesh::hold_landmarks() {
    for (const SphereLandmark& own : moving_.landmarks()) {
        is_held_[own.vertex] = 0;
        if (!mesh_.has_vertex(own.vertex)) continue;
        const auto there = std::ranges::find(onto_.landmarks(), own.direction, &SphereLandmark::direction);
        if (there == onto_.landmarks().end()) continue;
        gather(own.vertex);
        const MeshPoint place = onto_.place_of(there->vertex);
        if (!is_positive_at(onto_.point(place))) continue;
        put(own.vertex, place);
        is_held_[own.vertex] = 1;
    }
}

void MovingMesh::set_places(const Places& places) {
    places_ = places;
}

void MovingMesh::set_weights(const MatchWeights& weights) {
    weights_ = weights;
}

void MovingMesh::update_shape(Index triangle) {
    const glm::dvec3& a = moving_.positions()[mesh_.origin(3 * triangle)];
    const glm::dvec3& b = moving_.positions()[mesh_.origin(3 * triangle + 1)];
    const glm::dvec3& c = moving_.positions()[mesh_.origin(3 * triangle + 2)];
    const auto opposite_sides = rest_cotangents(a, b, c, shape_blend);
    for (std::size_t k = 0; k < 3; ++k)
        cotangent_[std::size_t{3} * triangle + k] = opposite_sides[(k + 1) % 3];
    const double mean = (squared_length(b - a) + squared_length(c - b) + squared_length(a - c)) / 3;
    const auto blended = [&](const glm::dvec3& side) {
        return (1 - shape_blend) * squared_length(side) + shape_blend * mean;
    };
    const double u = blended(b - a);
    const double v = blended(c - b);
    const double w = blended(a - c);
    constexpr double least = 1e-12;
    const double squared = 2 * (u * v + v * w + w * u) - (u * u + v * v + w * w);  // 16 area^2
    rest_area_[triangle] = std::max(std::sqrt(std::max(squared, 0.0)) / 4, least);
}

void MovingMesh::update_shapes_at(Index vertex) {
    mesh_.for_spokes(vertex, [&](Index spoke) { update_shape(spoke / 3); });
}

void MovingMesh::gather(Index vertex) {
    star_.clear();
    mesh_.for_spokes(vertex, [&](Index spoke) {
        const Index at_a = HalfEdgeMesh::next(spoke);
        const Index at_b = HalfEdgeMesh::previous(spoke);
        const Index a = mesh_.origin(at_a);
        const Index b = mesh_.origin(at_b);
        star_.push_back({{places_.in_space[a], places_.in_space[b], cotangent_[spoke], cotangent_[at_a],
                          cotangent_[at_b], rest_area_[spoke / 3]},
                         places_.on_sphere[a],
                         places_.on_sphere[b],
                         spoke / 3});
    });
}

void MovingMesh::list_present() {
    vertices_.clear();
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v)
        if (mesh_.has_vertex(v)) vertices_.push_back(v);
    triangles_.clear();
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t)
        if (mesh_.has_triangle(t)) triangles_.push_back(t);
}

void MovingMesh::update_masses() {
    for (const Index v : vertices_) mass_[v] = 0;
    for (const Index t : triangles_) {
        const std::array<Index, 3> corners = {mesh_.origin(3 * t), mesh_.origin(3 * t + 1),
                                              mesh_.origin(3 * t + 2)};
        const double there = doubled_area_of(places_.in_space[corners[0]], places_.in_space[corners[1]],
                                             places_.in_space[corners[2]]) /
                             2;
        for (const Index vertex : corners) mass_[vertex] += (rest_area_[t] + there) / 6;
    }
}

/// 1 per vertex whose triangles are stretched so much that it had better move as part of a coarser mesh.
std::vector<char> MovingMesh::strained_vertices() const {
    constexpr double strained = 6;  // distortion per rest area
    std::vector<double> energy(mesh_.vertex_capacity(), 0.0);
    std::vector<double> area(mesh_.vertex_capacity(), 0.0);
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t) {
        if (!mesh_.has_triangle(t)) continue;
        const std::array<Index, 3> corners = {mesh_.origin(3 * t), mesh_.origin(3 * t + 1),
                                              mesh_.origin(3 * t + 2)};
        const double here = distortion_of(
            {places_.in_space[corners[1]], places_.in_space[corners[2]], cotangent_[std::size_t{3} * t],
             cotangent_[3 * t + 1], cotangent_[3 * t + 2], rest_area_[t]},
            places_.in_space[corners[0]]);
        for (const Index vertex : corners) {
            energy[vertex] += here;
            area[vertex] += rest_area_[t];
        }
    }
    std::vector<char> are_strained(mesh_.vertex_capacity(), 0);
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v)
        are_strained[v] = energy[v] > strained * area[v] ? 1 : 0;
    return are_strained;
}

void MovingMesh::coarsen_to(std::size_t vertices, std::uint32_t variation, bool heeds_places) {
    CoarseningView view{.positions = moving_.positions(), .points = places_.on_sphere};
    view.are_held = is_held_;
    view.variation = variation;
    std::vector<char> strained;
    if (heeds_places) {
        strained = strained_vertices();
        view.images = places_.in_space;
        view.are_first = strained;
    }
    const std::vector<Index> collapses = coarsen(mesh_, vertices, view, meter_);
    collapses_.insert(collapses_.end(), collapses.begin(), collapses.end());
    count_ -= collapses.size();
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t)
        if (mesh_.has_triangle(t)) update_shape(t);
}

void MovingMesh::make_base(std::size_t vertices) {
    coarsen_to(vertices, 0, false);
    base_ = collapses_.size();
}

void MovingMesh::restore_all() {
    for (; collapses_.size() > base_; collapses_.pop_back(), ++count_) mesh_.undo_collapse(collapses_.back());
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t)
        if (mesh_.has_triangle(t)) update_shape(t);
}

bool MovingMesh::refine(int sweeps, std::size_t until) {
    double next = level_growth * double(count_);
    while (collapses_.size() > base_ && !(relaxed_count_ == count_ && count_ >= until)) {
        const Index half_edge = collapses_.back();
        if (!restore(half_edge)) {
            restore_all();
            return false;
        }
        collapses_.pop_back();
        if (double(count_) < next && collapses_.size() > base_) continue;
        set_weights(weights_at(double(count_)));
        relax(sweeps);
        next = level_growth * double(count_);
    }
    return true;
}

/// Undoes the collapse and places the vertex. Where there is no room, makes room and tries again.
/// \return false if there is still no room; then the collapse stands
bool MovingMesh::restore(Index half_edge) {
    constexpr int max_tries = 5;
    for (int tries = 0; tries < max_tries; ++tries) {
        const Index vertex = mesh_.origin(half_edge);
        const Index kept = mesh_.origin(mesh_.twin(half_edge));
        mesh_.undo_collapse(half_edge);
        ++count_;
        update_shapes_at(vertex);
        if (place_in_kernel(vertex, kept)) return true;
        mesh_.collapse(half_edge);
        --count_;
        update_shapes_at(kept);
        if (tries == 0) relax_for_room(kept);
        make_room_around(kept, tries + 1);
    }
    return false;
}

bool MovingMesh::place_in_kernel(Index vertex, Index kept) {
    gather(vertex);
    mass_[vertex] = 0;
    for (const StarSide& side : star_) mass_[vertex] += side.triangle.rest_area / 3;
    const glm::dvec3 from = places_.on_sphere[kept];
    const Index guess = places_.on_mesh[kept].triangle;
    double energy = std::numeric_limits<double>::infinity();
    const auto attempt = [&](const glm::dvec3& point) {
        if (const auto less = try_place(vertex, onto_.locate(glm::normalize(point), guess), energy))
            energy = *less;
    };
    if (const auto middle = kernel_middle(from))
        for (const double part : {1.0, 0.5, 0.25}) attempt(from + part * (*middle - from));
    glm::dvec3 sum(0);
    for (const StarSide& side : star_) sum += side.point_a;
    attempt(sum);
    for (const StarSide& side : star_) attempt(from + side.point_a);
    if (energy == std::numeric_limits<double>::infinity()) return false;

    for (int i = 0; i < 3; ++i) relax_vertex(vertex);
    mesh_.for_spokes(vertex, [&](Index spoke) { relax_vertex(mesh_.target(spoke)); });
    relax_vertex(vertex);
    return true;
}

/// Relaxes the whole mesh, or only the surroundings of \p vertex while the mesh has grown little since it was relaxed:
/// where bodies are unlike, many vertices find no room.
void MovingMesh::relax_for_room(Index vertex) {
    constexpr double growth = 1.03;
    constexpr int sweeps = 10;
    constexpr int rings = 5;
    if (double(count_) > growth * double(relaxed_count_)) {
        relax(sweeps);
    } else {
        relax_around(vertex, rings, sweeps);
    }
}

/// The vertices within \p rings rings of edges about \p vertex.
std::vector<Index> MovingMesh::vertices_around(Index vertex, int rings) const {
    std::vector<Index> near = {vertex};
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<Index> inner = near;
        for (const Index v : inner)
            mesh_.for_spokes(v, [&](Index spoke) { near.push_back(mesh_.target(spoke)); });
        std::ranges::sort(near);
        near.erase(std::unique(near.begin(), near.end()), near.end());
    }
    return near;
}

/// Moves the vertices within \p rings rings of edges about \p vertex to the middles of their kernels.
void MovingMesh::make_room_around(Index vertex, int rings) {
    constexpr int rounds = 10;
    const std::vector<Index> near = vertices_around(vertex, rings);
    for (int round = 0; round < rounds; ++round)
        for (const Index v : near) move_to_middle(v);
}

void MovingMesh::move_to_middle(Index vertex) {
    if (is_held_[vertex]) return;
    gather(vertex);
    const auto middle = kernel_middle(places_.on_sphere[vertex]);
    if (!middle) return;
    const MeshPoint place = onto_.locate(*middle, places_.on_mesh[vertex].triangle);
    if (is_positive_at(onto_.point(place))) put(vertex, place);
}

}  // namespace interleaf
