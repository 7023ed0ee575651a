// Unions whose making a test holds up, so that no test of waiting depends on how long the making takes.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "app/pictures/union_cache.h"

namespace interleaf::testing {

inline std::atomic<bool> unions_are_held = false;

/// A UnionCache::Maker that waits while unions_are_held, at most ten seconds.
inline UnionCache::Prepared union_when_released(const UnionCache::Keys& keys, UnionMesh& scratch) {
    for (int i = 0; i < 10'000 && unions_are_held; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::vector<const Hierarchy*> hierarchies;
    hierarchies.reserve(keys.hierarchies.size());
    for (const SharedHierarchy& key : keys.hierarchies) hierarchies.push_back(&*key);
    unite(hierarchies, scratch);
    set_blend(scratch, keys.blend);
    return std::make_shared<const PreparedSurface>(prepared_surface(scratch));
}

}  // namespace interleaf::testing
