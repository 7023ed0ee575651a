#include "fit/sampling/surface_sampling.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/space_triangle.h"
#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/greedy.h"

namespace interleaf {
namespace {

/// Weight of the turn of the normal in a leaf's error, as a fraction of the leaf's size.
constexpr double turn_share = 0.1;

/// The places on a leaf at which its distance is measured closely.
constexpr auto close_places = barycentric_grid<8>();

/// The work of a close measurement, in the units of a progress meter. Each vertex of the surface in the leaf
/// adds one unit.
constexpr std::size_t close_work = 400;

/// Leveling measures closely the leaves that seemed farthest: this many times the number of leaves that can
/// be added.
constexpr std::size_t leveling_choice = 3;

/// Only closure bisects a deeper leaf. Closure may add two levels, and max_level is the limit.
constexpr unsigned deepest_level = max_level - 4;

TriangleCorners corners_of(const AdaptiveMesh& mesh, Index leaf) {
    const auto& [a, b, c] = mesh.vertices(leaf);
    return {mesh.positions()[a], mesh.positions()[b], mesh.positions()[c]};
}

/// The square of the distance of a place of the surface from the key: from \p leaf, or from a nearer leaf
/// that is reached by moving to ever nearer neighbors. Stops when the square is at most \p enough.
double squared_distance_to_key(const glm::dvec3& place, const AdaptiveMesh& mesh, Index leaf, double enough) {
    double least = squared_distance_to_triangle(place, corners_of(mesh, leaf));
    for (bool is_nearer = true; is_nearer && least > enough;) {
        is_nearer = false;
        for (const Index neighbor : mesh.neighbors(leaf)) {
            const double distance = squared_distance_to_triangle(place, corners_of(mesh, neighbor));
            if (distance >= least) continue;
            least = distance;
            leaf = neighbor;
            is_nearer = true;
            break;
        }
    }
    return least;
}

class Sampler {
  public:
    Sampler(const MappedSurface& mapped, const SphereRoots& roots) : mapped_(mapped) {
        for (const glm::dvec3& point : roots.points) add_vertex(point, no_index);
        assign_vertices(roots);
    }

    glm::vec3 position(Index vertex) const { return glm::vec3(mapped_.position(mesh_points_[vertex])); }

    /// The adaptive mesh's rule for new vertices.
    glm::vec3 place_midpoint(Index a, Index b, Index midpoint) {
        assert(midpoint == sphere_points_.size());
        add_vertex(glm::normalize(sphere_points_[a] + sphere_points_[b]), mesh_points_[a].triangle);
        divided_edges_.push_back({{a, b, midpoint}, middle_of(a, midpoint), middle_of(b, midpoint)});
        return position(midpoint);
    }

    /// Records bisections.
    /// \param changed  the children of each bisection
    void divide_vertices(std::span<const Index> changed) {
        for (std::size_t i = 0; i < changed.size(); i += 2) divide_vertices(changed[i], changed[i + 1]);
        divided_edges_.clear();
    }

    /// The error that orders most bisections.
    double error(const AdaptiveMesh& mesh, Index leaf);

    /// The distance of a leaf from the surface as error() found it: for a few places and the vertices of the
    /// surface in the leaf, from this leaf alone. Infinite if error() has not been called.
    double noted_distance(Index leaf) const { return leaves_[leaf].distance; }

    /// The largest distance between the key at a leaf and the surface there, in both directions, at the
    /// places of a grid and at the vertices of the surface; \p least if that is larger.
    double close_distance(const AdaptiveMesh& mesh, Index leaf, double least) const;

    /// The largest distance of a landmark in a leaf from the leaf's point in its direction; 0 without landmarks.
    double landmark_distance(const AdaptiveMesh& mesh, Index leaf) const;

    /// Number of vertices of the surface in a leaf.
    std::size_t vertex_count(Index leaf) const { return vertices_of(leaves_[leaf]).size(); }

    SampledSurface result(const AdaptiveMesh& mesh) && {
        SampledSurface surface;
        for (const Index leaf : mesh.preorder())
            surface.leaves.push_back({mesh.vertices(leaf), static_cast<std::uint8_t>(mesh.level(leaf))});
        surface.positions.assign(mesh.positions().begin(), mesh.positions().end());
        surface.sphere_points = std::move(sphere_points_);
        surface.mesh_points = std::move(mesh_points_);
        return surface;
    }

  private:
    /// What is known about a leaf, so that its bisection has little left to locate.
    struct LeafRecord {
        Triangle corners;
        std::array<MeshPoint, 3> middles;  ///< of the sides, on the surface
        Index begin;                       ///< the leaf's vertices of the surface are a range of
        Index end;                         ///< vertices_
        double distance = std::numeric_limits<double>::infinity();  ///< see noted_distance()
    };
    /// An edge bisected in the present step. The leaves on both sides take over its halves.
    struct DividedEdge {
        NewVertex vertex;
        MeshPoint middle_at_a;  ///< of the half from a to the new vertex
        MeshPoint middle_at_b;
    };

    void add_vertex(const glm::dvec3& sphere_point, Index guess) {
        sphere_points_.push_back(sphere_point);
        mesh_points_.push_back(mapped_.location.locate(sphere_point, guess));
    }
    /// The place of the middle of an edge on the surface. The place of \p b is known already.
    MeshPoint middle_of(Index a, Index b) const {
        return mapped_.location.locate(glm::normalize(sphere_points_[a] + sphere_points_[b]),
                                       mesh_points_[b].triangle);
    }
    std::span<const Index> vertices_of(const LeafRecord& record) const {
        return std::span(vertices_).subspan(record.begin, record.end - record.begin);
    }
    void assign_vertices(const SphereRoots& roots);
    void divide_vertices(Index first, Index second);

    const MappedSurface& mapped_;
    std::vector<glm::dvec3> sphere_points_;  ///< one per vertex of the key
    std::vector<MeshPoint> mesh_points_;
    std::vector<Index> vertices_;  ///< of the surface; those in one leaf are consecutive
    std::vector<LeafRecord> leaves_;
    std::vector<Index> leaves_of_landmarks_;
    std::vector<DividedEdge> divided_edges_;  ///< in the present step
};

/// Puts every vertex of the surface into the root triangle into which the map takes it.
void Sampler::assign_vertices(const SphereRoots& roots) {
    const auto triangles = roots.complex.triangles();
    const SphereLocation root_location(triangles, roots.points);
    std::vector<Index> root_of(mapped_.points.size());
    std::vector<Index> counts(triangles.size(), 0);
    for (std::size_t v = 0; v < mapped_.points.size(); ++v) {
        root_of[v] = root_location.locate(mapped_.points[v], v > 0 ? root_of[v - 1] : no_index).triangle;
        ++counts[root_of[v]];
    }
    Index begin = 0;
    for (std::size_t root = 0; root < triangles.size(); ++root) {
        const auto& [a, b, c] = triangles[root];
        leaves_.push_back(
            {triangles[root], {middle_of(b, c), middle_of(c, a), middle_of(a, b)}, begin, begin});
        begin += counts[root];
    }
    vertices_.resize(mapped_.points.size());
    for (std::size_t v = 0; v < mapped_.points.size(); ++v)
        vertices_[leaves_[root_of[v]].end++] = static_cast<Index>(v);
    for (const MappedLandmark& landmark : mapped_.landmarks)
        leaves_of_landmarks_.push_back(root_location.locate(landmark.direction).triangle);
}

/// Performs one bisection: the first child takes the place of its parent.
void Sampler::divide_vertices(Index first, Index second) {
    const auto [corners, middles, begin, end, ignored] = leaves_[first];
    const auto [low, high] = std::minmax(corners[1], corners[2]);
    const auto edge =
        std::ranges::find_if(divided_edges_, [low = low, high = high](const DividedEdge& divided) {
            return divided.vertex.a == low && divided.vertex.b == high;
        });
    assert(edge != divided_edges_.end());
    const Index midpoint = edge->vertex.midpoint;
    const auto children = bisect(corners, midpoint);
    const glm::dvec3& apex = sphere_points_[corners[0]];
    const glm::dvec3& middle = sphere_points_[midpoint];
    const auto divide = std::partition(vertices_.begin() + begin, vertices_.begin() + end, [&](Index vertex) {
        return side_of_arc(apex, middle, mapped_.points[vertex]) >= 0;
    });
    const auto between = static_cast<Index>(divide - vertices_.begin());
    for (std::size_t k = 0; k < leaves_of_landmarks_.size(); ++k)
        if (leaves_of_landmarks_[k] == first && side_of_arc(apex, middle, mapped_.landmarks[k].direction) < 0)
            leaves_of_landmarks_[k] = second;
    if (leaves_.size() <= second) leaves_.resize(second + 1);

    // The sides of the children, numbered as in hierarchy/triangle.h: the first has the half at corners[2].
    const bool first_at_b = corners[2] == edge->vertex.b;
    const MeshPoint& middle_of_first = first_at_b ? edge->middle_at_b : edge->middle_at_a;
    const MeshPoint& middle_of_second = first_at_b ? edge->middle_at_a : edge->middle_at_b;
    const MeshPoint middle_between = middle_of(corners[0], midpoint);
    leaves_[first] = {children[0], {middles[1], middle_between, middle_of_first}, begin, between};
    leaves_[second] = {children[1], {middles[2], middle_of_second, middle_between}, between, end};
}

double Sampler::error(const AdaptiveMesh& mesh, Index leaf) {
    LeafRecord& record = leaves_[leaf];
    const auto& [a, b, c] = mesh.vertices(leaf);
    const TriangleCorners corners = corners_of(mesh, leaf);
    const glm::dvec3 normal = unit_normal(corners);

    double squared_distance = 0;
    double squared_turn = 0;
    const auto measure_at = [&](const MeshPoint& point) {
        squared_distance =
            std::max(squared_distance, squared_distance_to_triangle(mapped_.position(point), corners));
        const glm::dvec3 turn = mapped_.normals[point.triangle] - normal;
        squared_turn = std::max(squared_turn, glm::dot(turn, turn));
    };
    for (const MeshPoint& middle : record.middles) measure_at(middle);
    const glm::dvec3 center = glm::normalize(sphere_points_[a] + sphere_points_[b] + sphere_points_[c]);
    measure_at(mapped_.location.locate(center, record.middles[0].triangle));
    for (const Index vertex : vertices_of(record))
        squared_distance =
            std::max(squared_distance, squared_distance_to_triangle(mapped_.mesh.positions[vertex], corners));
    record.distance = std::sqrt(squared_distance);

    if (mesh.level(leaf) >= deepest_level) return 0;
    const double size =
        std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                  glm::distance(corners[2], corners[0])});
    return std::max(record.distance + turn_share * size * std::sqrt(squared_turn),
                    landmark_distance(mesh, leaf));
}

double Sampler::landmark_distance(const AdaptiveMesh& mesh, Index leaf) const {
    if (mesh.level(leaf) >= deepest_level) return 0;
    double largest = 0;
    for (std::size_t k = 0; k < leaves_of_landmarks_.size(); ++k) {
        if (leaves_of_landmarks_[k] != leaf) continue;
        const auto& [a, b, c] = mesh.vertices(leaf);
        const glm::dvec3 &u = sphere_points_[a], &v = sphere_points_[b], &w = sphere_points_[c];
        const auto& [direction, position] = mapped_.landmarks[k];
        glm::dvec3 place(side_of_arc(v, w, direction), side_of_arc(w, u, direction),
                         side_of_arc(u, v, direction));
        place = glm::max(place, glm::dvec3(0));
        place /= place[0] + place[1] + place[2];
        const TriangleCorners corners = corners_of(mesh, leaf);
        const glm::dvec3 in_key = place[0] * corners[0] + place[1] * corners[1] + place[2] * corners[2];
        largest = std::max(largest, glm::distance(in_key, position));
    }
    return largest;
}

double Sampler::close_distance(const AdaptiveMesh& mesh, Index leaf, double least) const {
    if (mesh.level(leaf) >= deepest_level) return 0;
    const auto& [a, b, c] = mesh.vertices(leaf);
    double squared = least * least;
    for (const Index vertex : vertices_of(leaves_[leaf]))
        squared =
            std::max(squared, squared_distance_to_key(mapped_.mesh.positions[vertex], mesh, leaf, squared));
    const auto measure = [&](const FacingPlaces& places) {
        const glm::dvec3 gap = places.on_surface - places.on_leaf;
        if (glm::dot(gap, gap) <= squared) return true;  // neither is farther from the other surface
        squared = std::max(squared, squared_distance_to_key(places.on_surface, mesh, leaf, squared));
        Index nearest = places.triangle;
        const double from_surface = mapped_.distance(places.on_leaf, nearest, std::sqrt(squared));
        squared = std::max(squared, from_surface * from_surface);
        return true;
    };
    all_of_places(mapped_, close_places, {sphere_points_[a], sphere_points_[b], sphere_points_[c]},
                  corners_of(mesh, leaf), mesh_points_[a].triangle, measure);
    return std::sqrt(squared);
}

/// About the largest noted distance of a leaf when the first \p count leaves are left out. It is a little
/// less, so that rounding does not separate equal leaves.
double noted_distance_behind(std::size_t count, const Sampler& sampler, const AdaptiveMesh& mesh) {
    std::vector<double> distances;
    distances.reserve(mesh.leaf_count());
    for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf) distances.push_back(sampler.noted_distance(leaf));
    if (count >= distances.size()) return 0;
    const auto place = distances.begin() + static_cast<std::ptrdiff_t>(count);
    std::ranges::nth_element(distances, place, std::greater());
    return 0.999 * *place;
}

/// The surface's normals at a few places of \p leaf, found by the map; zero where the surface has no area.
std::array<glm::dvec3, 4> normals_under(const Triangle& leaf, const SampledSurface& surface,
                                        const MappedSurface& mapped) {
    const auto& [a, b, c] = leaf;
    const glm::dvec3 &u = surface.sphere_points[a], &v = surface.sphere_points[b],
                     &w = surface.sphere_points[c];
    std::array<glm::dvec3, 4> normals{u + v + w, 4.0 * u + v + w, u + 4.0 * v + w, u + v + 4.0 * w};
    Index guess = surface.mesh_points[a].triangle;
    for (glm::dvec3& place : normals) {
        guess = mapped.location.locate(glm::normalize(place), guess).triangle;
        place = mapped.normals[guess];
    }
    return normals;
}

/// Not of length 1.
glm::dvec3 normal_of(const Triangle& leaf, const SampledSurface& surface) {
    const auto& [a, b, c] = leaf;
    const glm::dvec3 first(surface.positions[a]);
    return glm::cross(glm::dvec3(surface.positions[b]) - first, glm::dvec3(surface.positions[c]) - first);
}

}  // namespace

SampledSurface sample_surface(const MappedSurface& mapped, const SphereRoots& roots,
                              const SamplingOptions& options, const Progress& progress) {
    Sampler sampler(mapped, roots);
    std::vector<glm::vec3> root_positions;
    root_positions.reserve(roots.complex.vertex_count());
    for (Index vertex = 0; vertex < roots.complex.vertex_count(); ++vertex)
        root_positions.push_back(sampler.position(vertex));
    AdaptiveMesh leaves(roots.complex, root_positions, [&](Index a, Index b, Index midpoint) {
        return sampler.place_midpoint(a, b, midpoint);
    });

    ProgressMeter meter(progress);
    meter.enter("sampling", 0);
    const auto after_step = [&](const AdaptiveMesh& refined, std::span<const Index> changed) {
        sampler.divide_vertices(changed);
        meter.set_part(double(refined.leaf_count()) / options.leaves);
        meter.step();
    };
    const auto close_distance = [&](const AdaptiveMesh& refined, Index leaf, double least) {
        meter.step(close_work + sampler.vertex_count(leaf));
        return sampler.close_distance(refined, leaf, least);
    };
    if (options.tolerance > 0) {
        refine_greedily(leaves,
                        [&](const AdaptiveMesh& refined, Index leaf) {
                            return std::max(close_distance(refined, leaf, options.tolerance),
                                            sampler.landmark_distance(refined, leaf));
                        },
                        {.leaves = options.leaves, .tolerance = options.tolerance, .after_step = after_step});
    } else {
        const Index leveling = std::min(options.leaves / 10, options.max_leveling);
        refine_greedily(leaves,
                        [&](const AdaptiveMesh& refined, Index leaf) { return sampler.error(refined, leaf); },
                        {.leaves = options.leaves - leveling, .after_step = after_step});
        if (leveling == 0) return std::move(sampler).result(leaves);
        const double far = noted_distance_behind(leveling_choice * leveling, sampler, leaves);
        // Distances below half of this need not be told apart: leveling is not meant for those leaves.
        refine_greedily(
            leaves,
            [&](const AdaptiveMesh& refined, Index leaf) {
                return sampler.noted_distance(leaf) < far ? 0 : close_distance(refined, leaf, far / 2);
            },
            {.leaves = options.leaves, .after_step = after_step});
    }
    return std::move(sampler).result(leaves);
}

bool faces_away(const Triangle& leaf, const SampledSurface& surface, const MappedSurface& mapped) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& normal : normals_under(leaf, surface, mapped)) sum += normal;
    return !(glm::dot(sum, normal_of(leaf, surface)) > 0);
}

bool is_turned_over(const Triangle& leaf, const SampledSurface& surface, const MappedSurface& mapped) {
    const glm::dvec3 of_leaf = normal_of(leaf, surface);
    return std::ranges::none_of(normals_under(leaf, surface, mapped),
                                [&](const glm::dvec3& normal) { return glm::dot(normal, of_leaf) > 0; });
}

}  // namespace interleaf
