#include "fit/clean_up/edge_pairing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace interleaf {
namespace {

struct EdgeUse {
    Index low;
    Index high;
    Index half_edge;
    bool is_forward;  ///< whether it runs from the lower vertex to the higher
    auto key() const { return std::pair(low, high); }
};

std::vector<EdgeUse> sorted_uses(std::span<const Triangle> triangles, ProgressMeter& meter) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t) {
        for (Index k = 0; k < 3; ++k) {
            const Index from = triangles[t][k];
            const Index to = triangles[t][(k + 1) % 3];
            uses.push_back({std::min(from, to), std::max(from, to), 3 * t + k, from < to});
        }
        meter.step();
    }
    std::sort(uses.begin(), uses.end(), [&](const EdgeUse& a, const EdgeUse& b) {
        meter.step(1);
        return a.key() != b.key() ? a.key() < b.key() : a.half_edge < b.half_edge;
    });
    return uses;
}

/// The uses of one edge, sorted counter-clockwise around the edge, seen from its higher vertex.
void sort_by_angle(std::span<EdgeUse> uses, std::span<const glm::dvec3> positions,
                   std::span<const Triangle> triangles) {
    const glm::dvec3 low = positions[uses.front().low];
    const glm::dvec3 axis = positions[uses.front().high] - low;
    const auto direction = [&](const EdgeUse& use) {
        const Index third = triangles[use.half_edge / 3][(use.half_edge % 3 + 2) % 3];
        return glm::cross(axis,
                          positions[third] - low);  // turned by a right angle, without the axial part
    };
    const glm::dvec3 x = direction(uses.front());
    const glm::dvec3 y = glm::cross(axis, x);
    const double axis_length = glm::length(axis);
    std::vector<std::pair<double, EdgeUse>> by_angle;
    for (const EdgeUse& use : uses) {
        const glm::dvec3 d = direction(use);
        const double angle = std::atan2(glm::dot(d, y), glm::dot(d, x) * axis_length);
        by_angle.emplace_back(angle < 0 ? angle + 2 * std::numbers::pi : angle, use);
    }
    std::stable_sort(by_angle.begin(), by_angle.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < uses.size(); ++i) uses[i] = by_angle[i].second;
}

/// The inside lies counter-clockwise of a backward use and clockwise of a forward use. So the two kinds are
/// matched like brackets, around the edge.
void pair_wedges(std::span<const EdgeUse> uses, std::vector<Index>& twin) {
    std::vector<Index> open;
    for (int round = 0; round < 2; ++round) {
        for (const EdgeUse& use : uses) {
            if (twin[use.half_edge] != no_index) continue;
            if (!use.is_forward) {
                if (round == 0) open.push_back(use.half_edge);
            } else if (!open.empty()) {
                twin[use.half_edge] = open.back();
                twin[open.back()] = use.half_edge;
                open.pop_back();
            }
        }
    }
}

}  // namespace

EdgePairing pair_edges(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                       ProgressMeter& meter) {
    EdgePairing pairing{std::vector<Index>(3 * triangles.size(), no_index), 0};
    std::vector<EdgeUse> uses = sorted_uses(triangles, meter);
    for (auto first = uses.begin(); first != uses.end();) {
        auto last = first + 1;
        while (last != uses.end() && last->key() == first->key()) ++last;
        const std::span<EdgeUse> edge(first, last);
        if (edge.size() == 2) {
            pairing.twin[edge[0].half_edge] = edge[1].half_edge;
            pairing.twin[edge[1].half_edge] = edge[0].half_edge;
        } else if (edge.size() > 2) {
            ++pairing.crowded_edges;
            sort_by_angle(edge, positions, triangles);
            pair_wedges(edge, pairing.twin);
        }
        first = last;
        meter.step();
    }
    return pairing;
}

}  // namespace interleaf
