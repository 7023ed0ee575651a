#include "hierarchy/matching/root_gluing.h"

#include <algorithm>
#include <array>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

void find_what_lies_across(const RootComplex& roots, RootGluing& gluing) {
    const auto neighbors = roots.neighbors();
    gluing.across.assign(3 * neighbors.size(), no_index);
    for (Index t = 0; t < neighbors.size(); ++t)
        for (Index k = 0; k < 3; ++k) {
            const Index n = neighbors[t][k];
            if (n == no_index) continue;
            // Two triangles share at most one edge, so the neighbor refers to t once.
            const auto back = std::find(neighbors[n].begin(), neighbors[n].end(), t) - neighbors[n].begin();
            gluing.across[3 * t + k] = 3 * n + static_cast<Index>(back);
        }
}

void find_surroundings(Index vertex_count, RootGluing& gluing) {
    gluing.surroundings.assign(vertex_count, 0);
    for (const Triangle& triangle : gluing.triangles)
        for (const Index vertex : triangle) gluing.surroundings[vertex] += 2;
    for (Index side = 0; side < gluing.across.size(); ++side)
        if (gluing.across[side] == no_index)
            for (const Index k : {1U, 2U}) gluing.surroundings[gluing.apex(turned(side, k))] |= 1;
}

void find_components(RootGluing& gluing) {
    const auto count = static_cast<Index>(gluing.triangles.size());
    gluing.components.assign(count, no_index);
    gluing.order.reserve(count);
    for (Index start = 0; start < count; ++start) {
        if (gluing.components[start] != no_index) continue;
        const auto component = static_cast<Index>(gluing.begins.size());
        const auto reach = [&](Index t) {
            gluing.components[t] = component;
            gluing.order.push_back(t);
        };
        std::size_t next = gluing.order.size();
        gluing.begins.push_back(static_cast<Index>(next));
        reach(start);
        for (; next < gluing.order.size(); ++next)
            for (Index k = 0; k < 3; ++k) {
                const Index side = gluing.across[3 * gluing.order[next] + k];
                if (side != no_index && gluing.components[side / 3] == no_index) reach(side / 3);
            }
    }
    gluing.begins.push_back(count);
}

/// Mixes four numbers into one: the finalizer of SplitMix64 (Steele, Lea, Flood 2014) over each in turn.
std::uint64_t mixed(const std::array<std::uint64_t, 4>& numbers) {
    std::uint64_t result = 0;
    for (const std::uint64_t number : numbers) {
        result = (result ^ number) + 0x9e3779b97f4a7c15;
        result = (result ^ (result >> 30)) * 0xbf58476d1ce4e5b9;
        result = (result ^ (result >> 27)) * 0x94d049bb133111eb;
        result ^= result >> 31;
    }
    return result;
}

}  // namespace

RootGluing gluing_of(const RootComplex& roots) {
    if (roots.triangle_count() > no_index / 3)
        throw InputError("there are too many root triangles to be compared with others");
    RootGluing gluing;
    gluing.triangles = roots.triangles();
    find_what_lies_across(roots, gluing);
    find_surroundings(roots.vertex_count(), gluing);
    find_components(gluing);
    return gluing;
}

std::vector<std::uint64_t> signatures(const RootGluing& gluing, bool marked, unsigned radius) {
    const auto side_count = static_cast<Index>(gluing.across.size());
    std::vector<std::uint64_t> present(side_count);
    for (Index side = 0; side < side_count; ++side) {
        const auto around = [&](Index k) { return gluing.surroundings[gluing.apex(turned(side, k))]; };
        present[side] = mixed({around(0), around(1), around(2), marked ? side % 3 : 3});
    }
    std::vector<std::uint64_t> next(side_count);
    for (unsigned step = 0; step < radius; ++step) {
        for (Index side = 0; side < side_count; ++side) {
            const Index across = gluing.across[side];
            next[side] = mixed({present[side], present[turned(side, 1)], present[turned(side, 2)],
                                across == no_index ? 0 : present[across]});
        }
        present.swap(next);
    }
    return present;
}

}  // namespace interleaf
