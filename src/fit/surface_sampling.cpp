#include "fit/surface_sampling.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/progress_meter.h"
#include "fit/surface_normals.h"
#include "fit/triangle_distance.h"
#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/greedy.h"

namespace interleaf {
namespace {

/// What the turn of the normal adds to a leaf's error, as a fraction of its size.
constexpr double turn_share = 0.1;

/// A deeper leaf is not bisected on its own account. Closure may add two levels, and max_level is the end.
constexpr unsigned deepest_level = max_level - 4;

class Sampler {
  public:
    Sampler(const SurfaceMesh& mesh, std::span<const glm::dvec3> points, const SphereLocation& location,
            const SphereRoots& roots)
        : mesh_(mesh),
          points_(points),
          location_(location),
          normals_(unit_normals(mesh.triangles, mesh.positions)) {
        for (const glm::dvec3& point : roots.points) add_vertex(point, no_index);
        assign_vertices(roots);
    }

    glm::vec3 position(Index vertex) const {
        return glm::vec3(
            mesh_points_[vertex].of(std::span<const Triangle>(mesh_.triangles), std::span(mesh_.positions)));
    }

    /// The rule of the adaptive mesh for new vertices.
    glm::vec3 place_midpoint(Index a, Index b, Index midpoint) {
        assert(midpoint == sphere_points_.size());
        add_vertex(glm::normalize(sphere_points_[a] + sphere_points_[b]), mesh_points_[a].triangle);
        divided_edges_.push_back({{a, b, midpoint}, middle_of(a, midpoint), middle_of(b, midpoint)});
        return position(midpoint);
    }

    /// Takes notice of bisections: \p changed holds the children of each.
    void divide_vertices(std::span<const Index> changed) {
        for (std::size_t i = 0; i < changed.size(); i += 2) divide_vertices(changed[i], changed[i + 1]);
        divided_edges_.clear();
    }

    double error(const AdaptiveMesh& mesh, Index leaf, bool distance_alone) const;

    SampledSurface result(const AdaptiveMesh& mesh) && {
        SampledSurface surface;
        for (const Index leaf : mesh.preorder())
            surface.leaves.push_back({mesh.vertices(leaf), static_cast<std::uint8_t>(mesh.level(leaf))});
        surface.positions.assign(mesh.positions().begin(), mesh.positions().end());
        surface.sphere_points = std::move(sphere_points_);
        surface.mesh_points = std::move(mesh_points_);
        return surface;
    }

  private:
    /// What is known of a leaf, so that its bisection has little left to locate.
    struct LeafRecord {
        Triangle corners;
        std::array<MeshPoint, 3> middles;  ///< of the sides, on the surface
        Index begin;                       ///< of those vertices of the surface that lie in it: a range of
        Index end;                         ///< vertices_
    };
    /// An edge bisected in the present step. Leaves at both its sides take its halves over.
    struct DividedEdge {
        NewVertex vertex;
        MeshPoint middle_at_a;  ///< of the half from a to the new vertex
        MeshPoint middle_at_b;
    };

    void add_vertex(const glm::dvec3& sphere_point, Index guess) {
        sphere_points_.push_back(sphere_point);
        mesh_points_.push_back(location_.locate(sphere_point, guess));
    }
    /// Where the middle of an edge lies on the surface; \p b lies there already.
    MeshPoint middle_of(Index a, Index b) const {
        return location_.locate(glm::normalize(sphere_points_[a] + sphere_points_[b]),
                                mesh_points_[b].triangle);
    }
    void assign_vertices(const SphereRoots& roots);
    void divide_vertices(Index first, Index second);

    const SurfaceMesh& mesh_;
    std::span<const glm::dvec3> points_;
    const SphereLocation& location_;
    std::vector<glm::dvec3> normals_;  ///< one a triangle of the surface

    std::vector<glm::dvec3> sphere_points_;  ///< one a vertex of the key
    std::vector<MeshPoint> mesh_points_;
    std::vector<Index> vertices_;  ///< of the surface, those of a leaf together
    std::vector<LeafRecord> leaves_;
    std::vector<DividedEdge> divided_edges_;  ///< in the present step
};

/// Puts every vertex of the surface into the root triangle it is mapped into.
void Sampler::assign_vertices(const SphereRoots& roots) {
    const auto triangles = roots.complex.triangles();
    const SphereLocation root_location(triangles, roots.points);
    std::vector<Index> root_of(points_.size());
    std::vector<Index> counts(triangles.size(), 0);
    for (std::size_t v = 0; v < points_.size(); ++v) {
        root_of[v] = root_location.locate(points_[v], v > 0 ? root_of[v - 1] : no_index).triangle;
        ++counts[root_of[v]];
    }
    Index begin = 0;
    for (std::size_t root = 0; root < triangles.size(); ++root) {
        const auto& [a, b, c] = triangles[root];
        leaves_.push_back(
            {triangles[root], {middle_of(b, c), middle_of(c, a), middle_of(a, b)}, begin, begin});
        begin += counts[root];
    }
    vertices_.resize(points_.size());
    for (std::size_t v = 0; v < points_.size(); ++v)
        vertices_[leaves_[root_of[v]].end++] = static_cast<Index>(v);
}

/// One bisection: the first child takes its parent's place.
void Sampler::divide_vertices(Index first, Index second) {
    const auto [corners, middles, begin, end] = leaves_[first];
    const auto [low, high] = std::minmax(corners[1], corners[2]);
    const auto edge =
        std::ranges::find_if(divided_edges_, [low = low, high = high](const DividedEdge& divided) {
            return divided.vertex.a == low && divided.vertex.b == high;
        });
    assert(edge != divided_edges_.end());
    const Index midpoint = edge->vertex.midpoint;
    const auto children = bisect(corners, midpoint);
    const glm::dvec3& apex = sphere_points_[corners[0]];
    const glm::dvec3& middle = sphere_points_[midpoint];
    const auto divide = std::partition(vertices_.begin() + begin, vertices_.begin() + end, [&](Index vertex) {
        return side_of_arc(apex, middle, points_[vertex]) >= 0;
    });
    const auto between = static_cast<Index>(divide - vertices_.begin());
    if (leaves_.size() <= second) leaves_.resize(second + 1);

    // The children's sides, as hierarchy/triangle.h numbers them: the first has the half at corners[2].
    const bool first_at_b = corners[2] == edge->vertex.b;
    const MeshPoint& middle_of_first = first_at_b ? edge->middle_at_b : edge->middle_at_a;
    const MeshPoint& middle_of_second = first_at_b ? edge->middle_at_a : edge->middle_at_b;
    const MeshPoint middle_between = middle_of(corners[0], midpoint);
    leaves_[first] = {children[0], {middles[1], middle_between, middle_of_first}, begin, between};
    leaves_[second] = {children[1], {middles[2], middle_of_second, middle_between}, between, end};
}

double Sampler::error(const AdaptiveMesh& mesh, Index leaf, bool distance_alone) const {
    if (mesh.level(leaf) >= deepest_level) return 0;
    const auto& [a, b, c] = mesh.vertices(leaf);
    const TriangleCorners corners = {mesh.positions()[a], mesh.positions()[b], mesh.positions()[c]};
    const glm::dvec3 &u = sphere_points_[a], &v = sphere_points_[b], &w = sphere_points_[c];
    const glm::dvec3 normal = unit_normal(corners);

    double squared_distance = 0;
    double squared_turn = 0;
    const LeafRecord& record = leaves_[leaf];
    const auto measure_at = [&](const MeshPoint& point) {
        const glm::dvec3 on_surface =
            point.of(std::span<const Triangle>(mesh_.triangles), std::span(mesh_.positions));
        squared_distance = std::max(squared_distance, squared_distance_to_triangle(on_surface, corners));
        const glm::dvec3 turn = normals_[point.triangle] - normal;
        squared_turn = std::max(squared_turn, glm::dot(turn, turn));
    };
    for (const MeshPoint& middle : record.middles) measure_at(middle);
    measure_at(location_.locate(glm::normalize(u + v + w), record.middles[0].triangle));
    for (Index i = record.begin; i < record.end; ++i)
        squared_distance =
            std::max(squared_distance, squared_distance_to_triangle(mesh_.positions[vertices_[i]], corners));
    if (distance_alone) return std::sqrt(squared_distance);

    const double size =
        std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                  glm::distance(corners[2], corners[0])});
    return std::sqrt(squared_distance) + turn_share * size * std::sqrt(squared_turn);
}

}  // namespace

SampledSurface sample_surface(const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                              const SphereLocation& location, const SphereRoots& roots,
                              const SamplingOptions& options, const Progress& progress) {
    Sampler sampler(mesh, points, location, roots);
    std::vector<glm::vec3> root_positions;
    root_positions.reserve(roots.complex.vertex_count());
    for (Index vertex = 0; vertex < roots.complex.vertex_count(); ++vertex)
        root_positions.push_back(sampler.position(vertex));
    AdaptiveMesh leaves(roots.complex, root_positions, [&](Index a, Index b, Index midpoint) {
        return sampler.place_midpoint(a, b, midpoint);
    });

    ProgressMeter meter(progress);
    meter.enter("sampling", 0);
    const auto after_step = [&](const AdaptiveMesh& refined, std::span<const Index> changed) {
        sampler.divide_vertices(changed);
        meter.set_part(double(refined.leaf_count()) / options.leaves);
        meter.step();
    };
    const bool distance_alone = options.tolerance > 0;
    refine_greedily(
        leaves,
        [&](const AdaptiveMesh& refined, Index leaf) { return sampler.error(refined, leaf, distance_alone); },
        {.leaves = options.leaves, .tolerance = options.tolerance, .after_step = after_step});
    return std::move(sampler).result(leaves);
}

}  // namespace interleaf
