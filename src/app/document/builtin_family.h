// The built-in family: the five keys of the paper's figure 8. Where its files are, and how they are made.
#pragma once

#include <filesystem>

#include "family/family.h"

namespace interleaf {

/// The folder of the built-in family: ../share/interleaf/families/five-keys seen from the executable when it
/// is installed, assets/families/five-keys of the source tree otherwise.
std::filesystem::path builtin_family_folder();

/// Makes the built-in family: the keys icosahedron, bone, cushion, star and sphere at the corners and the
/// middle of a square domain of four triangles, and a timeline that goes round all five along edges of the
/// domain.
Family make_five_keys();

}  // namespace interleaf
