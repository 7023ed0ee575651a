#include "app/storage/family_export.h"

#include <chrono>
#include <utility>

#include "text/shown_text.h"
#include <fmt/core.h>

#include "family/origin.h"
#include "io/formats.h"

namespace interleaf {
namespace {

void write_export(const Family& family, const Weights& weights, const std::filesystem::path& file) {
    find_format(file)->write({family, weights, {}}, {file});
}

}  // namespace

void FamilyExport::begin(std::shared_ptr<const Family> family, Weights weights, std::filesystem::path file) {
    auto written = std::async(std::launch::async, [family = std::move(family), weights = std::move(weights),
                                                   file] { write_export(*family, weights, file); });
    work_.emplace(Work{std::move(file), std::move(written)});
}

std::optional<Message> FamilyExport::take_result(double now) {
    if (!work_ || work_->written.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    Work work = *std::exchange(work_, std::nullopt);
    try {
        work.written.get();
    } catch (const std::exception& error) {
        return Message{.text = cause_of(error)};
    }
    return Message{.text = fmt::format("Exported {}", shown_name(work.file.filename().string())),
                   .kind = MessageKind::notice,
                   .seen = now};
}

}  // namespace interleaf
