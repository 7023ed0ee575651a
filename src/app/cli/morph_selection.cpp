#include "app/cli/morph_selection.h"

#include <optional>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/export/export.h"

namespace interleaf {
namespace {

Weights named_weights(const std::vector<NamedWeight>& named, const Family& family) {
    Weights weights;
    for (const NamedWeight& weight : named) {
        const std::optional<std::size_t> key = find_key(family, weight.key);
        if (!key) {
            std::string known;
            for (const Key& each : family.keys) known += (known.empty() ? "" : ", ") + each.name;
            throw UsageError(
                fmt::format("--weights: there is no key '{}', the keys are {}", weight.key, known));
        }
        weights.push_back({*key, weight.value});
    }
    return sorted_weights(std::move(weights));
}

}  // namespace

void require_source(const Family& family, TimeSource along) {
    if (has_source(family, along)) return;
    throw UsageError(along == TimeSource::path ? "--along: the family has no path through a parameter domain"
                                               : "--along: the family has no timeline");
}

std::optional<Weights> chosen_weights(const MorphSelection& selection, const Family& family) {
    if (selection.weights) return named_weights(*selection.weights, family);
    if (selection.at) {
        if (!family.domain) throw UsageError("--at: the family has no parameter domain");
        return family.domain->weights(family.domain->locate(*selection.at));
    }
    if (selection.along) require_source(family, *selection.along);
    if (!selection.time && !selection.along && family.keys.size() == 1) return Weights{{0, 1.0}};
    const auto source = selection.along ? selection.along : source_of_time(family);
    if (source) return weights_at(family, selection.time.value_or(0), *source);
    if (selection.time) throw UsageError("--time: the family has no timeline and no path");
    return std::nullopt;
}

Weights selected_weights(const MorphSelection& selection, const Family& family) {
    std::optional<Weights> weights = chosen_weights(selection, family);
    if (!weights) throw UsageError(no_default_blend);
    return *std::move(weights);
}

}  // namespace interleaf
