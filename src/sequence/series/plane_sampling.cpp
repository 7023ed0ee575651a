#include "sequence/series/plane_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/error.h"
#include "sequence/series/plane_mesh.h"
#include "sequence/series/root_grid.h"

namespace interleaf {

namespace {

/// A key may have this many leaves per triangle of its step and of the roots, and more if it is small.
constexpr std::size_t max_leaves_per_triangle = 64;
constexpr std::size_t least_max_leaves = 200'000;

/// The line that bisects a node has this width, relative to its length.
constexpr double line_width = 1e-12;

class PlaneSampler {
  public:
    PlaneSampler(const StepMesh& step, const SeriesRoots& roots, const PlaneSampling& sampling)
        : sampling_(sampling),
          plane_(step, sampling.axis, scales_of(sampling)),
          points_(roots.points),
          mesh_(roots.complex, floats_of(roots.points),
                [this](Index a, Index b, Index midpoint) { return place(a, b, midpoint); }),
          max_leaves_(
              std::max(least_max_leaves,
                       max_leaves_per_triangle * (step.triangles.size() + roots.complex.triangle_count()))) {
        start(roots);
    }

    void refine() {
        std::vector<Index> open(nodes_.size());
        for (Index leaf = 0; leaf < open.size(); ++leaf) open[leaf] = leaf;
        while (!open.empty()) {
            std::vector<Index> marked;
            for (const Index leaf : open)
                if (!is_done(nodes_[leaf])) marked.push_back(leaf);
            std::vector<Index> changed;
            mesh_.refine(marked, &changed);
            if (mesh_.leaf_count() > max_leaves_)
                throw InputError(
                    fmt::format("a difference of {:g} of the range needs more than {} leaves; "
                                "allow a larger tolerance",
                                sampling_.tolerance, max_leaves_));
            for (std::size_t pair = 0; pair < changed.size(); pair += 2)
                bisect_node(changed[pair], changed[pair + 1]);
            std::ranges::sort(changed);
            changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
            open = std::move(changed);
        }
    }

    SampledKey key(const SeriesFields& fields) const {
        std::vector<Field> scalars;
        for (std::size_t s = 0; s < fields.scalars.size(); ++s) {
            Field& field = scalars.emplace_back(Field{fields.scalars[s].name, FieldKind::scalar, {}});
            for (std::size_t v = 0; v < points_.size(); ++v)
                field.values.push_back(static_cast<float>(values_[v * plane_.scalar_count() + s]));
        }
        SampledKey sampled{mesh_.freeze(scalars), 0};
        for (const Node& node : nodes_)
            sampled.largest_difference = std::max(sampled.largest_difference, node.difference);
        return sampled;
    }

  private:
    /// A leaf of the mesh.
    struct Node {
        Triangle vertices{};
        std::vector<Index> near;  ///< the triangles of the step that it may overlap
        double difference = 0;
    };

    static std::vector<double> scales_of(const PlaneSampling& sampling) {
        std::vector<double> scales;
        for (const double range : sampling.ranges) scales.push_back(range > 0 ? 1 / range : 0);
        return scales;
    }
    static std::vector<glm::vec3> floats_of(std::span<const glm::dvec3> points) {
        return {points.begin(), points.end()};
    }

    glm::vec3 place(Index a, Index b, Index midpoint) {
        if (points_.size() <= midpoint) points_.resize(midpoint + std::size_t{1});
        points_[midpoint] = (points_[a] + points_[b]) / 2.0;
        midpoints_.emplace(edge_number(a, b), midpoint);
        return points_[midpoint];
    }

    static std::uint64_t edge_number(Index a, Index b) {
        return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    }

    glm::dvec2 at(Index vertex) const { return in_plane(points_[vertex], sampling_.axis); }
    PlaneTriangle triangle_of(const Triangle& vertices) const {
        return {at(vertices[0]), at(vertices[1]), at(vertices[2])};
    }
    double* values_at(Index vertex) { return values_.data() + vertex * plane_.scalar_count(); }

    void start(const SeriesRoots& roots) {
        const std::span<const Triangle> triangles = roots.complex.triangles();
        nodes_.resize(triangles.size());
        std::vector<PlaneTriangle> places;
        for (Index r = 0; r < triangles.size(); ++r) {
            nodes_[r].vertices = triangles[r];
            places.push_back(triangle_of(triangles[r]));
            if (!(places.back().double_area() > 0))
                throw InputError(fmt::format("root {} runs clockwise or has no area", r));
        }
        const RootGrid grid(places);
        std::vector<Index> over;
        for (Index t = 0; t < plane_.triangle_count(); ++t) {
            if (!(plane_.triangle(t).double_area() > 0)) continue;
            grid.overlapping(plane_.triangle(t), over);
            for (const Index r : over) nodes_[r].near.push_back(t);
        }
        evaluate_root_vertices();
    }

    void evaluate_root_vertices() {
        values_.resize(points_.size() * plane_.scalar_count());
        std::vector<double> distance(points_.size(), std::numeric_limits<double>::infinity());
        std::vector<double> values(plane_.scalar_count());
        for (const Node& node : nodes_)
            for (const Index vertex : node.vertices) {
                if (distance[vertex] == 0) continue;
                const double apart = plane_.evaluate(at(vertex), node.near, values.data());
                if (!(apart < distance[vertex])) continue;
                distance[vertex] = apart;
                std::ranges::copy(values, values_at(vertex));
            }
        for (std::size_t v = 0; v < distance.size(); ++v)
            if (!std::isfinite(distance[v]))
                throw InputError(
                    fmt::format("no triangle is near the root vertex at {}: the step covers "
                                "another domain than the roots",
                                text_of(points_[v])));
        is_evaluated_.assign(points_.size(), true);
    }

    bool is_done(Node& node) {
        if (sampling_.report) sampling_.report();
        const PlaneTriangle triangle = triangle_of(node.vertices);
        const PlaneNode plane_node{
            triangle,
            {values_at(node.vertices[0]), values_at(node.vertices[1]), values_at(node.vertices[2])}};
        if (sampling_.tolerance > 0) {
            node.difference = plane_.difference(plane_node, node.near, sampling_.tolerance);
            return node.difference <= sampling_.tolerance;
        }
        if (!node.near.empty() && !plane_.is_held(triangle, node.near)) return false;
        node.difference = plane_.difference(plane_node, node.near, std::numeric_limits<double>::infinity());
        return true;
    }

    /// Replaces the node \p first, which the mesh has bisected, by its children.
    void bisect_node(Index first, Index second) {
        nodes_.resize(std::max<std::size_t>(nodes_.size(), second + std::size_t{1}));
        Node parent = std::move(nodes_[first]);
        const auto& [apex, b, c] = parent.vertices;
        const Index midpoint = midpoints_.at(edge_number(b, c));
        evaluate_midpoint(midpoint, parent);

        const auto children = bisect(parent.vertices, midpoint);
        Node left{children[0], {}, 0};
        Node right{children[1], {}, 0};
        const glm::dvec2 from = at(apex);
        const glm::dvec2 line = at(midpoint) - from;
        const double width = line_width * glm::dot(line, line);
        for (const Index t : parent.near) {
            double least = std::numeric_limits<double>::max();
            double most = std::numeric_limits<double>::lowest();
            for (const glm::dvec2& corner : plane_.triangle(t).corners) {
                const double side = line.x * (corner.y - from.y) - line.y * (corner.x - from.x);
                least = std::min(least, side);
                most = std::max(most, side);
            }
            if (most > width) left.near.push_back(t);
            if (least < -width) right.near.push_back(t);
        }
        nodes_[first] = std::move(left);
        nodes_[second] = std::move(right);
    }

    void evaluate_midpoint(Index midpoint, const Node& parent) {
        values_.resize(points_.size() * plane_.scalar_count());
        is_evaluated_.resize(points_.size(), false);
        if (is_evaluated_[midpoint]) return;
        is_evaluated_[midpoint] = true;
        if (std::isfinite(plane_.evaluate(at(midpoint), parent.near, values_at(midpoint)))) return;
        // Far from the step, the values go on as between the ends of the edge.
        const double* b = values_at(parent.vertices[1]);
        const double* c = values_at(parent.vertices[2]);
        for (std::size_t s = 0; s < plane_.scalar_count(); ++s) values_at(midpoint)[s] = (b[s] + c[s]) / 2;
    }

    const PlaneSampling& sampling_;
    PlaneMesh plane_;
    std::vector<glm::dvec3> points_;  ///< by vertex
    std::vector<double> values_;      ///< by vertex, all scalars together
    std::vector<bool> is_evaluated_;  ///< by vertex
    std::unordered_map<std::uint64_t, Index> midpoints_;
    std::vector<Node> nodes_;  ///< by leaf of the mesh
    AdaptiveMesh mesh_;
    std::size_t max_leaves_;
};

/// Moves the vertices by the displacement, which is among the fields.
void displace(Hierarchy& key, const Triangle& displacement) {
    for (int axis = 0; axis < 3; ++axis) {
        const Index scalar = displacement[static_cast<std::size_t>(axis)];
        if (scalar == no_index) continue;
        for (std::size_t v = 0; v < key.positions.size(); ++v)
            key.positions[v][axis] += key.fields[scalar].values[v];
    }
}

}  // namespace

SampledKey sample_in_plane(const StepMesh& step, const SeriesRoots& roots, const SeriesFields& fields,
                           const PlaneSampling& sampling) {
    PlaneSampler sampler(step, roots, sampling);
    sampler.refine();
    SampledKey sampled = sampler.key(fields);
    displace(sampled.key, step.displacement);
    return sampled;
}

}  // namespace interleaf
