#include "fit/sampling/leaf_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <ranges>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "fit/sampling/leaf_faults.h"
#include "fit/sampling/star_grid.h"

namespace interleaf {
namespace {

constexpr int max_rounds = 6;
constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// Fractions of the way to a neighbor that are tried, towards it and away from it.
constexpr std::array<double, 10> way_parts = {0.4, -0.4, 0.2, -0.2, 0.1, -0.1, 0.05, -0.05, 0.025, -0.025};

/// Number of places per vertex that are checked closely, in the order of their angles, best first.
constexpr std::size_t max_places = 8;

/// After a move no place of the star may be farther than this fraction of the largest distance. The margin is
/// needed because distances are measured at some places only.
constexpr double near_enough = 0.9;

/// The same for moves that mend needles, in the last rounds: each only for needles that the ones before do not mend.
constexpr std::array<double, 3> near_enough_for_needles = {near_enough, 1.25, 1.6};

/// At most so many needles are mended, or a hundredth of the leaves: on very long bodies, most leaves are needles.
constexpr std::size_t max_needles = 100;

/// After a move no landmark may be farther from the key than this fraction of the box diagonal, unless it was before.
constexpr double near_landmark = 0.002;

/// The faults of some leaves.
struct Fault {
    int facing_away = 0;
    double cosine = -1;  ///< of the least angle, or of the wanted angle if that is smaller
};

/// The place of a vertex of the key.
struct Place {
    glm::dvec3 direction;
    MeshPoint point;
    glm::vec3 position;
};

class Smoothing {
  public:
    Smoothing(const MappedSurface& mapped, SampledSurface& surface, ProgressMeter& meter)
        : mapped_(mapped), surface_(surface), at_rest_(surface.positions.size(), false) {
        for (const Leaf& leaf : surface.leaves) leaves_.push_back(leaf.vertices);
        gather_stars();
        assign_vertices(meter);
        faces_away_.reserve(leaves_.size());
        for (const Triangle& leaf : leaves_) {
            meter.step();
            faces_away_.push_back(faces_away(leaf, surface_, mapped_));
        }
        max_distance_ = max_distance(meter);
    }

    void run(std::size_t fixed_vertices, const SmoothingLimits& limits, ProgressMeter& meter) {
        allowed_distance_ = near_enough * max_distance_;
        bool moved = true;
        std::size_t tries = 0;
        for (int round = 0; round < max_rounds && moved; ++round) {
            const std::size_t most = tries < limits.tries ? limits.tries_per_round : limits.tries_of_worst;
            const std::size_t end = most < no_limit - tries ? tries + most : no_limit;
            if (tries == end) break;
            moved = false;
            meter.set_part(double(round) / max_rounds);
            for (const Index leaf : faulty_leaves(meter))
                for (const Index vertex : leaves_[leaf]) {
                    if (tries >= end) break;
                    if (vertex < fixed_vertices || at_rest_[vertex] || !is_faulty(leaf)) continue;
                    moved = improve(vertex) || moved;
                    ++tries;
                    meter.step(5000);
                }
        }
    }

    /// Puts all vertices onto the surface that the mesh approximates. From now on, moves end there, too.
    void put_onto(const SurfaceDistance& original, ProgressMeter& meter) {
        original_ = &original;
        Index nearest = no_index;
        for (glm::vec3& position : surface_.positions) {
            position = on_original(position, nearest);
            meter.step();
        }
        for (Index leaf = 0; leaf < leaves_.size(); ++leaf) {
            faces_away_[leaf] = faces_away(leaves_[leaf], surface_, mapped_);
            meter.step();
        }
    }

    /// Mends the worst of the leaves with a smaller angle than limits.needle_angle.
    void mend_needles(std::size_t fixed_vertices, const SmoothingLimits& limits, ProgressMeter& meter) {
        const double cosine = cosine_of_degrees(limits.needle_angle);
        const auto is_needle = [&](Index leaf) { return max_cosine(corners(leaf)) > cosine; };
        std::vector<Index> needles = faulty_leaves(meter);
        std::erase_if(needles, std::not_fn(is_needle));
        needles.resize(std::min(needles.size(), std::max(max_needles, leaves_.size() / 100)));
        const auto improve_needles = [&] {
            bool moved = false;
            for (const Index leaf : needles)
                for (const Index vertex : leaves_[leaf]) {
                    if (vertex >= fixed_vertices && is_needle(leaf)) moved = improve(vertex) || moved;
                    meter.step(5000);
                }
            return moved;
        };
        for (const double factor : near_enough_for_needles) {
            const double farther = std::min(factor * max_distance_, limits.needle_distance);
            allowed_distance_ = std::max(near_enough * max_distance_, farther);
            for (int round = 0; round < max_rounds && improve_needles(); ++round) {
            }
        }
    }

  private:
    void gather_stars() {
        star_begin_.assign(surface_.positions.size() + 1, 0);
        for (const Triangle& leaf : leaves_)
            for (const Index vertex : leaf) ++star_begin_[vertex + 1];
        for (std::size_t v = 1; v < star_begin_.size(); ++v) star_begin_[v] += star_begin_[v - 1];
        stars_.resize(star_begin_.back());
        std::vector<Index> next(star_begin_.begin(), star_begin_.end() - 1);
        for (Index leaf = 0; leaf < leaves_.size(); ++leaf)
            for (const Index vertex : leaves_[leaf]) stars_[next[vertex]++] = leaf;
    }
    std::span<const Index> star(Index vertex) const {
        return std::span(stars_).subspan(star_begin_[vertex], star_begin_[vertex + 1] - star_begin_[vertex]);
    }

    void assign_vertices(ProgressMeter& meter);
    void assign_anew(std::span<const Index> star);
    std::vector<Index> faulty_leaves(ProgressMeter& meter) const;
    bool improve(Index vertex);
    std::vector<std::pair<double, Place>> better_places(Index vertex, const Fault& before);
    bool is_better(Index vertex, double cosine, const Fault& before);
    double max_distance(ProgressMeter& meter) const;
    bool is_near(Index vertex, std::span<const glm::dvec3> grid) const;
    bool is_near_landmarks(Index vertex, const Place& before) const;

    glm::vec3 on_original(const glm::vec3& position, Index& nearest) const {
        return glm::vec3(original_->nearest_point(glm::dvec3(position), nearest));
    }
    TriangleCorners corners(Index leaf) const { return corners_of(leaves_[leaf], surface_); }
    std::array<glm::dvec3, 3> directions(Index leaf) const {
        const auto& [a, b, c] = leaves_[leaf];
        return {surface_.sphere_points[a], surface_.sphere_points[b], surface_.sphere_points[c]};
    }
    bool is_one_to_one(std::span<const Index> star) const {
        return std::ranges::all_of(star, [&](Index leaf) {
            const auto [u, v, w] = directions(leaf);
            return side_of_arc(u, v, w) > 0;
        });
    }
    Fault fault(std::span<const Index> star) const {
        Fault found{0, good_cosine_};
        for (const Index leaf : star) {
            found.facing_away += faces_away_[leaf];
            found.cosine = std::max(found.cosine, max_cosine(corners(leaf)));
        }
        return found;
    }
    bool is_faulty(Index leaf) const { return faces_away_[leaf] || max_cosine(corners(leaf)) > good_cosine_; }
    Place place_of(Index vertex) const {
        return {surface_.sphere_points[vertex], surface_.mesh_points[vertex], surface_.positions[vertex]};
    }
    void put(Index vertex, const Place& place) {
        surface_.sphere_points[vertex] = place.direction;
        surface_.mesh_points[vertex] = place.point;
        surface_.positions[vertex] = place.position;
    }

    const double good_cosine_ = cosine_of_degrees(smoothed_angle);
    const StarGrids grids_;
    const MappedSurface& mapped_;
    SampledSurface& surface_;
    const SurfaceDistance* original_ = nullptr;  ///< if the vertices are on it
    std::vector<Triangle> leaves_;
    std::vector<Index> star_begin_;
    std::vector<Index> stars_;          ///< leaves around vertices
    std::vector<Index> inside_;         ///< the first of the mesh's vertices that lie in a leaf
    std::vector<Index> next_;           ///< per vertex, the next vertex in the same leaf
    std::vector<char> faces_away_;      ///< per leaf, whether it does
    std::vector<char> new_faces_away_;  ///< the same of a star that is tried, in its order
    std::vector<bool> at_rest_;         ///< whether a vertex found no better place since its star changed
    std::vector<MeshPoint> landmarks_;  ///< the places of the mapped landmarks on leaves, wherever these move
    const double allowed_landmark_distance_ = near_landmark * box_diagonal(mapped_.mesh);
    double max_distance_ = 0;      ///< before smoothing
    double allowed_distance_ = 0;  ///< for the present moves
};

/// Puts every vertex of the mesh, and every landmark, into the leaf into which the map takes it.
void Smoothing::assign_vertices(ProgressMeter& meter) {
    const SphereLocation location(leaves_, surface_.sphere_points);
    inside_.assign(leaves_.size(), no_index);
    next_.resize(mapped_.points.size());
    Index leaf = no_index;
    for (Index vertex = 0; vertex < mapped_.points.size(); ++vertex) {
        leaf = location.locate(mapped_.points[vertex], leaf).triangle;
        next_[vertex] = std::exchange(inside_[leaf], vertex);
        meter.step();
    }
    landmarks_.reserve(mapped_.landmarks.size());
    for (const MappedLandmark& landmark : mapped_.landmarks)
        landmarks_.push_back(location.locate(landmark.direction));
}

/// The same for the vertices in a star whose middle has moved.
void Smoothing::assign_anew(std::span<const Index> star) {
    std::vector<Index> vertices;
    for (const Index leaf : star)
        for (Index vertex = std::exchange(inside_[leaf], no_index); vertex != no_index;
             vertex = next_[vertex])
            vertices.push_back(vertex);
    for (const Index vertex : vertices) {
        const auto how_far_inside = [&](Index leaf) {
            const auto [u, v, w] = directions(leaf);
            const glm::dvec3& point = mapped_.points[vertex];
            return std::min({side_of_arc(u, v, point), side_of_arc(v, w, point), side_of_arc(w, u, point)});
        };
        const Index leaf = *std::ranges::max_element(star, {}, how_far_inside);
        next_[vertex] = std::exchange(inside_[leaf], vertex);
    }
}

/// The worst leaves first.
std::vector<Index> Smoothing::faulty_leaves(ProgressMeter& meter) const {
    std::vector<std::pair<double, Index>> found;
    for (Index leaf = 0; leaf < leaves_.size(); ++leaf) {
        meter.step();
        if (!is_faulty(leaf)) continue;
        const Fault here = fault(std::span(&leaf, 1));
        found.emplace_back(-here.facing_away - here.cosine, leaf);
    }
    std::ranges::sort(found);
    const auto leaves = found | std::views::values;
    return {leaves.begin(), leaves.end()};
}

/// The distance of the mesh from the key, at the vertices of the mesh and at the middles of leaves.
double Smoothing::max_distance(ProgressMeter& meter) const {
    const std::vector<glm::dvec3> positions(surface_.positions.begin(), surface_.positions.end());
    const SurfaceDistance to_key(leaves_, positions);
    Index nearest = no_index;
    double largest = 0;
    for (const glm::dvec3& position : mapped_.mesh.positions) {
        largest = std::max(largest, to_key(position, nearest));
        meter.step();
    }
    for (Index leaf = 0; leaf < leaves_.size(); ++leaf) {
        const auto [u, v, w] = directions(leaf);
        const Index guess = surface_.mesh_points[leaves_[leaf][0]].triangle;
        meter.step(60);
        for (const glm::dvec3& inside : {u + v + w, v + w})
            largest = std::max(
                largest,
                to_key(mapped_.position(mapped_.location.locate(glm::normalize(inside), guess)), nearest));
    }
    return largest;
}

/// Whether the mesh over the star of \p vertex is near the star, and the star near the mesh, at the places of a grid.
bool Smoothing::is_near(Index vertex, std::span<const glm::dvec3> grid) const {
    const double allowed = allowed_distance_ * allowed_distance_;
    const auto is_near_star = [&](const glm::dvec3& place) {
        return std::ranges::any_of(star(vertex), [&](Index leaf) {
            return squared_distance_to_triangle(place, corners(leaf)) <= allowed;
        });
    };
    for (const Index leaf : star(vertex)) {
        // As seen from the middle of the star.
        TriangleCorners corner = corners(leaf);
        std::array<glm::dvec3, 3> on_sphere = directions(leaf);
        const auto middle = std::ranges::find(leaves_[leaf], vertex) - leaves_[leaf].begin();
        std::ranges::rotate(corner, corner.begin() + middle);
        std::ranges::rotate(on_sphere, on_sphere.begin() + middle);
        const Index guess = surface_.mesh_points[leaves_[leaf][0]].triangle;
        const auto are_near = [&](const FacingPlaces& places) {
            if (glm::distance(places.on_surface, places.on_leaf) <= allowed_distance_) return true;
            Index near = places.triangle;
            return (squared_distance_to_triangle(places.on_surface, corner) <= allowed ||
                    is_near_star(places.on_surface)) &&
                   mapped_.distance.is_within(places.on_leaf, allowed_distance_, near);
        };
        if (!all_of_places(mapped_, grid, on_sphere, corner, guess, are_near)) return false;
        for (Index inside = inside_[leaf]; inside != no_index; inside = next_[inside])
            if (!is_near_star(mapped_.mesh.positions[inside])) return false;
    }
    return true;
}

/// Whether the landmarks in the star of \p vertex are near, or at least as near as with the vertex at \p before.
bool Smoothing::is_near_landmarks(Index vertex, const Place& before) const {
    for (std::size_t k = 0; k < landmarks_.size(); ++k) {
        const auto& [leaf, weights] = landmarks_[k];
        const auto corner = std::ranges::find(leaves_[leaf], vertex) - leaves_[leaf].begin();
        if (corner == 3) continue;
        const auto [a, b, c] = corners(leaf);
        const glm::dvec3 gap =
            weights[0] * a + weights[1] * b + weights[2] * c - mapped_.landmarks[k].position;
        const glm::dvec3 move = weights[static_cast<int>(corner)] *
                                (glm::dvec3(surface_.positions[vertex]) - glm::dvec3(before.position));
        if (glm::length(gap) > std::max(allowed_landmark_distance_, glm::length(gap - move))) return false;
    }
    return true;
}

/// Places that keep the star one to one and its least angle no smaller, with the cosine of that angle; best first.
std::vector<std::pair<double, Place>> Smoothing::better_places(Index vertex, const Fault& before) {
    const Place here = place_of(vertex);
    std::vector<std::pair<double, Place>> found;
    Index nearest = no_index;
    for (const Index leaf : star(vertex)) {
        const Triangle& leaf_vertices = leaves_[leaf];
        const std::size_t corner = leaf_vertices[0] == vertex ? 0 : leaf_vertices[1] == vertex ? 1 : 2;
        const glm::dvec3 way = surface_.sphere_points[leaf_vertices[(corner + 1) % 3]] - here.direction;
        for (const double part : way_parts) {
            const glm::dvec3 direction = glm::normalize(here.direction + part * way);
            surface_.sphere_points[vertex] = direction;
            if (!is_one_to_one(star(vertex))) continue;
            const MeshPoint point = mapped_.location.locate(direction, here.point.triangle);
            Place place{direction, point, glm::vec3(mapped_.position(point))};
            if (original_ != nullptr) place.position = on_original(place.position, nearest);
            put(vertex, place);
            double cosine = -1;
            for (const Index other : star(vertex)) {
                cosine = std::max(cosine, max_cosine(corners(other)));
                if (cosine > before.cosine) break;
            }
            if (cosine <= before.cosine) found.emplace_back(cosine, place);
        }
    }
    put(vertex, here);
    std::ranges::stable_sort(found, {}, &std::pair<double, Place>::first);
    if (found.size() > max_places) found.resize(max_places);
    return found;
}

/// Whether the star of \p vertex, with the \p cosine of its least angle, is less faulty than before.
bool Smoothing::is_better(Index vertex, double cosine, const Fault& before) {
    int allowed = before.facing_away - (std::max(cosine, good_cosine_) < before.cosine ? 0 : 1);
    if (allowed < 0) return false;
    new_faces_away_.clear();
    return std::ranges::all_of(star(vertex), [&](Index leaf) {
        new_faces_away_.push_back(faces_away(leaves_[leaf], surface_, mapped_));
        allowed -= new_faces_away_.back();
        return allowed >= 0;
    });
}

/// Moves the vertex to the first place that improves its star and is near enough to the surface.
bool Smoothing::improve(Index vertex) {
    const Fault before = fault(star(vertex));
    const Place here = place_of(vertex);
    for (const auto& [cosine, place] : better_places(vertex, before)) {
        put(vertex, place);
        if (is_better(vertex, cosine, before) && is_near_landmarks(vertex, here) &&
            is_near(vertex, grids_.coarse) && is_near(vertex, grids_.between)) {
            assign_anew(star(vertex));
            for (std::size_t k = 0; k < star(vertex).size(); ++k)
                faces_away_[star(vertex)[k]] = new_faces_away_[k];
            for (const Index leaf : star(vertex))
                for (const Index neighbor : leaves_[leaf]) at_rest_[neighbor] = false;
            return true;
        }
    }
    put(vertex, here);
    at_rest_[vertex] = true;
    return false;
}

}  // namespace

void smooth_leaves(const MappedSurface& mapped, std::size_t fixed_vertices, SampledSurface& surface,
                   const Progress& progress, const SmoothingLimits& limits, const SurfaceDistance* original) {
    ProgressMeter meter(progress);
    meter.enter("smoothing", 0);
    Smoothing smoothing(mapped, surface, meter);
    smoothing.run(fixed_vertices, limits, meter);
    if (original != nullptr) smoothing.put_onto(*original, meter);
    if (limits.needle_angle > 0) smoothing.mend_needles(fixed_vertices, limits, meter);
}

}  // namespace interleaf
