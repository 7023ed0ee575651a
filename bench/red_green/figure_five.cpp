#include "figure_five.h"

#include <cmath>
#include <numbers>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/union_mesh.h"

namespace interleaf::bench {
namespace {

constexpr Index center = 6;
constexpr float column_width = 2.15F;
constexpr float row_height = 1.95F;

/// The root triangles that each of the two keys refines.
const std::array<std::vector<Index>, 2> refined = {{{0}, {2, 5}}};

/// A hexagon of six triangles, where pairs of neighbors share their refinement edge.
Hierarchy hexagon() {
    std::vector<glm::vec3> positions;
    for (int corner = 0; corner < 6; ++corner) {
        const double angle = corner * std::numbers::pi / 3;
        positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    positions.emplace_back(0);
    std::vector<Triangle> roots;
    for (Index n = 0; n < 6; ++n) {
        const Index next = (n + 1) % 6;
        roots.push_back(n % 2 == 1 ? Triangle{n, next, center} : Triangle{next, center, n});
    }
    return unrefined(RootComplex(7, std::move(roots)), std::move(positions));
}

glm::dvec3 flat(const glm::dvec3& point) {
    return point;
}

glm::dvec3 mean(const glm::dvec3& a, const glm::dvec3& b) {
    return (a + b) / 2.0;
}

/// The bisected key with the midpoints of all edges of \p refined_roots, no two of which are neighbors.
Hierarchy bisected(const Hierarchy& roots, const std::vector<Index>& refined_roots) {
    AdaptiveMesh mesh(roots.roots, roots.positions);
    for (const Index root : refined_roots) {
        const Triangle corners = roots.roots.triangles()[root];
        mesh.refine({&root, 1});
        std::vector<Index> halves;
        for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf) {
            const Triangle& vertices = mesh.vertices(leaf);
            // A half (l, k, i) or (l, i, j) of the root (i, j, k) has one of its two other edges.
            const bool is_first = vertices[1] == corners[2] && vertices[2] == corners[0];
            const bool is_second = vertices[1] == corners[0] && vertices[2] == corners[1];
            if (mesh.level(leaf) == 1 && (is_first || is_second)) halves.push_back(leaf);
        }
        mesh.refine(halves);
    }
    return mesh.freeze();
}

void append(std::vector<PicturePiece>& all, std::vector<PicturePiece> added, int column, int row) {
    const glm::vec3 offset(column_width * static_cast<float>(column), -row_height * static_cast<float>(row),
                           0);
    for (PicturePiece& piece : added) {
        for (glm::vec3& point : piece.corners) point += offset;
        for (glm::vec3& point : piece.middles) point += offset;
        piece.centroid += offset;
        all.push_back(piece);
    }
}

void append_red_green(std::vector<PicturePiece>& all, const Hierarchy& roots) {
    RedComplex complex(roots.roots, {roots.positions.begin(), roots.positions.end()}, mean);
    std::vector<RedGreenKey> keys(2, {RedForest(complex), flat});
    for (std::size_t key = 0; key < 2; ++key) {
        for (const Index root : refined[key]) keys[key].forest.split(root);
        keys[key].forest.close();
        const int column = key == 0 ? 0 : 2;
        append(all, pieces_of(overlay({&keys[key], 1}), std::vector{1.0}), column, 0);
    }
    append(all, pieces_of(overlay(keys), std::vector{0.5, 0.5}), 1, 0);
}

void append_bisected(std::vector<PicturePiece>& all, const Hierarchy& roots) {
    const std::array keys = {bisected(roots, refined[0]), bisected(roots, refined[1])};
    const std::array<std::vector<const Hierarchy*>, 3> columns = {
        {{&keys[0]}, {&keys[0], &keys[1]}, {&keys[1]}}};
    for (int column = 0; column < 3; ++column) {
        const UnionMesh mesh = unite(columns[static_cast<std::size_t>(column)]);
        append(all, pieces_of(mesh.triangles, mesh.positions[0]), column, 1);
    }
}

}  // namespace

std::vector<PicturePiece> figure_five() {
    const Hierarchy roots = hexagon();
    std::vector<PicturePiece> pieces;
    append_red_green(pieces, roots);
    append_bisected(pieces, roots);
    return pieces;
}

}  // namespace interleaf::bench
