#include "sequence/flow.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "hierarchy/cube.h"
#include "sequence/deformation_flow.h"
#include "sequence/evolving_mesh.h"
#include "sequence/surface_stretch.h"

namespace interleaf {
namespace {

/// The directions of the vertices of \p roots from the origin.
std::vector<glm::dvec3> directions_of(const Hierarchy& roots) {
    std::vector<glm::dvec3> directions;
    directions.reserve(roots.positions.size());
    for (const glm::dvec3 corner : roots.positions) directions.push_back(glm::normalize(corner));
    return directions;
}

/// The ball in the flow, with an adaptive mesh.
class FlowingBall {
  public:
    FlowingBall(const Hierarchy& roots, unsigned steps, double tolerance)
        : sphere_(flow_duration, steps),
          directions_(directions_of(roots)),
          surface_(roots.roots, traced(directions_),
                   [this](Index a, Index b, Index midpoint) {
                       if (midpoint == directions_.size()) directions_.emplace_back();
                       directions_[midpoint] = halfway(a, b);
                       return sphere_.at(directions_[midpoint]);
                   }),
          tolerance_(tolerance * 2 * flow_ball_radius * std::sqrt(3.0)) {
        adapt();
    }

    void advance() {
        sphere_.advance();
        // Freed vertices move along. They are at most as many as the vertices once were.
        const std::span<glm::dvec3> positions = surface_.positions();
        for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = sphere_.at(directions_[v]);
        adapt();
    }

    Hierarchy state() const {
        std::vector<glm::dvec3> before;
        before.reserve(directions_.size());
        for (const glm::dvec3& direction : directions_) before.push_back(flow_ball_radius * direction);
        const std::vector<float> stretches =
            vertex_stretches(surface_.triangles(), before, surface_.positions());
        const Field field{.name = "stretch", .values = {stretches.begin(), stretches.end()}};
        return surface_.freeze(std::span(&field, 1));
    }

  private:
    glm::dvec3 halfway(Index a, Index b) const { return glm::normalize(directions_[a] + directions_[b]); }

    std::vector<glm::dvec3> traced(std::span<const glm::dvec3> directions) {
        std::vector<glm::dvec3> positions;
        positions.reserve(directions.size());
        for (const glm::dvec3& direction : directions) positions.push_back(sphere_.at(direction));
        return positions;
    }

    void adapt() {
        surface_.adapt(
            [this](Index a, Index b) {
                const std::span<const glm::dvec3> positions = surface_.positions();
                return glm::distance(sphere_.at(halfway(a, b)), (positions[a] + positions[b]) / 2.0);
            },
            tolerance_);
    }

    FlowingSphere sphere_;
    std::vector<glm::dvec3> directions_;  ///< by vertex: the names of points of the sphere
    EvolvingMesh surface_;
    double tolerance_;
};

}  // namespace

Family make_flow(const SequenceOptions& options, const SequenceProgress& progress) {
    check_options(options);
    FlowingBall ball(cube(), options.steps, options.tolerance);
    std::vector<Hierarchy> states = {ball.state()};
    for (unsigned step = 1; step <= options.steps; ++step) {
        ball.advance();
        states.push_back(ball.state());
        if (progress) progress(static_cast<double>(step) / options.steps);
    }
    return family_of_states("Ball in a flow", std::move(states), flow_duration);
}

}  // namespace interleaf
