// Decimation: plates keep their extent. That collapses can be undone is tested with the half-edge mesh.
#include "fit/sphere_map/decimation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/fit.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/space_triangle.h"

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

double area_of(const HalfEdgeMesh& mesh, const SurfaceMesh& surface) {
    double doubled = 0;
    for (Index triangle = 0; triangle < mesh.triangle_capacity(); ++triangle) {
        if (!mesh.has_triangle(triangle)) continue;
        const auto corner = [&](Index k) { return surface.positions[mesh.origin(3 * triangle + k)]; };
        doubled += doubled_area({corner(0), corner(1), corner(2)});
    }
    return doubled / 2;
}

/// The fraction of the area that \p surface has left when it is reduced to a part of its vertices.
double area_left(const SurfaceMesh& surface, double part) {
    HalfEdgeMesh mesh(static_cast<Index>(surface.positions.size()), surface.triangles);
    const double whole = area_of(mesh, surface);
    const Progress none;
    ProgressMeter meter(none);
    std::vector<Index> collapses = decimate(mesh, surface.positions, meter, 1);
    for (auto restored = static_cast<std::size_t>(part * double(surface.positions.size())); restored > 4;
         --restored) {
        mesh.undo_collapse(collapses.back());
        collapses.pop_back();
    }
    return area_of(mesh, surface) / whole;
}

}  // namespace

TEST_CASE("a plate about as thick as its edges are long keeps its extent") {
    struct Plate {
        unsigned squares;
        double thickness_in_edges;
    };
    for (const auto& [squares, thickness_in_edges] :
         {Plate{40, 0.1}, Plate{40, 0.6}, Plate{40, 1}, Plate{120, 1.6}}) {
        CAPTURE(squares);
        CAPTURE(thickness_in_edges);
        CHECK(area_left(plate(squares, thickness_in_edges / squares), 1.0 / 32) > 0.6);
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
