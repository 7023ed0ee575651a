#include "app/importing/series_import.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "app/importing/fitted_series.h"
#include "family/field_scale.h"
#include "family/field_units.h"
#include "family/new_family.h"
#include "family/origin.h"
#include "family/warp.h"
#include "hierarchy/error.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/text/json_place.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {
namespace {

/// \p text with the file of a step in place of "step N", which errors of the recovery begin with.
std::string with_file(std::string text, const SeriesFiles& series) {
    constexpr std::string_view word = "step ";
    std::size_t step = 0;
    const char* const end = text.data() + text.size();
    const auto number = std::from_chars(text.data() + std::min(word.size(), text.size()), end, step);
    if (!text.starts_with(word) || number.ec != std::errc() || step >= series.files.size())
        return fmt::format("{}: {}", series.files.front().string(), text);
    std::string_view rest(number.ptr, end);
    rest.remove_prefix(std::min(rest.find_first_not_of(":, "), rest.size()));
    const auto is_named = [rest](const std::filesystem::path& file) {
        return rest.starts_with(file.string() + ": ");
    };
    const std::filesystem::path& first = series.files[step];
    if (is_named(first) || std::ranges::any_of(series.further_parts[step], is_named))
        return std::string(rest);
    return fmt::format("{}: {}", first.string(), rest);
}

/// What is subtracted from all steps.
struct StepOffsets {
    glm::dvec3 origin{0};
    std::vector<FieldScale> fields{};
};

FieldMesh read_step(const SeriesFiles& series, std::size_t step, const StepOffsets& offsets) {
    FieldMesh mesh = read_step_mesh(series, step);
    if (offsets.origin != glm::dvec3(0))
        for (glm::dvec3& point : mesh.points) point -= offsets.origin;
    for (MeshField& field : mesh.point_fields)
        if (const double offset = scale_of(offsets.fields, field.name).offset; offset != 0)
            for (double& value : field.values) value -= offset;
    return mesh;
}

/// The least and the largest value of each field of one component, over some steps.
class FieldRanges {
  public:
    void include(const FieldMesh& mesh) {
        for (const MeshField& field : mesh.point_fields) {
            if (field.components != 1 || field.values.empty()) continue;
            const auto [low, high] = std::ranges::minmax(field.values);
            const auto [known, is_new] = ranges_.try_emplace(field.name, low, high);
            if (is_new) continue;
            known->second = {std::min(known->second.first, low), std::max(known->second.second, high)};
        }
    }

    /// The scales of the fields that need an offset, except \p displacement.
    std::vector<FieldScale> scales(std::string_view displacement) const {
        std::vector<FieldScale> scales;
        for (const auto& [name, range] : ranges_)
            if (name != displacement && std::isfinite(range.first) && std::isfinite(range.second))
                set_scale(scales, {.field = name, .offset = offset_for(range.first, range.second)});
        return scales;
    }

  private:
    std::map<std::string, std::pair<double, double>> ranges_;
};

/// The offsets of \p series, whose first step is \p first. What is wrong with the other steps, the recovery tells.
StepOffsets offsets_of(const SeriesFiles& series, const FieldMesh& first, std::string_view displacement) {
    FieldRanges ranges;
    ranges.include(first);
    const std::size_t count = series.files.size();
    for (const std::size_t step : std::set{count / 2, count - 1}) {
        if (step == 0) continue;
        try {
            ranges.include(read_step_mesh(series, step));
        } catch (const std::runtime_error&) {
            break;
        }
    }
    return {origin_for(first.points, first.triangles), ranges.scales(displacement)};
}

/// Checks, before the long work, that the keys of steps like \p first get the fields whose units \p choices has.
/// \throw InputError if one is missing
void require_fields_of_units(const ImportChoices& choices, const FieldMesh& first) {
    if (choices.units.empty()) return;
    const std::vector<SeriesScalar> scalars = fields_of(first, choices.fields, choices.displacement).scalars;
    for (const auto& [field, unit] : choices.units)
        if (std::ranges::find(scalars, field, &SeriesScalar::name) == scalars.end())
            throw InputError(fmt::format("no key has a scalar field called \"{}\"", field));
}

/// Gives \p family the units of the fields of \p first, its first step, and then those of \p choices.
/// \throw InputError if a choice names no field
void set_units(Family& family, const FieldMesh& first, const ImportChoices& choices) {
    const std::vector<Field>& fields = family.keys.front().hierarchy->fields;
    for (const MeshField& field : first.point_fields) {
        if (field.unit.empty() || !is_unit(field.unit)) continue;
        for (std::size_t c = 0; c < field.components; ++c)
            if (const std::string scalar = component_name(field, c);
                find_field(fields, {scalar, FieldKind::scalar}) != nullptr)
                family = with_field_unit(std::move(family), scalar, field.unit);
    }
    for (const auto& [field, unit] : choices.units) family = with_field_unit(std::move(family), field, unit);
    family = with_time_unit(std::move(family), choices.time_unit);
}

/// The warp that \p choice names, of steps like \p first; none without a choice.
std::optional<Warp> warp_of(const std::optional<ChosenWarp>& choice, const FieldMesh& first) {
    if (!choice) return std::nullopt;
    const std::optional<unsigned> axis = flat_axis(first.points);
    if (!axis)
        throw InputError("step 0: the points are not in a plane x, y or z = constant, as --warp needs");
    return Warp{.axis = *axis, .field = choice->field, .factor = static_cast<float>(choice->factor)};
}

void require_scalar(const Hierarchy& key, const std::string& name) {
    std::string known;
    for (const Field& field : key.fields) {
        if (field.name == name && field.kind == FieldKind::scalar) return;
        known += (known.empty() ? "" : ", ") + field.name;
    }
    throw InputError(fmt::format("step 0: field {} is missing, expected one of the keys' for --warp: {}",
                                 name, known.empty() ? "none" : known));
}

/// A sentence about the fields of cells of \p first, which no key gets; none if it has no such fields but those that
/// `export` writes about the leaves of a key.
std::optional<std::string> note_about_cell_fields(const FieldMesh& first) {
    const std::vector<MeshField>& fields = first.triangle_fields;
    const auto has = [&](std::string_view name) {
        return std::ranges::find(fields, name, &MeshField::name) != fields.end();
    };
    const bool is_exported = has("level") && has("root");
    constexpr std::size_t max_names = 8;
    std::string names;
    std::size_t count = 0;
    for (const MeshField& field : fields) {
        if (is_exported && (field.name == "level" || field.name == "root" || field.name == "origin"))
            continue;
        if (++count <= max_names) names += (names.empty() ? "" : ", ") + in_quotes(field.name);
    }
    if (count == 0) return std::nullopt;
    if (count > max_names) names += fmt::format(" and {} more", count - max_names);
    return fmt::format("fields of cells are left out: {}", names);
}

/// \param in_files  the times that the files of the steps have, which count if the series has none of its own
Timeline timeline_of(const SeriesFiles& series, std::span<const std::optional<double>> in_files) {
    const auto does_not_increase = [](const auto& a, const auto& b) { return !(a && b && *a < *b); };
    const bool are_in_files = series.are_steps && in_files.size() > 1 &&
                              std::ranges::adjacent_find(in_files, does_not_increase) == in_files.end() &&
                              std::isfinite(*in_files.back() - *in_files.front());
    std::vector<TimelineKey> keys;
    keys.reserve(series.times.size());
    for (std::size_t step = 0; step < series.times.size(); ++step)
        keys.push_back({are_in_files ? *in_files[step] : series.times[step], step});
    const bool are_steps = series.are_steps && !are_in_files;
    return Timeline(std::move(keys), {}, are_steps ? TimeUnit::steps : TimeUnit::seconds);
}

}  // namespace

SeriesFiles every_step(const SeriesFiles& series, std::size_t every) {
    if (every == 0) throw UsageError("--every: expected at least 1");
    SeriesFiles taken;
    taken.are_steps = series.are_steps;
    for (std::size_t step = 0; step < series.files.size(); step += every) {
        taken.files.push_back(series.files[step]);
        taken.times.push_back(series.times[step]);
        taken.further_parts.push_back(series.further_parts[step]);
    }
    return taken;
}

ImportedSeries import_series(const SeriesFiles& series, std::string_view name, const ImportChoices& choices,
                             const SeriesProgress& progress) {
    const FieldMesh first = read_step_mesh(series, 0);
    const StepOffsets offsets = offsets_of(series, first, choices.displacement);
    std::optional<Hierarchy> roots;
    if (!choices.roots.empty()) roots = read_hierarchy(choices.roots);
    const SeriesOptions options{.tolerance = choices.tolerance,
                                .newest = choices.newest,
                                .fields = choices.fields,
                                .displacement = choices.displacement,
                                .roots = roots ? &*roots : nullptr};
    std::vector<std::optional<double>> times_in_files(series.files.size());
    const Series steps{series.files.size(), [&](std::size_t step) {
                           FieldMesh mesh = read_step(series, step, offsets);
                           times_in_files[step] = mesh.time;
                           return mesh;
                       }};

    ImportedSeries imported;
    std::vector<Key> keys;
    keys.reserve(series.files.size());
    std::optional<Warp> warp;
    // A fitted series has come some way already when it turns out that no bisection connects the steps.
    double reached = 0;
    const SeriesProgress onward = [&](std::string_view stage, double part) {
        reached = std::max(reached, part);
        if (progress) progress(stage, reached);
    };
    const TakeKey take_key = [&](std::size_t step, Hierarchy key) {
        if (step == 0) keys.clear();
        if (warp) {
            require_scalar(key, warp->field);
            key = warped(key, *warp);
        }
        keys.push_back({series.files[step].stem().string(), std::move(key)});
    };
    try {
        require_fields_of_units(choices, first);
        warp = warp_of(choices.warp, first);
        try {
            imported.report = recover(steps, options, take_key, onward);
        } catch (const UnrecoveredSurfaces& unrecovered) {
            if (!can_be_fitted(options)) throw;
            const std::string reason = with_file(unrecovered.what(), series);
            imported.report = fit_steps(steps, options, reason, take_key, onward);
        }
    } catch (const NeedsTolerance& error) {
        throw NeedsTolerance(with_file(error.reason, series));
    } catch (const InputError& error) {
        throw InputError(with_file(error.what(), series));
    }
    if (choices.fields.empty())
        if (auto note = note_about_cell_fields(first)) imported.report.notes.push_back(std::move(*note));
    imported.family = family_of_keys(name, std::move(keys));
    imported.family.timeline = timeline_of(series, times_in_files);
    imported.family.domain.reset();
    imported.family.origin = offsets.origin;
    for (const FieldScale& scale : offsets.fields)
        if (find_field(imported.family.keys.front().hierarchy->fields, {scale.field, FieldKind::scalar}) !=
            nullptr)
            imported.family.field_scales.push_back(scale);
    set_units(imported.family, first, choices);
    return imported;
}

}  // namespace interleaf
