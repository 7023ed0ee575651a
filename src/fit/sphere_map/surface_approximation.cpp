#include "fit/sphere_map/surface_approximation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/surface_distance.h"

namespace interleaf {
namespace {

/// The distance of a chord from a smooth surface falls to a quarter per round.
constexpr int max_divisions = 6;

/// Divides a triangle by the middles of its sides.
/// \param middles  of the sides from corner k to corner k + 1; no_index for a side that stays whole
void divide(const Triangle& triangle, const std::array<Index, 3>& middles, std::vector<Triangle>& result) {
    const auto halved = std::ranges::count_if(middles, [](Index middle) { return middle != no_index; });
    if (halved == 0) {
        result.push_back(triangle);
        return;
    }
    // Corner 0 is opposite the only whole side, or begins the only halved side.
    std::size_t first = 0;
    if (halved == 1)
        while (middles[first] == no_index) ++first;
    if (halved == 2)
        while (middles[(first + 1) % 3] != no_index) ++first;
    const Index a = triangle[first];
    const Index b = triangle[(first + 1) % 3];
    const Index c = triangle[(first + 2) % 3];
    const Index ab = middles[first];
    const Index bc = middles[(first + 1) % 3];
    const Index ca = middles[(first + 2) % 3];
    if (halved == 1) {
        result.insert(result.end(), {Triangle{a, ab, c}, Triangle{ab, b, c}});
    } else if (halved == 2) {
        result.insert(result.end(), {Triangle{a, ab, ca}, Triangle{ab, b, ca}, Triangle{b, c, ca}});
    } else {
        result.insert(result.end(),
                      {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}});
    }
}

}  // namespace

void approximate_closely(const SurfaceMesh& surface, SurfaceMesh& mesh, std::vector<glm::dvec3>& points,
                         double tolerance, ProgressMeter& meter) {
    const SurfaceDistance distance(surface.triangles, surface.positions);
    Index nearest = no_index;
    for (int round = 0; round < max_divisions; ++round) {
        const HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
        std::vector<Index> middles(3 * mesh.triangles.size(), no_index);
        const std::size_t before = mesh.positions.size();
        for (Index half_edge = 0; half_edge < middles.size(); ++half_edge) {
            const Index a = half_edges.origin(half_edge);
            const Index b = half_edges.target(half_edge);
            if (a > b) continue;
            meter.step(10);
            const glm::dvec3 middle = (mesh.positions[a] + mesh.positions[b]) / 2.0;
            if (distance(middle, nearest, tolerance) <= tolerance) continue;
            middles[half_edge] = middles[half_edges.twin(half_edge)] =
                static_cast<Index>(mesh.positions.size());
            mesh.positions.push_back(distance.nearest_point(middle, nearest));
            points.push_back(glm::normalize(points[a] + points[b]));
        }
        if (mesh.positions.size() == before) return;
        std::vector<Triangle> triangles;
        triangles.reserve(2 * mesh.triangles.size());
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            const std::size_t first = 3 * triangle;
            divide(mesh.triangles[triangle], {middles[first], middles[first + 1], middles[first + 2]},
                   triangles);
        }
        mesh.triangles = std::move(triangles);
    }
}

}  // namespace interleaf
