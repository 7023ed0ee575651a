// Figures of a scalar field over the surface of a key, for plots over time.
#pragma once

#include "hierarchy/field.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

struct FieldFigures {
    double integral = 0;  ///< over the leaves, where the field is linear
    double least = 0;
    double most = 0;
};

/// \param field   a scalar of \p key
/// \param offset  is added to all values (field_scale.h)
FieldFigures figures_of(const Hierarchy& key, const Field& field, double offset = 0);

}  // namespace interleaf
