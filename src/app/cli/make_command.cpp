#include "app/cli/make_command.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "app/cli/adapt_command.h"
#include "app/cli/held_interrupts.h"
#include "app/cli/progress_line.h"
#include "app/document/builtin_family.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "io/family/family_file.h"
#include "io/text/joined_text.h"
#include "sequence/catenoid.h"
#include "sequence/flow.h"

namespace interleaf {
namespace {

constexpr std::string_view family_name = "five-keys";

/// An evolution that can be made by name.
struct SequenceMaker {
    std::string_view name;
    std::string_view description;  ///< one line, for users
    bool has_distance;             ///< whether --distance fits
    Family (*make)(const MakeOptions& options, const SequenceOptions& steps,
                   const SequenceProgress& progress);
};

Family flow_of(const MakeOptions&, const SequenceOptions& steps, const SequenceProgress& progress) {
    return make_flow(steps, progress);
}

Family catenoid_of(const MakeOptions& options, const SequenceOptions& steps,
                   const SequenceProgress& progress) {
    CatenoidOptions catenoid{.steps = steps};
    catenoid.distance = options.distance.value_or(catenoid.distance);
    return make_catenoid(catenoid, progress);
}

constexpr std::array sequences = {
    SequenceMaker{"flow", "a folder with a sequence: a ball in a flow that deforms it and turns back", false,
                  flow_of},
    SequenceMaker{"catenoid", "a folder with a sequence: a film between two rings minimizes its area", true,
                  catenoid_of},
};

/// "flow or catenoid": the sequences, or those that have a distance.
std::string sequences_in_words(bool with_distance) {
    std::vector<std::string> names;
    for (const SequenceMaker& sequence : sequences)
        if (sequence.has_distance || !with_distance) names.emplace_back(sequence.name);
    return either_of(names);
}

/// \throw UsageError if an option is only for sequences
void refuse_sequence_options(const MakeOptions& options) {
    if (options.steps || options.distance) {
        throw UsageError(fmt::format("make {}: --{} is for sequences: {}", options.name,
                                     options.steps ? "steps" : "distance", sequences_in_words(false)));
    }
}

void make_family(const MakeOptions& options) {
    refuse_sequence_options(options);
    if (options.budget.leaves || options.budget.tolerance) {
        throw UsageError(fmt::format("make {}: --leaves and --tolerance are for single shapes", family_name));
    }
    if (options.form.compressed)
        throw UsageError(fmt::format("make {}: --compress is for single shapes and sequences", family_name));
    if (options.output == "-") throw UsageError(fmt::format("make {}: -o must name a folder", family_name));
    write_family(make_five_keys(), options.output);
}

void make_sequence(const SequenceMaker& sequence, const MakeOptions& options) {
    if (options.budget.leaves)
        throw UsageError(fmt::format("make {}: --leaves is for single shapes", sequence.name));
    if (options.distance && !sequence.has_distance)
        throw UsageError(
            fmt::format("make {}: --distance is for {}", sequence.name, sequences_in_words(true)));
    if (options.output == "-") throw UsageError(fmt::format("make {}: -o must name a folder", sequence.name));
    SequenceOptions steps;
    steps.steps = options.steps.value_or(steps.steps);
    steps.tolerance = options.budget.tolerance.value_or(steps.tolerance);

    const HeldInterrupts interrupts;
    Family family;
    try {
        ProgressLine line;
        family = sequence.make(options, steps, [&](double part) {
            line.show(sequence.name, part);
            if (interrupts.is_waiting()) throw Cancelled();
        });
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
    write_family(family, options.output, options.form);
}

}  // namespace

void run_make(const MakeOptions& options) {
    if (options.name == family_name) return make_family(options);
    const auto* const sequence =
        std::find_if(sequences.begin(), sequences.end(),
                     [&](const SequenceMaker& candidate) { return candidate.name == options.name; });
    if (sequence != sequences.end()) return make_sequence(*sequence, options);
    const Shape* shape = find_shape(options.name);
    if (shape == nullptr) {
        throw UsageError(fmt::format(
            "make: there is no shape or sequence '{}'; `interleaf make --list` lists them", options.name));
    }
    refuse_sequence_options(options);
    write_output(key_target_of(options.output),
                 serialize_hierarchy(make_key(*shape, options.budget), options.form));
}

void list_shapes() {
    for (const Shape& shape : shapes()) fmt::print("{:<14}{}\n", shape.name, shape.description);
    fmt::print("{:<14}a folder with the built-in family of the first five shapes\n", family_name);
    for (const SequenceMaker& sequence : sequences)
        fmt::print("{:<14}{}\n", sequence.name, sequence.description);
    fmt::print("\nConstants, for `interleaf family --adapt`, with their ranges:\n");
    for (const Shape& shape : parametric_shapes()) {
        fmt::print("{:<14}", shape.name);
        for (const SurfaceConstant& constant : shape.constants)
            fmt::print("{}{} {}:{}", &constant == shape.constants.data() ? "" : ", ", constant.name,
                       constant.low, constant.high);
        fmt::print("\n");
    }
}

}  // namespace interleaf
