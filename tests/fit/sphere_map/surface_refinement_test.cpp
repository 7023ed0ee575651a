// Refined meshes of the same surface, and the keys that they give for bodies with few large triangles.
#include "fit/sphere_map/surface_refinement.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"
#include "fit/fit.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/checker.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

SurfaceMesh refined(const SurfaceMesh& mesh, const RefinementOptions& options = {}) {
    const Progress none;
    ProgressMeter meter(none);
    return refine(mesh, options, meter);
}

double area_of(const SurfaceMesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        area += glm::length(glm::cross(p[b] - p[a], p[c] - p[a])) / 2;
    }
    return area;
}

/// The largest distance of a vertex of one mesh from the other.
double distance(const SurfaceMesh& from, const SurfaceMesh& to) {
    const SurfaceDistance to_surface(to.triangles, to.positions);
    double largest = 0;
    Index nearest = no_index;
    for (const glm::dvec3& position : from.positions)
        largest = std::max(largest, to_surface(position, nearest));
    return largest;
}

}  // namespace

TEST_CASE("a refined mesh is the same surface: no vertex moves, new ones lie on it, its area stays") {
    for (const Cap cap : {Cap::corner_fan, Cap::center_fan, Cap::zigzag}) {
        const SurfaceMesh mesh = moved(cylinder(30, 3, cap), [](const glm::dvec3& p) {
            return glm::dvec3(p.x + 0.3 * p.z, p.y - 0.7 * p.x, p.z + 0.1 * p.y);
        });
        const SurfaceMesh fine = refined(mesh);
        CHECK(fine.triangles.size() > 3000);
        CHECK(fine.triangles.size() < 20000);
        CHECK(std::equal(mesh.positions.begin(), mesh.positions.end(), fine.positions.begin()));
        CHECK(distance(fine, mesh) < 1e-5);
        CHECK(area_of(fine) == doctest::Approx(area_of(mesh)).epsilon(1e-5));
        const HalfEdgeMesh half_edges(static_cast<Index>(fine.positions.size()),
                                      fine.triangles);  // else throws
        CHECK(half_edges.is_connected());
        CHECK(fine.positions.size() - fine.triangles.size() / 2 == 2);
    }
}

TEST_CASE("triangles of a refined mesh are well shaped on flat faces, however these were triangulated") {
    const SurfaceMesh box = cylinder(4, 1.5, Cap::corner_fan);
    CHECK(triangle_shapes(box).large == doctest::Approx(1));
    const SurfaceMesh fine = refined(box);
    CHECK(triangle_shapes(fine).large == 0);
    CHECK(triangle_shapes(fine).needles == 0);
    CHECK(triangle_shapes(cylinder(100, 4, Cap::zigzag)).needles > 0.5);
}

TEST_CASE("a refined mesh has no more triangles than are allowed, and does not fold where the surface does") {
    const SurfaceMesh mesh = cylinder(64, 20, Cap::corner_fan);
    const SurfaceMesh fine = refined(mesh, {.triangles = 1e6, .max_added = 1000});
    CHECK(fine.triangles.size() <= mesh.triangles.size() + 1002);
    const SurfaceMesh plate = moved(cylinder(4, 2, Cap::corner_fan), [](const glm::dvec3& p) {
        return p * glm::dvec3(1, 1, 1e-4);  // the sides are closer than the flatness
    });
    CHECK(area_of(refined(plate)) == doctest::Approx(area_of(plate)).epsilon(1e-4));
}

TEST_CASE("flips and splits keep the half-edges of a closed mesh as its triangles say") {
    const SurfaceMesh mesh = icosphere(1);
    HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
    for (Index step = 0; step < 300; ++step) {
        const Index half_edge = (step * 37) % (3 * half_edges.triangle_capacity());
        const Index c = half_edges.origin(HalfEdgeMesh::previous(half_edge));
        const Index d = half_edges.origin(HalfEdgeMesh::previous(half_edges.twin(half_edge)));
        if (step % 3 == 0) {
            const Index middle = half_edges.split(half_edge);
            CHECK(middle + 1 == half_edges.vertex_capacity());
        } else if (!half_edges.are_joined(c, d)) {
            half_edges.flip(half_edge);
            CHECK(half_edges.are_joined(c, d));
        }
    }
    std::vector<Triangle> triangles;
    for (Index t = 0; t < half_edges.triangle_capacity(); ++t)
        triangles.push_back(
            {half_edges.origin(3 * t), half_edges.origin(3 * t + 1), half_edges.origin(3 * t + 2)});
    const HalfEdgeMesh anew(half_edges.vertex_capacity(), triangles);
    for (Index half_edge = 0; half_edge < 3 * anew.triangle_capacity(); ++half_edge)
        CHECK(anew.twin(half_edge) == half_edges.twin(half_edge));
    for (Index vertex = 0; vertex < anew.vertex_capacity(); ++vertex) {
        CHECK(anew.degree(vertex) == half_edges.degree(vertex));
        CHECK(half_edges.origin(half_edges.outgoing(vertex)) == vertex);
    }
}

TEST_CASE(
    "cylinders of few and of many sides, flat and long, become good keys, whatever their caps are made of") {
    struct Body {
        unsigned sides;
        double height;
        Cap cap;
    };
    std::vector<Body> bodies = {{64, 2, Cap::corner_fan},    {5, 0.05, Cap::zigzag},
                                {128, 2, Cap::zigzag},       {16, 20, Cap::center_fan},
                                {64, 0.05, Cap::corner_fan}, {3, 0.5, Cap::corner_fan}};
    bodies.resize(trials(static_cast<unsigned>(bodies.size())));
    for (const auto& [sides, height, cap] : bodies) {
        CAPTURE(sides);
        CAPTURE(height);
        const FittedKey key = fit(cylinder(sides, height, cap), {});
        CHECK(check(key.hierarchy).empty());
        CHECK(key.report.mesh_triangles == key.mesh.triangles.size());
        CHECK(key.report.quality.hausdorff < 0.001);
        CHECK(key.report.quality.flipped_leaves < 10);
        CHECK(key.report.quality.min_angle > 8);
    }
}

TEST_CASE("a mesh of many well-shaped triangles is mapped as it is") {
    const SurfaceMesh mesh = moved(icosphere(4), [](const glm::dvec3& p) { return p * glm::dvec3(1, 2, 3); });
    CHECK(triangle_shapes(mesh).large == 0);
    SphericalMap map = map_to_sphere(mesh, {}, Keeps::shapes);
    center_map(mesh, map.points);
    const FittedKey mapped = fit_mapped(mesh, std::move(map.points), {});
    CHECK(fit(mesh, {}).hierarchy.positions == mapped.hierarchy.positions);
}

TEST_CASE("colors and scalars between the vertices of a refined mesh are those of the mesh") {
    SurfaceMesh mesh = cylinder(48, 2, Cap::corner_fan);
    const auto color = [](const glm::dvec3& p) {
        return glm::vec3(0.5 + 0.3 * p.x, 0.5 - 0.3 * p.y, 0.25 * p.z);
    };
    mesh.scalars = {{"x", 1, {}}};
    for (const glm::dvec3& position : mesh.positions) {
        mesh.colors.push_back(color(position));
        mesh.scalars.front().values.push_back(position.x);
    }
    const FittedKey key = fit(mesh, {});
    REQUIRE(key.hierarchy.fields.size() == 2);
    for (Index vertex = 0; vertex < key.hierarchy.vertex_count(); ++vertex) {
        const auto value = key.hierarchy.fields.front().at(vertex);
        const glm::vec3 expected = color(glm::dvec3(key.hierarchy.positions[vertex]));
        CHECK(glm::distance(glm::vec3(value[0], value[1], value[2]), expected) < 1e-4F);
        CHECK(std::abs(key.hierarchy.fields[1].values[vertex] - key.hierarchy.positions[vertex].x) < 1e-4F);
    }
}

TEST_CASE("work on a refined mesh is stopped when told to, and the parts it tells do not fall") {
    const SurfaceMesh mesh = cylinder(12, 2, Cap::corner_fan);
    int calls = 0;
    double last = 0;
    fit(mesh, {.leaves = 500}, [&](std::string_view, double part) {
        CHECK(part >= last);
        CHECK(part <= 1);
        last = part;
        ++calls;
        return true;
    });
    for (int stop = 1; stop <= calls; stop += 1 + calls / static_cast<int>(trials(4))) {
        int left = stop;
        CHECK_THROWS_AS(fit(mesh, {.leaves = 500}, [&](std::string_view, double) { return --left > 0; }),
                        Cancelled);
    }
}
