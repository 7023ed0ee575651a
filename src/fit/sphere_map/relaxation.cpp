#include "fit/sphere_map/relaxation.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/sphere_map/rest_shape.h"

namespace interleaf {
namespace {

/// A vertex rests when a step lowers its star's energy by less than this fraction. The length of steps is no
/// measure in stars that are much longer than wide.
constexpr double still = 1e-3;

}  // namespace

Relaxation::Relaxation(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                       std::span<const double> vertex_area, std::span<glm::dvec3> points, Keeps keeps)
    : mesh_(mesh),
      positions_(positions),
      vertex_area_(vertex_area),
      points_(points),
      cotangent_(3 * std::size_t(mesh.triangle_capacity())),
      area_(mesh.triangle_capacity()),
      is_active_(mesh.vertex_capacity()),
      is_pinned_(mesh.vertex_capacity()),
      star_(glm::dvec3(0, 0, 1), keeps) {}

void Relaxation::update_shape(Index triangle, double blend) {
    std::array<glm::dvec3, 3> corners{};
    double area = 0;
    for (Index k = 0; k < 3; ++k) {
        const Index vertex = mesh_.origin(3 * triangle + k);
        corners[k] = positions_[vertex];
        area += vertex_area_[vertex] / mesh_.degree(vertex);
    }
    area_[triangle] = area;
    const auto cotangents = rest_cotangents(corners[0], corners[1], corners[2], blend);
    for (Index k = 0; k < 3; ++k) cotangent_[3 * triangle + k] = cotangents[k];
}

void Relaxation::update_shapes(double blend) {
    for (Index triangle = 0; triangle < mesh_.triangle_capacity(); ++triangle)
        if (mesh_.has_triangle(triangle)) update_shape(triangle, blend);
}

void Relaxation::update_shapes_at(Index vertex, double blend) {
    Index half_edge = mesh_.outgoing(vertex);
    do {
        update_shape(half_edge / 3, blend);
        half_edge = mesh_.rotated(half_edge);
    } while (half_edge != mesh_.outgoing(vertex));
}

void Relaxation::gather(Index vertex, const glm::dvec3& center) {
    star_.restart(center);
    Index half_edge = mesh_.outgoing(vertex);
    do {
        const Index across = HalfEdgeMesh::next(half_edge);
        const Index back = HalfEdgeMesh::previous(half_edge);
        star_.add(points_[mesh_.origin(across)], points_[mesh_.origin(back)], cotangent_[half_edge],
                  cotangent_[back], cotangent_[across], area_[half_edge / 3]);
        half_edge = mesh_.rotated(half_edge);
    } while (half_edge != mesh_.outgoing(vertex));
}

double Relaxation::relax(Index vertex) {
    if (is_pinned_[vertex]) return 0;
    gather(vertex, points_[vertex]);
    const NewtonStep step = star_.newton_step();
    if (step.gain > 0) points_[vertex] = star_.frame().point_at(step.place);
    return step.gain;
}

void Relaxation::relax_star(Index vertex) {
    constexpr int rounds = 2;
    constexpr Index max_degree = 32;  // a hub is in every star, and would make the work quadratic
    for (int round = 0; round < rounds; ++round) {
        relax(vertex);
        Index half_edge = mesh_.outgoing(vertex);
        do {
            const Index neighbor = mesh_.target(half_edge);
            if (mesh_.degree(neighbor) <= max_degree) relax(neighbor);
            half_edge = mesh_.rotated(half_edge);
        } while (half_edge != mesh_.outgoing(vertex));
    }
    relax(vertex);
}

double Relaxation::min_share(Index vertex) const {
    double least = std::numeric_limits<double>::infinity();
    Index half_edge = mesh_.outgoing(vertex);
    do {
        const glm::dvec3& a = points_[vertex];
        const glm::dvec3& b = points_[mesh_.target(half_edge)];
        const glm::dvec3& c = points_[mesh_.origin(HalfEdgeMesh::previous(half_edge))];
        const double area = glm::dot(a, glm::cross(b - a, c - a)) / 2;
        least = std::min(least, area / area_[half_edge / 3]);
        half_edge = mesh_.rotated(half_edge);
    } while (half_edge != mesh_.outgoing(vertex));
    return least;
}

void Relaxation::relax_around(Index vertex, int steps, ProgressMeter& meter) {
    waiting_.clear();
    const auto add = [&](Index other) {
        if (!std::exchange(is_active_[other], char{1})) waiting_.push_back(other);
    };
    const auto add_star = [&](Index middle) {
        add(middle);
        Index half_edge = mesh_.outgoing(middle);
        do {
            add(mesh_.target(half_edge));
            half_edge = mesh_.rotated(half_edge);
        } while (half_edge != mesh_.outgoing(middle));
    };
    is_active_.assign(mesh_.vertex_capacity(), 0);
    add_star(vertex);
    for (std::size_t i = 0; i < waiting_.size() && steps > 0; ++i, --steps) {
        const Index next = waiting_[i];
        is_active_[next] = 0;
        meter.step();
        if (relax(next) >= still) add_star(next);
    }
}

bool Relaxation::put_into_kernel(Index vertex, const glm::dvec3& seed) {
    gather(vertex, seed);
    const auto middle = star_.middle_of_kernel();
    if (!middle) return false;
    points_[vertex] = star_.frame().point_at(*middle);
    return true;
}

void Relaxation::sweep(int sweeps, ProgressMeter& meter) {
    is_active_.assign(mesh_.vertex_capacity(), 1);
    bool moved = true;
    for (int i = 0; i < sweeps && moved; ++i) {
        moved = false;
        for (Index vertex = 0; vertex < mesh_.vertex_capacity(); ++vertex) {
            if (!mesh_.has_vertex(vertex) || !std::exchange(is_active_[vertex], char{0})) continue;
            meter.step();
            if (relax(vertex) < still) continue;
            moved = true;
            activate_star(vertex);
        }
    }
}

bool Relaxation::untangle(int sweeps, ProgressMeter& meter) {
    is_active_.assign(mesh_.vertex_capacity(), 1);
    for (int i = 0; i < sweeps; ++i) {
        bool is_sound = true;
        for (Index vertex = 0; vertex < mesh_.vertex_capacity(); ++vertex) {
            if (!mesh_.has_vertex(vertex) || !is_active_[vertex]) continue;
            meter.step();
            gather(vertex, points_[vertex]);
            if (star_.has_center_in_kernel()) {
                is_active_[vertex] = 0;
                continue;
            }
            is_sound = false;
            if (!is_pinned_[vertex] && put_into_kernel(vertex, points_[vertex])) activate_star(vertex);
        }
        if (is_sound) return true;
    }
    return false;
}

void Relaxation::activate_star(Index vertex) {
    is_active_[vertex] = 1;
    Index half_edge = mesh_.outgoing(vertex);
    do {
        is_active_[mesh_.target(half_edge)] = 1;
        half_edge = mesh_.rotated(half_edge);
    } while (half_edge != mesh_.outgoing(vertex));
}

}  // namespace interleaf
