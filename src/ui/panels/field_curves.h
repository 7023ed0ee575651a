// Curves of a field over time: its integral, and its least and largest values.
#pragma once

#include <string>
#include <vector>

namespace interleaf {

/// The figures of a field at the keys of a timeline. All arrays have equal sizes.
struct FieldCurves {
    std::vector<double> times;  ///< ascending
    std::vector<double> integrals;
    std::vector<double> least;
    std::vector<double> most;
    std::string unit{};       ///< of the field; empty if unknown
    std::string time_unit{};  ///< of the times; empty for steps
};

/// Shows the curves, as wide as the current panel, with a line at \p time. Shows nothing for fewer than two times.
void field_curves(const FieldCurves& curves, double time);

}  // namespace interleaf
