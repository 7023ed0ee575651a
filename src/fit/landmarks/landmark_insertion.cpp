#include "fit/landmarks/landmark_insertion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

#include <fmt/core.h>

#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/error.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

/// Barycentric coordinates below this one count as 0.
constexpr double at_border = 1e-3;

class LandmarkInsertion {
  public:
    explicit LandmarkInsertion(const SurfaceMesh& mesh)
        : distance_(mesh.triangles, mesh.positions), mesh_(mesh), whole_(mesh.triangles.size()) {
        for (Index triangle = 0; triangle < whole_.size(); ++triangle) whole_[triangle] = triangle;
    }

    /// Makes the point of the mesh nearest to \p point a vertex.
    Index insert(const glm::dvec3& point) {
        const auto [triangle, place] = nearest(point);
        const Triangle corners = mesh_.triangles[triangle];
        std::vector<unsigned> used;  // the corners between which the place lies
        for (unsigned k = 0; k < 3; ++k)
            if (place[int(k)] > at_border) used.push_back(k);
        if (used.size() == 3) return split_triangle(triangle, add_vertex(corners, place));
        if (used.size() < 2) return corners[used.empty() ? 0 : used[0]];
        const unsigned across = 3 - used[0] - used[1];
        glm::dvec3 on_side = place;
        on_side[int(across)] = 0;
        on_side /= on_side.x + on_side.y + on_side.z;
        return split_side(triangle, across, add_vertex(corners, on_side));
    }

    const glm::dvec3& position(Index vertex) const { return mesh_.positions[vertex]; }
    SurfaceMesh take() { return std::move(mesh_); }

  private:
    struct Place {
        Index triangle;
        glm::dvec3 barycentric;
    };

    Place nearest(const glm::dvec3& point) const {
        Index whole = no_index;
        distance_(point, whole);
        std::vector<Index> candidates = {whole};
        if (const auto found = parts_.find(whole); found != parts_.end())
            candidates.insert(candidates.end(), found->second.begin(), found->second.end());
        Place best{whole, {}};
        double least = std::numeric_limits<double>::infinity();
        for (const Index triangle : candidates) {
            const auto& [a, b, c] = mesh_.triangles[triangle];
            const TriangleCorners corners{mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
            const double distance = squared_distance_to_triangle(point, corners);
            if (distance >= least) continue;
            least = distance;
            best = {triangle, nearest_place(point, corners)};
        }
        return best;
    }

    Index add_vertex(const Triangle& corners, const glm::dvec3& place) {
        const auto mean = [&](const auto& values) {
            using Value = std::decay_t<decltype(values[0])>;
            using Number = typename Value::value_type;
            return Number(place.x) * values[corners[0]] + Number(place.y) * values[corners[1]] +
                   Number(place.z) * values[corners[2]];
        };
        mesh_.positions.push_back(mean(mesh_.positions));
        if (!mesh_.colors.empty()) mesh_.colors.push_back(mean(mesh_.colors));
        append_mean(mesh_.scalars, corners, std::array{place.x, place.y, place.z});
        return static_cast<Index>(mesh_.positions.size() - 1);
    }

    /// Adds a triangle that is a part of \p sibling's whole triangle.
    void add_part(const Triangle& part, Index sibling) {
        const auto added = static_cast<Index>(mesh_.triangles.size());
        mesh_.triangles.push_back(part);
        whole_.push_back(whole_[sibling]);
        parts_[whole_[sibling]].push_back(added);
    }

    Index split_triangle(Index triangle, Index middle) {
        const auto [a, b, c] = mesh_.triangles[triangle];
        mesh_.triangles[triangle] = {a, b, middle};
        add_part({b, c, middle}, triangle);
        add_part({c, a, middle}, triangle);
        return middle;
    }

    /// Puts \p middle on the side opposite corner \p across.
    Index split_side(Index triangle, unsigned across, Index middle) {
        const Index from = mesh_.triangles[triangle][(across + 1) % 3];
        const Index to = mesh_.triangles[triangle][(across + 2) % 3];
        split_at(triangle, across, middle);
        for (Index other = 0;; ++other) {
            assert(other < mesh_.triangles.size());
            for (unsigned k = 0; k < 3; ++k) {
                const Triangle& corners = mesh_.triangles[other];
                if (corners[(k + 1) % 3] != to || corners[(k + 2) % 3] != from) continue;
                split_at(other, k, middle);
                return middle;
            }
        }
    }

    void split_at(Index triangle, unsigned across, Index middle) {
        const Triangle corners = mesh_.triangles[triangle];
        const Index tip = corners[across];
        mesh_.triangles[triangle] = {tip, corners[(across + 1) % 3], middle};
        add_part({tip, middle, corners[(across + 2) % 3]}, triangle);
    }

    SurfaceDistance distance_;  // from the mesh as it was
    SurfaceMesh mesh_;
    std::vector<Index> whole_;  // per triangle, the triangle of the given mesh that it is a part of
    std::map<Index, std::vector<Index>> parts_;
};

}  // namespace

MeshWithLandmarks insert_landmarks(const SurfaceMesh& mesh, std::span<const Landmark> landmarks) {
    LandmarkInsertion insertion(mesh);
    MeshWithLandmarks made;
    for (const Landmark& landmark : landmarks) {
        const Index vertex = insertion.insert(landmark.position);
        if (const auto same = std::ranges::find(made.vertices, vertex); same != made.vertices.end())
            throw InputError(
                fmt::format("the landmarks '{}' and '{}' are at the same point, expected different points",
                            shown_text(landmarks[std::size_t(same - made.vertices.begin())].name),
                            shown_text(landmark.name)));
        made.vertices.push_back(vertex);
        made.distances.push_back(glm::distance(landmark.position, insertion.position(vertex)));
    }
    made.mesh = insertion.take();
    return made;
}

}  // namespace interleaf
