#include "sequence/series/generated_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/marking.h"

namespace interleaf::testing {

namespace {

FieldMesh flattened(const AdaptiveMesh& mesh, double time) {
    FieldMesh flat;
    for (const glm::vec3& position : mesh.positions()) flat.points.emplace_back(position);
    for (const Index leaf : mesh.preorder()) flat.triangles.push_back(mesh.vertices(leaf));
    MeshField& field = flat.point_fields.emplace_back(MeshField{"u", 1, {}});
    for (const glm::dvec3& point : flat.points) field.values.push_back(front_at(point, time));
    return flat;
}

std::array<float, 4> corner_of(const glm::dvec3& place, double value) {
    const glm::vec3 position(place);
    return {position.x, position.y, position.z, static_cast<float>(value)};
}

void insert_ascending(CornerSets& sets, std::array<std::array<float, 4>, 3> corners) {
    std::ranges::sort(corners);
    sets.insert(corners);
}

}  // namespace

Hierarchy square_roots(unsigned cells) {
    const Index row = cells + 1;
    std::vector<glm::vec3> positions;
    for (Index y = 0; y < row; ++y)
        for (Index x = 0; x < row; ++x)
            positions.emplace_back(static_cast<float>(x) / static_cast<float>(cells),
                                   static_cast<float>(y) / static_cast<float>(cells), 0);
    std::vector<Triangle> triangles;
    for (Index y = 0; y < cells; ++y)
        for (Index x = 0; x < cells; ++x) {
            const Index at = row * y + x;
            triangles.push_back({at + 1, at + row + 1, at});
            triangles.push_back({at + row, at, at + row + 1});
        }
    return unrefined(RootComplex(row * row, triangles), positions);
}

double front_at(const glm::dvec3& at, double time) {
    const double distance = glm::distance(at, {0.35 + 0.3 * time, 0.5, 0});
    return 1 / (1 + std::exp((distance - 0.25) * 30));
}

std::vector<FieldMesh> random_steps(const Hierarchy& roots, unsigned count, std::mt19937& random) {
    AdaptiveMesh mesh(roots.roots, roots.positions);
    const auto some_leaves = [&](unsigned one_of) {
        std::vector<Index> marked;
        for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf)
            if (mesh.is_leaf(leaf) && random() % one_of == 0) marked.push_back(leaf);
        return marked;
    };
    // All roots are bisected twice, so that the rule of order has something to coarsen everywhere.
    mesh.refine(some_leaves(1));
    mesh.refine(some_leaves(1));
    std::vector<FieldMesh> steps;
    for (unsigned step = 0; step < count; ++step) {
        for (int round = 0; round < 3; ++round) {
            mesh.coarsen(some_leaves(1));
            mesh.refine(some_leaves(4));
        }
        mesh.refine(some_leaves(3));
        steps.push_back(flattened(mesh, static_cast<double>(step) / count));
    }
    return steps;
}

FieldMesh disguised(const FieldMesh& mesh, const Disguise& disguise, std::mt19937& random) {
    std::vector<glm::dvec3> places = mesh.points;
    std::uniform_real_distribution<double> moved(-disguise.noise / 2, disguise.noise / 2);
    for (glm::dvec3& place : places) place += glm::dvec3(moved(random), moved(random), 0);

    std::vector<std::size_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (disguise.shuffled) std::shuffle(order.begin(), order.end(), random);

    FieldMesh result;
    result.points = places;
    result.point_fields = mesh.point_fields;
    for (const std::size_t t : order) {
        auto corners = mesh.triangles[t];
        std::rotate(corners.begin(), corners.begin() + (3 - disguise.newest) % 3, corners.end());
        if (disguise.shuffled) std::rotate(corners.begin(), corners.begin() + random() % 3, corners.end());
        if (disguise.turned_over && random() % 2 == 0)
            std::swap(corners[(disguise.newest + 1) % 3], corners[(disguise.newest + 2) % 3]);
        result.triangles.push_back(corners);
    }
    if (!disguise.doubled) return result;
    FieldMesh doubled;
    for (const MeshField& field : result.point_fields)
        doubled.point_fields.push_back({field.name, field.components, {}});
    for (auto corners : result.triangles) {
        for (Index& corner : corners) {
            for (std::size_t f = 0; f < result.point_fields.size(); ++f) {
                const std::size_t size = result.point_fields[f].components;
                const auto values = result.point_fields[f].values.begin() + static_cast<long>(size * corner);
                auto& target = doubled.point_fields[f].values;
                target.insert(target.end(), values, values + static_cast<long>(size));
            }
            doubled.points.push_back(result.points[corner]);
            corner = static_cast<Index>(doubled.points.size() - 1);
        }
        doubled.triangles.push_back(corners);
    }
    return doubled;
}

CornerSets corner_sets(const FieldMesh& mesh) {
    CornerSets sets;
    for (const auto& triangle : mesh.triangles) {
        std::array<std::array<float, 4>, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = corner_of(mesh.points[triangle[k]], mesh.point_fields[0].values[triangle[k]]);
        insert_ascending(sets, corners);
    }
    return sets;
}

CornerSets corner_sets(const Hierarchy& key) {
    CornerSets sets;
    for (const Leaf& leaf : leaves_of(key)) {
        std::array<std::array<float, 4>, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = corner_of(key.positions[leaf.vertices[k]], key.fields[0].values[leaf.vertices[k]]);
        insert_ascending(sets, corners);
    }
    return sets;
}

Series series_of(const std::vector<FieldMesh>& steps) {
    return {steps.size(), [&steps](std::size_t step) { return steps[step]; }};
}

Recovered recovered(const std::vector<FieldMesh>& steps, const SeriesOptions& options) {
    Recovered result;
    result.report = recover(series_of(steps), options,
                            [&](std::size_t, Hierarchy key) { result.keys.push_back(std::move(key)); });
    return result;
}

double shortest_edge(const std::vector<FieldMesh>& steps) {
    double shortest = std::numeric_limits<double>::max();
    for (const FieldMesh& step : steps)
        for (const auto& [a, b, c] : step.triangles)
            shortest = std::min({shortest, glm::distance(step.points[a], step.points[b]),
                                 glm::distance(step.points[b], step.points[c]),
                                 glm::distance(step.points[c], step.points[a])});
    return shortest;
}

}  // namespace interleaf::testing
