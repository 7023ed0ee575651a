#include "app/document/blend_commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/edit_commands.h"
#include "family/weight_edits.h"

namespace interleaf {

namespace {

/// Difference from 1 that rounding may leave.
constexpr double sum_tolerance = 1e-12;

}  // namespace

void choose_driver(ViewerState& state, Driver driver, double now) {
    if (!state.session.can_drive(driver)) return;
    if (driver != Driver::key) return state.session.drive_by(driver, now);
    const Weights& weights = state.session.weights();
    const auto largest = std::ranges::max_element(weights, {}, &Weight::value);
    select_key(state, state.selected_key.value_or(largest->key), now);
}

void toggle_key(ViewerState& state, std::size_t key, double now) {
    const Weights& weights = state.session.weights();
    const bool is_active = std::ranges::find(weights, key, &Weight::key) != weights.end();
    state.session.set_weights(is_active ? without_key(weights, key) : with_weight(weights, key, 0), now);
}

void make_weights_sum_to_one(ViewerState& state, double now) {
    if (auto weights = summed_to_one(state.session.weights()))
        state.session.set_weights(*std::move(weights), now);
}

void reset_weights(ViewerState& state, double now) {
    if (!can_reset_weights(state)) return;
    state.session.set_weights(Weights(*state.session.first_weights()), now);
}

void choose_blend(ViewerState& state, BlendKind blend, double now) {
    if (state.document.family().blend == blend) return;
    edit(
        state, blend == BlendKind::turning ? "Turn parts" : "Blend straight",
        [blend](Family family) {
            family.blend = blend;
            return family;
        },
        now);
}

void toggle_turning(ViewerState& state, double now) {
    choose_blend(state, is_turning(state) ? BlendKind::straight : BlendKind::turning, now);
}

bool is_turning(const ViewerState& state) {
    return state.document.family().blend == BlendKind::turning;
}

bool can_make_weights_sum_to_one(const ViewerState& state) {
    const Weights& weights = state.session.weights();
    return summed_to_one(weights) && std::abs(sum_of(weights) - 1) > sum_tolerance;
}

bool can_reset_weights(const ViewerState& state) {
    const Weights* const first = state.session.first_weights();
    return first != nullptr && *first != state.session.weights();
}

}  // namespace interleaf
