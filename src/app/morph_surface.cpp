#include "app/morph_surface.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace interleaf {

void MorphSurface::update(const Family& family, const Weights& weights) {
    std::vector<std::size_t> keys = active_keys(weights);
    std::vector<SharedHierarchy> hierarchies;
    for (const std::size_t key : keys) hierarchies.push_back(family.keys[key].hierarchy);
    const bool is_same = keys == figures_.keys &&
                         std::ranges::equal(hierarchies, hierarchies_,
                                            [](const auto& a, const auto& b) { return a.is_same(b); });
    if (is_same) return;

    const auto start = std::chrono::steady_clock::now();
    unite(family, weights, mesh_);
    normal_form(mesh_, form_);
    renderer_.upload(mesh_, form_, keys);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;

    hierarchies_ = std::move(hierarchies);
    figures_ = {.keys = std::move(keys),
                .leaves = mesh_.leaf_count(),
                .vertices = mesh_.vertex_count(),
                .levels = renderer_.levels(),
                .origins = {renderer_.origins().begin(), renderer_.origins().end()},
                .rebuilds = figures_.rebuilds + 1,
                .rebuild_milliseconds = taken.count()};
}

}  // namespace interleaf
