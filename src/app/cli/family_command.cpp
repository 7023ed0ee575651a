#include "app/cli/family_command.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/cli/error_message.h"
#include "app/document/opening.h"
#include "family/key_edits.h"
#include "hierarchy/error.h"
#include "io/family/family_file.h"

namespace interleaf {

namespace {

/// The timeline's interpolation with what \p options change.
Interpolation interpolation_of(const Family& family, const FamilyOptions& options) {
    if (!family.timeline) throw UsageError("--interpolation, --degree: the family has no timeline");
    Interpolation interpolation = family.timeline->interpolation();
    if (options.basis) interpolation = {.basis = *options.basis};
    if (options.degree && interpolation.basis != Basis::bernstein)
        throw UsageError("--degree: only the interpolation bernstein has a degree");
    if (options.degree) interpolation.degree = *options.degree;
    return interpolation;
}

void make_adapted(const FamilyOptions& options) {
    if (!options.keys.empty()) throw UsageError("--adapt: it makes its own keys, so no KEY is taken");
    if (options.basis || options.degree)
        throw UsageError("--adapt: the family has no timeline for --interpolation and --degree");
    if (options.blend)
        throw UsageError("--adapt: it chooses keys for straight blends, so no --blend is taken");
    run_adapt(options.adapt, options.output, options.form);
}

}  // namespace

void run_family(const FamilyOptions& options) {
    if (!options.adapt.shape.empty()) return make_adapted(options);
    if (!options.adapt.ranges.empty() || options.adapt.tolerance)
        throw UsageError("--range, --tolerance: they are for --adapt");
    if (options.keys.empty()) throw UsageError("family: KEY is required, or --adapt");
    std::vector<std::string> changes;
    Family family = open_family(options.keys, &changes);
    if (options.basis || options.degree) {
        const Interpolation interpolation = interpolation_of(family, options);
        family = with_interpolation(std::move(family), interpolation);
    }
    if (options.blend) family.blend = *options.blend;
    try {
        for (const auto& [field, unit] : options.units)
            family = with_field_unit(std::move(family), field, unit);
        if (options.time_unit) family = with_time_unit(std::move(family), *options.time_unit);
    } catch (const InputError& error) {
        throw UsageError(fmt::format("--unit, --time-unit: {}", error.what()));
    }
    write_family(family, options.output, options.form);
    for (const std::string& change : changes) print_error(change);
}

}  // namespace interleaf
