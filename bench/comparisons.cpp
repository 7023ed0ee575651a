// Compares hierarchies over common roots with three other ways to keep adaptive meshes that change, which the paper
// mentions (docs/comparisons.md). Prints one line of JSON.
//
// - Non-conforming grids (Rheinboldt and Mesztenyi 1980): only the triangles that need it are bisected. A vertex inside
//   an edge of a leaf is constrained to that edge.
// - Two connectivities per key (Polthier and Rumpf 1994): each interval between two keys has a mesh that both have, so
//   each inner key is kept twice.
// - Progressive meshes (Hoppe 1996): a coarse mesh and a sequence of vertex splits.
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "json_line.h"
#include "keys.h"
#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/sphere_map/decimation.h"
#include "hierarchy/union_mesh.h"
#include "shapes/icosahedron.h"
#include "shapes/shapes.h"

namespace {

using namespace interleaf;
using Json = nlohmann::ordered_json;

// ---- non-conforming grids ----

/// The points of the unit sphere that bisection of the icosahedron makes, shared by all forests over it.
class SpherePoints {
  public:
    SpherePoints() {
        const Hierarchy roots = icosahedron();
        roots_.assign(roots.roots.triangles().begin(), roots.roots.triangles().end());
        for (const glm::vec3& point : roots.positions) points_.push_back(glm::normalize(glm::dvec3(point)));
    }

    const std::vector<Triangle>& roots() const { return roots_; }
    glm::dvec3 point(Index vertex) const { return points_[vertex]; }

    Index midpoint(Index a, Index b) {
        const auto [entry, is_new] =
            middles_.try_emplace(std::minmax(a, b), static_cast<Index>(points_.size()));
        if (is_new) points_.push_back(glm::normalize(points_[a] + points_[b]));
        return entry->second;
    }

    /// The middle of an edge, if it has been made; else no_index.
    Index known_midpoint(Index a, Index b) const {
        const auto found = middles_.find(std::minmax(a, b));
        return found == middles_.end() ? no_index : found->second;
    }

    std::array<Triangle, 2> halves(const Triangle& node) {
        const Index middle = midpoint(node[1], node[2]);
        return {{{middle, node[2], node[0]}, {middle, node[0], node[1]}}};
    }

  private:
    std::vector<Triangle> roots_;
    std::vector<glm::dvec3> points_;
    std::map<std::pair<Index, Index>, Index> middles_;
};

/// A forest: the nodes that are bisected.
using Forest = std::set<Triangle>;

std::vector<Triangle> leaves_of(const Forest& forest, SpherePoints& points) {
    std::vector<Triangle> open = points.roots();
    std::vector<Triangle> leaves;
    while (!open.empty()) {
        const Triangle node = open.back();
        open.pop_back();
        if (!forest.contains(node)) {
            leaves.push_back(node);
            continue;
        }
        for (const Triangle& half : points.halves(node)) open.push_back(half);
    }
    return leaves;
}

std::set<Index> vertices_of(const std::vector<Triangle>& leaves) {
    std::set<Index> vertices;
    for (const Triangle& leaf : leaves) vertices.insert(leaf.begin(), leaf.end());
    return vertices;
}

/// The distance of the middle of the refinement edge, and of the center, from their places on the surface.
double error_of(const Triangle& node, const Surface& surface, const SpherePoints& points) {
    const std::array<glm::dvec3, 3> at = {points.point(node[0]), points.point(node[1]),
                                          points.point(node[2])};
    const std::array<glm::dvec3, 3> on = {surface(at[0]), surface(at[1]), surface(at[2])};
    const glm::dvec3 middle = surface(glm::normalize(at[1] + at[2]));
    const glm::dvec3 center = surface(glm::normalize(at[0] + at[1] + at[2]));
    return std::max(glm::distance(middle, (on[1] + on[2]) / 2.0),
                    glm::distance(center, (on[0] + on[1] + on[2]) / 3.0));
}

/// Bisects only the nodes whose error exceeds \p tolerance.
Forest forest_within(double tolerance, const Surface& surface, SpherePoints& points) {
    Forest forest;
    std::vector<Triangle> open = points.roots();
    while (!open.empty()) {
        const Triangle node = open.back();
        open.pop_back();
        if (error_of(node, surface, points) <= tolerance) continue;
        forest.insert(node);
        for (const Triangle& half : points.halves(node)) open.push_back(half);
    }
    return forest;
}

/// Calls \p visit(vertex, a, b) for each vertex of \p used inside the edge a b of a leaf, with the ends of the edge
/// that it halves.
template <typename Visit>
void for_constrained(const std::vector<Triangle>& leaves, const std::set<Index>& used,
                     const SpherePoints& points, Visit visit) {
    for (const Triangle& leaf : leaves)
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<std::pair<Index, Index>> open = {{leaf[k], leaf[(k + 1) % 3]}};
            while (!open.empty()) {
                const auto [a, b] = open.back();
                open.pop_back();
                const Index middle = points.known_midpoint(a, b);
                if (middle == no_index || !used.contains(middle)) continue;
                visit(middle, leaf[k], leaf[(k + 1) % 3]);
                open.push_back({a, middle});
                open.push_back({middle, b});
            }
        }
}

std::set<Index> constrained_of(const Forest& forest, SpherePoints& points) {
    const std::vector<Triangle> leaves = leaves_of(forest, points);
    std::set<Index> constrained;
    for_constrained(leaves, vertices_of(leaves), points,
                    [&](Index vertex, Index, Index) { constrained.insert(vertex); });
    return constrained;
}

/// The smallest conforming forest that contains \p forest: leaves with a constrained vertex are bisected.
Forest closed(Forest forest, SpherePoints& points) {
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        const std::vector<Triangle> leaves = leaves_of(forest, points);
        const std::set<Index> used = vertices_of(leaves);
        for (const Triangle& leaf : leaves)
            for (std::size_t k = 0; k < 3; ++k) {
                const Index middle = points.known_midpoint(leaf[k], leaf[(k + 1) % 3]);
                if (middle != no_index && used.contains(middle)) is_changed |= forest.insert(leaf).second;
            }
    }
    return forest;
}

/// The largest distance by which a constrained vertex is off its place on the surface, in tolerances.
double largest_shift(const Forest& forest, double tolerance, const Surface& surface, SpherePoints& points) {
    const std::vector<Triangle> leaves = leaves_of(forest, points);
    double largest = 0;
    for_constrained(leaves, vertices_of(leaves), points, [&](Index vertex, Index a, Index b) {
        const glm::dvec3 from = surface(points.point(a));
        const glm::dvec3 along = surface(points.point(b)) - from;
        const glm::dvec3 place = surface(points.point(vertex));
        const double part = std::clamp(glm::dot(place - from, along) / glm::dot(along, along), 0.0, 1.0);
        largest = std::max(largest, glm::distance(place, from + part * along));
    });
    return largest / tolerance;
}

Json compare_non_conforming() {
    constexpr double tolerance = 0.002;  // of shapes that are about 2 wide
    SpherePoints points;
    std::vector<Forest> forests;
    Json keys = Json::array();
    for (const char* name : {"star", "cushion"}) {
        const Surface surface = find_shape(name)->surface;
        const Forest forest = forest_within(tolerance, surface, points);
        const Forest conforming = closed(forest, points);
        const std::vector<Triangle> leaves = leaves_of(forest, points);
        keys.push_back({{"key", name},
                        {"leaves", leaves.size()},
                        {"vertices", vertices_of(leaves).size()},
                        {"constrained_vertices", constrained_of(forest, points).size()},
                        {"largest_shift_in_tolerances", largest_shift(forest, tolerance, surface, points)},
                        {"conforming_leaves", leaves_of(conforming, points).size()}});
        forests.push_back(forest);
    }
    Forest both = forests[0];
    both.insert(forests[1].begin(), forests[1].end());
    Forest closed_both = closed(forests[0], points);
    const Forest closed_second = closed(forests[1], points);
    closed_both.insert(closed_second.begin(), closed_second.end());
    const std::set<Index> constrained = constrained_of(both, points);
    std::size_t released = 0;
    for (const Forest& forest : forests)
        for (const Index vertex : constrained_of(forest, points))
            released += constrained.contains(vertex) ? 0 : 1;
    return {{"tolerance", tolerance},
            {"keys", keys},
            {"union",
             {{"leaves", leaves_of(both, points).size()},
              {"constrained_vertices", constrained.size()},
              {"constrained_in_a_key_alone", released},
              {"conforming_leaves", leaves_of(closed_both, points).size()},
              {"constrained_in_the_conforming_union", constrained_of(closed_both, points).size()}}}};
}

// ---- two connectivities per key ----

std::size_t mesh_bytes(const UnionMesh& mesh) {
    return mesh.leaf_count() * sizeof(Triangle) + 2 * mesh.vertex_count() * sizeof(glm::vec3);
}

/// A refined spot that moves over the sphere, one key per place.
Json compare_two_connectivities() {
    constexpr Index leaves = 20000;
    constexpr std::size_t count = 12;
    constexpr int runs = 5;
    std::vector<Hierarchy> keys;
    for (std::size_t place = 0; place < count; ++place) keys.push_back(bench::local_key(leaves, place));
    std::size_t key_bytes = 0;
    std::size_t key_leaves = 0;
    for (const Hierarchy& key : keys) {
        key_bytes += key.byte_count();
        key_leaves += key.leaf_count();
    }
    std::vector<UnionMesh> intervals;
    std::size_t interval_bytes = 0;
    for (std::size_t n = 0; n + 1 < count; ++n) {
        intervals.push_back(unite(std::array<const Hierarchy*, 2>{&keys[n], &keys[n + 1]}));
        interval_bytes += mesh_bytes(intervals.back());
    }
    constexpr std::size_t edited = count / 2;
    const auto remade = [&](std::size_t first) {
        return bench::min_seconds_of(runs, [&] {
            unite(std::array<const Hierarchy*, 2>{&keys[first], &keys[first + 1]});
        });
    };
    return {{"keys", count},
            {"leaves", key_leaves},
            {"hierarchy_bytes", key_bytes},
            {"interval_bytes", interval_bytes},
            {"bytes_written_by_an_edit", keys[edited].byte_count()},
            {"interval_bytes_written_by_an_edit",
             mesh_bytes(intervals[edited - 1]) + mesh_bytes(intervals[edited])},
            {"milliseconds_to_unite_one_interval", 1e3 * remade(edited)},
            {"milliseconds_to_unite_both", 1e3 * (remade(edited - 1) + remade(edited))}};
}

// ---- progressive meshes ----

/// What a vertex split of a progressive mesh depends on: the new vertex, the vertex that it leaves, and the two
/// neighbors that both have.
using Split = std::tuple<Index, Index, Index, Index>;

struct ProgressiveMesh {
    std::size_t triangles = 0;
    std::set<Split> splits;
};

/// The progressive mesh of a closed mesh, down to a tetrahedron.
/// \param number  of the vertices, the same in all meshes for one point of the roots
ProgressiveMesh progressive_mesh(const std::vector<Triangle>& triangles, std::span<const glm::vec3> positions,
                                 std::span<const Index> number) {
    const std::vector<glm::dvec3> places(positions.begin(), positions.end());
    HalfEdgeMesh mesh(static_cast<Index>(positions.size()), triangles);
    const Progress no_progress;
    ProgressMeter meter(no_progress);
    const std::vector<Index> collapses = decimate(mesh, places, meter, 1);
    ProgressiveMesh made{triangles.size(), {}};
    for (std::size_t n = collapses.size(); n-- > 0;) {
        const Index edge = collapses[n];
        mesh.undo_collapse(edge);
        const Index left = mesh.target(HalfEdgeMesh::next(edge));
        const Index right = mesh.target(HalfEdgeMesh::next(mesh.twin(edge)));
        const auto [low, high] = std::minmax(number[left], number[right]);
        made.splits.insert({number[mesh.origin(edge)], number[mesh.target(edge)], low, high});
    }
    return made;
}

Json compare_progressive() {
    constexpr Index leaves = 20000;
    // Of a split: the vertex, two neighbors by their places around it, and two positions.
    constexpr std::size_t split_bytes = sizeof(Index) + 2 + 2 * sizeof(glm::vec3);
    const std::array keys = {bench::random_key(leaves, 1), bench::random_key(leaves, 2)};
    const UnionMesh both = unite(std::array<const Hierarchy*, 2>{&keys[0], &keys[1]});
    // The vertices of a key by their numbers in the union, which contains the leaves of each key.
    std::vector<ProgressiveMesh> meshes;
    std::size_t shared_nodes = 0;
    std::size_t nodes = 0;
    Json rows = Json::array();
    for (const Hierarchy& key : keys) {
        const UnionMesh with_union = unite(std::array<const Hierarchy*, 1>{&key});
        std::map<std::tuple<float, float, float>, Index> place_number;
        for (std::size_t v = 0; v < both.vertex_count(); ++v) {
            const glm::vec3& p = both.positions[&key == &keys[0] ? 0 : 1][v];
            place_number.emplace(std::tuple(p.x, p.y, p.z), static_cast<Index>(v));
        }
        std::vector<Index> number;
        number.reserve(with_union.vertex_count());
        for (const glm::vec3& p : with_union.positions[0])
            number.push_back(place_number.at(std::tuple(p.x, p.y, p.z)));
        meshes.push_back(progressive_mesh({with_union.triangles.begin(), with_union.triangles.end()},
                                          with_union.positions[0], number));
        const std::size_t bytes = meshes.back().splits.size() * split_bytes;
        rows.push_back({{"triangles", meshes.back().triangles},
                        {"splits", meshes.back().splits.size()},
                        {"progressive_bytes_per_triangle",
                         static_cast<double>(bytes) / static_cast<double>(meshes.back().triangles)},
                        {"hierarchy_bytes_per_triangle",
                         static_cast<double>(key.byte_count()) / static_cast<double>(key.leaf_count())}});
        nodes += key.leaf_count() - key.roots.triangle_count();
    }
    shared_nodes = nodes - (both.leaf_count() - keys[0].roots.triangle_count());
    std::size_t shared_splits = 0;
    for (const Split& split : meshes[0].splits) shared_splits += meshes[1].splits.contains(split) ? 1 : 0;
    return {{"keys", rows},
            {"splits_in_both", shared_splits},
            {"bisections_in_both", shared_nodes},
            {"union_leaves", both.leaf_count()}};
}

}  // namespace

int main() {
    bench::print_line({{"non_conforming_grids", compare_non_conforming()},
                       {"two_connectivities", compare_two_connectivities()},
                       {"progressive_meshes", compare_progressive()}});
}
