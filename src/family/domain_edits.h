// Edits of a parameter domain (paper, section 4.2). Each gives a changed domain, which is a valid
// triangulation of what it covers, as every ParameterDomain is.
#pragma once

#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "family/parameter_domain.h"

namespace interleaf {

/// With \p vertex at \p to, or, where triangles would turn over or overlap, as far on the straight way there
/// as they do not.
ParameterDomain with_vertex_moved(const ParameterDomain& domain, Index vertex, glm::dvec2 to);

/// With the last vertex, of \p key, at \p at: the triangle there is split in three; an edge nearer than \p
/// snap, in domain units, is split together with its triangles, the vertex then lying on it; a point further
/// outside than that gets a triangle over the boundary edge it sees nearest. \throw InputError where a vertex
/// is nearer than \p snap, where the point is not finite, or where no valid triangulation comes of it
ParameterDomain with_vertex_added(const ParameterDomain& domain, glm::dvec2 at, std::size_t key, double snap);

/// With the triangles about \p vertex replaced by others of its neighbours; what only triangles at \p vertex
/// covered, at a corner of the domain, is no longer covered. Vertices that then belong to no triangle go with
/// it, and none is left of a domain without triangles.
/// \throw InputError if the neighbours cannot be triangulated
std::optional<ParameterDomain> without_vertex(const ParameterDomain& domain, Index vertex);

/// With \p key at \p vertex.
ParameterDomain with_vertex_key(const ParameterDomain& domain, Index vertex, std::size_t key);

}  // namespace interleaf
