// `interleaf family --adapt`: a family over an adaptive parameter domain (paper, section 6).
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/hierarchy/hierarchy_file.h"
#include "shapes/shapes.h"

namespace interleaf {

/// The range of a constant of a shape, an axis of the domain.
struct ConstantRange {
    std::string name;
    double low;
    double high;
};

struct AdaptOptions {
    std::string shape;
    std::vector<ConstantRange> ranges;  ///< two
    std::optional<double> tolerance;    ///< largest distance, as a fraction of the box diagonal of the family
};

/// The shapes that can be computed at any values of their constants: the shapes with constants, and the ball in
/// the flow, whose constants are the time and the strength of the flow.
std::span<const Shape> parametric_shapes();

/// Makes the family and writes it into \p folder. Prints the number of keys. Shows progress on a terminal.
/// \throw UsageError, InputError, MachineError
void run_adapt(const AdaptOptions& options, const std::filesystem::path& folder,
               const HierarchyFileOptions& form);

}  // namespace interleaf
