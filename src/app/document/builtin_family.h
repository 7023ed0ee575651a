// The built-in family: the five keys of the paper's figure 8, the folder of its files, and its construction.
#pragma once

#include <filesystem>

#include "family/family.h"

namespace interleaf {

/// The folder of the built-in family: ../share/interleaf/families/five-keys relative to an installed
/// executable, assets/families/five-keys of the source tree otherwise.
std::filesystem::path builtin_family_folder();

/// Makes the built-in family. Its keys icosahedron, bone, cushion, star and sphere are at the corners and the
/// middle of a square domain of four triangles. Its timeline visits all five along edges of the domain.
Family make_five_keys();

}  // namespace interleaf
