#include "fit/clean_up/triangle_soup.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// The vertices of a triangle in ascending order, and whether an even permutation sorts them.
struct SortedTriangle {
    Triangle vertices;
    bool is_even;
    Index triangle;
};

SortedTriangle sorted(const Triangle& triangle, Index index) {
    auto [a, b, c] = triangle;
    bool is_even = true;
    const auto order = [&](Index& low, Index& high) {
        if (low <= high) return;
        std::swap(low, high);
        is_even = !is_even;
    };
    order(a, b);
    order(b, c);
    order(a, b);
    return {{a, b, c}, is_even, index};
}

/// Keeps the triangles whose entry in \p keep is not 0.
std::size_t erase_others(std::vector<Triangle>& triangles, std::span<const char> keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (keep[i]) triangles[kept++] = triangles[i];
    const std::size_t removed = triangles.size() - kept;
    triangles.resize(kept);
    return removed;
}

/// Of the equal triangles \p copies, the first one that looks the way that most of them do; no_index if equal
/// numbers look either way.
Index most_common(std::span<const SortedTriangle> copies) {
    const auto even =
        std::count_if(copies.begin(), copies.end(), [](const auto& copy) { return copy.is_even; });
    const auto odd = std::ptrdiff_t(copies.size()) - even;
    if (even == odd) return no_index;
    return std::find_if(copies.begin(), copies.end(),
                        [&](const auto& copy) { return copy.is_even == (even > odd); })
        ->triangle;
}

/// Patches of triangles that exist for both sides, joined along edges. Finds the patches that the surface
/// needs.
class FoldedPatches {
  public:
    /// \param folded  one triangle of each pair of triangles with opposite sides
    /// \param keep    1 for the triangles that are kept in any case
    FoldedPatches(std::span<const Triangle> triangles, std::span<const Index> folded,
                  std::span<const char> keep)
        : patch_(folded.size()), votes_(folded.size(), 0) {
        std::iota(patch_.begin(), patch_.end(), Index{0});
        std::vector<EdgeUse> uses;
        for (Index place = 0; place < folded.size(); ++place)
            add_edges(triangles[folded[place]], place, uses);
        for (Index triangle = 0; triangle < triangles.size(); ++triangle)
            if (keep[triangle]) add_edges(triangles[triangle], no_index, uses);
        std::ranges::sort(uses, {},
                          [](const EdgeUse& use) { return std::tie(use.low, use.high, use.place); });
        const auto for_each_edge = [&](auto call) {
            for (auto first = uses.begin(); first != uses.end();) {
                const auto last = std::find_if(first, uses.end(), [&](const EdgeUse& use) {
                    return use.low != first->low || use.high != first->high;
                });
                call(std::span<const EdgeUse>(first, last));
                first = last;
            }
        };
        for_each_edge([&](std::span<const EdgeUse> edge) {
            if (edge.back().place == no_index) return;
            for (const EdgeUse& use : edge) patch_[root(use.place)] = root(edge.front().place);
        });
        // Without the patch, an edge of it at which an odd number of other triangles ends would be the rim of
        // a hole.
        for_each_edge([&](std::span<const EdgeUse> edge) {
            const auto others = std::ranges::count(edge, no_index, &EdgeUse::place);
            if (std::ptrdiff_t(edge.size()) - others == 1)
                votes_[root(edge.front().place)] += others % 2 == 1 ? 1 : -1;
        });
    }

    bool closes(Index place) { return votes_[root(place)] > 0; }

  private:
    struct EdgeUse {
        Index low;
        Index high;
        Index place;  ///< in folded; no_index for another triangle, which comes last
    };

    static void add_edges(const Triangle& triangle, Index place, std::vector<EdgeUse>& uses) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            uses.push_back({low, high, place});
        }
    }

    Index root(Index place) {
        while (patch_[place] != place) place = patch_[place] = patch_[patch_[place]];
        return place;
    }

    std::vector<Index> patch_;  ///< by place, another triangle of the same patch; finally its first
    std::vector<std::ptrdiff_t> votes_;
};

/// Turns a triangle over, and updates the twins of its half-edges.
void turn(Index triangle, std::vector<Triangle>& triangles, std::vector<Index>& twin) {
    std::swap(triangles[triangle][1], triangles[triangle][2]);
    // a b, b c, c a become a c, c b, b a.
    const std::size_t first = 3 * std::size_t(triangle);
    std::swap(twin[first], twin[first + 2]);
    for (Index k = 0; k < 3; ++k) {
        const Index partner = twin[3 * triangle + k];
        if (partner != no_index) twin[partner] = 3 * triangle + k;
    }
}

}  // namespace

std::vector<Index> first_at_same_point(std::span<const glm::dvec3> positions, ProgressMeter& meter) {
    std::vector<Index> order(positions.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto key = [&](Index vertex) {
        return std::tie(positions[vertex].x, positions[vertex].y, positions[vertex].z);
    };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        meter.step(1);
        return key(a) != key(b) ? key(a) < key(b) : a < b;
    });
    std::vector<Index> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_first = i == 0 || key(order[i - 1]) != key(order[i]);
        first[order[i]] = is_first ? order[i] : first[order[i - 1]];
    }
    return first;
}

std::size_t remove_degenerate(std::vector<Triangle>& triangles) {
    return std::erase_if(triangles, [](const Triangle& triangle) {
        const auto [a, b, c] = triangle;
        return a == b || b == c || c == a;
    });
}

std::size_t remove_duplicates(std::vector<Triangle>& triangles, ProgressMeter& meter) {
    std::vector<SortedTriangle> order;
    order.reserve(triangles.size());
    for (Index i = 0; i < triangles.size(); ++i) order.push_back(sorted(triangles[i], i));
    std::sort(order.begin(), order.end(), [&](const SortedTriangle& a, const SortedTriangle& b) {
        meter.step(1);
        return std::tie(a.vertices, a.triangle) < std::tie(b.vertices, b.triangle);
    });
    std::vector<char> keep(triangles.size(), 0);
    std::vector<Index> folded;
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
        while (last < order.size() && order[last].vertices == order[first].vertices) ++last;
        const Index kept = most_common({order.data() + first, last - first});
        if (kept == no_index)
            folded.push_back(order[first].triangle);
        else
            keep[kept] = 1;
        meter.step();
    }
    if (!folded.empty()) {
        const bool is_most_folded =
            2 * std::count(keep.begin(), keep.end(), 1) < std::ptrdiff_t(triangles.size());
        FoldedPatches patches(triangles, folded, keep);
        for (Index place = 0; place < folded.size(); ++place)
            if (is_most_folded || patches.closes(place)) keep[folded[place]] = 1;
    }
    return erase_others(triangles, keep);
}

std::vector<Index> components_of(std::span<const Index> twin, ProgressMeter& meter) {
    std::vector<Index> component(twin.size() / 3, no_index);
    std::vector<Index> waiting;
    Index count = 0;
    for (Index first = 0; first < component.size(); ++first) {
        if (component[first] != no_index) continue;
        component[first] = count;
        waiting.push_back(first);
        while (!waiting.empty()) {
            const Index triangle = waiting.back();
            waiting.pop_back();
            meter.step();
            for (Index k = 0; k < 3; ++k) {
                const Index partner = twin[3 * triangle + k];
                if (partner == no_index || component[partner / 3] != no_index) continue;
                component[partner / 3] = count;
                waiting.push_back(partner / 3);
            }
        }
        ++count;
    }
    return component;
}

std::size_t make_agree(std::vector<Triangle>& triangles, std::vector<Index>& twin, ProgressMeter& meter) {
    std::size_t turned = 0;
    std::vector<char> is_settled(triangles.size());
    std::vector<Index> waiting;
    for (Index first = 0; first < triangles.size(); ++first) {
        if (!std::exchange(is_settled[first], char{1})) waiting.push_back(first);
        while (!waiting.empty()) {
            const Index triangle = waiting.back();
            waiting.pop_back();
            meter.step();
            for (Index k = 0; k < 3; ++k) {
                const Index partner = twin[3 * triangle + k];
                if (partner == no_index) continue;
                const Index other = partner / 3;
                const Index from = triangles[triangle][k];
                const bool agrees = triangles[other][partner % 3] != from;
                if (is_settled[other]) {
                    if (!agrees)
                        throw InputError(
                            fmt::format("the surface is one-sided, like a Moebius strip: no way to turn its "
                                        "triangles agrees "
                                        "at the edge between vertices {} and {}",
                                        from, triangles[triangle][(k + 1) % 3]));
                    continue;
                }
                is_settled[other] = 1;
                waiting.push_back(other);
                if (agrees) continue;
                turn(other, triangles, twin);
                ++turned;
            }
        }
    }
    return turned;
}

}  // namespace interleaf
