#include "app/document/document.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "family/family_time.h"

namespace interleaf {

Document::Document(Family family, std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {
    states_.push_back({"", std::make_shared<const Family>(std::move(family)), std::nullopt});
}

std::shared_ptr<const Family> Document::family_to_save() const {
    const auto& [step, family, source] = states_[current_];
    if (!source || !has_source(*family, *source)) return family;
    return std::make_shared<const Family>(with_time_source(*family, *source));
}

void Document::drive_in_this_run(TimeSource source) {
    State& state = states_[current_];
    auto driven = std::make_shared<const Family>(with_time_source(*state.family, source));
    if (!state.source_to_save) state.source_to_save = state.family->time_source;
    state.family = std::move(driven);
}

void Document::edit(std::string step, Family family) {
    if (saved_ && *saved_ > current_) saved_.reset();
    states_.resize(current_ + 1);
    states_.push_back({std::move(step), std::make_shared<const Family>(std::move(family)),
                       states_[current_].source_to_save});
    ++current_;
}

void Document::amend(Family family) {
    assert(current_ > 0 && current_ + 1 == states_.size());
    if (saved_ == current_) saved_.reset();
    states_[current_].family = std::make_shared<const Family>(std::move(family));
}

void Document::retract() {
    assert(current_ > 0 && current_ + 1 == states_.size());
    if (saved_ == current_) saved_.reset();
    states_.pop_back();
    --current_;
}

const std::string* Document::undo_step() const {
    return current_ > 0 ? &states_[current_].step : nullptr;
}

const std::string* Document::redo_step() const {
    return current_ + 1 < states_.size() ? &states_[current_ + 1].step : nullptr;
}

void Document::undo() {
    if (current_ > 0) --current_;
}

void Document::redo() {
    if (current_ + 1 < states_.size()) ++current_;
}

void Document::mark_saved(const std::shared_ptr<const Family>& family, std::filesystem::path folder) {
    const auto state = std::ranges::find(states_, family, &State::family);
    saved_.reset();
    if (state != states_.end()) saved_ = static_cast<std::size_t>(state - states_.begin());
    folder_ = std::move(folder);
}

}  // namespace interleaf
