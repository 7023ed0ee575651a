#include "fit/correspondence/matched_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/correspondence/surface_features.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/space_triangle.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// Radii of smoothing, for area 1: of the first level, and the factor from level to level. The last level is
/// about as fine as the even mesh.
constexpr double first_radius = 0.12;
constexpr double radius_factor = 0.6;

/// The fraction of the whole work at which normals are smoothed.
constexpr double smoothing_begins = 0.4;

std::vector<Triangle> triangles_across(std::span<const Triangle> triangles, std::size_t vertex_count) {
    const HalfEdgeMesh mesh(static_cast<Index>(vertex_count), triangles);
    std::vector<Triangle> across(triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
        for (Index corner = 0; corner < 3; ++corner)
            across[t][corner] = mesh.twin(HalfEdgeMesh::on_side(t, corner)) / 3;
    return across;
}

}  // namespace

SphereMesh normalized(const SurfaceMesh& mesh, std::span<const glm::dvec3> points, const glm::dmat3& turn) {
    SphereMesh result{mesh.triangles, mesh.positions, {points.begin(), points.end()}};
    const glm::dvec3 first = mesh.positions.front();
    double area = 0;
    glm::dvec3 moment(0);
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 u = mesh.positions[a] - first;
        const glm::dvec3 v = mesh.positions[b] - first;
        const glm::dvec3 w = mesh.positions[c] - first;
        const double here = glm::length(glm::cross(v - u, w - u)) / 2;
        area += here;
        moment += here / 3 * (u + v + w);
    }
    if (!(area > 0)) throw InputError("the surface has no area");
    const glm::dvec3 center = first + moment / area;
    const double scale = 1 / std::sqrt(area);
    for (glm::dvec3& position : result.positions) position = turn * (scale * (position - center));
    return result;
}

MatchedBody::MatchedBody(SphereMesh body, const Progress& progress)
    : mesh_(std::move(body)),
      neighbors_(triangles_across(mesh_.triangles, mesh_.positions.size())),
      location_(mesh_.triangles, mesh_.points) {
    for (const auto& [a, b, c] : mesh_.triangles)
        triangle_normals_.push_back(
            unit_normal({mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]}));
    ProgressMeter meter(progress);
    meter.enter("measuring the body", 0);
    outwardness_ = interleaf::outwardness(mesh_.triangles, mesh_.positions, 0, smoothing_begins, meter);
    const std::vector<glm::dvec3> raw = vertex_normals(mesh_.triangles, mesh_.positions);
    double radius = first_radius;
    for (std::vector<glm::dvec3>& normals : normals_) {
        normals = smoothed_directions(mesh_.triangles, mesh_.positions, raw, radius, meter);
        radius *= radius_factor;
    }
}

glm::dvec3 MatchedBody::point(const MeshPoint& place) const {
    return glm::normalize(place.of(triangles(), points()));
}

MeshPoint MatchedBody::place_of(Index vertex) const {
    MeshPoint place;
    for (Index t = 0; t < triangles().size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (triangles()[t][k] == vertex) {
                place.triangle = t;
                place.barycentric[static_cast<glm::length_t>(k)] = 1;
                return place;
            }
    return place;
}

MeshPoint walk(const MatchedBody& body, MeshPoint place, const glm::dvec3& step) {
    constexpr int max_triangles = 400;
    constexpr double no_area = 1e-26;  // square of twice the area
    double left = glm::length(step);
    glm::dvec3 normal = body.triangle_normals()[place.triangle];
    glm::dvec3 direction = step - glm::dot(step, normal) * normal;
    if (!(glm::length(direction) > 1e-12 * left)) return place;
    direction = glm::normalize(direction);
    glm::length_t entered = -1;  // the side through which the way came
    for (int i = 0; i < max_triangles; ++i) {
        const Triangle& corners = body.triangles()[place.triangle];
        const glm::dvec3& a = body.positions()[corners[0]];
        const glm::dvec3& b = body.positions()[corners[1]];
        const glm::dvec3& c = body.positions()[corners[2]];
        normal = glm::cross(b - a, c - a);
        const double squared = glm::dot(normal, normal);
        if (!(squared > no_area)) return place;
        const glm::dvec3 rate = glm::dvec3(glm::dot(normal, glm::cross(c - b, direction)),
                                           glm::dot(normal, glm::cross(a - c, direction)),
                                           glm::dot(normal, glm::cross(b - a, direction))) /
                                squared;
        double length = left;
        glm::length_t exit = -1;
        for (glm::length_t k = 0; k < 3; ++k) {
            if (k == entered || !(rate[k] < 0)) continue;
            const double to_side = std::max(0.0, place.barycentric[k]) / -rate[k];
            if (to_side >= length) continue;
            length = to_side;
            exit = k;
        }
        const glm::dvec3 raised = glm::max(place.barycentric + length * rate, glm::dvec3(0));
        place.barycentric = raised / (raised.x + raised.y + raised.z);
        left -= length;
        if (exit < 0 || !(left > 0)) return place;

        const auto side = static_cast<std::size_t>(exit);
        const Index from = corners[(side + 1) % 3];
        const Index to = corners[(side + 2) % 3];
        const Index next = body.neighbors()[place.triangle][side];
        const glm::dvec3& next_normal = body.triangle_normals()[next];
        if (!(glm::dot(next_normal, next_normal) > 0.5)) return place;
        const glm::dvec3 edge = glm::normalize(body.positions()[to] - body.positions()[from]);
        const glm::dvec3 inward = glm::cross(body.triangle_normals()[place.triangle], edge);
        direction = glm::normalize(glm::dot(direction, edge) * edge +
                                   glm::dot(direction, inward) * glm::cross(next_normal, edge));
        MeshPoint across{.triangle = next, .barycentric = glm::dvec3(0)};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto place_k = static_cast<glm::length_t>(k);
            if (body.triangles()[next][k] == from)
                across.barycentric[place_k] = place.barycentric[static_cast<glm::length_t>((side + 1) % 3)];
            else if (body.triangles()[next][k] == to)
                across.barycentric[place_k] = place.barycentric[static_cast<glm::length_t>((side + 2) % 3)];
            else
                entered = place_k;
        }
        place = across;
    }
    return place;
}

}  // namespace interleaf
