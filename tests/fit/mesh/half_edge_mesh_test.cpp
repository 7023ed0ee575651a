// Collapses and their undoing: the mesh stays a simplicial sphere on the way down, and is restored exactly.
#include "fit/mesh/half_edge_mesh.h"

#include <doctest/doctest.h>

#include "fit/closed_meshes.h"
#include "fit/sphere_map/decimation.h"
#include "hierarchy/measure.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

std::vector<Triangle> triangles_of(const HalfEdgeMesh& mesh) {
    std::vector<Triangle> triangles;
    for (Index t = 0; t < mesh.triangle_capacity(); ++t)
        if (mesh.has_triangle(t))
            triangles.push_back({mesh.origin(3 * t), mesh.origin(3 * t + 1), mesh.origin(3 * t + 2)});
    return triangles;
}

/// The relations of the half-edges, derived from the triangles alone.
void check_links(const HalfEdgeMesh& mesh) {
    std::vector<Index> degree(mesh.vertex_capacity());
    for (Index t = 0; t < mesh.triangle_capacity(); ++t) {
        if (!mesh.has_triangle(t)) continue;
        for (Index h = 3 * t; h < 3 * t + 3; ++h) {
            REQUIRE(mesh.has_triangle(mesh.twin(h) / 3));
            REQUIRE(mesh.twin(mesh.twin(h)) == h);
            REQUIRE(mesh.origin(mesh.twin(h)) == mesh.target(h));
            REQUIRE(mesh.has_vertex(mesh.origin(h)));
            ++degree[mesh.origin(h)];
        }
    }
    for (Index v = 0; v < mesh.vertex_capacity(); ++v) {
        if (!mesh.has_vertex(v)) continue;
        REQUIRE(mesh.origin(mesh.outgoing(v)) == v);
        REQUIRE(mesh.has_triangle(mesh.outgoing(v) / 3));
        REQUIRE(mesh.degree(v) == degree[v]);
    }
}

std::vector<NamedMesh> small_meshes() {
    std::vector<NamedMesh> meshes = {{"sphere", icosphere(2)}, {"globe", globe(40, 3)}};
    for (std::uint32_t seed = 1; seed <= 50; ++seed)
        meshes.push_back({"random, seed " + std::to_string(seed), random_sphere(seed, 5 + seed)});
    return meshes;
}

}  // namespace

TEST_CASE("every mesh goes down to a tetrahedron and comes back, a simplicial sphere all the way") {
    for (const auto& [name, surface] : small_meshes()) {
        CAPTURE(name);
        HalfEdgeMesh mesh(static_cast<Index>(surface.positions.size()), surface.triangles);
        check_links(mesh);
        const Progress none;
        ProgressMeter meter(none);
        std::vector<Index> collapses = decimate(mesh, surface.positions, meter, 1);
        REQUIRE(collapses.size() == surface.positions.size() - 4);
        CHECK(triangles_of(mesh).size() == 4);
        for (; !collapses.empty(); collapses.pop_back()) {
            const std::vector<Triangle> triangles = triangles_of(mesh);
            REQUIRE(is_closed_manifold(triangles));
            REQUIRE(euler_number(triangles) == 2);
            check_links(mesh);
            mesh.undo_collapse(collapses.back());
        }
        check_links(mesh);
        CHECK(triangles_of(mesh) == surface.triangles);
    }
}

TEST_CASE("a vertex of 60,000 edges does not make the collapses quadratic") {
    // The direct way would take about 10^10 steps here; this takes almost none.
    const SurfaceMesh surface = double_pyramid(60000);
    HalfEdgeMesh mesh(static_cast<Index>(surface.positions.size()), surface.triangles);
    const Progress none;
    ProgressMeter meter(none);
    CHECK(decimate(mesh, surface.positions, meter, 1).size() == surface.positions.size() - 4);
    CHECK(is_closed_manifold(triangles_of(mesh)));
}

TEST_CASE("half-edge 3 t + k begins at corner k, and the half-edge on side k is opposite corner k") {
    for (const auto& [name, surface] : small_meshes()) {
        CAPTURE(name);
        const HalfEdgeMesh mesh(static_cast<Index>(surface.positions.size()), surface.triangles);
        for (Index t = 0; t < surface.triangles.size(); ++t)
            for (Index k = 0; k < 3; ++k) {
                const Triangle& corners = surface.triangles[t];
                REQUIRE(mesh.origin(3 * t + k) == corners[k]);
                REQUIRE(mesh.target(3 * t + k) == corners[(k + 1) % 3]);
                const Index on_side = HalfEdgeMesh::on_side(t, k);
                REQUIRE(on_side / 3 == t);
                REQUIRE(mesh.origin(on_side) == corners[(k + 1) % 3]);
                REQUIRE(mesh.target(on_side) == corners[(k + 2) % 3]);
            }
    }
}
