#include "app/fitting/fit_roots.h"

#include <algorithm>

#include <fmt/core.h>

#include "hierarchy/cube.h"
#include "hierarchy/error.h"
#include "shapes/icosahedron.h"

namespace interleaf {

const std::vector<NamedRoots>& named_roots() {
    static const std::vector<NamedRoots> all{{"cube", project_to_sphere(cube())},
                                             {"icosahedron", project_to_sphere(icosahedron())},
                                             {"octahedron", project_to_sphere(octahedron())}};
    return all;
}

const NamedRoots* find_roots(std::string_view name) {
    const auto found = std::ranges::find(named_roots(), name, &NamedRoots::name);
    return found == named_roots().end() ? nullptr : &*found;
}

NamedRoots roots_of(const Family& family) {
    const RootComplex& complex = family.keys.front().hierarchy->roots;
    for (const NamedRoots& named : named_roots())
        if (named.roots.complex == complex) return named;
    std::string fault;
    for (const Key& key : family.keys) {
        try {
            return {key.name, project_to_sphere(*key.hierarchy)};
        } catch (const InputError& error) {
            if (fault.empty()) fault = error.what();
        }
    }
    throw InputError(fmt::format("meshes cannot be fitted over the roots of {}: {}", family.name, fault));
}

}  // namespace interleaf
