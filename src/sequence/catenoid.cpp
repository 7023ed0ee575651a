#include "sequence/catenoid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "sequence/area_flow.h"
#include "sequence/evolving_mesh.h"

namespace interleaf {
namespace {

/// A cylinder of root rectangles. Vertex (row, column) has the number row * columns + column.
struct CylinderGrid {
    Index rows;     ///< between the rings
    Index columns;  ///< around the axis; even, so that the diagonals can alternate
};

/// The grid whose rectangles are closest to squares, so that triangles stay close to right isosceles ones,
/// with the least number of rows that allows six columns.
CylinderGrid grid_for(double distance) {
    for (Index rows = 1;; ++rows) {
        const auto columns = static_cast<Index>(2 * std::lround(std::numbers::pi * rows / distance));
        if (columns >= 6) return {rows, columns};
    }
}

/// The rectangles, each halved by a diagonal, which is the refinement edge of both halves. Four or eight
/// triangles meet at each vertex between the rings.
RootComplex roots_of(const CylinderGrid& grid) {
    std::vector<Triangle> triangles;
    for (Index row = 0; row < grid.rows; ++row) {
        for (Index column = 0; column < grid.columns; ++column) {
            const Index next = (column + 1) % grid.columns;
            const Index low = row * grid.columns + column;
            const Index low_next = row * grid.columns + next;
            const Index high = low + grid.columns;
            const Index high_next = low_next + grid.columns;
            if ((row + column) % 2 == 0) {
                triangles.push_back({high, low, high_next});
                triangles.push_back({low_next, high_next, low});
            } else {
                triangles.push_back({low, low_next, high});
                triangles.push_back({high_next, high, low_next});
            }
        }
    }
    return {(grid.rows + 1) * grid.columns, std::move(triangles)};
}

std::vector<glm::dvec3> positions_of(const CylinderGrid& grid, double distance) {
    std::vector<glm::dvec3> positions;
    for (Index row = 0; row <= grid.rows; ++row) {
        for (Index column = 0; column < grid.columns; ++column) {
            const double angle = 2 * std::numbers::pi * column / grid.columns;
            positions.emplace_back(std::sin(angle), distance * (static_cast<double>(row) / grid.rows - 0.5),
                                   std::cos(angle));
        }
    }
    return positions;
}

double distance_from_axis(const glm::dvec3& position) {
    return std::hypot(position.x, position.z);
}

/// \p position at the distance 1 from the axis.
glm::dvec3 on_cylinder(const glm::dvec3& position) {
    const double radius = distance_from_axis(position);
    return {position.x / radius, position.y, position.z / radius};
}

/// The film, as it changes with time.
class Film {
  public:
    Film(double distance, double tolerance)
        : grid_(grid_for(distance)),
          surface_(roots_of(grid_), positions_of(grid_, distance),
                   [this](Index a, Index b, Index midpoint) { return place(a, b, midpoint); }),
          is_on_ring_(surface_.positions().size()),
          normals_(surface_.positions().size()),
          tolerance_(tolerance * std::sqrt(8 + distance * distance)) {
        std::fill_n(is_on_ring_.begin(), grid_.columns, true);
        std::fill_n(is_on_ring_.rbegin(), grid_.columns, true);
        adapt();
        is_cylinder_ = false;
        neck_ = neck_radius();
    }

    double time() const { return time_; }
    double neck() const { return neck_; }

    /// Whether the flow has come to its end.
    bool is_at_end() const {
        constexpr double standstill = 5e-4;  // radii per second
        return neck_ <= narrowest_neck || speed_of_neck_ < standstill;
    }

    /// Adapts the mesh, then flows on by a part of a step: as long as the present neck allows, and not beyond
    /// \p time.
    void flow_until(double time) {
        constexpr double max_part = 0.02;
        // The neck r of a thin film shrinks at the speed 1/r.
        const double part = std::min(max_part, 0.1 * neck_ * neck_);
        if (time_ > 0) adapt();
        const double length = std::min(part, time - time_);
        const double before = neck_radius();
        step_to_smaller_area(surface_.triangles(), is_on_ring_, length, surface_.positions());
        time_ = part < time - time_ ? time_ + part : time;
        neck_ = neck_radius();
        speed_of_neck_ = std::abs(neck_ - before) / length;
    }

    Hierarchy state() const {
        const std::vector<float> curvatures =
            mean_curvatures(surface_.triangles(), is_on_ring_, surface_.positions());
        const Field field{.name = "mean curvature", .values = {curvatures.begin(), curvatures.end()}};
        return surface_.freeze(std::span(&field, 1));
    }

  private:
    /// Whether both vertices are on the same ring. An edge between them is then an edge of the ring, because
    /// edges are straight on the unrolled cylinder.
    bool is_ring_edge(Index a, Index b) const {
        return is_on_ring_[a] && is_on_ring_[b] &&
               (surface_.positions()[a].y > 0) == (surface_.positions()[b].y > 0);
    }

    glm::dvec3 place(Index a, Index b, Index midpoint) {
        if (midpoint == is_on_ring_.size()) {
            is_on_ring_.push_back(false);
            normals_.emplace_back();
        }
        is_on_ring_[midpoint] = is_ring_edge(a, b);
        const glm::dvec3 normal = normals_[a] + normals_[b];
        normals_[midpoint] = glm::dot(normal, normal) > 0 ? glm::normalize(normal) : normal;
        const glm::dvec3 from = surface_.positions()[a];
        const glm::dvec3 to = surface_.positions()[b];
        const glm::dvec3 middle = (from + to) / 2.0;
        if (is_on_ring_[midpoint] || is_cylinder_) return on_cylinder(middle);
        return middle - (glm::dot(to - from, normals_[a]) * normals_[a] +
                         glm::dot(from - to, normals_[b]) * normals_[b]) /
                            8.0;
    }

    double error_of_edge(Index a, Index b) const {
        const glm::dvec3& from = surface_.positions()[a];
        const glm::dvec3& to = surface_.positions()[b];
        const double arc_height = glm::distance(from, to) * glm::distance(normals_[a], normals_[b]) / 8;
        if (!is_ring_edge(a, b)) return arc_height;
        return std::max(arc_height, 1 - distance_from_axis((from + to) / 2.0));
    }

    void adapt() {
        surface_.adapt(
            [this](Index a, Index b) { return error_of_edge(a, b); }, tolerance_,
            [this] { normals_ = area_weighted_normals(surface_.triangles(), surface_.positions()); });
    }

    /// The least distance of a vertex from the axis.
    double neck_radius() const {
        double radius = std::numeric_limits<double>::infinity();
        for (const Triangle& triangle : surface_.triangles())
            for (const Index v : triangle)
                radius = std::min(radius, distance_from_axis(surface_.positions()[v]));
        return radius;
    }

    CylinderGrid grid_;
    EvolvingMesh surface_;
    Pinned is_on_ring_;                ///< by vertex
    std::vector<glm::dvec3> normals_;  ///< by vertex, unit; when the mesh was adapted last
    double tolerance_;
    bool is_cylinder_ = true;  ///< whether new vertices are still placed on the cylinder
    double time_ = 0;
    double neck_ = 1;
    double speed_of_neck_ = std::numeric_limits<double>::infinity();  ///< in the last part of a step
};

constexpr double max_duration = 50;

/// The states of a film that comes to its end after \p duration, in equal steps. A film that collapses comes
/// to its end in the last step, even if that takes a little longer. If it ends in an earlier step, because
/// other parts of steps led to it than in the run that found the duration, \p duration becomes the time of
/// that end, and there are too few states.
std::vector<Hierarchy> states_of(Film& film, bool collapses, unsigned steps, double& duration,
                                 const SequenceProgress& report) {
    std::vector<Hierarchy> states = {film.state()};
    const auto is_torn = [&] { return film.neck() <= narrowest_neck; };
    for (unsigned step = 1; step <= steps; ++step) {
        const double time = duration * step / steps;
        while (film.time() < time && !is_torn()) film.flow_until(time);
        if (step < steps && is_torn()) {
            duration = film.time();
            break;
        }
        while (step == steps && collapses && !is_torn()) film.flow_until(max_duration);
        states.push_back(film.state());
        report(0.5 + 0.5 * step / steps);
    }
    return states;
}

}  // namespace

Family make_catenoid(const CatenoidOptions& options, const SequenceProgress& progress) {
    constexpr double min_distance = 0.2;
    constexpr double max_distance = 3;
    check_options(options.steps);
    if (!(options.distance >= min_distance && options.distance <= max_distance))
        throw UsageError(
            fmt::format("the distance between the rings must be from {} to {}", min_distance, max_distance));
    double done = 0;
    const SequenceProgress report = [&](double part) {
        done = std::max(done, part);
        if (progress) progress(done);
    };

    Film first(options.distance, options.steps.tolerance);
    while (!first.is_at_end() && first.time() < max_duration) {
        first.flow_until(max_duration);
        report(0);
    }
    double duration = first.time();
    std::vector<Hierarchy> states;
    while (states.size() <= options.steps.steps) {
        Film film(options.distance, options.steps.tolerance);
        states = states_of(film, first.neck() <= narrowest_neck, options.steps.steps, duration, report);
    }
    return family_of_states("Film between two rings", std::move(states), duration);
}

}  // namespace interleaf
