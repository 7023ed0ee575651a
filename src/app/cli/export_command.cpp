#include "app/cli/export_command.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/cli/error_message.h"
#include "app/cli/held_interrupts.h"
#include "app/cli/progress_line.h"
#include "app/document/opening.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "io/export/time_list.h"
#include "io/formats.h"
#include "io/text/joined_text.h"

namespace interleaf {

void run_export(const ExportOptions& options) {
    const std::string name = format_of(options.output, format_names(&Format::is_exported));
    const Format& format = *format_with_extension("." + name);
    if (options.form.compressed && !format.is_exported_key())
        throw UsageError(fmt::format("--compress: expected the format {}, got '{}'",
                                     either_of(format_names(&Format::is_exported_key)), name));
    if (options.segments && name != "glb")
        throw UsageError(fmt::format("--segments: expected the format glb, got '{}'", name));
    if ((options.series.has_times() || !options.times.empty() || options.series.mesh) && name != "pvd")
        throw UsageError(
            fmt::format("--fps, --every, --times and --union: expected the format pvd, got '{}'", name));
    if (options.series.frames_per_second.has_value() + options.series.time_step.has_value() +
            !options.times.empty() >
        1)
        throw UsageError("--fps, --every and --times exclude each other");
    SeriesExportOptions series = options.series;
    if (!options.times.empty()) series.times = read_times(options.times);
    const Family family = open_family(options.morph.family);
    std::vector<std::string> remarks;
    const HeldInterrupts interrupts;
    try {
        ProgressLine line;
        format.write({.family = family,
                      .weights = chosen_weights(options.morph, family),
                      .form = options.form,
                      .series = series,
                      .segments = options.segments,
                      .remarks = &remarks,
                      .progress =
                          [&](std::string_view stage, double part) {
                              line.show(stage, part);
                              return !interrupts.is_waiting();
                          }},
                     target_of(options.output));
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
    for (const std::string& remark : remarks)
        print_error(fmt::format("{}: {}", options.output.target, remark));
    for (const std::string& sentence : lost_offsets(format, family))
        print_error(fmt::format("{}: {}", options.output.target, sentence));
}

}  // namespace interleaf
