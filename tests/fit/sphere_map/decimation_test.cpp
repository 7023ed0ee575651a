// Decimation: plates keep their extent. That collapses can be undone is tested with the half-edge mesh.
#include "fit/sphere_map/decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/fit.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"

using namespace interleaf;

namespace {

/// A closed plate over the unit square, divided into squares, whose two sides meet at the rim.
SurfaceMesh plate(unsigned squares, double thickness) {
    SurfaceMesh mesh;
    std::vector<std::array<Index, 2>> vertices;  // of the lower and the upper side
    for (unsigned i = 0; i <= squares; ++i) {
        for (unsigned j = 0; j <= squares; ++j) {
            const bool is_rim = i == 0 || j == 0 || i == squares || j == squares;
            const glm::dvec3 place(double(i) / squares, double(j) / squares, 0);
            const glm::dvec3 up(0, 0, is_rim ? 0 : thickness / 2);
            const auto lower = static_cast<Index>(mesh.positions.size());
            mesh.positions.push_back(place - up);
            if (!is_rim) mesh.positions.push_back(place + up);
            vertices.push_back({lower, is_rim ? lower : lower + 1});
        }
    }
    for (unsigned i = 0; i < squares; ++i) {
        for (unsigned j = 0; j < squares; ++j) {
            const unsigned at = i * (squares + 1) + j;
            std::array<unsigned, 4> corners{at, at + squares + 1, at + squares + 2, at + 1};
            // A diagonal that cut off a corner of the plate would make a triangle of the rim alone, on both sides.
            if (i + j + 1 == squares && (i == 0 || j == 0)) std::ranges::rotate(corners, corners.begin() + 1);
            const auto corner = [&](std::size_t k, std::size_t side) { return vertices[corners[k]][side]; };
            mesh.triangles.push_back({corner(0, 1), corner(1, 1), corner(2, 1)});
            mesh.triangles.push_back({corner(0, 1), corner(2, 1), corner(3, 1)});
            mesh.triangles.push_back({corner(0, 0), corner(2, 0), corner(1, 0)});
            mesh.triangles.push_back({corner(0, 0), corner(3, 0), corner(2, 0)});
        }
    }
    return mesh;
}

/// The longest edge of the tetrahedron to which \p surface is reduced.
double longest_edge_left(const SurfaceMesh& surface) {
    HalfEdgeMesh mesh(static_cast<Index>(surface.positions.size()), surface.triangles);
    const Progress none;
    ProgressMeter meter(none);
    decimate(mesh, surface.positions, meter, 1);
    double longest = 0;
    for (Index half_edge = 0; half_edge < 3 * mesh.triangle_capacity(); ++half_edge) {
        if (!mesh.has_triangle(half_edge / 3)) continue;
        longest = std::max(longest, glm::distance(surface.positions[mesh.origin(half_edge)],
                                                  surface.positions[mesh.target(half_edge)]));
    }
    return longest;
}

}  // namespace

TEST_CASE("a plate as thick as its edges are long keeps its extent") {
    for (const unsigned squares : {40U, 60U}) {
        for (const double thickness_in_edges : {0.1, 0.6, 1.0, 2.0}) {
            CAPTURE(squares);
            CAPTURE(thickness_in_edges);
            CHECK(longest_edge_left(plate(squares, thickness_in_edges / squares)) > 3.0 / squares);
        }
    }
}

TEST_CASE("such a plate is fitted at the first attempt, with good leaves") {
    const FittedKey key = fit(plate(80, 0.6 / 80), {});
    CHECK(key.report.map_method == MapMethod::progressive);
    CHECK(std::ranges::none_of(key.report.times,
                               [](const StageTime& time) { return time.stage == "refused attempts"; }));
    CHECK(key.report.quality.hausdorff < 1e-3);
    CHECK(key.report.quality.min_angle > 5);
}
