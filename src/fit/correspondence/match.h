// Matches the map of one body to that of another, the model, so that like parts lie at like places of the
// sphere, and blends of the two bodies make sense half way.
//
// A map to the sphere depends on the mesh: two meshes of one body have different maps, and one rotation cannot
// make them agree. So the mesh of the body moves over the surface of the model until the two agree best
// (moving_mesh.h), from coarse to fine (Schmidt, Pieper and Kobbelt 2023 optimize maps over spheres for a like
// energy). Each vertex then takes over the model's point on the sphere, at its place on the model.
// Without landmarks, all bodies should stand alike. Landmarks that both bodies have stay on each other.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/correspondence/matched_body.h"
#include "fit/correspondence/moving_mesh.h"
#include "fit/mesh/surface_mesh.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct MatchOptions {
    std::size_t vertices =
        8000;  ///< at most, of the mesh that moves from coarse to fine; twice those of a small body
    int max_passes = 10;   ///< from coarse to fine; at least 1
    double enough = 1.01;  ///< no further pass once the distortion is below this
};

struct MatchReport {
    MatchFigures before;  ///< of the given map
    MatchFigures after;   ///< of the matched map; of the given map if that is kept
    int passes = 0;
    std::string fault;  ///< why the given map is kept, in words; empty if the body is matched

    /// Of the surface half way between the model's key and the body's, both scaled to area 1 (half_way.h). Only fit()
    /// measures it, since match() makes no keys, and only if a matched key is sound otherwise; else 0.
    double half_way_area_before = 0;
    double half_way_area_after = 0;  ///< the same as before if the given map is kept
};

struct MatchedMap {
    SurfaceMesh mesh;  ///< the given mesh with long edges halved, without colors; empty if there is a fault
    std::vector<glm::dvec3> points;  ///< of the unit sphere, one per vertex of that mesh
    MatchReport report;
};

/// Says in words why a map gives no good key; empty if the key is good.
using KeyJudge = std::function<std::string(const MatchedMap& map, const Progress& progress)>;

/// A body to which others are matched.
/// \param mesh    clean
/// \param points  the map of \p mesh by which its key is sampled: one point per vertex
/// \param turn    the rotation of that map after the alignment
/// \param landmarks  directions on the sphere at which landmarks of other bodies are
/// \throw InputError  if the surface has no area
/// \throw Cancelled
std::unique_ptr<const MatchedBody> model_of(const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                                            const glm::dmat3& turn, std::span<const glm::dvec3> landmarks,
                                            const MatchOptions& options, const Progress& progress);

/// Matches a map to that of \p model. The same input gives the same bits. Never rotate the result: its points
/// correspond to those of the model's map as they are.
/// \param mesh    clean
/// \param points  a map of \p mesh to the sphere, one to one and aligned: one point per vertex
/// \param turn    applied to the body before it is compared: the rotation of its map after the alignment
/// \param held    vertices of \p mesh, landmarks: they keep their points. Three or more also turn the body, as they lie
///                on the model
/// \param judge   of the matched map; none to take it as it is. Where the key is no good, shapes on the sphere are
///                restored in more places, which costs agreement, up to three times
/// \throw Cancelled
MatchedMap match(const MatchedBody& model, const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                 const glm::dmat3& turn, std::span<const Index> held, const MatchOptions& options,
                 const Progress& progress, const KeyJudge& judge = {});

}  // namespace interleaf
