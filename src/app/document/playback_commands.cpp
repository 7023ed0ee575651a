#include "app/document/playback_commands.h"

#include <cmath>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "app/document/edit_commands.h"
#include "family/family_time.h"
#include "family/key_edits.h"
#include "hierarchy/triangle.h"
#include "text/parsed_number.h"

namespace interleaf {

namespace {

/// The number in \p text: "0.25", or "1/4" for a quotient.
std::optional<double> number_in(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto first = parsed_number<double>(std::string_view(text).substr(0, slash));
    const auto second =
        slash == std::string::npos ? 1 : parsed_number<double>(std::string_view(text).substr(slash + 1));
    if (!first || !second || !std::isfinite(*first / *second)) return std::nullopt;
    return *first / *second;
}

/// A question for a number from \p min to \p max.
/// \param range  names the permitted numbers
template <typename Apply>
TextQuestion number_question(const std::string& text, double entry, double min, double max,
                             const std::string& range, Apply apply) {
    return {.text = text,
            .entry = fmt::format("{:.10g}", entry),
            .button = "Set",
            .fault =
                [=](const std::string& typed) {
                    const auto number = number_in(typed);
                    return number && min <= *number && *number <= max ? std::string() : range;
                },
            .answer =
                [apply](ViewerState& state, const std::string& typed, double now) {
                    if (const auto number = number_in(typed)) apply(state, *number, now);
                }};
}

std::optional<std::size_t> present_place(const ViewerState& state) {
    const Family& family = state.document.family();
    if (source_of_time(family) != TimeSource::keys) return std::nullopt;
    return family.timeline->place_at(state.session.time());
}

}  // namespace

void ask_for_present_time(ViewerState& state) {
    if (!state.session.has_time()) return;
    const double begin = state.session.playback().begin();
    const double end = state.session.playback().end();
    const Family& family = state.document.family();
    const std::string unit = unit_name_of(family, *source_of_time(family));
    const std::string units = unit == "s" ? "seconds" : unit;
    state.question = number_question(
        unit.empty() ? "Step to go to" : fmt::format("Time to go to, in {}", units), state.session.time(),
        begin, end,
        unit.empty() ? fmt::format("a step from {:.10g} to {:.10g}", begin, end)
                     : fmt::format("a time from {:.10g} to {:.10g} {}", begin, end, units),
        [](ViewerState& changed, double time, double now) { changed.session.seek(time, now); });
}

void ask_for_speed(ViewerState& state) {
    if (!state.session.has_time()) return;
    state.question = number_question(
        "Speed of playback; 1 is real time", state.session.playback().speed(), min_speed, max_speed,
        "a speed from 1/64 to 8, such as 1/16 or 0.3",
        [](ViewerState& changed, double speed, double now) { changed.session.set_speed(speed, now); });
}

void ask_for_frame_rate(ViewerState& state) {
    if (!state.session.has_time()) return;
    state.question =
        number_question("Frames per second of single steps", state.session.frame_rate, 0.001, 1000,
                        "a number of frames per second, 0.001 to 1000",
                        [](ViewerState& changed, double rate, double) { changed.session.frame_rate = rate; });
}

void ask_for_degree(ViewerState& state) {
    if (!state.session.has_timeline()) return;
    const std::size_t degree = state.document.family().timeline->interpolation().degree;
    state.question = number_question(
        "Degree of the Bernstein pieces", degree > 0 ? static_cast<double>(degree) : 3, 1, 1000,
        "a whole degree from 1 to 1000", [](ViewerState& changed, double typed, double now) {
            choose_interpolation(
                changed, {.basis = Basis::bernstein, .degree = static_cast<std::size_t>(std::lround(typed))},
                now);
        });
    state.question->fault = [fault = state.question->fault](const std::string& typed) {
        return parsed_number<std::size_t>(typed) ? fault(typed) : "a whole degree from 1 to 1000";
    };
}

void change_speed(ViewerState& state, int direction, double now) {
    // From a typed speed to the next power of two.
    const double exponent = std::log2(state.session.playback().speed());
    const double next = direction > 0 ? std::floor(exponent + 1e-9) + 1 : std::ceil(exponent - 1e-9) - 1;
    state.session.set_speed(std::exp2(next), now);
}

void cycle_repeat(ViewerState& state, double now) {
    const auto place = static_cast<std::size_t>(state.session.playback().repeat());
    state.session.set_repeat(repeats()[(place + 1) % repeats().size()], now);
}

void set_in_point(ViewerState& state, double time, double now) {
    const Playback& playback = state.session.playback();
    const double out = playback.range().end;
    state.session.set_range(TimeRange{time, time < out ? out : playback.end()}, now);
}

void set_out_point(ViewerState& state, double time, double now) {
    const Playback& playback = state.session.playback();
    const double in = playback.range().begin;
    state.session.set_range(TimeRange{time > in ? in : playback.begin(), time}, now);
}

void choose_interpolation(ViewerState& state, Interpolation interpolation, double now) {
    const auto& timeline = state.document.family().timeline;
    if (!timeline || timeline->interpolation() == interpolation) return;
    edit(
        state, fmt::format("Interpolate by {}", name_of(interpolation.basis)),
        [&](const Family& family) { return with_interpolation(family, interpolation); }, now);
}

void cycle_interpolation(ViewerState& state, double now) {
    const auto& timeline = state.document.family().timeline;
    if (!timeline) return;
    const auto place = static_cast<std::size_t>(timeline->interpolation().basis);
    choose_interpolation(state, {.basis = bases()[(place + 1) % bases().size()]}, now);
}

void add_present_time(ViewerState& state, double now) {
    if (source_of_time(state.document.family()) == TimeSource::path) return;
    if (state.selected_key) add_time(state, *state.selected_key, state.session.time(), now);
}

void remove_present_time(ViewerState& state, double now) {
    if (const auto place = present_place(state)) remove_time(state, *place, now);
}

bool has_present_time(const ViewerState& state) {
    return present_place(state).has_value();
}

}  // namespace interleaf
