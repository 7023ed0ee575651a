#include "app/storage/series_importing.h"

#include <exception>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "app/document/message.h"
#include "app/importing/import_job.h"
#include "app/storage/import_offer.h"
#include "hierarchy/progress.h"
#include "io/text/words.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

/// An import that takes less shows no progress: a dialog would only flicker.
constexpr double hidden_import = 0.3;  // seconds

/// The tolerance that \p entry, in percent, stands for; none if it is out of range.
std::optional<double> tolerance_in(const std::string& entry) {
    std::string_view rest = entry;
    const std::optional<double> percent = parse_double(take_word(rest));
    if (!percent || !take_word(rest).empty() || !(*percent >= 0 && *percent <= 100)) return std::nullopt;
    return *percent / 100;
}

}  // namespace

std::string sentences_of(const SeriesReport& report) {
    std::string text = fmt::format("{} steps over {} roots, found by {}.", report.steps.size(),
                                   report.root_count, name_of(report.method));
    for (const std::string& note : report.notes) text += fmt::format("\n{}", note);
    return text;
}

void SeriesImporting::start(std::vector<std::filesystem::path> files, ImportChoices choices,
                            Receiver receiver, double now) {
    files_ = std::move(files);
    receiver_ = std::move(receiver);
    choices_ = std::move(choices);
    begin(now);
}

void SeriesImporting::offer(std::vector<std::filesystem::path> files, const ImportChoices& choices,
                            Receiver receiver) {
    offered_ = import_offer(files);
    files_ = std::move(files);
    receiver_ = std::move(receiver);
    options_.open(dialog_choices(choices, offered_));
}

void SeriesImporting::begin(double now) {
    job_.start(fmt::format("Importing {}", shown_name(files_.front().filename().string())),
               import_work(files_, choices_), now, hidden_import);
}

void SeriesImporting::show(const Rect& area, double now) {
    if (options_.is_open()) {
        offered_.fault = fault_of(options_.choices(), offered_);
        if (const auto is_wanted = options_.show(area, offered_)) is_wanted_ = is_wanted;
    } else if (dialog_.is_open()) {
        if (auto answer = dialog_.show(area)) answer_ = std::move(answer);
    } else {
        job_.show(area, now);
    }
}

std::optional<std::string> SeriesImporting::update(double now) {
    if (const auto is_wanted = std::exchange(is_wanted_, std::nullopt)) {
        choices_ = import_choices(options_.choices(), offered_);
        if (*is_wanted)
            begin(now);
        else
            receiver_ = nullptr;
    }
    if (const auto answer = std::exchange(answer_, std::nullopt)) {
        if (answer->button == 0) {
            choices_.tolerance = tolerance_in(answer->entry);
            begin(now);
        } else {
            receiver_ = nullptr;
        }
    }
    return job_.is_over() ? hand_on_keys() : std::nullopt;
}

/// \pre the work is done
std::optional<std::string> SeriesImporting::hand_on_keys() {
    ImportedSeries imported;
    try {
        imported = job_.take();
    } catch (const Cancelled&) {
        receiver_ = nullptr;
        return std::nullopt;
    } catch (const NeedsTolerance& error) {
        ask_for_tolerance(error.reason);
        return std::nullopt;
    } catch (const std::exception& error) {
        receiver_ = nullptr;
        return cause_of(error);
    }
    std::exchange(receiver_, nullptr)(std::move(imported), choices_);
    return std::nullopt;
}

void SeriesImporting::ask_for_tolerance(const std::string& reason) {
    dialog_.ask(
        {.text = "Sample the fields of the series? Largest difference, in percent of each field's range:",
         .detail =
             fmt::format("No bisections connect its meshes: {}. Sampling makes keys on new triangles; a "
                         "smaller difference needs more of them.",
                         reason),
         .buttons = {"Sample", "Cancel"},
         .entry = fmt::format("{:g}", 100 * NeedsTolerance::usual),
         .fault = [](const std::string& entry) -> std::string {
             return tolerance_in(entry) ? "" : "Expected a number from 0 to 100";
         }});
}

}  // namespace interleaf
