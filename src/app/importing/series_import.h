// Imports a series of meshes, one file per time step, as a family with a timeline, for the window and the command line.
// Keys of bisected meshes are recovered (sequence/series); to closed surfaces that are meshed anew, keys are fitted
// (fitted_series.h).
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "family/family.h"
#include "family/field_units.h"
#include "io/series_files.h"
#include "sequence/series/series.h"

namespace interleaf {

/// The positions of flat keys move across their plane, by a factor times a field.
struct ChosenWarp {
    std::string field;
    double factor = 1;

    bool operator==(const ChosenWarp&) const = default;
};

struct ImportChoices {
    std::optional<double> tolerance{};  ///< SeriesOptions::tolerance
    std::optional<unsigned> newest{};   ///< SeriesOptions::newest
    std::vector<std::string> fields{};  ///< point fields that the keys get; all if empty
    std::string displacement{};         ///< point field that is added to the points; none if empty
    std::optional<ChosenWarp> warp{};
    std::vector<NamedUnit> units{};  ///< of scalars of the keys, in place of those in the files
    std::string time_unit{};         ///< of the times; empty if unknown

    /// Only the steps 0, every, 2 every, ... are imported. import_work() leaves out the others; callers of
    /// import_series() do so by every_step().
    std::size_t every = 1;

    std::filesystem::path roots{};  ///< a key whose roots are those of all keys; none if empty

    bool operator==(const ImportChoices&) const = default;
};

struct ImportedSeries {
    /// One key per step, named as its file, at the time of the step: that of the list of files; or the time that each
    /// file has, if all of several files have one and these increase; or else as series_files()
    Family family;
    SeriesReport report;
};

/// The steps 0, \p every, 2 \p every, ... of \p series.
/// \throw UsageError if \p every is 0
SeriesFiles every_step(const SeriesFiles& series, std::size_t every);

/// Imports \p series. Positions far from 0 get an origin (family/origin.h), that of the first step. Scalars far from
/// 0 get an offset (family/field_scale.h), that of the first, the middle and the last step. Where no fields are
/// chosen, a note of the report names the fields of cells, which are left out.
/// \param name      of the family
/// \param progress  as SeriesProgress; it may throw to end the work
/// \throw InputError    naming the file, the place and what would help
/// \throw UsageError    if a choice is out of its range
/// \throw MachineError  if a file cannot be read
ImportedSeries import_series(const SeriesFiles& series, std::string_view name, const ImportChoices& choices,
                             const SeriesProgress& progress);

}  // namespace interleaf
