#include "fit/clean_up/near_welding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

struct MeshEdge {
    Index low;
    Index high;
    auto operator<=>(const MeshEdge&) const = default;
};

/// Per vertex, whether it belongs to an edge of only one triangle.
std::vector<char> find_rims(std::size_t vertex_count, std::span<const Triangle> triangles,
                            ProgressMeter& meter) {
    std::vector<MeshEdge> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            edges.push_back({low, high});
        }
    std::sort(edges.begin(), edges.end(), [&](const MeshEdge& a, const MeshEdge& b) {
        meter.step(1);
        return a < b;
    });
    std::vector<char> is_at_rim(vertex_count, 0);
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last] == edges[first]) ++last;
        if (last - first == 1) is_at_rim[edges[first].low] = is_at_rim[edges[first].high] = 1;
    }
    return is_at_rim;
}

/// Per vertex, the largest distance over which another vertex is joined to it; 0 for none.
std::vector<double> tolerances(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles) {
    glm::dvec3 least(std::numeric_limits<double>::infinity());
    glm::dvec3 most = -least;
    std::vector<double> shortest(positions.size(), std::numeric_limits<double>::infinity());
    for (const Triangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index from = triangle[k];
            const Index to = triangle[(k + 1) % 3];
            least = glm::min(least, positions[from]);
            most = glm::max(most, positions[from]);
            const double length = glm::distance(positions[from], positions[to]);
            shortest[from] = std::min(shortest[from], length);
            shortest[to] = std::min(shortest[to], length);
        }
    const double size = glm::distance(least, most);
    for (double& length : shortest) {
        length = std::min(welding_part_of_edge * length, welding_part_of_size * size);
        // Below the rounding of doubles there is nothing to join, and there would be too many cells to count.
        if (length < 1e-14 * size) length = 0;
    }
    return shortest;
}

/// The vertices whose tolerance is at most \p tolerance and more than half of it, by the cell of a grid.
class Grid {
  public:
    /// \param positions  must outlive this object
    Grid(std::span<const glm::dvec3> positions, double tolerance)
        : positions_(positions), tolerance_(tolerance) {}

    void add(Index vertex) { cells_[key(cell_of(positions_[vertex]))].push_back(vertex); }

    /// Finds the vertex nearest to \p position that is no farther than \p shortest and the vertex's own
    /// tolerance. If there is one, stores the vertex in \p nearest and its distance in \p shortest. Of
    /// equally near vertices, takes the one with the lowest index.
    void find_nearer(const glm::dvec3& position, std::span<const double> tolerance, Index& nearest,
                     double& shortest) const {
        const double reach = std::min(shortest, tolerance_);
        const glm::dvec3 low = cell_of(position - glm::dvec3(reach));
        const glm::dvec3 high = cell_of(position + glm::dvec3(reach));
        for (double x = low.x; x <= high.x; ++x)
            for (double y = low.y; y <= high.y; ++y)
                for (double z = low.z; z <= high.z; ++z) {
                    const auto cell = cells_.find(key({x, y, z}));
                    if (cell == cells_.end()) continue;
                    for (const Index vertex : cell->second) {
                        const double here = glm::distance(positions_[vertex], position);
                        if (here > tolerance[vertex] || here > shortest) continue;
                        if (here == shortest && nearest < vertex) continue;
                        shortest = here;
                        nearest = vertex;
                    }
                }
    }

  private:
    using Key = std::array<std::int64_t, 3>;

    struct Hash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t hash = 0;
            for (const std::int64_t part : key)
                hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15;
            return static_cast<std::size_t>(hash ^ hash >> 32);
        }
    };

    glm::dvec3 cell_of(const glm::dvec3& position) const {
        return glm::floor((position - positions_.front()) / (2 * tolerance_));
    }
    static Key key(const glm::dvec3& cell) {
        return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
                static_cast<std::int64_t>(cell.z)};
    }

    std::span<const glm::dvec3> positions_;
    double tolerance_;
    std::unordered_map<Key, std::vector<Index>, Hash> cells_;  ///< only looked up, so order does not matter
};

}  // namespace

std::size_t weld_nearby(std::span<const glm::dvec3> positions, std::vector<Triangle>& triangles,
                        ProgressMeter& meter) {
    const std::vector<char> is_at_rim = find_rims(positions.size(), triangles, meter);
    const std::vector<double> tolerance = tolerances(positions, triangles);
    // One grid per power of two of the tolerance: few vertices of one grid are near each other.
    std::map<int, Grid> grids;
    std::vector<Index> joined(positions.size());
    std::size_t count = 0;
    for (Index vertex = 0; vertex < positions.size(); ++vertex) {
        joined[vertex] = vertex;
        if (!is_at_rim[vertex] || !(tolerance[vertex] > 0)) continue;
        Index nearest = no_index;
        double shortest = tolerance[vertex];
        for (const auto& [level, grid] : grids) {
            grid.find_nearer(positions[vertex], tolerance, nearest, shortest);
            meter.step();
        }
        if (nearest != no_index) {
            joined[vertex] = nearest;
            ++count;
            continue;
        }
        const int level = std::ilogb(tolerance[vertex]) + 1;
        grids.try_emplace(level, positions, std::ldexp(1, level)).first->second.add(vertex);
    }
    if (count > 0)
        for (Triangle& triangle : triangles)
            for (Index& vertex : triangle) vertex = joined[vertex];
    return count;
}

}  // namespace interleaf
