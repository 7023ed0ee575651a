#include "sequence/adaptive_domain.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {
namespace {

/// Intervals per edge of the grid of parameters that are tried in a triangle.
constexpr unsigned grid_parts = 4;

/// The largest distance at the tried parameters, as a part of the largest distance anywhere.
constexpr double tried_part = 0.85;

/// The domain while it is bisected. Its mesh lies over the unit square.
class DomainRefinement {
  public:
    DomainRefinement(const ComputedSurfaces& surfaces, const AdaptiveDomainOptions& options,
                     const AdaptiveDomainProgress& progress)
        : surfaces_(surfaces),
          options_(options),
          progress_(progress),
          mesh_(RootComplex(4, {{1, 2, 0}, {3, 0, 2}}), corners()) {}

    Family run() {
        std::vector<Index> untried = {0, 1};
        for (;;) {
            make_keys();
            std::vector<Index> marked;
            for (const Index triangle : untried)
                if (is_too_coarse(triangle)) marked.push_back(triangle);
            if (marked.empty()) return family();
            std::vector<Index> changed;
            mesh_.refine(marked, &changed);
            std::ranges::sort(changed);
            changed.erase(std::ranges::unique(changed).begin(), changed.end());
            untried = std::move(changed);
        }
    }

  private:
    static std::array<glm::vec3, 4> corners() {
        return {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)};
    }

    glm::dvec2 parameter(Index vertex) const {
        const glm::vec3 place = mesh_.positions()[vertex];
        const auto& [low, high] = options_.box;
        return low + glm::dvec2(place.x, place.y) * (high - low);
    }

    void make_keys() {
        if (mesh_.vertex_count() > options_.max_keys)
            throw InputError(
                fmt::format("the tolerance needs more than {} keys: expected a larger tolerance "
                            "or smaller ranges",
                            options_.max_keys));
        while (keys_.size() < mesh_.vertex_count()) {
            if (progress_) progress_(keys_.size());
            keys_.push_back(surfaces_.key(parameter(static_cast<Index>(keys_.size()))));
        }
    }

    /// Whether the blend of the triangle's keys is too far from the surface at a parameter in it.
    bool is_too_coarse(Index triangle) const {
        const auto& [a, b, c] = mesh_.vertices(triangle);
        const std::array keys = {&*keys_[a].hierarchy, &*keys_[b].hierarchy, &*keys_[c].hierarchy};
        const UnionMesh mesh = unite(keys);
        for (unsigned i = 0; i <= grid_parts; ++i)
            for (unsigned j = 0; i + j <= grid_parts; ++j) {
                const std::array<double, 3> weights = {double(i) / grid_parts, double(j) / grid_parts,
                                                       double(grid_parts - i - j) / grid_parts};
                const glm::dvec2 at =
                    weights[0] * parameter(a) + weights[1] * parameter(b) + weights[2] * parameter(c);
                const std::array blend = {float(weights[0]), float(weights[1]), float(weights[2])};
                if (surfaces_.distance(at, mesh, morph(mesh, blend)) > tried_part) return true;
            }
        return false;
    }

    Family family() {
        std::vector<DomainVertex> vertices;
        vertices.reserve(keys_.size());
        for (Index v = 0; v < keys_.size(); ++v) vertices.push_back({parameter(v), v});
        std::vector<Triangle> triangles;
        triangles.reserve(mesh_.leaf_count());
        for (const Index leaf : mesh_.preorder()) triangles.push_back(mesh_.vertices(leaf));
        Family family;
        family.name = "Adaptive domain";
        family.keys = std::move(keys_);
        family.domain.emplace(std::move(vertices), std::move(triangles));
        return family;
    }

    const ComputedSurfaces& surfaces_;
    const AdaptiveDomainOptions& options_;
    const AdaptiveDomainProgress& progress_;
    AdaptiveMesh mesh_;
    std::vector<Key> keys_;  ///< one per vertex
};

}  // namespace

Family adapt_domain(const ComputedSurfaces& surfaces, const AdaptiveDomainOptions& options,
                    const AdaptiveDomainProgress& progress) {
    return DomainRefinement(surfaces, options, progress).run();
}

}  // namespace interleaf
