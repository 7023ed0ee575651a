// Welds the points of a step that are one vertex of its mesh, and collects the values of the fields there.
#pragma once

#include <string>
#include <vector>

#include "sequence/series/step_mesh.h"

namespace interleaf {

/// A mesh with the points, triangles and values of \p mesh. Equal points are one, up to the rounding to six
/// digits where edges are longer than that. Points of no triangle are left out. Welded points get one value:
/// the mean where theirs differ by more than rounding.
///
/// The neighbors, the orientation and the hanging vertex are not set.
/// \param notes  receives a sentence per field whose values differ
/// \throw InputError  naming the place, where numbers are not finite, indices are out of range, or corners of a
///     triangle coincide
StepMesh weld(const FieldMesh& mesh, const SeriesFields& fields, std::vector<std::string>& notes);

}  // namespace interleaf
