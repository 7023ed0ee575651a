#include "app/storage/family_export.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "hierarchy/progress.h"
#include "io/formats.h"
#include "text/shown_text.h"

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
    job_.wait();
    file_ = file;
    job_.start(
        fmt::format("Exporting {}", shown_file(file_)),
        [family = std::move(family), weights = std::move(weights), file = std::move(file)](
            const Progress& progress) { return remarks_of_export(*family, weights, file, progress); },
        now, least_shown_time);
}

std::optional<Message> FamilyExport::take_result(double now) {
    if (!job_.is_over()) return std::nullopt;
    std::string text =
        fmt::format("Exported {} in {}", shown_file(file_), shown_name(file_.parent_path().string()));
    try {
        for (const std::string& remark : job_.take()) text += "\n" + remark;
    } catch (const Cancelled&) {
        return Message{.text = fmt::format("Export of {} cancelled", shown_file(file_)),
                       .kind = MessageKind::notice,
                       .seen = now};
    } catch (const std::exception& error) {
        return Message{.text = cause_of(error)};
    }
    return Message{.text = std::move(text), .kind = MessageKind::notice, .seen = now};
}

}  // namespace interleaf
