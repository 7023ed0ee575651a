#include "app/cli/lod_command.h"

#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/cli/error_message.h"
#include "app/cli/held_interrupts.h"
#include "app/cli/output.h"
#include "app/cli/progress_line.h"
#include "app/document/opening.h"
#include "hierarchy/detail/cut.h"
#include "hierarchy/detail/vertex_errors.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"
#include "hierarchy/progress.h"
#include "io/family/family_file.h"
#include "io/formats.h"
#include "text/shown_text.h"
#include "ui/widgets/number_text.h"

namespace interleaf {
namespace {

void check_limits(const LodOptions& options) {
    if (options.leaves.has_value() == options.tolerance.has_value())
        throw UsageError("lod: expected --leaves or --tolerance, one of them");
    if (options.tolerance && !(*options.tolerance >= 0))
        throw UsageError(
            fmt::format("--tolerance: expected a number that is not negative, got {}", *options.tolerance));
}

/// Diagonal of the box of \p key, in double precision: it may exceed the range of floats.
double box_diagonal_of(const Hierarchy& key) {
    const Box box = bounding_box(key.positions);
    return glm::distance(glm::dvec3(box.min), glm::dvec3(box.max));
}

struct CutKey {
    Hierarchy hierarchy;
    std::string report;  ///< one line about it
};

CutKey cut_key(const Hierarchy& key, const LodOptions& options, const DetailProgress& progress) {
    const std::vector<float> errors = vertex_errors(key, progress);
    const CutSizes sizes(key, errors);
    const double diagonal = box_diagonal_of(key);
    const float threshold =
        options.leaves ? sizes.threshold(*options.leaves) : static_cast<float>(*options.tolerance * diagonal);
    CutKey result{cut(key, errors, threshold), {}};
    const double distance = diagonal > 0 ? sizes.distance(threshold) / diagonal : 0;
    result.report =
        fmt::format("{} of {} leaves, at most {:.3g} % of the box diagonal from the key",
                    grouped(result.hierarchy.leaf_count()), grouped(key.leaf_count()), 100 * distance);
    return result;
}

/// Cuts all keys of \p family.
/// \return a line about each
/// \throw Cancelled if the user interrupts
std::vector<std::string> cut_keys(Family& family, const LodOptions& options,
                                  const HeldInterrupts& interrupts) {
    std::size_t all = 0;
    for (const Key& key : family.keys) all += key.hierarchy->leaf_count();
    ProgressLine line;
    std::vector<std::string> reports;
    reports.reserve(family.keys.size());
    std::size_t done = 0;
    for (Key& key : family.keys) {
        const std::size_t leaves = key.hierarchy->leaf_count();
        const std::string name = shown_text(key.name);
        CutKey result = cut_key(*key.hierarchy, options, [&](double part) {
            const double leaves_done = static_cast<double>(done) + part * static_cast<double>(leaves);
            line.show(name, leaves_done / static_cast<double>(all));
            if (interrupts.is_waiting()) throw Cancelled();
        });
        done += leaves;
        key.hierarchy = std::move(result.hierarchy);
        reports.push_back(fmt::format("{}: {}", name, result.report));
    }
    return reports;
}

/// Writes the only key of \p family to a file.
void write_key(const Family& family, const LodOptions& options) {
    write_output(key_target_of(options.output),
                 serialize_hierarchy(*family.keys.front().hierarchy, options.form));
    for (const std::string& sentence : lost_offsets(*format_with_extension(".ilh"), family))
        print_error(fmt::format("{}: {}", options.output, sentence));
}

}  // namespace

void run_lod(const LodOptions& options) {
    check_limits(options);
    Opening opened = open_files(std::span(&options.input, 1));
    if (const auto* const series = std::get_if<SeriesToImport>(&opened)) opened = import_steps(*series);
    const auto* const keys = std::get_if<OpenedKeys>(&opened);
    const bool is_key = keys != nullptr && keys->family.keys.size() == 1;
    std::vector<std::string> changes;
    Family family = family_of(std::move(opened), &changes);
    if (is_key)
        key_target_of(options.output);
    else if (options.output == "-")
        throw UsageError("lod: -o must name a folder for a family");
    const Index roots = family.keys.front().hierarchy->roots.triangle_count();
    if (options.leaves && *options.leaves < roots)
        throw UsageError(
            fmt::format("--leaves: {} leaves are too few: there are {} roots", *options.leaves, roots));

    const HeldInterrupts interrupts;
    std::vector<std::string> reports;
    try {
        reports = cut_keys(family, options, interrupts);
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
    if (is_key)
        write_key(family, options);
    else
        write_family(family, options.output, options.form);
    for (const std::string& change : changes) print_error(change);
    if (options.output == "-") return;
    for (const std::string& report : reports) fmt::print("{}\n", report);
}

}  // namespace interleaf
