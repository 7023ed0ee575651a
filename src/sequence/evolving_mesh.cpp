#include "sequence/evolving_mesh.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {
namespace {

std::vector<glm::vec3> in_single_precision(std::span<const glm::dvec3> positions) {
    return {positions.begin(), positions.end()};
}

}  // namespace

EvolvingMesh::EvolvingMesh(const RootComplex& roots, std::vector<glm::dvec3> positions, PlaceMidpoint place)
    : positions_(std::move(positions)),
      ends_(positions_.size(), {no_index, no_index}),
      place_(std::move(place)),
      mesh_(roots, in_single_precision(positions_), [this](Index a, Index b, Index midpoint) {
          if (midpoint == positions_.size()) {
              positions_.emplace_back();
              ends_.emplace_back();
          }
          ends_[midpoint] = {a, b};
          positions_[midpoint] = place_(a, b, midpoint);
          return glm::vec3(positions_[midpoint]);
      }) {}

std::vector<Triangle> EvolvingMesh::triangles() const {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh_.leaf_count());
    for (const Index leaf : mesh_.preorder()) triangles.push_back(mesh_.vertices(leaf));
    return triangles;
}

std::vector<Index> EvolvingMesh::leaves_to_refine(const EdgeError& error, double tolerance) const {
    std::vector<Index> marked;
    for (Index leaf = 0; leaf < mesh_.leaf_bound(); ++leaf) {
        if (!mesh_.is_leaf(leaf)) continue;
        const auto& [a, b, c] = mesh_.vertices(leaf);
        if (std::max({error(a, b), error(b, c), error(c, a)}) > tolerance) marked.push_back(leaf);
    }
    return marked;
}

std::vector<Index> EvolvingMesh::leaves_to_coarsen(const EdgeError& error, double tolerance) const {
    std::vector<Index> marked;
    for (Index leaf = 0; leaf < mesh_.leaf_bound(); ++leaf) {
        if (!mesh_.is_leaf(leaf) || mesh_.level(leaf) == 0) continue;
        // The parent has three edges: the edge that the newest vertex bisects, and the refinement edges of
        // its two children. Each child answers for its own, and coarsening needs the marks of both.
        const auto& [newest, b, c] = mesh_.vertices(leaf);
        const auto& [from, to] = ends_[newest];
        if (std::max(error(from, to), error(b, c)) <= tolerance / 2) marked.push_back(leaf);
    }
    return marked;
}

void EvolvingMesh::adapt(const EdgeError& error, double tolerance, const std::function<void()>& prepare) {
    const auto prepare_round = [&] {
        if (prepare) prepare();
    };
    prepare_round();
    for (;;) {
        const std::vector<Index> marked = leaves_to_refine(error, tolerance);
        if (marked.empty()) break;
        mesh_.refine(marked);
        if (mesh_.leaf_count() > max_leaves)
            throw InputError(fmt::format("the tolerance is too small: it needs over {} leaves", max_leaves));
        prepare_round();
    }
    for (;;) {
        const Index before = mesh_.leaf_count();
        mesh_.coarsen(leaves_to_coarsen(error, tolerance));
        if (mesh_.leaf_count() == before) break;
        prepare_round();
    }
}

Hierarchy EvolvingMesh::freeze(std::span<const Field> fields) const {
    std::vector<Leaf> leaves;
    leaves.reserve(mesh_.leaf_count());
    for (const Index leaf : mesh_.preorder())
        leaves.push_back({mesh_.vertices(leaf), static_cast<std::uint8_t>(mesh_.level(leaf))});
    return hierarchy_from_leaves(mesh_.roots(), leaves, in_single_precision(positions_), fields);
}

}  // namespace interleaf
