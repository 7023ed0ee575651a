// The parameter domain (paper, figure 8): its triangles coloured by barycentric weight, and the point to
// drag.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "family/family.h"
#include "ui/rect.h"

namespace interleaf {

struct ParameterDomainResult {
    std::optional<glm::dvec2> moved_to;  ///< where the pointer holds the point; may be outside the domain
    Rect plot;                           ///< the pixels of the bounding box of the domain's vertices
};

/// \param point  where the morph stands, if anywhere
/// \param path   the points the timeline passes, in their order
/// \pre   the family has a domain
ParameterDomainResult parameter_domain_panel(const Family& family, const std::optional<DomainPoint>& point,
                                             std::span<const glm::dvec2> path);

}  // namespace interleaf
