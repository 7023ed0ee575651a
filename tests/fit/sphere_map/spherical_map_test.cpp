// The map to the sphere: one to one, the same every time, and cancelled at once on request.
#include "fit/sphere_map/spherical_map.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "messages.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"
#include "fit/mesh/unit_box.h"
#include "fit/sphere_map/curvature_flow.h"
#include "fit/sphere_map/progressive_map.h"
#include "hierarchy/error.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

double spherical_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a, glm::cross(b - a, c - a)) / 2;
}

/// The smallest ratio of a triangle's share of the sphere to its share of the surface.
double min_share(const SurfaceMesh& mesh, std::span<const glm::dvec3> points) {
    std::vector<double> areas;
    double whole = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        areas.push_back(glm::length(glm::cross(p[b] - p[a], p[c] - p[a])) / 2);
        whole += areas.back();
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const double share = spherical_area(points[a], points[b], points[c]) / (4 * std::numbers::pi);
        least = std::min(least, share / (areas[i] / whole));
    }
    return least;
}

glm::dvec3 center_of_mass(const SurfaceMesh& mesh, std::span<const glm::dvec3> points) {
    glm::dvec3 sum(0);
    double whole = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        const double area = glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
        sum += area * (points[a] + points[b] + points[c]) / 3.0;
        whole += area;
    }
    return sum / whole;
}

}  // namespace

TEST_CASE("every closed surface of genus 0 is mapped one to one, long, thin, flat, tiny and giant ones too") {
    for (const auto& [name, mesh] : closed_meshes()) {
        CAPTURE(name);
        const SphericalMap map = map_to_sphere(mesh, {});
        CHECK(fault_of_map(mesh, map.points) == "");
        CHECK(map.method == MapMethod::progressive);
    }
}

TEST_CASE(
    "200 random simplicial spheres at random positions, which intersect themselves, are mapped one to one") {
    for (std::uint32_t seed = 1; seed <= trials(200); ++seed) {
        CAPTURE(seed);
        const SurfaceMesh mesh = random_sphere(seed, 4 + seed);
        CHECK(fault_of_map(mesh, map_to_sphere(mesh, {}).points) == "");
    }
}

TEST_CASE("thin parts keep a share of the sphere that bisection can find") {
    for (const auto& [name, mesh] : closed_meshes()) {
        if (name != "spiky sphere" && name != "rod, 40 times as long as thick" && name != "bent bone")
            continue;
        CAPTURE(name);
        CHECK(min_share(mesh, map_to_sphere(mesh, {}).points) > 1e-6);
    }
}

TEST_CASE("a sphere comes back nearly as it was: no part of it takes much more or less room") {
    const SurfaceMesh mesh = icosphere(4);
    const SphericalMap map = map_to_sphere(mesh, {});
    double least = 1e9;
    double most = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        const double ratio =
            spherical_area(map.points[a], map.points[b], map.points[c]) / spherical_area(p[a], p[b], p[c]);
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    CHECK(least > 0.8);
    CHECK(most < 1.25);
}

TEST_CASE("the same mesh gives the same bits, also moved by a power of two") {
    const SurfaceMesh mesh = moved(icosphere(4), [](const glm::dvec3& p) { return p * glm::dvec3(1, 2, 5); });
    const SphericalMap map = map_to_sphere(mesh, {});
    CHECK(map_to_sphere(mesh, {}).points == map.points);
    const SurfaceMesh larger = moved(mesh, [](const glm::dvec3& p) { return p * 1024.0; });
    CHECK(map_to_sphere(larger, {}).points == map.points);
}

TEST_CASE("the map is stopped by every call of progress, and the parts it tells do not fall") {
    const SurfaceMesh mesh = globe(40, 30);
    int calls = 0;
    double last = 0;
    map_to_sphere(mesh, [&](std::string_view stage, double part) {
        CHECK(!stage.empty());
        CHECK(part >= last);
        CHECK(part <= 1);
        last = part;
        ++calls;
        return true;
    });
    CHECK(calls > 10);
    for (int stop = 0; stop < calls; ++stop) {
        int call = 0;
        CHECK_THROWS_AS(map_to_sphere(mesh, [&](std::string_view, double) { return call++ != stop; }),
                        Cancelled);
        CHECK(call == stop + 1);
    }
}

TEST_CASE("the fallback by curvature flow maps one to one where it is used first, and is stopped as well") {
    for (const auto& [name, mesh] : closed_meshes()) {
        if (name != "bumpy sphere" && name != "bent bone") continue;
        CAPTURE(name);
        const HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
        const Progress none;
        ProgressMeter meter(none);
        const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
        CHECK(fault_of_map(mesh, map_by_curvature_flow(half_edges, positions, {}, meter)) == "");
        int calls = 0;
        const Progress stop = [&](std::string_view, double) { return ++calls < 100; };
        ProgressMeter stopping(stop);
        CHECK_THROWS_AS(map_by_curvature_flow(half_edges, positions, {}, stopping), Cancelled);
    }
}

TEST_CASE("the careful way maps one to one as well") {
    for (const auto& [name, mesh] : closed_meshes()) {
        CAPTURE(name);
        HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
        const Progress none;
        ProgressMeter meter(none);
        const ProgressiveMap map =
            map_progressively(half_edges, in_unit_box(mesh.positions), careful_options, meter);
        CHECK(map.failure == "");
        CHECK(fault_of_map(mesh, map.points) == "");
    }
}

TEST_CASE("what is no clean mesh of genus 0 is refused with the reason") {
    CHECK_THROWS_WITH_AS(map_to_sphere(torus(12, 8), {}), doctest::Contains("Euler number 0"), InputError);
    CHECK_THROWS_WITH_AS(map_to_sphere(sheet(3), {}), doctest::Contains("edge between vertices"), InputError);
    CHECK_THROWS_WITH_AS(map_to_sphere({}, {}), doctest::Contains("Euler number 0"), InputError);
    CHECK_THROWS_WITH_AS(map_to_sphere({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, {}}, {}),
                         doctest::Contains("fewer than 4"), InputError);
    CHECK_THROWS_WITH_AS(map_to_sphere(joined(icosphere(1), torus(5, 5)), {}), doctest::Contains("one piece"),
                         InputError);
    SurfaceMesh mesh = icosphere(1);
    mesh.positions[7].y = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(map_to_sphere(mesh, {}), doctest::Contains("vertex 7 is at"), InputError);
    mesh = icosphere(1);
    mesh.triangles[3][1] = 1000;
    CHECK_THROWS_WITH_AS(map_to_sphere(mesh, {}), doctest::Contains("names vertex 1000"), InputError);
    mesh = icosphere(1);
    std::swap(mesh.triangles[3][1], mesh.triangles[3][2]);
    CHECK_THROWS_WITH_AS(map_to_sphere(mesh, {}), doctest::Contains("opposite directions"), InputError);
    mesh = icosphere(1);
    mesh.positions.emplace_back(1, 2, 3);
    CHECK_THROWS_WITH_AS(map_to_sphere(mesh, {}), doctest::Contains("no triangle uses vertex 42"),
                         InputError);
    // Two tetrahedra that share a vertex, and a separate third one.
    mesh = joined(tetrahedron(), tetrahedron());
    for (Triangle& triangle : mesh.triangles)
        for (Index& vertex : triangle)
            if (vertex >= 4) vertex = vertex == 4 ? 0 : vertex - 1;
    mesh.positions.erase(mesh.positions.begin() + 4);
    CHECK_THROWS_WITH_AS(map_to_sphere(mesh, {}), doctest::Contains("touches itself at vertex 0"),
                         InputError);
}

TEST_CASE("a sound map has no fault; any one triangle turned over is found") {
    const SurfaceMesh mesh = icosphere(2);
    CHECK(fault_of_map(mesh, on_sphere(mesh)) == "");
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        SurfaceMesh turned = mesh;
        std::swap(turned.triangles[i][0], turned.triangles[i][1]);
        CHECK(contains(fault_of_map(turned, on_sphere(mesh)), "1 of 320 spherical triangles"));
    }
}

TEST_CASE("a vertex moved across an edge of its star, by however little, is found; short of it, is not") {
    const SurfaceMesh mesh = icosphere(2);
    const Triangle triangle = mesh.triangles[17];
    const glm::dvec3 on_edge = glm::normalize(mesh.positions[triangle[1]] + mesh.positions[triangle[2]]);
    const glm::dvec3 inward = mesh.positions[triangle[0]] - on_edge;
    std::vector<glm::dvec3> points = on_sphere(mesh);
    for (const double step : {1e-3, 1e-8, 1e-12, 1e-14}) {
        CAPTURE(step);
        points[triangle[0]] = glm::normalize(on_edge + step * inward);
        CHECK(fault_of_map(mesh, points) == "");
        points[triangle[0]] = glm::normalize(on_edge - step * inward);
        CHECK(contains(fault_of_map(mesh, points), "flipped"));
    }
}

TEST_CASE("a map that goes around the sphere twice has only positive triangles and is found by its degree") {
    // Doubling the longitude covers the sphere twice; the poles are the branch points.
    const SurfaceMesh mesh = globe(24, 11);
    std::vector<glm::dvec3> points = on_sphere(mesh);
    for (glm::dvec3& p : points) {
        const double radius = std::hypot(p.x, p.y);
        const double angle = 2 * std::atan2(p.y, p.x);
        p = glm::normalize(glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), p.z));
    }
    CHECK(fault_of_map(mesh, points) == "it covers the sphere 2 times");
}

TEST_CASE("points that are missing, not unit or not finite are a fault") {
    const SurfaceMesh mesh = icosphere(1);
    std::vector<glm::dvec3> points = on_sphere(mesh);
    points[5] *= 1.001;
    CHECK(contains(fault_of_map(mesh, points), "point 5 is not on the unit sphere"));
    points[5].x = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(fault_of_map(mesh, points), "point 5 is not on the unit sphere"));
    points.pop_back();
    CHECK(contains(fault_of_map(mesh, points), "41 points for 42 vertices"));
}

TEST_CASE(
    "centering brings the surface's center of mass to the sphere's center and keeps the map one to one") {
    for (const auto& [name, mesh] : closed_meshes()) {
        if (mesh.positions.size() < 100 || name.starts_with("all")) continue;
        CAPTURE(name);
        std::vector<glm::dvec3> points = map_to_sphere(mesh, {}).points;
        const SurfaceMesh scaled = {in_unit_box(mesh.positions), mesh.triangles, {}};
        const double before = glm::length(center_of_mass(scaled, points));
        center_map(mesh, points);
        CHECK(fault_of_map(mesh, points) == "");
        CHECK(glm::length(center_of_mass(scaled, points)) <= before + 1e-12);
    }
}

TEST_CASE("centering undoes a Moebius map, up to a rotation") {
    const SurfaceMesh mesh = icosphere(4);
    std::vector<glm::dvec3> points = on_sphere(mesh);
    const glm::dvec3 c = {0.3, -0.5, 0.4};
    for (glm::dvec3& p : points)
        p = glm::normalize((1 - glm::dot(c, c)) / glm::dot(p + c, p + c) * (p + c) + c);
    REQUIRE(glm::length(center_of_mass(mesh, points)) > 0.5);
    center_map(mesh, points);
    CHECK(glm::length(center_of_mass(mesh, points)) < 1e-9);
    double largest = 0;
    for (const Triangle& triangle : mesh.triangles) {
        const auto length = [&](std::span<const glm::dvec3> p) {
            return glm::distance(p[triangle[0]], p[triangle[1]]);
        };
        largest = std::max(largest, std::abs(length(points) - length(mesh.positions)));
    }
    CHECK(largest < 1e-3);
}
