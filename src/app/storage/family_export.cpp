#include "app/storage/family_export.h"

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/shown_text.h"
#include <fmt/core.h>

#include "hierarchy/progress.h"
#include "io/formats.h"
#include "ui/dialogs/progress_dialog.h"

namespace interleaf {
namespace {

/// Exports that take less show no progress: a dialog would only flicker.
constexpr double least_shown_time = 0.4;  // seconds

/// \return what the format holds only approximately, or otherwise, one sentence each
std::vector<std::string> remarks_of_export(const Family& family, const Weights& weights,
                                           const std::filesystem::path& file, const Progress& progress) {
    std::vector<std::string> remarks;
    const Format& format = *find_format(file);
    format.write({.family = family, .weights = weights, .remarks = &remarks, .progress = progress}, {file});
    for (std::string& sentence : lost_offsets(format, family)) remarks.push_back(std::move(sentence));
    return remarks;
}

std::string shown_file(const std::filesystem::path& file) {
    return shown_name(file.filename().string());
}

}  // namespace

void FamilyExport::begin(std::shared_ptr<const Family> family, Weights weights, std::filesystem::path file,
                         double now) {
    if (work_) work_->written.wait();
    auto report = std::make_shared<Report>();
    const Progress progress = [report](std::string_view stage, double part) {
        const std::lock_guard lock(report->mutex);
        report->stage = stage;
        report->part = part;
        return !report->is_cancelled;
    };
    auto written = std::async(std::launch::async,
                              [family = std::move(family), weights = std::move(weights), file, progress] {
                                  return remarks_of_export(*family, weights, file, progress);
                              });
    work_.emplace(Work{std::move(file), std::move(report), std::move(written), now});
}

void FamilyExport::show(const Rect& area, double now) {
    if (!work_) return;
    const bool is_done = work_->written.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!is_done && now - work_->started > least_shown_time) work_->is_shown = true;
    if (!work_->is_shown) return;
    ProgressShown shown{.title = fmt::format("Exporting {}", shown_file(work_->file)),
                        .stage = {},
                        .part = 0,
                        .seconds = now - work_->started};
    {
        const std::lock_guard lock(work_->report->mutex);
        shown.stage = work_->report->is_cancelled ? "cancelling" : work_->report->stage;
        shown.part = work_->report->part;
    }
    if (progress_dialog(shown, area, is_done)) cancel();
    work_->is_closed = is_done;
}

void FamilyExport::cancel() {
    if (!work_) return;
    const std::lock_guard lock(work_->report->mutex);
    work_->report->is_cancelled = true;
}

std::optional<Message> FamilyExport::take_result(double now) {
    if (!work_ || work_->is_shown != work_->is_closed ||
        work_->written.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    Work work = *std::exchange(work_, std::nullopt);
    std::string text =
        fmt::format("Exported {} in {}", shown_file(work.file), shown_name(work.file.parent_path().string()));
    try {
        for (const std::string& remark : work.written.get()) text += "\n" + remark;
    } catch (const Cancelled&) {
        return Message{.text = fmt::format("Export of {} cancelled", shown_file(work.file)),
                       .kind = MessageKind::notice,
                       .seen = now};
    } catch (const std::exception& error) {
        return Message{.text = cause_of(error)};
    }
    return Message{.text = std::move(text), .kind = MessageKind::notice, .seen = now};
}

}  // namespace interleaf
