// The whole way from a mesh to a key: known figures, refusals, and cancellation.
#include "fit/fit.h"

#include <cmath>
#include <string>
#include <utility>

#include "messages.h"
#include "sanitized.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"
#include "fit/star_shapes.h"
#include "hierarchy/checker.h"
#include "hierarchy/cube.h"
#include "hierarchy/error.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

template <typename Error, typename Action>
std::string error_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("star-shaped surfaces become good keys, measured and reported") {
    for (const MappedMesh& mapped : {unit_sphere_mesh(4), bumpy_ellipsoid(4)}) {
        const FittedKey key = fit_mapped(mapped.mesh, mapped.points, {.leaves = 5000});
        CHECK(check(key.hierarchy).empty());
        CHECK(key.hierarchy.leaf_count() <= 5000);
        CHECK(key.report.mesh_vertices == mapped.mesh.positions.size());
        CHECK(key.report.mean_cosine > 0.95);
        CHECK(key.report.quality.hausdorff < 0.002);
        CHECK(key.report.quality.hausdorff > key.report.at_20000_leaves.hausdorff);
        CHECK(key.report.quality.root_mean_square < key.report.quality.hausdorff);
        CHECK(key.report.quality.flipped_leaves == 0);
        CHECK(key.report.quality.euler == 2);
        CHECK(key.report.quality.min_angle > 15);
        CHECK(key.hierarchy.fields.empty());
    }
}

TEST_CASE("the distance that is measured is the true one where that is known") {
    // 12 flat roots against the sphere: the middles of the cube's squares are farthest, 1 - 1 / sqrt(3).
    const MappedMesh mapped = unit_sphere_mesh(5);
    FitOptions options{.leaves = 12};
    const FittedKey key = fit_mapped(mapped.mesh, mapped.points, options);
    const double diagonal = 2 * std::sqrt(3.0);
    CHECK(key.report.quality.hausdorff == doctest::Approx((1 - 1 / std::sqrt(3.0)) / diagonal).epsilon(0.01));
}

TEST_CASE("any mesh without handles that the map takes gets a key, from the file's triangles on") {
    SurfaceMesh mesh = bumpy_ellipsoid(3).mesh;
    mesh.triangles.erase(mesh.triangles.begin() + 100);  // a hole
    const FittedKey key = fit(mesh, {.leaves = 4000});
    CHECK(check(key.hierarchy).empty());
    CHECK(key.report.clean_up.fillings.size() == 1);
    CHECK(key.report.quality.hausdorff < 0.005);
    CHECK(key.report.times.size() >= 5);
}

// Smoothing two keys of needles takes too long under the sanitizers, which see the same code in other tests.
TEST_CASE(
    "a long prism gets the key of its own mesh where the approximation of its surface gives thin needles" *
    doctest::skip(is_sanitized)) {
    const FittedKey key = fit(cylinder(4, 100, Cap::corner_fan), {});
    CHECK(key.fine_mesh.triangles.empty());
    CHECK(key.report.quality.min_angle > 0.3);
    CHECK(key.report.quality.hausdorff < 0.0002);
}

// Their own meshes give keys that are nearer, but with leaves below one degree.
TEST_CASE("a flat prism of many sides gets the key of its refined mesh, without needles") {
    for (const auto& [sides, height] :
         {std::pair{48U, 0.75}, std::pair{100U, 0.2}, std::pair{32U, 1.0}, std::pair{300U, 0.1}}) {
        CAPTURE(sides);
        const FittedKey key = fit(cylinder(sides, height, Cap::every_other), {});
        CHECK(key.report.quality.min_angle > 18);
        CHECK(key.report.quality.hausdorff < 0.001);
        CHECK(key.report.quality.flipped_leaves == 0);
        if (is_sanitized) break;
    }
}

TEST_CASE(
    "parts and holes beyond a little are fitted only when that is wanted, and the report says how far off") {
    const SurfaceMesh body = bumpy_ellipsoid(3).mesh;
    const SurfaceMesh two =
        joined(body, moved(icosphere(2), [](const glm::dvec3& p) { return 0.5 * p + glm::dvec3(3, 0, 0); }));
    const FitOptions options{.leaves = 2000};
    CHECK(error_of<InputError>([&] { fit(two, options); }).find("--keep-largest") != std::string::npos);
    FitOptions kept = options;
    kept.keep_largest = true;
    const FittedKey key = fit(two, kept);
    CHECK(key.report.clean_up.dropped_parts.size() == 1);
    CHECK(key.report.quality.hausdorff < 0.01);
    // The dropped ball reaches to 3.5, the body to about 1.
    CHECK(key.report.hausdorff_as_brought > 0.3);

    SurfaceMesh open = body;
    std::erase_if(open.triangles, [&](const Triangle& t) {
        return body.positions[t[0]].y + body.positions[t[1]].y + body.positions[t[2]].y > 1.2;
    });
    const std::string refusal = error_of<InputError>([&] { fit(open, options); });
    CHECK(refusal.find("--fill-holes") != std::string::npos);
    FitOptions filled = options;
    filled.fill_holes = true;
    const FittedKey closed = fit(open, filled);
    CHECK(closed.report.clean_up.made_area > 0.05);
    CHECK(closed.report.hausdorff_as_brought > 2 * closed.report.quality.hausdorff);

    const FittedKey whole = fit(body, options);
    CHECK(whole.report.hausdorff_as_brought == whole.report.quality.hausdorff);
}

TEST_CASE("a tolerance is kept, by the measure of the report") {
    const MappedMesh mapped = bumpy_ellipsoid(4);
    for (const double tolerance : {0.02, 0.002, 0.0005}) {
        const FittedKey key = fit_mapped(mapped.mesh, mapped.points, {.tolerance = tolerance});
        CHECK(key.report.quality.hausdorff <= tolerance);
    }
}

TEST_CASE("the rotation asked for moves the vertices over the surface, not the surface") {
    const MappedMesh mapped = bumpy_ellipsoid(3);
    const FittedKey plain = fit_mapped(mapped.mesh, mapped.points, {.leaves = 2000});
    FitOptions options{.leaves = 2000};
    options.rotation = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1);  // x to y: a quarter turn about z
    const FittedKey turned = fit_mapped(mapped.mesh, mapped.points, options);
    CHECK(turned.report.quality.hausdorff < 0.005);
    // The part of the surface at root vertex v is now at the root vertex to which the turn takes v.
    const SphereRoots roots = project_to_sphere(cube());
    for (std::size_t v = 0; v < 8; ++v)
        for (std::size_t w = 0; w < 8; ++w)
            if (glm::distance(options.rotation * roots.points[v], roots.points[w]) < 1e-6)
                CHECK(glm::distance(plain.hierarchy.positions[v], turned.hierarchy.positions[w]) < 1e-4F);
}

TEST_CASE("colors of the mesh arrive at the key's vertices") {
    MappedMesh mapped = unit_sphere_mesh(5);
    for (const glm::dvec3& point : mapped.points) mapped.mesh.colors.emplace_back(0.5 * point + 0.5);
    const FittedKey key = fit_mapped(mapped.mesh, mapped.points, {.leaves = 3000});
    REQUIRE(key.hierarchy.fields.size() == 1);
    const Field& field = key.hierarchy.fields.front();
    CHECK(field.label() == FieldName{"color", FieldKind::color});
    REQUIRE(field.values.size() == 3 * key.hierarchy.vertex_count());
    for (Index v = 0; v < key.hierarchy.vertex_count(); ++v) {
        const auto color = field.at(v);
        const glm::vec3 expected = 0.5F * key.hierarchy.positions[v] + 0.5F;
        CHECK(glm::distance(glm::vec3(color[0], color[1], color[2]), expected) < 1e-5F);
    }
}

TEST_CASE("scalars of the mesh arrive at the key's vertices, behind a color") {
    MappedMesh mapped = unit_sphere_mesh(4);
    mapped.mesh.scalars = {{"height", 1, {}}, {"color", 1, {}}};
    for (const glm::dvec3& point : mapped.points) {
        mapped.mesh.colors.emplace_back(0.5F);
        mapped.mesh.scalars[0].values.push_back(2 * point.z + 300);
        mapped.mesh.scalars[1].values.push_back(0);
    }
    const FittedKey key = fit_mapped(mapped.mesh, mapped.points, {.leaves = 1000});
    REQUIRE(key.hierarchy.fields.size() == 2);  // one name, one field: the scalar "color" is left out
    CHECK(key.hierarchy.fields[0].label() == FieldName{"color", FieldKind::color});
    CHECK(key.hierarchy.fields[1].label() == FieldName{"height", FieldKind::scalar});
    for (Index v = 0; v < key.hierarchy.vertex_count(); ++v)
        CHECK(std::abs(key.hierarchy.fields[1].values[v] - (2 * key.hierarchy.positions[v].z + 300)) < 1e-4F);
}

TEST_CASE("what is not good enough is refused, with figures") {
    const MappedMesh mapped = bumpy_ellipsoid(4);
    FitOptions strict;
    strict.limits = {.hausdorff = 1e-6};
    CHECK(contains(error_of<InputError>([&] { fit_mapped(mapped.mesh, mapped.points, strict); }),
                   "no good key: "));
    CHECK(contains(fault_of_fit({.hausdorff = 0.006, .euler = 2}, 20000), "0.6 % of the box diagonal"));
    CHECK(contains(fault_of_fit({.hausdorff = 0.001, .flipped_leaves = 101, .euler = 2}, 20000),
                   "turned over"));
    CHECK(contains(fault_of_fit({.hausdorff = 0.001, .euler = 0}, 20000), "Euler number 0"));
    CHECK(fault_of_fit({.hausdorff = 0.004, .flipped_leaves = 99, .euler = 2}, 20000).empty());
    CHECK_FALSE(fault_of_fit({.hausdorff = std::nan(""), .euler = 2}, 20000).empty());
}

TEST_CASE("leaves that are turned over are counted") {
    const MappedMesh mapped = unit_sphere_mesh(3);
    const MappedSurface located(mapped.mesh, mapped.points);
    SampledSurface surface = sample_surface(located, project_to_sphere(cube()), {.leaves = 500}, {});
    CHECK(measure_quality(located, surface, {}).flipped_leaves == 0);
    for (Leaf& leaf : surface.leaves) std::swap(leaf.vertices[1], leaf.vertices[2]);
    CHECK(measure_quality(located, surface, {}).flipped_leaves == surface.leaves.size());
}

TEST_CASE("options out of range, and both a number of leaves and a tolerance, are refused") {
    const MappedMesh mapped = unit_sphere_mesh(1);
    const auto fault = [&](const FitOptions& options) {
        return error_of<UsageError>([&] { fit_mapped(mapped.mesh, mapped.points, options); });
    };
    CHECK(contains(fault({.leaves = 100, .tolerance = 0.1}), "exclude each other"));
    CHECK(contains(fault({.leaves = 11}), "12 roots"));
    CHECK(contains(fault({.tolerance = 1e-9}), "at least"));
    CHECK(contains(fault({.tolerance = std::nan("")}), "at least"));
}

TEST_CASE("it ends at whatever call of progress says so, and says how far it is") {
    const SurfaceMesh mesh = bumpy_ellipsoid(2).mesh;
    // While measuring waits for another thread, calls come with time. So only the others are counted.
    const std::string_view measuring = "measuring";
    int calls = 0;
    double last = 0;
    fit(mesh, {.leaves = 500}, [&](std::string_view stage, double part) {
        if (stage != measuring) ++calls;
        CHECK_FALSE(stage.empty());
        CHECK(part >= last);
        CHECK(part <= 1);
        last = part;
        return true;
    });
    REQUIRE(calls > 20);
    // Cancels at every one of the first calls, then more sparsely.
    const auto first = static_cast<int>(trials(8));
    for (int stop = 1; stop <= calls; stop += stop < first ? 1 : 1 + calls / first) {
        int left = stop;
        CHECK_THROWS_AS(fit(mesh, {.leaves = 500},
                            [&](std::string_view stage, double) { return stage == measuring || --left > 0; }),
                        Cancelled);
        CHECK(left == 0);
    }
    int after = 0;
    CHECK_THROWS_AS(fit(mesh, {.leaves = 500},
                        [&](std::string_view stage, double) { return stage != measuring || ++after == 0; }),
                    Cancelled);
    CHECK(after == 1);
}
