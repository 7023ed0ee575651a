#include "app/importing/series_import.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/core.h>

#include "family/new_family.h"
#include "family/origin.h"
#include "hierarchy/error.h"
#include "io/hierarchy/hierarchy_file.h"

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
    const std::string file = series.files[step].string();
    rest.remove_prefix(std::min(rest.find_first_not_of(":, "), rest.size()));
    if (rest.starts_with(file + ": ")) return std::string(rest);
    return fmt::format("{}: {}", file, rest);
}

FieldMesh read_step(const std::filesystem::path& file, const glm::dvec3& origin) {
    FieldMesh mesh = read_field_mesh(file);
    if (origin != glm::dvec3(0))
        for (glm::dvec3& point : mesh.points) point -= origin;
    return mesh;
}

Timeline timeline_of(const SeriesFiles& series) {
    std::vector<TimelineKey> keys;
    keys.reserve(series.times.size());
    for (std::size_t step = 0; step < series.times.size(); ++step) keys.push_back({series.times[step], step});
    return Timeline(std::move(keys), {}, series.are_steps ? TimeUnit::steps : TimeUnit::seconds);
}

}  // namespace

SeriesFiles every_step(const SeriesFiles& series, std::size_t every) {
    if (every == 0) throw UsageError("--every: expected at least 1");
    SeriesFiles taken;
    taken.are_steps = series.are_steps;
    for (std::size_t step = 0; step < series.files.size(); step += every) {
        taken.files.push_back(series.files[step]);
        taken.times.push_back(series.times[step]);
    }
    return taken;
}

ImportedSeries import_series(const SeriesFiles& series, std::string_view name, const ImportChoices& choices,
                             const SeriesProgress& progress) {
    const FieldMesh first = read_field_mesh(series.files.front());
    const glm::dvec3 origin = origin_for(first.points, first.triangles);
    std::optional<Hierarchy> roots;
    if (!choices.roots.empty()) roots = read_hierarchy(choices.roots);
    const SeriesOptions options{.tolerance = choices.tolerance,
                                .newest = choices.newest,
                                .fields = choices.fields,
                                .displacement = choices.displacement,
                                .roots = roots ? &*roots : nullptr};
    const Series steps{series.files.size(),
                       [&](std::size_t step) { return read_step(series.files[step], origin); }};

    ImportedSeries imported;
    std::vector<Key> keys;
    keys.reserve(series.files.size());
    try {
        imported.report = recover(
            steps, options,
            [&](std::size_t step, Hierarchy key) {
                keys.push_back({series.files[step].stem().string(), std::move(key)});
            },
            progress);
    } catch (const InputError& error) {
        throw InputError(with_file(error.what(), series));
    }
    imported.family = family_of_keys(name, std::move(keys));
    imported.family.timeline = timeline_of(series);
    imported.family.domain.reset();
    imported.family.origin = origin;
    return imported;
}

}  // namespace interleaf
