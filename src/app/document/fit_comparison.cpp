#include "app/document/fit_comparison.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <glm/vec3.hpp>

#include "fit/fit_quality.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_distance.h"

namespace interleaf {

namespace {

/// Measures distances from a mesh, in parts of \p unit, while progress goes from \p begin to \p end.
class Measure {
  public:
    Measure(const SurfaceDistance& mesh, double unit, ProgressMeter& meter, double begin, double end)
        : mesh_(mesh), unit_(unit), meter_(meter), begin_(begin), length_(end - begin) {}

    /// Reports that the \p n-th of \p count pieces of work is next.
    void go_on(std::size_t n, std::size_t count) {
        meter_.set_part(begin_ + length_ * static_cast<double>(n) / static_cast<double>(count));
    }

    float operator()(const glm::dvec3& place) {
        meter_.step();
        return static_cast<float>(mesh_(place, nearest_) / unit_);
    }

  private:
    const SurfaceDistance& mesh_;
    double unit_;
    ProgressMeter& meter_;
    double begin_;
    double length_;
    Index nearest_ = no_index;
};

std::vector<float> distances_at_vertices(std::span<const glm::dvec3> vertices, Measure measure) {
    std::vector<float> found;
    found.reserve(vertices.size());
    for (const glm::dvec3& vertex : vertices) {
        measure.go_on(found.size(), vertices.size());
        found.push_back(measure(vertex));
    }
    return found;
}

/// Per vertex, the largest value of the leaves around it.
std::vector<float> distances_of_leaves(std::span<const Triangle> leaves, std::span<const glm::dvec3> vertices,
                                       Measure measure) {
    std::vector<float> found(vertices.size(), 0.0F);
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
        measure.go_on(leaf, leaves.size());
        const auto& [i, j, k] = leaves[leaf];
        const glm::dvec3 &a = vertices[i], &b = vertices[j], &c = vertices[k];
        float largest = 0;
        for (const glm::dvec3& place :
             {a, (a + b) / 2.0, b, (a + b + c) / 3.0, (b + c) / 2.0, c, (c + a) / 2.0})
            largest = std::max(largest, measure(place));
        for (const Index vertex : leaves[leaf]) found[vertex] = std::max(found[vertex], largest);
    }
    return found;
}

}  // namespace

FitComparison compare(std::string mesh_name, FittedKey fitted, const Progress& progress) {
    const SurfaceMesh& mesh = fitted.mesh;
    const Hierarchy& key = fitted.hierarchy;
    std::vector<Triangle> leaves;
    leaves.reserve(key.leaf_count());
    for (const Leaf& leaf : leaves_of(key)) leaves.push_back(leaf.vertices);
    const std::vector<glm::dvec3> key_positions(key.positions.begin(), key.positions.end());
    const double percent = box_diagonal(mesh) / 100;

    ProgressMeter meter(progress);
    meter.enter("comparing", 0);
    FitComparison comparison;
    const SurfaceDistance to_mesh(mesh.triangles, mesh.positions);
    comparison.key_distances =
        distances_of_leaves(leaves, key_positions, Measure(to_mesh, percent, meter, 0, 0.7));
    const SurfaceDistance to_key(leaves, key_positions);
    comparison.mesh_distances =
        distances_at_vertices(mesh.positions, Measure(to_key, percent, meter, 0.7, 1));
    comparison.mesh_name = std::move(mesh_name);
    comparison.positions.assign(mesh.positions.begin(), mesh.positions.end());
    comparison.triangles = std::move(fitted.mesh.triangles);
    comparison.quality = fitted.report.quality;
    comparison.key = std::move(fitted.hierarchy);
    return comparison;
}

float max_distance(const FitComparison& comparison) {
    return std::max(std::ranges::max(comparison.mesh_distances), std::ranges::max(comparison.key_distances));
}

std::vector<ComparedKey> compared_keys(const Family& family, const Comparisons& comparisons) {
    std::vector<ComparedKey> compared;
    for (std::size_t key = 0; key < family.keys.size(); ++key) {
        const auto found = std::ranges::find_if(comparisons, [&](const auto& comparison) {
            return comparison->key.is_same(family.keys[key].hierarchy);
        });
        if (found != comparisons.end()) compared.push_back({key, *found});
    }
    return compared;
}

std::string in_words(const FitQuality& quality) {
    return fmt::format("at most {:.3g} % of the box diagonal from the mesh, least angle {:.3g} degrees, {}",
                       100 * quality.hausdorff, quality.min_angle,
                       quality.flipped_leaves == 0 ? "no flipped leaves"
                       : quality.flipped_leaves == 1
                           ? "1 flipped leaf"
                           : fmt::format("{} flipped leaves", quality.flipped_leaves));
}

}  // namespace interleaf
