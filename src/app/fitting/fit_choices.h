// Converts the user's choices in the fit dialog to options of the fit, and checks them.
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

/// What is wrong with \p choices: the number and its valid range; "" for nothing.
/// \param names  the names of the meshes, one per turn
std::string fault_of(const FitChoices& choices, const SphereRoots& roots,
                     const std::vector<std::string>& names);

/// The options of the fit without a rotation, because each mesh has its own.
/// \pre fault_of() finds nothing
FitOptions fit_options(const FitChoices& choices, const SphereRoots& roots);

PlacingOptions placing_of(const FitChoices& choices);

/// The up axes, one per mesh.
std::vector<UpAxis> ups_of(const FitChoices& choices);

/// The rotation of one mesh.
/// \pre fault_of() finds nothing
glm::dmat3 rotation_of(const FitChoices::Turn& turn);

/// The edges of \p roots over a mesh that \p turn rotates before it is mapped. The ends are directions. An
/// empty turn does not rotate.
std::vector<std::array<glm::vec3, 2>> edges_over_mesh(const SphereRoots& roots, const FitChoices::Turn& turn);

}  // namespace interleaf
