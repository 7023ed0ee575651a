// Edits of a parameter domain (paper, section 4.2). Each returns a changed domain. Like every
// ParameterDomain, the result is a valid triangulation of the region it covers.
#pragma once

#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "family/parameter_domain.h"

namespace interleaf {

/// The domain with \p vertex moved to \p to. If triangles would turn over or overlap there, the vertex stops
/// before that on its straight path.
ParameterDomain with_vertex_moved(const ParameterDomain& domain, Index vertex, glm::dvec2 to);

/// The domain with another vertex for \p key at \p at; it becomes the last vertex.
///
/// An edge nearer than \p snap is split together with its triangles, so that the vertex lies on it. Otherwise
/// the triangle around the point is split into three. A point farther outside gets a triangle over the
/// nearest boundary edge that faces it.
/// \param snap  a distance in domain units
/// \throw InputError if a vertex is nearer than \p snap, if the point is not finite, or if the result is no
///     valid triangulation
ParameterDomain with_vertex_added(const ParameterDomain& domain, glm::dvec2 at, std::size_t key, double snap);

/// The domain without \p vertex: other triangles of its neighbors replace those around it. If the vertex is
/// at a corner of the domain, the region that only its triangles covered is no longer covered. Vertices that
/// then belong to no triangle are removed, too.
/// \return the domain; none if it has no triangles left
/// \throw InputError if the neighbors cannot be triangulated
std::optional<ParameterDomain> without_vertex(const ParameterDomain& domain, Index vertex);

/// The domain with \p key at \p vertex.
ParameterDomain with_vertex_key(const ParameterDomain& domain, Index vertex, std::size_t key);

}  // namespace interleaf
