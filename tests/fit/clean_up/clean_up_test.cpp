// Clean-up: it repairs, counts and reports each fault, and refuses what it cannot repair.
#include "fit/clean_up/clean_up.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/clean_up/surface_splitting.h"
#include "fit/closed_meshes.h"
#include "fit/mesh/progress_meter.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

double volume(const SurfaceMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += glm::dot(mesh.positions[a], glm::cross(mesh.positions[b], mesh.positions[c])) / 6;
    return sum;
}

/// \p mesh with its coordinates as scalars.
SurfaceMesh with_coordinates(SurfaceMesh mesh) {
    mesh.scalars = {{"x", 1, {}}, {"y", 1, {}}, {"z", 1, {}}};
    for (const glm::dvec3& position : mesh.positions)
        for (int axis = 0; axis < 3; ++axis)
            mesh.scalars[static_cast<std::size_t>(axis)].values.push_back(position[axis]);
    return mesh;
}

/// Whether the scalars of with_coordinates() still are the coordinates of all vertices.
bool has_coordinates(const SurfaceMesh& mesh) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<double>& values = mesh.scalars[static_cast<std::size_t>(axis)].values;
            if (values.size() != mesh.positions.size()) return false;
            if (std::abs(values[v] - mesh.positions[v][axis]) > 1e-12 * glm::length(mesh.positions[v]))
                return false;
        }
    return true;
}

/// Cleans up, and checks what must hold for any result.
CleanMesh cleaned(const SurfaceMesh& mesh) {
    CleanMesh clean = clean_up(with_coordinates(mesh), {});
    CHECK(has_coordinates(clean.mesh));
    CHECK(is_closed_manifold(clean.mesh.triangles));
    CHECK(euler_number(clean.mesh.triangles) == 2);
    CHECK(volume(clean.mesh) > 0);
    REQUIRE(clean.source_vertex.size() == clean.mesh.positions.size());
    CHECK(clean.mesh.colors.size() == (mesh.colors.empty() ? 0 : clean.mesh.positions.size()));
    for (std::size_t i = 0; i < clean.source_vertex.size(); ++i) {
        const Index source = clean.source_vertex[i];
        if (source != no_index) CHECK(clean.mesh.positions[i] == mesh.positions[source]);
    }
    CHECK(fault_of_map(clean.mesh, map_to_sphere(clean.mesh, {}).points) == "");
    return clean;
}

void remove_triangles_at(SurfaceMesh& mesh, Index vertex) {
    std::erase_if(mesh.triangles,
                  [&](const Triangle& t) { return std::find(t.begin(), t.end(), vertex) != t.end(); });
}

SurfaceMesh cube_at(const glm::dvec3& corner) {
    SurfaceMesh cube;
    for (int i = 0; i < 8; ++i) cube.positions.emplace_back(corner + glm::dvec3(i & 1, (i >> 1) & 1, i >> 2));
    cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return cube;
}

/// All faces of the cubes of a grid, each as two triangles. Faces inside the grid appear once.
SurfaceMesh faces_of_grid(Index count) {
    SurfaceMesh mesh;
    const Index side = count + 1;
    for (Index i = 0; i < side * side * side; ++i)
        mesh.positions.emplace_back(i % side, i / side % side, i / side / side);
    const Index steps[] = {1, side, side * side};
    for (Index i = 0; i < side * side * side; ++i) {
        const Index place[] = {i % side, i / side % side, i / side / side};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            if (place[u] == count || place[v] == count) continue;
            mesh.triangles.push_back({i, i + steps[u], i + steps[u] + steps[v]});
            mesh.triangles.push_back({i, i + steps[u] + steps[v], i + steps[v]});
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("a clean mesh comes back as it was, with nothing to say") {
    for (const auto& [name, mesh] : closed_meshes()) {
        if (name.starts_with("all")) continue;
        CAPTURE(name);
        const CleanMesh clean = clean_up(mesh, {});
        CHECK(clean.mesh.positions == mesh.positions);
        CHECK(clean.mesh.triangles == mesh.triangles);
        CHECK(clean.report.sentences().empty());
    }
}

TEST_CASE("triangles that share no vertices are welded") {
    const SurfaceMesh mesh = icosphere(2);
    SurfaceMesh soup;
    for (const Triangle& triangle : mesh.triangles) {
        const auto first = static_cast<Index>(soup.positions.size());
        for (const Index vertex : triangle) soup.positions.push_back(mesh.positions[vertex]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const CleanMesh clean = cleaned(soup);
    CHECK(clean.mesh.positions.size() == mesh.positions.size());
    CHECK(clean.mesh.triangles.size() == mesh.triangles.size());
    CHECK(clean.report.welded_vertices == soup.positions.size() - mesh.positions.size());
}

TEST_CASE("triangles turned at random, in random order, are made to agree and to look outward") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        SurfaceMesh mesh = icosphere(2);
        std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
        for (Triangle& triangle : mesh.triangles)
            if (random() % 2 == 0) std::swap(triangle[1], triangle[2]);
        const CleanMesh clean = cleaned(mesh);
        CHECK(clean.report.turned_triangles > 0);
        CHECK(volume(clean.mesh) == doctest::Approx(volume(icosphere(2))));
    }
}

TEST_CASE("a surface that looks inward is turned over") {
    SurfaceMesh mesh = icosphere(2);
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    const CleanMesh clean = cleaned(mesh);
    CHECK(clean.report.turned_outward);
    CHECK(clean.report.sentences() ==
          std::vector<std::string>{"The surface looked inward and was turned over."});
}

TEST_CASE("degenerate and duplicate triangles are removed") {
    SurfaceMesh mesh = icosphere(2);
    mesh.triangles.push_back({4, 4, 9});
    mesh.triangles.push_back(mesh.triangles[7]);
    const auto [a, b, c] = mesh.triangles[9];
    mesh.triangles.push_back({b, c, a});
    const CleanMesh clean = cleaned(mesh);
    CHECK(clean.report.degenerate_triangles == 1);
    CHECK(clean.report.duplicate_triangles == 2);
    CHECK(clean.mesh.triangles.size() == 320);
}

TEST_CASE("a mesh that has each triangle for both of its sides loses one side") {
    SurfaceMesh mesh = icosphere(2);
    for (const auto& [a, b, c] : icosphere(2).triangles) mesh.triangles.push_back({a, c, b});
    const CleanMesh clean = cleaned(mesh);
    CHECK(clean.report.duplicate_triangles == 320);
    CHECK(clean.mesh.triangles == icosphere(2).triangles);
}

TEST_CASE("a fin folded onto itself goes") {
    SurfaceMesh mesh = icosphere(2);
    const auto [a, b, c] = mesh.triangles[0];
    const auto tip = static_cast<Index>(mesh.positions.size());
    mesh.positions.emplace_back(3.0 * mesh.positions[a]);
    mesh.triangles.push_back({a, b, tip});
    mesh.triangles.push_back({b, a, tip});
    const CleanMesh clean = cleaned(mesh);
    CHECK(clean.report.duplicate_triangles == 2);
    CHECK(clean.mesh.triangles == icosphere(2).triangles);
}

TEST_CASE("triangles that are there for both sides are kept where they close the surface") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        SurfaceMesh mesh = icosphere(2);
        std::size_t doubled = 0;
        for (std::size_t i = 0; i < 320; ++i) {
            if (random() % (1 + seed) != 0) continue;
            const auto [a, b, c] = mesh.triangles[i];
            mesh.triangles.push_back({b, a, c});
            ++doubled;
        }
        if (2 * doubled >= 320) continue;
        const CleanMesh clean = cleaned(mesh);
        CHECK(clean.report.duplicate_triangles == doubled);
        CHECK(clean.mesh.triangles.size() == 320);
        CHECK(clean.report.fillings.empty());
    }
}

TEST_CASE("a wall inside that has triangles for both of its sides goes") {
    // Two cubes side by side. The square between them appears once per cube.
    SurfaceMesh mesh = joined(cube_at({0, 0, 0}), cube_at({1, 0, 0}));
    const CleanMesh clean = cleaned(mesh);
    CHECK(clean.report.duplicate_triangles == 4);
    CHECK(clean.report.dropped_parts.empty());
    CHECK(volume(clean.mesh) == doctest::Approx(2));
}

TEST_CASE("parts of the area that are lost and made are measured, and refused unless allowed") {
    const SurfaceMesh two =
        joined(icosphere(3), moved(icosphere(3), [](const glm::dvec3& p) { return 0.5 * p + 5.0; }));
    const CleanMesh parts = cleaned(two);
    REQUIRE(parts.report.dropped_parts.size() == 1);
    CHECK(parts.report.dropped_parts[0].triangles == 1280);
    CHECK(parts.report.dropped_area == doctest::Approx(0.2));
    CHECK(parts.dropped.triangles.size() == 1280);
    CHECK(parts.dropped.positions.size() == 642);
    REQUIRE(unwanted_changes(parts.report, false, true).size() == 1);
    CHECK(unwanted_changes(parts.report, false, true)[0].find("2 parts") != std::string::npos);
    CHECK(unwanted_changes(parts.report, false, true)[0].find("20 % of the area would be lost") !=
          std::string::npos);
    CHECK(unwanted_changes(parts.report, true, false).empty());

    SurfaceMesh cube = cube_at({0, 0, 0});
    cube.triangles.resize(10);
    const CleanMesh hole = cleaned(cube);
    REQUIRE(hole.report.fillings.size() == 1);
    CHECK(hole.report.fillings[0].edges == 4);
    CHECK(hole.report.made_area == doctest::Approx(0.2));
    CHECK(unwanted_changes(hole.report, true, true).empty());
    REQUIRE(unwanted_changes(hole.report, true, false).size() == 1);
    CHECK(unwanted_changes(hole.report, true, false)[0].find("would add 20 % to its area") !=
          std::string::npos);
    CHECK(unwanted_changes(cleaned(icosphere(2)).report, false, false).empty());
}

TEST_CASE("the component of the largest area is kept, not the one of most triangles") {
    const SurfaceMesh small = moved(icosphere(3), [](const glm::dvec3& p) { return 0.1 * p + 5.0; });
    const CleanMesh clean = cleaned(joined(small, icosphere(1)));
    CHECK(clean.mesh.triangles.size() == 80);
    CHECK(clean.report.dropped_parts.size() == 1);
    CHECK(clean.report.dropped_triangles() == 1280);
    CHECK(clean.source_vertex.front() == small.positions.size());
}

TEST_CASE("two balls that touch at a point come apart there") {
    const CleanMesh clean = cleaned(joined(icosphere(2), moved(icosphere(2), [&](const glm::dvec3& p) {
                                               return p + 2.0 * icosphere(0).positions[1] - glm::dvec3(0);
                                           })));
    CHECK(clean.report.dropped_parts.size() == 1);
}

TEST_CASE("two cubes that touch along an edge come apart there") {
    const CleanMesh clean = cleaned(joined(cube_at({0, 0, 0}), cube_at({1, 1, 0})));
    CHECK(clean.report.crowded_edges == 1);
    CHECK(clean.report.dropped_parts.size() == 1);
    CHECK(clean.mesh.triangles.size() == 12);
    CHECK(volume(clean.mesh) == doctest::Approx(1));
}

TEST_CASE("a surface that touches itself at a vertex gets a second vertex there") {
    SurfaceMesh mesh = icosphere(3);
    mesh.positions[20] = mesh.positions[300];
    const CleanMesh clean = cleaned(mesh);
    CHECK(clean.report.welded_vertices == 1);
    CHECK(clean.report.split_vertices == 1);
    CHECK(clean.mesh.positions.size() == mesh.positions.size());
}

TEST_CASE("of two edges between the same vertices one gets a midpoint") {
    // Two tetrahedra at one edge (0, 1). There, each is joined to the other instead of to itself.
    SurfaceMesh mesh;
    mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {2, 3, 0}, {3, 2, 1}, {0, 1, 5}, {1, 0, 4}, {5, 4, 0}, {4, 5, 1}};
    std::vector<Index> twin(24, no_index);
    const auto ends = [&](Index h) {
        return std::pair(mesh.triangles[h / 3][h % 3], mesh.triangles[h / 3][(h % 3 + 1) % 3]);
    };
    for (Index g = 0; g < 24; ++g)
        for (Index h = 0; h < 24; ++h)
            if (ends(g) == std::pair(ends(h).second, ends(h).first) &&
                (ends(g).first > 1 || ends(g).second > 1))
                twin[g] = h;
    for (const auto& [g, h] : {std::pair<Index, Index>(0, 15), {3, 12}}) {
        twin[g] = h;
        twin[h] = g;
    }
    REQUIRE(std::count(twin.begin(), twin.end(), no_index) == 0);
    REQUIRE_FALSE(is_closed_manifold(mesh.triangles));

    const Progress none;
    ProgressMeter meter(none);
    CHECK(split_double_edges(mesh, twin, meter) == 1);
    CHECK(is_closed_manifold(mesh.triangles));
    CHECK(mesh.triangles.size() == 10);
    CHECK(mesh.positions.back() == glm::dvec3(0));
    for (Index h = 0; h < twin.size(); ++h) {
        CHECK(twin[twin[h]] == h);
        CHECK(ends(twin[h]) == std::pair(ends(h).second, ends(h).first));
    }
}

TEST_CASE("holes of 3, of 6 and of 300 edges are filled, without vertices out of proportion") {
    SurfaceMesh mesh = icosphere(3);
    mesh.colors.assign(mesh.positions.size(), glm::vec3(0.25F));
    mesh.triangles.erase(mesh.triangles.begin() + 11);
    remove_triangles_at(mesh, 600);
    CleanMesh clean = cleaned(mesh);
    CHECK(clean.report.fillings.size() == 2);
    CHECK(clean.report.filling_triangles() == 1 + 6);
    CHECK(clean.source_vertex.back() == no_index);
    CHECK(glm::distance(clean.mesh.colors.back(), glm::vec3(0.25F)) < 1e-6F);

    mesh = globe(300, 40);
    remove_triangles_at(mesh, 0);
    clean = cleaned(mesh);
    CHECK(clean.report.fillings.size() == 1);
    CHECK(clean.mesh.positions.size() < mesh.positions.size() + 300);
}

TEST_CASE("random spheres with random triangles taken out and added are repaired or refused, never more") {
    int repaired = 0;
    for (unsigned seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        SurfaceMesh mesh = seed % 2 == 0 ? icosphere(1) : random_sphere(seed, 10 + seed % 40);
        const auto vertex = [&] { return static_cast<Index>(random() % mesh.positions.size()); };
        for (unsigned i = 0; i < seed % 5; ++i)
            mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(random() % mesh.triangles.size()));
        for (unsigned i = 0; i < seed % 7; ++i) mesh.triangles.push_back({vertex(), vertex(), vertex()});
        for (unsigned i = 0; i < seed % 3; ++i) mesh.positions[vertex()] = mesh.positions[vertex()];
        try {
            cleaned(mesh);
            ++repaired;
        } catch (const InputError& error) {
            CHECK(std::string(error.what()).find("map") == std::string::npos);
        }
    }
    CHECK(repaired > 200);
}

TEST_CASE("what cannot be repaired is refused with a plain reason") {
    const auto refusal = [](const SurfaceMesh& mesh) -> std::string {
        try {
            clean_up(mesh, {});
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    const auto has = [&](const SurfaceMesh& mesh, std::string_view reason) {
        const std::string text = refusal(mesh);
        CAPTURE(text);
        CHECK(text.find(reason) != std::string::npos);
    };
    has({}, "no triangles");
    has({{{0, 0, 0}}, {{0, 0, 0}}, {}}, "names some point twice");
    has({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}}, "open sheet");
    has(torus(12, 8), "like a torus");
    has(sheet(4), "open sheet");
    SurfaceMesh loose;
    for (Index t = 0; t < 20; ++t) {
        for (const glm::dvec3& corner : {glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
            loose.positions.push_back(corner + 3.0 * t);
        loose.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    has(loose, "no two of the 20 triangles share an edge");
    has(faces_of_grid(3), "all faces of a volume mesh");
    has(moved(icosphere(2),
              [](const glm::dvec3& p) { return glm::dvec3(p.x + 0.3 * p.z, p.y + 0.2 * p.z, 0); }),
        "encloses no volume");
    has(moved(icosphere(2), [](const glm::dvec3&) { return glm::dvec3(1); }), "names some point twice");

    SurfaceMesh mesh = icosphere(1);
    mesh.positions[3].z = std::numeric_limits<double>::quiet_NaN();
    has(mesh, "vertex 3 is at");
    mesh.positions[3].z = 1e39;
    has(mesh, "vertex 3 is at");
    mesh = icosphere(1);
    mesh.triangles[5][2] = 42;
    has(mesh, "triangle 5 names vertex 42, but there are 42");
    mesh = icosphere(1);
    mesh.colors.resize(3);
    has(mesh, "3 colors for 42 vertices");
    mesh.colors.clear();
    mesh.scalars = {{"u", 1, {1, 2}}};
    has(mesh, "field u has 2 values for 42 vertices");

    // A Moebius strip: a band of squares, closed with a half turn.
    SurfaceMesh strip;
    for (Index i = 0; i < 10; ++i) {
        const double angle = 0.628318 * i;
        for (const double side : {-0.3, 0.3})
            strip.positions.emplace_back((1 + side * std::cos(angle / 2)) * std::cos(angle),
                                         (1 + side * std::cos(angle / 2)) * std::sin(angle),
                                         side * std::sin(angle / 2));
    }
    for (Index i = 0; i < 10; ++i) {
        const Index a = 2 * i;
        const Index c = i < 9 ? a + 2 : 1;
        const Index d = i < 9 ? a + 3 : 0;
        strip.triangles.push_back({a, a + 1, c});
        strip.triangles.push_back({a + 1, d, c});
    }
    has(strip, "one-sided");
}

TEST_CASE("cleaning up is stopped by every call of progress") {
    const SurfaceMesh mesh = icosphere(3);
    int calls = 0;
    clean_up(mesh, [&](std::string_view, double) { return ++calls > 0; });
    CHECK(calls > 10);
    for (int stop = 0; stop < calls; ++stop) {
        int call = 0;
        CHECK_THROWS_AS(clean_up(mesh, [&](std::string_view, double) { return call++ != stop; }), Cancelled);
    }
}
