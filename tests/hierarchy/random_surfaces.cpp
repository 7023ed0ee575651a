#include "hierarchy/random_surfaces.h"

#include <algorithm>
#include <numeric>

#include "hierarchy/error.h"

namespace interleaf::testing {

namespace {

std::vector<Index> random_permutation(std::size_t count, Random& random) {
    std::vector<Index> values(count);
    std::iota(values.begin(), values.end(), Index{0});
    for (std::size_t n = count; n > 1; --n) std::swap(values[n - 1], values[random.below(n)]);
    return values;
}

}  // namespace

RootComplex connected_sum(const RootComplex& a, Index t, const RootComplex& b, Index u) {
    const Triangle cut = a.triangles()[t], other_cut = b.triangles()[u];
    const auto vertex = [&](Index v) {
        // The edges are glued in opposite directions, so that the orientation stays consistent.
        if (v == other_cut[0]) return cut[0];
        if (v == other_cut[1]) return cut[2];
        if (v == other_cut[2]) return cut[1];
        return v + a.vertex_count();
    };
    std::vector<Triangle> triangles;
    for (Index n = 0; n < a.triangle_count(); ++n)
        if (n != t) triangles.push_back(a.triangles()[n]);
    for (Index n = 0; n < b.triangle_count(); ++n) {
        const auto& [i, j, k] = b.triangles()[n];
        if (n != u) triangles.push_back({vertex(i), vertex(j), vertex(k)});
    }
    return compacted(triangles);
}

RootComplex flipped_at_random(RootComplex roots, std::size_t count, Random& random) {
    for (std::size_t n = 0; n < count; ++n) {
        const auto t = static_cast<Index>(random.below(roots.triangle_count()));
        const std::size_t k = random.below(3);
        const Index u = roots.neighbors()[t][k];
        if (u == no_index) continue;
        const auto& at = roots.triangles()[t];
        const Index a = at[k], b = at[(k + 1) % 3], c = at[(k + 2) % 3];
        const auto& across = roots.triangles()[u];
        const Index d =
            *std::find_if(across.begin(), across.end(), [&](Index v) { return v != b && v != c; });
        std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
        triangles[t] = {a, b, d};
        triangles[u] = {a, d, c};
        try {
            roots = RootComplex(roots.vertex_count(), std::move(triangles));
        } catch (const InputError&) {
            continue;  // a and d already share an edge
        }
    }
    return roots;
}

RootComplex random_surface(unsigned genus, bool open, Random& random) {
    RootComplex roots;
    const auto add = [&](const RootComplex& piece) {
        if (roots.triangle_count() == 0) {
            roots = piece;
        } else {
            roots = connected_sum(roots, static_cast<Index>(random.below(roots.triangle_count())), piece,
                                  static_cast<Index>(random.below(piece.triangle_count())));
        }
    };
    for (unsigned left = genus; left > 0;) {
        const unsigned part = 1 + static_cast<unsigned>(random.below(left));
        if (part == 1 && random.chance(0.5)) {
            add(torus(3 + static_cast<unsigned>(random.below(3)),
                      3 + static_cast<unsigned>(random.below(3))));
        } else {
            add(plate(part));
        }
        left -= part;
    }
    if (genus == 0 || random.chance(0.3)) add(random.chance(0.5) ? octahedron() : plate(0));
    if (random.chance(0.3)) add(RootComplex(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}));
    if (random.chance(0.6)) roots = flipped_at_random(roots, random.below(40), random);
    if (open) roots = cut_open(roots, 1 + random.below(5), random);
    return marked(renumbered(roots, random_renumbering(roots, random)), Marking::random, random);
}

Hierarchy bisected_key(const RootComplex& roots, Random& random) {
    AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
    refine_at_random(mesh, random, 1 + static_cast<unsigned>(random.below(5)),
                     2 * roots.triangle_count() + 60);
    Hierarchy key = mesh.freeze();
    for (glm::vec3& p : key.positions) p += 0.1F * random.point();
    return key;
}

RootComplex mirrored(const RootComplex& roots) {
    std::vector<Triangle> triangles;
    for (const auto& [i, j, k] : roots.triangles()) triangles.push_back({i, k, j});
    return {roots.vertex_count(), std::move(triangles)};
}

Renumbering random_renumbering(const RootComplex& roots, Random& random) {
    Renumbering renumbering;
    renumbering.vertices = random_permutation(roots.vertex_count(), random);
    renumbering.roots = random_permutation(roots.triangle_count(), random);
    return renumbering;
}

RootComplex renumbered(const RootComplex& roots, const Renumbering& renumbering) {
    const std::vector<Index>& vertex = renumbering.vertices;
    std::vector<Triangle> triangles(roots.triangle_count());
    for (Index r = 0; r < roots.triangle_count(); ++r) {
        const auto& [i, j, k] = roots.triangles()[r];
        triangles[renumbering.roots[r]] = {vertex[i], vertex[j], vertex[k]};
    }
    return {roots.vertex_count(), std::move(triangles)};
}

Hierarchy renumbered(const Hierarchy& key, const Renumbering& renumbering) {
    const auto number = [&](Index v) { return v < key.roots.vertex_count() ? renumbering.vertices[v] : v; };
    std::vector<std::vector<Leaf>> trees(key.roots.triangle_count());
    const std::vector<Leaf> leaves = leaves_of(key);
    // the covered part of the present root, in units of 2^-60: leaves lie at most 60 levels deep here
    std::uint64_t covered = 0;
    Index root = 0;
    for (const Leaf& leaf : leaves) {
        const auto& [i, j, k] = leaf.vertices;
        trees[renumbering.roots[root]].push_back({{number(i), number(j), number(k)}, leaf.level});
        covered += std::uint64_t{1} << (60 - leaf.level);
        if (covered < std::uint64_t{1} << 60) continue;
        covered = 0;
        ++root;
    }
    std::vector<Leaf> all;
    for (const std::vector<Leaf>& tree : trees) all.insert(all.end(), tree.begin(), tree.end());
    std::vector<glm::vec3> positions(key.vertex_count());
    for (Index v = 0; v < key.vertex_count(); ++v) positions[number(v)] = key.positions[v];
    return hierarchy_from_leaves(renumbered(key.roots, renumbering), all, positions);
}

}  // namespace interleaf::testing
