// The sequence "flow": a ball in the deformation flow (deformation_flow.h). Its mesh follows the flow, is
// refined and coarsened after every step by its own error, and is a sphere again at the end.
//
// The roots are the 12 right isosceles triangles of a cube. A new vertex is a point of the sphere, traced
// from time 0 to the present. Midpoints of chords would be no points of the flow: the errors that they bring
// in grow with it, until the number of leaves explodes.
#pragma once

#include "sequence/sequence.h"

namespace interleaf {

/// The period of the flow, in seconds: the ball becomes as thin as meshes of some thousand leaves show well.
inline constexpr double flow_duration = 1.5;

/// Makes the sequence.
///
/// The error of an edge is the distance of its middle from the point of the surface between its ends: the
/// traced point halfway between both on the sphere. Each key has the scalar field "stretch": by which factor
/// a length on the surface has grown at most (surface_stretch.h).
/// \throw UsageError if an option is out of its range
/// \throw InputError if the tolerance needs too many leaves
Family make_flow(const SequenceOptions& options, const SequenceProgress& progress = {});

}  // namespace interleaf
