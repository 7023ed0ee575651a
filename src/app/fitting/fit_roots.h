// The named roots over which meshes can be fitted, the same for the command line and the window.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "family/family.h"
#include "fit/sphere_map/sphere_roots.h"

namespace interleaf {

struct NamedRoots {
    std::string name;  ///< "cube"
    SphereRoots roots;
};

/// The cube, which is the best choice in general, the icosahedron and the octahedron.
const std::vector<NamedRoots>& named_roots();

/// The roots called \p name; null if there are none.
const NamedRoots* find_roots(std::string_view name);

/// Roots over which keys for \p family must be fitted: the named roots that the family has, or the roots of
/// the first key that can be projected to the sphere, named after this key.
/// \throw InputError if there is no such key, with the reason
NamedRoots roots_of(const Family& family);

}  // namespace interleaf
