#include "hierarchy/random_families.h"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <numeric>

#include "trials.h"
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "hierarchy/marking.h"

namespace interleaf::testing {

namespace {

void shuffle(std::vector<Index>& values, Random& random) {
    for (std::size_t n = values.size(); n > 1; --n) std::swap(values[n - 1], values[random.below(n)]);
}

/// The same complex with vertices and triangles renumbered at random.
RootComplex shuffled(const RootComplex& roots, Random& random) {
    std::vector<Index> number(roots.vertex_count());
    std::iota(number.begin(), number.end(), Index{0});
    shuffle(number, random);
    std::vector<Index> order(roots.triangle_count());
    std::iota(order.begin(), order.end(), Index{0});
    shuffle(order, random);
    std::vector<Triangle> triangles;
    for (const Index t : order) {
        const Triangle& triangle = roots.triangles()[t];
        triangles.push_back({number[triangle[0]], number[triangle[1]], number[triangle[2]]});
    }
    return {roots.vertex_count(), std::move(triangles)};
}

RootComplex random_piece(Random& random) {
    const auto size = [&](unsigned from, unsigned choices) {
        return from + static_cast<unsigned>(random.below(choices));
    };
    switch (random.below(8)) {
        case 0:
            return octahedron();
        case 1:
            return RootComplex(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}});
        case 2:
            return plate(size(0, 4));
        case 3:
            return torus(size(3, 3), size(3, 3));
        case 4:
            return sheet(size(1, 4), size(1, 4));
        case 5:
            return RootComplex(3, {{0, 1, 2}});
        case 6:
            return cut_open(octahedron(), size(1, 4), random);
        default:
            return cut_open(torus(4, 3), size(1, 6), random);
    }
}

}  // namespace

std::vector<const Hierarchy*> RandomFamily::key_pointers() const {
    std::vector<const Hierarchy*> pointers;
    for (const Hierarchy& key : keys) pointers.push_back(&key);
    return pointers;
}

RootComplex compacted(const std::vector<Triangle>& triangles) {
    std::map<Index, Index> number;
    std::vector<Triangle> result = triangles;
    for (Triangle& triangle : result)
        for (Index& vertex : triangle)
            vertex = number.try_emplace(vertex, static_cast<Index>(number.size())).first->second;
    return {static_cast<Index>(number.size()), std::move(result)};
}

RootComplex cut_open(RootComplex roots, std::size_t count, Random& random) {
    for (std::size_t n = 0; n < count && roots.triangle_count() > 2; ++n) {
        std::vector<Triangle> rest(roots.triangles().begin(), roots.triangles().end());
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(random.below(rest.size())));
        try {
            roots = compacted(rest);
        } catch (const InputError&) {
            continue;  // the remaining triangles would touch at a single vertex only
        }
    }
    return roots;
}

RootComplex side_by_side(const RootComplex& a, const RootComplex& b) {
    std::vector<Triangle> triangles(a.triangles().begin(), a.triangles().end());
    for (const auto& [i, j, k] : b.triangles())
        triangles.push_back({i + a.vertex_count(), j + a.vertex_count(), k + a.vertex_count()});
    return {a.vertex_count() + b.vertex_count(), std::move(triangles)};
}

RootComplex plate(unsigned genus) {
    const int width = static_cast<int>(2 * genus) + 1;
    const auto solid = [&](int x, int y, int z) {
        const bool inside = x >= 0 && x < width && y >= 0 && y < 3 && z == 0;
        return inside && !(x % 2 == 1 && y == 1);
    };
    std::vector<Triangle> triangles;
    const auto vertex = [&](int x, int y, int z) {
        return static_cast<Index>((z * 4 + y) * (width + 1) + x);
    };
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < 3; ++y) {
            if (!solid(x, y, 0)) continue;
            for (int axis = 0; axis < 3; ++axis)
                for (const int side : {0, 1}) {
                    std::array<int, 3> beyond = {x, y, 0};
                    beyond[static_cast<std::size_t>(axis)] += side == 0 ? -1 : 1;
                    if (solid(beyond[0], beyond[1], beyond[2])) continue;
                    std::array<Index, 4> corner{};
                    for (int n = 0; n < 4; ++n) {
                        std::array<int, 3> at = {x, y, 0};
                        at[static_cast<std::size_t>(axis)] += side;
                        at[static_cast<std::size_t>((axis + 1) % 3)] += n & 1;
                        at[static_cast<std::size_t>((axis + 2) % 3)] += n >> 1;
                        corner[static_cast<std::size_t>(n)] = vertex(at[0], at[1], at[2]);
                    }
                    if (side == 0) std::swap(corner[1], corner[2]);
                    triangles.push_back({corner[0], corner[1], corner[2]});
                    triangles.push_back({corner[3], corner[2], corner[1]});
                }
        }
    return compacted(triangles);
}

RootComplex tetrahedron() {
    return {4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}};
}

RootComplex octahedron() {
    return {6, {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

RootComplex pinwheel(Index spokes) {
    std::vector<Triangle> triangles;
    for (Index n = 0; n < spokes; ++n) triangles.push_back({1 + n, 1 + (n + 1) % spokes, 0});
    return {spokes + 1, std::move(triangles)};
}

RootComplex sheet(unsigned columns, unsigned rows) {
    std::vector<Triangle> triangles;
    const auto vertex = [&](unsigned x, unsigned y) { return static_cast<Index>(y * (columns + 1) + x); };
    for (unsigned y = 0; y < rows; ++y)
        for (unsigned x = 0; x < columns; ++x) {
            triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)});
            triangles.push_back({vertex(x + 1, y + 1), vertex(x, y + 1), vertex(x + 1, y)});
        }
    return {static_cast<Index>((columns + 1) * (rows + 1)), std::move(triangles)};
}

RootComplex torus(unsigned columns, unsigned rows) {
    std::vector<Triangle> triangles;
    const auto vertex = [&](unsigned x, unsigned y) {
        return static_cast<Index>(y % rows * columns + x % columns);
    };
    for (unsigned y = 0; y < rows; ++y)
        for (unsigned x = 0; x < columns; ++x) {
            triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)});
            triangles.push_back({vertex(x + 1, y + 1), vertex(x, y + 1), vertex(x + 1, y)});
        }
    return {static_cast<Index>(columns * rows), std::move(triangles)};
}

RootComplex random_roots(Random& random) {
    RootComplex roots = random_piece(random);
    if (random.chance(0.2)) roots = side_by_side(roots, random_piece(random));
    return marked(shuffled(roots, random), Marking::random, random);
}

RootComplex marked(const RootComplex& roots, Marking marking, Random& random) {
    if (marking == Marking::longest_edge)
        return mark_longest_edges(roots, random_points(random, roots.vertex_count()));
    if (marking == Marking::compatible) return mark_compatibly(roots);
    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    for (Triangle& triangle : triangles)
        std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(random.below(3)),
                    triangle.end());
    return {roots.vertex_count(), std::move(triangles)};
}

std::vector<glm::vec3> random_points(Random& random, std::size_t count) {
    std::vector<glm::vec3> points(count);
    for (glm::vec3& point : points) point = random.point();
    return points;
}

void refine_at_random(AdaptiveMesh& mesh, Random& random, unsigned rounds, Index leaf_limit) {
    const double density = random.unit() * 0.3;
    const glm::vec3 place = random.point();
    std::vector<Index> marks;
    for (unsigned round = 0; round < rounds && mesh.leaf_count() < leaf_limit; ++round) {
        marks.clear();
        for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf) {
            const bool near = glm::distance(mesh.positions()[mesh.vertices(leaf)[0]], place) < 0.3F;
            if (random.chance(near ? 0.5 : density)) marks.push_back(leaf);
        }
        if (marks.empty()) marks.push_back(static_cast<Index>(random.below(mesh.leaf_count())));
        mesh.refine(marks);
    }
}

Hierarchy random_key(const RootComplex& roots, Random& random) {
    std::vector<glm::vec3> points = random_points(random, roots.vertex_count());
    AdaptiveMesh* self = nullptr;
    AdaptiveMesh mesh(roots, std::move(points), [&](Index a, Index b, Index) {
        const glm::vec3 p = self->positions()[a], q = self->positions()[b];
        return 0.5F * (p + q) + 0.2F * glm::distance(p, q) * random.point();
    });
    self = &mesh;
    refine_at_random(mesh, random, static_cast<unsigned>(random.below(7)),
                     60 + static_cast<Index>(random.below(60)));
    return mesh.freeze();
}

float longest_edge(const AdaptiveMesh& mesh, Index leaf) {
    const auto& [a, b, c] = mesh.vertices(leaf);
    const auto p = mesh.positions();
    return std::max({glm::distance(p[a], p[b]), glm::distance(p[b], p[c]), glm::distance(p[c], p[a])});
}

RandomFamily random_family(std::uint64_t seed, std::size_t key_count) {
    Random random(seed);
    const auto marking = static_cast<Marking>(random.below(3));
    RandomFamily family{seed, marking, marked(random_roots(random), marking, random), {}};
    for (std::size_t key = 0; key < key_count; ++key) family.keys.push_back(random_key(family.roots, random));
    return family;
}

void for_random_families(unsigned hierarchy_count, std::size_t key_count,
                         const std::function<void(const RandomFamily&)>& property) {
    // Many properties are tried on the same families: these are made once a program. They are small.
    static std::map<std::size_t, std::deque<RandomFamily>> made;
    std::deque<RandomFamily>& families = made[key_count];
    for (std::size_t n = 0; n * key_count < trials(hierarchy_count); ++n) {
        if (n == families.size()) families.push_back(random_family(20260001 + n, key_count));
        property(families[n]);
    }
}

}  // namespace interleaf::testing
