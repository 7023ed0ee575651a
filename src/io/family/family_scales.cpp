#include "io/family/family_scales.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/field.h"
#include "io/family/family_format.h"

namespace interleaf {

std::string written_unit_at(const JsonPlace& place) {
    std::string unit = place.string();
    if (!is_unit(unit))
        place.fail_expecting(fmt::format("a unit of at most {} bytes without control characters", max_unit));
    return unit;
}

TimeUnit unit_at(const JsonPlace& place, double version) {
    const auto unit_place = place.optional_member("unit");
    if (!unit_place || version < family_format::version) return TimeUnit::seconds;
    const std::optional<TimeUnit> unit = time_unit_named(unit_place->string());
    if (!unit) unit_place->fail_expecting("\"seconds\" or \"steps\"");
    return *unit;
}

std::vector<FieldScale> scales_at(const JsonPlace& place) {
    if (place.size() > family_format::max_scales)
        place.fail(
            fmt::format("has {} scales, expected at most {}", place.size(), family_format::max_scales));
    std::vector<FieldScale> scales;
    scales.reserve(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace scale = place.element(i);
        const JsonPlace name = scale.member("field");
        FieldScale read{.field = name.string()};
        if (!is_field_name(read.field)) name.fail_expecting("the name of a field");
        if (std::ranges::find(scales, read.field, &FieldScale::field) != scales.end())
            name.fail_expecting("a field that no other scale has");
        if (const auto offset = scale.optional_member("offset")) read.offset = offset->number();
        if (const auto unit = scale.optional_member("unit")) read.unit = written_unit_at(*unit);
        scales.push_back(std::move(read));
    }
    return scales;
}

}  // namespace interleaf
