#include "fit/landmarks/pinned_map.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/landmarks/sphere_flow.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/unit_box.h"
#include "fit/sphere_map/alignment.h"
#include "fit/sphere_map/orientation.h"
#include "fit/sphere_map/progressive_mapping.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/rotation_fit.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

/// Vertices of the coarse mesh, at least, and per landmark.
constexpr std::size_t coarse_vertices = 1000;
constexpr std::size_t coarse_vertices_per_landmark = 20;

/// How far a stage moves the farthest landmark, at most and at least, as a chord of the unit sphere.
constexpr double longest_step = 0.03;
constexpr double shortest_step = 0.001;
constexpr double growth_of_step = 1.3;

/// Radius of the flow's kernel, before stages are refused, and at least.
constexpr double widest_kernel = 0.8;
constexpr double narrowest_kernel = 0.12;
constexpr double shrinkage_of_kernel = 0.7;

/// After this many refused stages, the coarse mesh gets more vertices: room to move.
constexpr int max_refusals = 6;

/// A stage that flips at most this fraction of the triangles is mended rather than refused.
constexpr double mended_part = 0.01;
constexpr int mending_sweeps = 30;

constexpr int sweeps_of_stage = 10;
constexpr int sweeps_of_group = 100;
constexpr std::size_t first_group = 4;

/// Limits of the work, in vertices times stages. Right landmarks of four-legged animals take 50,000 at most.
/// Doubtful ones are given up early.
constexpr std::size_t max_work = 500'000;
constexpr std::size_t max_work_if_doubtful = 200'000;

/// How much the rotation that leaves the map as it is counts against each landmark. So one or two landmarks
/// do not turn the map more than they must.
constexpr double inertia = 1e-3;

class PinnedMapping {
  public:
    PinnedMapping(const LandmarkPins& pins, HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                  const ProgressiveOptions& options, ProgressMeter& meter)
        : pins_(pins), positions_(positions), meter_(meter), mapping_(mesh, positions, options, meter) {}

    /// \return why there is no room on the sphere; empty for success
    std::string run(PinnedMap& made) {
        if (!make_coarse_map()) return mapping_.failure();
        turn_to_targets();
        made.agreement = agreement_;
        const std::vector<std::size_t> order = farthest_first();
        for (std::size_t size = std::min(first_group, order.size());;
             size = std::min(2 * size, order.size())) {
            meter_.enter("moving landmarks", mapping_part());
            std::string failure = carry(std::span(order).first(size));
            if (!failure.empty()) return failure;
            if (size == order.size()) break;
        }
        meter_.enter("mapping to the sphere", mapping_part());
        if (!mapping_.raise(positions_.size())) return mapping_.failure();
        made.points = std::move(mapping_.points());
        return {};
    }

  private:
    glm::dvec3& point_of(std::size_t landmark) { return mapping_.points()[pins_.vertices[landmark]]; }

    double distance_to_target(std::size_t landmark) {
        return glm::distance(point_of(landmark), pins_.directions[landmark]);
    }

    double mapping_part() const { return 0.9 * double(mapping_.count()) / double(positions_.size()); }

    bool make_coarse_map() {
        std::vector<char> kept(positions_.size());
        for (const Index vertex : pins_.vertices) kept[vertex] = 1;
        mapping_.collapse(kept);
        const auto has_all = [&] {
            return std::ranges::all_of(pins_.vertices,
                                       [&](Index vertex) { return mapping_.mesh().has_vertex(vertex); });
        };
        if (!mapping_.raise(std::max(coarse_vertices, coarse_vertices_per_landmark * pins_.vertices.size())))
            return false;
        while (!has_all())
            if (!mapping_.raise(more_vertices())) return false;
        return true;
    }

    std::size_t more_vertices() const { return mapping_.count() + mapping_.count() / 2; }

    /// The vertices that the coarse mesh has.
    std::vector<Index> present_vertices() const {
        std::vector<Index> present;
        present.reserve(mapping_.count());
        for (Index vertex = 0; vertex < positions_.size(); ++vertex)
            if (mapping_.mesh().has_vertex(vertex)) present.push_back(vertex);
        return present;
    }

    /// Centers the coarse map, aligns it to space, and turns it so that landmarks lie near their targets.
    void turn_to_targets() {
        const std::vector<Index> present = present_vertices();
        SurfaceMesh coarse;
        std::vector<glm::dvec3> points;
        std::vector<Index> number(positions_.size(), no_index);
        for (const Index vertex : present) {
            number[vertex] = static_cast<Index>(points.size());
            points.push_back(mapping_.points()[vertex]);
            coarse.positions.push_back(positions_[vertex]);
        }
        const HalfEdgeMesh& mesh = mapping_.mesh();
        for (Index triangle = 0; triangle < mesh.triangle_capacity(); ++triangle)
            if (mesh.has_triangle(triangle))
                coarse.triangles.push_back({number[mesh.origin(3 * triangle)],
                                            number[mesh.origin(3 * triangle + 1)],
                                            number[mesh.origin(3 * triangle + 2)]});
        center_map(coarse, points);
        rotate(points, rotation_to_surface(coarse, points));

        std::vector<glm::dvec3> from;
        from.reserve(pins_.vertices.size());
        for (const Index vertex : pins_.vertices) from.push_back(points[number[vertex]]);
        rotate(points, rotation_to_targets(from));
        for (std::size_t i = 0; i < present.size(); ++i) mapping_.points()[present[i]] = points[i];

        for (std::size_t k = 0; k < pins_.vertices.size(); ++k) {
            agreement_.ways.push_back(distance_to_target(k));
            if (agreement_.ways[k] > agreement_.ways[agreement_.farthest]) agreement_.farthest = k;
        }
    }

    glm::dmat3 rotation_to_targets(std::vector<glm::dvec3> from) {
        agreement_ = agreement_of(from, pins_);
        std::vector<glm::dvec3> to = pins_.directions;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 still(0);
            still[axis] = 1;
            from.push_back(inertia * still);
            to.push_back(still);
        }
        return fit_rotation(from, to).rotation;
    }

    /// The landmarks in an order in which each is as far as possible from all before it. The distance of two
    /// landmarks is the smaller of the distances of their points and of their targets.
    std::vector<std::size_t> farthest_first() {
        const std::size_t count = pins_.vertices.size();
        const auto distance = [&](std::size_t i, std::size_t j) {
            return std::min(glm::distance(point_of(i), point_of(j)),
                            glm::distance(pins_.directions[i], pins_.directions[j]));
        };
        std::size_t first = 0;
        double largest = -1;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (distance(i, j) > largest) {
                    largest = distance(i, j);
                    first = i;
                }
        std::vector<std::size_t> order;
        std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
        for (std::size_t next = first; order.size() < count;) {
            order.push_back(next);
            nearest[next] = -1;
            for (std::size_t k = 0; k < count; ++k) nearest[k] = std::min(nearest[k], distance(k, next));
            next = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
        }
        return order;
    }

    std::size_t farthest_of(std::span<const std::size_t> group) {
        return *std::ranges::max_element(group, {}, [&](std::size_t k) { return distance_to_target(k); });
    }

    bool is_there(std::span<const std::size_t> group) {
        return std::ranges::all_of(group, [&](std::size_t k) { return point_of(k) == pins_.directions[k]; });
    }

    /// Pins the landmarks of \p group, and carries them to their targets.
    /// \return what prevents it; empty for success
    std::string carry(std::span<const std::size_t> group) {
        for (const std::size_t k : group) mapping_.relaxation().pin(pins_.vertices[k]);
        double step = longest_step;
        double radius = widest_kernel;
        int refusals = 0;
        while (!is_there(group)) {
            work_ += mapping_.count();
            if (work_ > (agreement_.is_doubtful() ? max_work_if_doubtful : max_work))
                return stuck_text(group);
            if (try_stage(group, step, radius)) {
                mapping_.relaxation().sweep(sweeps_of_stage, meter_);
                step = std::min(longest_step, growth_of_step * step);
                continue;
            }
            step /= 2;
            radius = std::max(narrowest_kernel, shrinkage_of_kernel * radius);
            if (step >= shortest_step && ++refusals < max_refusals) {
                mapping_.relaxation().sweep(sweeps_of_stage, meter_);
                continue;
            }
            if (mapping_.count() == positions_.size()) return stuck_text(group);
            if (!mapping_.raise(more_vertices())) return mapping_.failure();
            refusals = 0;
            step = longest_step / 2;
        }
        mapping_.relaxation().sweep(sweeps_of_group, meter_);
        return {};
    }

    std::string stuck_text(std::span<const std::size_t> group) {
        return fmt::format("the landmark '{}' does not reach its place",
                           shown_text(pins_.names[farthest_of(group)]));
    }

    /// The point at the chord \p step from \p point toward \p target.
    static glm::dvec3 toward(const glm::dvec3& point, const glm::dvec3& target, double step) {
        const glm::dvec3 tangent = target - glm::dot(target, point) * point;
        const double length = glm::length(tangent);
        const glm::dvec3 direction = length > 0 ? tangent / length : TangentFrame(point).s_axis;
        return glm::normalize(point + step * direction);
    }

    /// Moves the whole map so that the farthest landmark of \p group gets nearer to its target by \p step, and
    /// all others by the same part of their way.
    /// \return false if that flips triangles; then nothing has moved
    bool try_stage(std::span<const std::size_t> group, double step, double radius) {
        const double farthest = distance_to_target(farthest_of(group));
        const std::vector<Index> present = present_vertices();
        std::vector<glm::dvec3> moved;
        moved.reserve(present.size());
        for (const Index vertex : present) moved.push_back(mapping_.points()[vertex]);
        std::vector<Index> landmarks;
        std::vector<glm::dvec3> goals;
        for (const std::size_t k : group) {
            landmarks.push_back(
                static_cast<Index>(std::ranges::lower_bound(present, pins_.vertices[k]) - present.begin()));
            goals.push_back(farthest <= step ? pins_.directions[k]
                                             : toward(point_of(k), pins_.directions[k],
                                                      step / farthest * distance_to_target(k)));
        }
        flow(moved, landmarks, goals, radius);

        const std::vector<glm::dvec3> before = mapping_.points();
        for (std::size_t i = 0; i < present.size(); ++i) mapping_.points()[present[i]] = moved[i];
        const std::size_t flipped = count_flipped();
        if (flipped == 0 || (double(flipped) < mended_part * 2 * double(mapping_.count()) &&
                             mapping_.relaxation().untangle(mending_sweeps, meter_)))
            return true;
        std::ranges::copy(before, mapping_.points().begin());
        return false;
    }

    std::size_t count_flipped() {
        const HalfEdgeMesh& mesh = mapping_.mesh();
        const std::vector<glm::dvec3>& points = mapping_.points();
        std::size_t flipped = 0;
        for (Index triangle = 0; triangle < mesh.triangle_capacity(); ++triangle)
            if (mesh.has_triangle(triangle) &&
                orientation(points[mesh.origin(3 * triangle)], points[mesh.origin(3 * triangle + 1)],
                            points[mesh.origin(3 * triangle + 2)]) <= 0)
                ++flipped;
        return flipped;
    }

    const LandmarkPins& pins_;
    std::span<const glm::dvec3> positions_;
    ProgressMeter& meter_;
    ProgressiveMapping mapping_;
    LandmarkAgreement agreement_;
    std::size_t work_ = 0;
};

}  // namespace

PinnedMap map_to_pins(const SurfaceMesh& mesh, const LandmarkPins& pins, const PinnedMapOptions& options,
                      const Progress& progress) {
    ProgressMeter meter(progress);
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
    std::string faults;
    LandmarkAgreement agreement;
    for (ProgressiveOptions each : {ProgressiveOptions{}, careful_options}) {
        each.keeps = options.keeps;
        each.crowded = options.crowded;
        HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
        PinnedMap made;
        std::string fault = PinnedMapping(pins, half_edges, positions, each, meter).run(made);
        if (fault.empty()) fault = fault_of_map(mesh, made.points);
        if (fault.empty()) return made;
        agreement = made.agreement;
        if (faults != fault) faults += faults.empty() ? fault : "; " + fault;
        if (agreement.is_doubtful()) break;
    }
    const std::string text =
        fmt::format("the surface could not be mapped to a sphere with its landmarks in place ({}){}", faults,
                    advice_on(agreement, pins));
    if (agreement.is_doubtful()) throw LandmarkError(text);
    throw InputError(text);
}

}  // namespace interleaf
