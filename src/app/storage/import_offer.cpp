#include "app/storage/import_offer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>

#include <fmt/core.h>

#include "app/storage/import_settings.h"
#include "hierarchy/field_mesh.h"
#include "io/series_files.h"
#include "text/parsed_number.h"
#include "text/shown_text.h"
#include "ui/widgets/number_text.h"

namespace interleaf {
namespace {

/// The part that \p text, in percent, stands for; none if it is no number from 0 to 100.
std::optional<double> part_in(const std::string& text) {
    const std::optional<double> percent = parsed_number<double>(text);
    if (!percent || !(*percent >= 0 && *percent <= 100)) return std::nullopt;
    return *percent / 100;
}

std::optional<std::size_t> count_in(const std::string& text) {
    const std::optional<std::size_t> count = parsed_number<std::size_t>(text);
    return count && *count > 0 && *count < every_limit ? count : std::nullopt;
}

/// A short text that part_in() reads as \p part, or as a neighbor of it if no number of percent stands for it.
std::string percent_of(double part) {
    std::string rounded = fmt::format("{:g}", 100 * part);
    if (part_in(rounded) == part) return rounded;
    const double percent = 100 * part;
    for (const double each : {std::nextafter(percent, 0.0), std::nextafter(percent, 100.0)})
        if (each / 100 == part) return fmt::format("{}", each);
    return fmt::format("{}", percent);
}

}  // namespace

ImportDialogShown import_offer(const std::vector<std::filesystem::path>& files) {
    const SeriesFiles series = series_files(files);
    const FieldMesh first = read_step_mesh(series, 0);
    ImportDialogShown offer;
    offer.title = fmt::format("Import {}", shown_name(files.front().filename().string()));
    offer.detail = fmt::format("{} {}, {} triangles in the first", grouped(series.files.size()),
                               series.files.size() == 1 ? "step" : "steps", grouped(first.triangles.size()));
    for (const MeshField& field : first.point_fields) {
        offer.fields.push_back(field.name);
        for (std::size_t c = 0; c < field.components; ++c) offer.scalars.push_back(component_name(field, c));
        if (field.components == 2 || field.components == 3) offer.vectors.push_back(field.name);
    }
    return offer;
}

ImportDialogChoices dialog_choices(const ImportChoices& choices, const ImportDialogShown& offer) {
    const auto offered = [](const std::vector<std::string>& names, const std::string& name) {
        return std::ranges::find(names, name) != names.end() ? name : std::string();
    };
    ImportDialogChoices typed;
    if (choices.tolerance) typed.tolerance = percent_of(*choices.tolerance);
    typed.every = fmt::format("{}", choices.every);
    typed.roots = choices.roots.string();
    if (choices.newest) typed.newest = *choices.newest + 1;
    if (choices.warp) {
        typed.warp = offered(offer.scalars, choices.warp->field);
        typed.factor = choices.warp->factor;
    }
    typed.displacement = offered(offer.vectors, choices.displacement);
    for (const std::string& field : offer.fields)
        typed.are_wanted.push_back(!offered(choices.fields, field).empty());
    if (std::ranges::find(typed.are_wanted, true) == typed.are_wanted.end())
        typed.are_wanted.assign(offer.fields.size(), true);
    return typed;
}

std::string fault_of(const ImportDialogChoices& choices, const ImportDialogShown& offer) {
    std::error_code ignored;
    if (!count_in(choices.every))
        return fmt::format("Every: expected a whole number from 1 on, below {}", every_limit);
    if (!choices.tolerance.empty() && !part_in(choices.tolerance))
        return "Tolerance: expected a percentage from 0 to 100, or nothing";
    if (!choices.roots.empty() && !std::filesystem::is_regular_file(choices.roots, ignored))
        return "Roots: there is no such file";
    if (!std::isfinite(choices.factor) ||
        std::abs(choices.factor) > double{std::numeric_limits<float>::max()})
        return "Warp: expected a factor";
    if (!offer.fields.empty() &&
        std::ranges::none_of(choices.are_wanted, [](bool is_wanted) { return is_wanted; }))
        return "Fields: choose at least one";
    return "";
}

ImportChoices import_choices(const ImportDialogChoices& choices, const ImportDialogShown& offer) {
    ImportChoices wanted;
    wanted.every = count_in(choices.every).value_or(1);
    if (!choices.tolerance.empty()) wanted.tolerance = part_in(choices.tolerance);
    if (choices.newest > 0) wanted.newest = static_cast<unsigned>(choices.newest - 1);
    std::error_code ignored;
    if (!choices.roots.empty()) wanted.roots = std::filesystem::absolute(choices.roots, ignored);
    wanted.displacement = choices.displacement;
    if (!choices.warp.empty()) wanted.warp = ChosenWarp{choices.warp, choices.factor};
    if (std::ranges::find(choices.are_wanted, false) != choices.are_wanted.end())
        for (std::size_t n = 0; n < offer.fields.size(); ++n)
            if (choices.are_wanted[n]) wanted.fields.push_back(offer.fields[n]);
    return wanted;
}

}  // namespace interleaf
