// The sequence "catenoid": a film between two rings that minimizes its area by mean curvature flow
// (area_flow.h). It begins as a cylinder. Up to a distance of 1.3255 radii between the rings it becomes the
// catenoid; farther apart there is none, and the film collapses.
#pragma once

#include "sequence/sequence.h"

namespace interleaf {

struct CatenoidOptions {
    SequenceOptions steps;

    /// Distance between the rings, whose radius is 1; 0.2 to 3.
    double distance = 1;
};

/// The film tears when its neck gets as narrow as this radius. A sequence that collapses ends there.
inline constexpr double narrowest_neck = 0.1;

/// Makes the sequence. The rings are horizontal; the axis through their centers is the y axis.
///
/// The sequence ends when the film stands still, or when its neck is as narrow as narrowest_neck. A first run
/// finds that time. The unit of time is a second where the film moves at the speed of its principal
/// curvatures' sum.
///
/// The error of an edge is the height of the arc over it, from the turn of the normal between its ends. So
/// the mesh is fine where the curvature is high. New vertices on a ring are placed on the ring, others on the
/// arc over the middle of their edge (the cubic of Vlachos, Peters, Boyd, Mitchell, "Curved PN Triangles",
/// 2001). Each key has the scalar field "mean curvature", positive on the cylinder.
/// \throw UsageError if an option is out of its range
/// \throw InputError if the tolerance needs too many leaves
Family make_catenoid(const CatenoidOptions& options, const SequenceProgress& progress = {});

}  // namespace interleaf
