// An adaptive parameter domain (paper, section 6): the domain is bisected by the same rule as the surfaces, and
// gets a key at each new vertex, until the blend is near enough to the surface that it stands for everywhere.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "family/family.h"
#include "family/parameter_domain.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// A family of surfaces that can be computed at any parameter.
struct ComputedSurfaces {
    /// The key at \p parameter. All keys have the same roots.
    std::function<Key(const glm::dvec2& parameter)> key;

    /// The distance of a blend from the surface at \p parameter, in units of the tolerance.
    std::function<double(const glm::dvec2& parameter, const UnionMesh& mesh,
                         std::span<const glm::vec3> positions)>
        distance;
};

struct AdaptiveDomainOptions {
    DomainBox box;                 ///< the rectangle of parameters; neither side is 0
    std::size_t max_keys = 1'000;  ///< more keys are refused
};

/// Receives the number of keys so far. It may throw to end the work. An empty function is never called.
using AdaptiveDomainProgress = std::function<void(std::size_t keys)>;

/// The family whose domain is the rectangle, bisected until the distance is at most 1 at all parameters that are
/// tried: in each triangle, those of a regular grid. Between them the distance may be a little larger; a margin
/// allows for it.
///
/// The domain begins with two triangles. The family has no timeline.
/// \throw InputError if more than the maximum number of keys would be needed
Family adapt_domain(const ComputedSurfaces& surfaces, const AdaptiveDomainOptions& options,
                    const AdaptiveDomainProgress& progress = {});

}  // namespace interleaf
