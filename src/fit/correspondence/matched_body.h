// A body as it is compared with another one: a mesh of area 1 about its center of area, mapped to the sphere, with
// the functions that are compared.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/correspondence/sphere_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/sphere_location.h"

namespace interleaf {

/// Number of levels of smoothing.
inline constexpr std::size_t smoothing_levels = 5;

/// A mapped mesh, scaled to area 1 and moved so that its center of area is at 0.
/// \param mesh    clean
/// \param points  a map of \p mesh to the unit sphere, one point per vertex
/// \param turn    applied to the body
/// \throw InputError  if the surface has no area
SphereMesh normalized(const SurfaceMesh& mesh, std::span<const glm::dvec3> points, const glm::dmat3& turn);

class MatchedBody {
  public:
    /// \param body  normalized() and without long edges (even_mesh.h); its map is one to one
    /// \throw Cancelled
    MatchedBody(SphereMesh body, const Progress& progress);
    MatchedBody(const MatchedBody&) = delete;
    MatchedBody& operator=(const MatchedBody&) = delete;

    const SphereMesh& mesh() const { return mesh_; }
    std::span<const Triangle> triangles() const { return mesh_.triangles; }
    std::span<const glm::dvec3> positions() const { return mesh_.positions; }
    /// Of the unit sphere, in the given map, one per vertex.
    std::span<const glm::dvec3> points() const { return mesh_.points; }

    /// Vertices that correspond to vertices of other bodies.
    std::span<const SphereLandmark> landmarks() const { return mesh_.landmarks; }

    /// Triangles across the sides opposite the corners.
    const std::vector<Triangle>& neighbors() const { return neighbors_; }
    const std::vector<glm::dvec3>& triangle_normals() const { return triangle_normals_; }
    /// Per vertex. A higher level is smoothed less.
    const std::vector<glm::dvec3>& normals(std::size_t level) const { return normals_[level]; }
    const std::vector<double>& outwardness() const { return outwardness_; }

    /// Finds directions in points().
    MeshPoint locate(const glm::dvec3& direction, Index guess) const {
        return location_.locate(direction, guess);
    }

    glm::dvec3 position(const MeshPoint& place) const { return place.of(triangles(), positions()); }
    glm::dvec3 point(const MeshPoint& place) const;
    MeshPoint place_of(Index vertex) const;

  private:
    SphereMesh mesh_;
    std::vector<Triangle> neighbors_;
    std::vector<glm::dvec3> triangle_normals_;
    std::array<std::vector<glm::dvec3>, smoothing_levels> normals_;
    std::vector<double> outwardness_;
    SphereLocation location_;
};

/// Walks straight over a body: through triangles in straight lines that keep their angle at edges (Polthier and
/// Schmies 1998).
/// \param step  direction and length in space; its part along the normal does not count
MeshPoint walk(const MatchedBody& body, MeshPoint place, const glm::dvec3& step);

}  // namespace interleaf
