// The roots that meshes can be fitted over, by their names: the command line and the window offer the same.
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

/// The cube, which is the best in general, the icosahedron, the octahedron.
const std::vector<NamedRoots>& named_roots();

/// The one called \p name; null when there is none.
const NamedRoots* find_roots(std::string_view name);

/// Roots over which fitted keys go into \p family: the named ones that it has, or those of its first key that
/// can be projected to the sphere, called as this key is.
/// \throw InputError saying why not, where there is no such key
NamedRoots roots_of(const Family& family);

}  // namespace interleaf
