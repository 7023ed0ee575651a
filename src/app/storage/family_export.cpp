#include "app/storage/family_export.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "text/shown_text.h"
#include <fmt/core.h>

#include "family/origin.h"
#include "io/formats.h"

namespace interleaf {
namespace {

/// \return what the format holds only approximately, or otherwise, one sentence each
std::vector<std::string> remarks_of_export(const Family& family, const Weights& weights,
                                           const std::filesystem::path& file) {
    std::vector<std::string> remarks;
    const Format& format = *find_format(file);
    format.write({.family = family, .weights = weights, .remarks = &remarks}, {file});
    if (!format.written->origin && family.origin != glm::dvec3(0))
        remarks.push_back(origin_sentence(family.origin));
    return remarks;
}

}  // namespace

void FamilyExport::begin(std::shared_ptr<const Family> family, Weights weights, std::filesystem::path file) {
    auto written =
        std::async(std::launch::async, [family = std::move(family), weights = std::move(weights), file] {
            return remarks_of_export(*family, weights, file);
        });
    work_.emplace(Work{std::move(file), std::move(written)});
}

std::optional<Message> FamilyExport::take_result(double now) {
    if (!work_ || work_->written.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    Work work = *std::exchange(work_, std::nullopt);
    std::string text = fmt::format("Exported {}", shown_name(work.file.filename().string()));
    try {
        for (const std::string& remark : work.written.get()) text += "\n" + remark;
    } catch (const std::exception& error) {
        return Message{.text = cause_of(error)};
    }
    return Message{.text = std::move(text), .kind = MessageKind::notice, .seen = now};
}

}  // namespace interleaf
