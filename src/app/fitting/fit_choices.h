// What a person has chosen in the offer to fit meshes, as options of the fit; and what is wrong with it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "app/fitting/fit_roots.h"
#include "fit/fit.h"
#include "fit/placement.h"
#include "ui/dialogs/fit_dialog.h"

namespace interleaf {

/// What is wrong with \p choices, the number and what it may be; "" for nothing.
/// \param names  of the meshes, one a turn
std::string fault_of(const FitChoices& choices, const SphereRoots& roots,
                     const std::vector<std::string>& names);

/// Without a rotation, which each mesh has of its own. \pre fault_of() finds nothing
FitOptions fit_options(const FitChoices& choices, const SphereRoots& roots);

PlacingOptions placing_of(const FitChoices& choices);

/// One per mesh.
std::vector<UpAxis> ups_of(const FitChoices& choices);

/// \pre fault_of() finds nothing
glm::dmat3 rotation_of(const FitChoices::Turn& turn);

/// The edges of \p roots, their ends as directions, where they come to lie over a mesh that is turned by \p
/// turn before it is mapped; not turned where the turn is none.
std::vector<std::array<glm::vec3, 2>> edges_over_mesh(const SphereRoots& roots, const FitChoices::Turn& turn);

}  // namespace interleaf
