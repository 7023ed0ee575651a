#include "shapes/shapes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/error.h"
#include "hierarchy/greedy.h"
#include "shapes/brezel.h"
#include "shapes/leaf_fit.h"

namespace interleaf {
namespace {

const auto all_shapes = std::to_array<Shape>({
    {"icosahedron", "the 20 roots alone, on the unit sphere", unit_sphere, nullptr},
    {"bone", "a bone with two knobs at each end", unit_sphere, PlainSurface(bone_surface), bone_constants,
     bone_surface},
    {"cushion", "a square cushion with four pointed corners", unit_sphere, PlainSurface(cushion_surface),
     cushion_constants, cushion_surface},
    {"star", "a star with twelve arms", unit_sphere, PlainSurface(star_surface), star_constants,
     star_surface},
    {"sphere", "the unit sphere", unit_sphere, sphere_surface},
    {"brezel", "a brezel with two holes, over 144 roots of its own", brezel, brezel_surface},
});

constexpr std::array<ShippedKey, 5> shipped_keys = {{
    {"icosahedron", {20, {}}},
    {"bone", {14000, {}}},
    {"cushion", {9000, {}}},
    {"star", {20000, {}}},
    {"sphere", {6000, {}}},
}};

constexpr Index default_leaves = 20000;
constexpr double min_tolerance = 1e-6;

/// The contribution of the normal's turn to a leaf's error, as a fraction of the leaf's size.
constexpr double turn_share = 0.02;

/// Between the samples, the distance to the surface may exceed the one at the samples by this fraction.
constexpr double sampling_margin = 0.1;

void check_budget(const ShapeBudget& budget, Index roots) {
    if (budget.leaves && budget.tolerance) {
        throw UsageError("a number of leaves and a tolerance exclude each other");
    }
    if (budget.leaves && *budget.leaves < roots) {
        throw UsageError(fmt::format("{} leaves are too few: there are {} roots", *budget.leaves, roots));
    }
    if (budget.tolerance && !(*budget.tolerance >= min_tolerance)) {
        throw UsageError(fmt::format("the tolerance must be at least {}", min_tolerance));
    }
}

/// Diagonal of the surface's box, from samples. They lie inside the box, so the result is never too large.
double box_diagonal(const Shape& shape, const Hierarchy& roots) {
    constexpr unsigned samples_per_edge = 24;
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const auto& [a, b, c] : roots.roots.triangles()) {
        for (const glm::dvec3& u :
             base_grid(shape.base, {roots.positions[a], roots.positions[b], roots.positions[c]},
                       samples_per_edge)) {
            low = glm::min(low, shape.surface(u));
            high = glm::max(high, shape.surface(u));
        }
    }
    return glm::distance(low, high);
}

}  // namespace

std::span<const Shape> shapes() {
    return all_shapes;
}

std::span<const ShippedKey> five_keys() {
    return shipped_keys;
}

const Shape* find_shape(std::string_view name) {
    const auto shape = std::find_if(all_shapes.begin(), all_shapes.end(),
                                    [&](const Shape& candidate) { return candidate.name == name; });
    return shape == all_shapes.end() ? nullptr : &*shape;
}

Shape with_constants(const Shape& shape, std::vector<double> values) {
    for (std::size_t i = 0; i < shape.constants.size(); ++i) {
        const SurfaceConstant& constant = shape.constants[i];
        if (!(values[i] >= constant.low && values[i] <= constant.high))
            throw UsageError(fmt::format("{} of {}: expected {} to {}, got {}", constant.name, shape.name,
                                         constant.low, constant.high, values[i]));
    }
    Shape changed = shape;
    changed.surface = [parametric = shape.parametric, values = std::move(values)](const glm::dvec3& u) {
        return parametric(u, values);
    };
    return changed;
}

Hierarchy make_key(const Shape& shape, const ShapeBudget& budget) {
    Hierarchy roots = shape.base.roots();
    check_budget(budget, roots.roots.triangle_count());
    if (shape.surface == nullptr) return roots;

    std::vector<glm::dvec3> base_points;
    std::vector<glm::vec3> positions;
    for (const glm::dvec3 corner : roots.positions) {
        base_points.push_back(shape.base.project(corner));
        positions.emplace_back(shape.surface(base_points.back()));
    }
    AdaptiveMesh mesh(roots.roots, std::move(positions), [&](Index a, Index b, Index) {
        base_points.push_back(shape.base.project((base_points[a] + base_points[b]) / 2.0));
        return glm::vec3(shape.surface(base_points.back()));
    });
    const auto fit = [&](Index leaf) {
        const auto& [a, b, c] = mesh.vertices(leaf);
        return measure_fit(shape.base, shape.surface, {base_points[a], base_points[b], base_points[c]});
    };
    if (budget.tolerance) {
        const double most = *budget.tolerance * box_diagonal(shape, roots) * (1 - sampling_margin);
        const auto error = [&](const AdaptiveMesh&, Index leaf) { return fit(leaf).apart; };
        refine_greedily(mesh, error, {.tolerance = most});
    } else {
        const auto error = [&](const AdaptiveMesh&, Index leaf) {
            const LeafFit measured = fit(leaf);
            return measured.distance + turn_share * measured.size * measured.turn;
        };
        refine_greedily(mesh, error, {.leaves = budget.leaves.value_or(default_leaves)});
    }
    return mesh.freeze();
}

}  // namespace interleaf
