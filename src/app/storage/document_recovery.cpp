#include "app/storage/document_recovery.h"

#include <ctime>
#include <utility>

#include <fmt/chrono.h>

namespace interleaf {

namespace {

/// How long a document must stay unchanged before its autosave; seconds.
constexpr double autosave_rest = 1;

}  // namespace

DocumentRecovery::DocumentRecovery(const std::filesystem::path& state_folder, const Document& document)
    : autosave_(state_folder), seen_(document.snapshot()), abandoned_(abandoned_recoveries(state_folder)) {}

std::optional<Recovery> DocumentRecovery::claim_offered() {
    const Recovery offered = abandoned_.front();
    abandoned_.clear();
    return claim_recovery(offered);
}

void DocumentRecovery::discard_offered() {
    const Recovery offered = abandoned_.front();
    abandoned_.erase(abandoned_.begin());
    if (const auto claimed = claim_recovery(offered)) discard_recovery(*claimed);
}

void DocumentRecovery::adopt(Recovery claimed) {
    autosave_.adopt(std::move(claimed));
}

void DocumentRecovery::look_after(const Document& document, bool is_dragging, double now) {
    const auto present = document.snapshot();
    if (present != seen_) {
        seen_ = present;
        seen_since_ = now;
    }
    if (present == autosaved_ || is_dragging || now - seen_since_ < autosave_rest) return;
    autosaved_ = present;
    if (document.is_changed()) {
        autosave_.write(document.family_to_save(), document.folder().value_or(std::filesystem::path()));
    } else {
        autosave_.clear();  // undo has returned to the saved state
    }
}

void DocumentRecovery::keep(const Document& document) {
    if (!document.is_changed()) return;
    autosaved_ = document.snapshot();
    autosave_.write(document.family_to_save(), document.folder().value_or(std::filesystem::path()));
}

void DocumentRecovery::forget(const Document& document) {
    autosaved_ = document.snapshot();
    autosave_.clear();
}

Question question_about(const RecoveryNote& note) {
    const std::string when =
        note.time == 0
            ? ""
            : fmt::format(", as of {:%Y-%m-%d %H:%M}", fmt::localtime(static_cast<std::time_t>(note.time)));
    return {.text = fmt::format("Recover {}?", note.name),
            .detail = fmt::format("Interleaf ended while it had changes that were not saved{}.", when),
            .buttons = {"Recover", "Discard", "Later"},
            .entry = {},
            .fault = {}};
}

}  // namespace interleaf
