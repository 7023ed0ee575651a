#include "app/document/unit_commands.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "app/document/edit_commands.h"
#include "family/field_scale.h"
#include "family/field_units.h"
#include "hierarchy/field.h"

namespace interleaf {
namespace {

std::string fault_of_unit(const std::string& unit) {
    return is_unit(unit) ? "" : fmt::format("at most {} bytes, such as m/s", max_unit);
}

}  // namespace

const std::string* shown_scalar(const ViewerState& state) {
    const Display& display = state.session.display;
    if (display.coloring != Coloring::field) return nullptr;
    const bool is_scalar = std::ranges::any_of(state.document.family().keys, [&](const Key& key) {
        return find_field(key.hierarchy->fields, {display.field, FieldKind::scalar}) != nullptr;
    });
    return is_scalar ? &display.field : nullptr;
}

void ask_for_field_unit(ViewerState& state) {
    const std::string* const shown = shown_scalar(state);
    if (shown == nullptr) return;
    const std::string unit = scale_of(state.document.family().field_scales, *shown).unit;
    state.question = TextQuestion{
        .text = fmt::format("Unit of {}, such as m/s; empty for none", *shown),
        .entry = unit,
        .button = "Set",
        .fault = fault_of_unit,
        .answer = [field = *shown, unit](ViewerState& changed, const std::string& entry, double now) {
            if (entry == unit) return;
            edit(
                changed, fmt::format("Set the unit of {}", field),
                [&](const Family& family) { return with_field_unit(family, field, entry); }, now);
        }};
}

void ask_for_time_unit(ViewerState& state) {
    if (!state.document.family().timeline) return;
    const std::string unit = state.document.family().time_unit;
    state.question =
        TextQuestion{.text = "Unit of the timeline's times, such as ms; empty for seconds or steps",
                     .entry = unit,
                     .button = "Set",
                     .fault = fault_of_unit,
                     .answer = [unit](ViewerState& changed, const std::string& entry, double now) {
                         if (entry == unit) return;
                         edit(
                             changed, "Set the unit of time",
                             [&](const Family& family) { return with_time_unit(family, entry); }, now);
                     }};
}

}  // namespace interleaf
