// The landmarks that a person sets on several meshes, as plain data, and the edits of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/landmark.h"

namespace interleaf {

/// A named point that several meshes may have.
struct LandmarkPoint {
    std::string name;
    std::vector<std::optional<glm::dvec3>> places;  ///< one per mesh, in the coordinates of its file
    /// On the sphere of an existing family, which the first mesh stands for. Such a point does not move there.
    std::optional<glm::dvec3> direction{};

    bool operator==(const LandmarkPoint&) const = default;
};

using LandmarkPoints = std::vector<LandmarkPoint>;

/// Whether \p point corresponds to a point of the first mesh, so that it counts for \p mesh.
bool is_paired(const LandmarkPoint& point, std::size_t mesh);

/// The landmarks of \p mesh that count: those that the first mesh has, too. Of the first mesh, those that another
/// mesh has.
std::vector<Landmark> counting_landmarks(const LandmarkPoints& points, std::size_t mesh);

/// Puts a point on \p mesh: at the landmark \p selected if that has none there, else at the last landmark without
/// one there that another mesh has, else as a new landmark.
/// \param mesh_count  number of meshes
/// \return the index of the landmark
std::size_t add_place(LandmarkPoints& points, std::size_t mesh_count, std::size_t mesh,
                      const glm::dvec3& place, std::optional<std::size_t> selected);

/// Puts \p landmarks on \p mesh: each at the landmark of its name, or as a new one. Landmarks of an existing family do
/// not move on the first mesh, which stands for it.
/// \param mesh_count  number of meshes
void put_landmarks(LandmarkPoints& points, std::size_t mesh_count, std::size_t mesh,
                   const std::vector<Landmark>& landmarks);

/// The landmarks that \p mesh has, with or without partners.
std::vector<Landmark> landmarks_on(const LandmarkPoints& points, std::size_t mesh);

/// The smallest number that is no name yet.
std::string free_name(const LandmarkPoints& points);

/// What is wrong with \p name for the landmark \p index; "" if nothing is.
std::string fault_of_name(const LandmarkPoints& points, std::size_t index, const std::string& name);

/// Pairs of landmarks that mirror each other: the plane between two of them that mirrors most others decides.
/// \param places  of one mesh
/// \return        pairs of indices of \p places; empty if no plane mirrors two pairs, or a pair and a point on it
std::vector<std::array<std::size_t, 2>> mirror_pairs(const std::vector<glm::dvec3>& places);

/// Exchanges, on \p mesh, the places of landmarks that mirror each other on the first mesh.
/// \return whether there are some
bool swap_sides(LandmarkPoints& points, std::size_t mesh);

/// Landmarks with undo and redo.
class LandmarkHistory {
  public:
    explicit LandmarkHistory(LandmarkPoints points = {}) : states_{std::move(points)} {}

    const LandmarkPoints& points() const { return states_[present_]; }

    /// Makes \p points the present state. Nothing changes if they are the present state already.
    void push(LandmarkPoints points);

    /// Replaces the present state, as part of the step that made it.
    void amend(LandmarkPoints points) { states_[present_] = std::move(points); }

    bool can_undo() const { return present_ > 0; }
    bool can_redo() const { return present_ + 1 < states_.size(); }
    void undo() { present_ -= can_undo() ? 1 : 0; }
    void redo() { present_ += can_redo() ? 1 : 0; }

  private:
    std::vector<LandmarkPoints> states_;
    std::size_t present_ = 0;
};

}  // namespace interleaf
