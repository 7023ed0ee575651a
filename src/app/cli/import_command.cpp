#include "app/cli/import_command.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/error_message.h"
#include "app/cli/held_interrupts.h"
#include "app/cli/output.h"
#include "app/cli/progress_line.h"
#include "family/origin.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "io/family/family_file.h"

namespace interleaf {
namespace {

using Json = nlohmann::ordered_json;

/// \throw Cancelled  when an interrupt is waiting
ImportedSeries import_files(const ImportOptions& options, const SeriesFiles& series,
                            const HeldInterrupts& interrupts) {
    ProgressLine line;
    return import_series(series, family_name_for(options.output), options.choices,
                         [&](std::string_view stage, double part) {
                             line.show(stage, part);
                             if (interrupts.is_waiting()) throw Cancelled();
                         });
}

Json json_of(const SeriesFiles& series, const ImportedSeries& imported) {
    Json steps = Json::array();
    for (std::size_t step = 0; step < series.files.size(); ++step) {
        const StepReport& report = imported.report.steps[step];
        steps.push_back({{"file", series.files[step].string()},
                         {"time", imported.family.timeline->keys()[step].time},
                         {"triangles", report.triangles},
                         {"leaves", report.leaves},
                         {"largest_difference", report.largest_difference},
                         {"distance", report.distance},
                         {"integral_error", report.integral_error},
                         {"moved_widths", report.moved_widths},
                         {"point_motion", report.point_motion},
                         {"surface_motion", report.surface_motion}});
    }
    return {{"method", name_of(imported.report.method)},
            {"roots", imported.report.root_count},
            {"notes", imported.report.notes},
            {"steps", steps}};
}

void print_steps(const SeriesFiles& series, const ImportedSeries& imported) {
    fmt::print("{} steps over {} roots, method: {}\n", series.files.size(), imported.report.root_count,
               name_of(imported.report.method));
    for (std::size_t step = 0; step < series.files.size(); ++step) {
        const StepReport& report = imported.report.steps[step];
        fmt::print(
            "{}: time {}, {} triangles, {} leaves, largest difference {:.3g} %{}\n",
            series.files[step].filename().string(), imported.family.timeline->keys()[step].time,
            report.triangles, report.leaves, 100 * report.largest_difference,
            imported.report.method == SeriesMethod::by_fitting
                ? fmt::format(", {:.3g} % of the box diagonal from the mesh; until the next step, "
                              "points move {:.3g} %, the surface {:.3g} %",
                              100 * report.distance, 100 * report.point_motion, 100 * report.surface_motion)
                : "");
    }
}

}  // namespace

void run_import(const ImportOptions& options) {
    if (options.output == "-") throw UsageError("import: -o must name a folder");
    const SeriesFiles series = every_step(series_files(options.series), options.every);
    const HeldInterrupts interrupts;
    ImportedSeries imported;
    try {
        imported = import_files(options, series, interrupts);
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
    write_family(imported.family, options.output, options.form);
    for (const std::string& note : imported.report.notes)
        print_error(fmt::format("{}: {}", options.series.front().string(), note));
    if (imported.family.origin != glm::dvec3(0))
        print_error(fmt::format("{}: {}", options.output, origin_sentence(imported.family.origin)));
    if (options.json)
        fmt::print("{}\n", json_of(series, imported).dump(2, ' ', false, Json::error_handler_t::replace));
    else
        print_steps(series, imported);
}

}  // namespace interleaf
