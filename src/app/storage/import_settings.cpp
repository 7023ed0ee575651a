#include "app/storage/import_settings.h"

#include <cstddef>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "io/family/family_format.h"
#include "text/characters.h"

namespace interleaf {
namespace {

constexpr std::size_t corner_count = 3;

}  // namespace

nlohmann::ordered_json import_json(const ImportChoices& choices) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    if (choices.every != 1) json["every"] = choices.every;
    if (choices.tolerance) json["tolerance"] = *choices.tolerance;
    if (choices.newest) json["newest"] = *choices.newest;
    for (const std::string& field : choices.fields)
        if (is_utf8(field)) json["fields"].push_back(field);
    if (!choices.displacement.empty() && is_utf8(choices.displacement))
        json["displacement"] = choices.displacement;
    if (choices.warp && is_utf8(choices.warp->field))
        json["warp"] = {{"field", choices.warp->field}, {"factor", choices.warp->factor}};
    std::string roots = family_format::utf8_of(choices.roots);
    if (!roots.empty() && is_utf8(roots)) json["roots"] = std::move(roots);
    return json;
}

ImportChoices import_choices_at(const JsonPlace& place) {
    ImportChoices choices;
    if (const auto every = place.optional_member("every")) {
        choices.every = every->index_below(every_limit);
        if (choices.every == 0) every->fail_expecting("a number from 1 on");
    }
    if (const auto tolerance = place.optional_member("tolerance")) {
        choices.tolerance = tolerance->number();
        if (!(*choices.tolerance >= 0 && *choices.tolerance <= 1))
            tolerance->fail_expecting("a number from 0 to 1");
    }
    if (const auto newest = place.optional_member("newest"))
        choices.newest = newest->index_below(corner_count);
    if (const auto fields = place.optional_member("fields"))
        for (std::size_t i = 0; i < fields->size(); ++i)
            choices.fields.push_back(fields->element(i).string());
    if (const auto displacement = place.optional_member("displacement"))
        choices.displacement = displacement->string();
    if (const auto warp = place.optional_member("warp"))
        choices.warp = ChosenWarp{warp->member("field").string(), warp->member("factor").number()};
    if (const auto roots = place.optional_member("roots"))
        choices.roots = family_format::path_of(roots->string());
    return choices;
}

}  // namespace interleaf
