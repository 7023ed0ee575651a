#include "app/cli/morph_selection.h"

#include <fmt/core.h>

#include "hierarchy/error.h"

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
                fmt::format("--weights: no key is called '{}'; there are {}", weight.key, known));
        }
        weights.push_back({*key, weight.value});
    }
    return sorted_weights(std::move(weights));
}

}  // namespace

Weights selected_weights(const MorphSelection& selection, const Family& family) {
    if (selection.weights) return named_weights(*selection.weights, family);
    if (selection.at) {
        if (!family.domain) throw UsageError("--at: the family has no parameter domain");
        return family.domain->weights(family.domain->locate(*selection.at));
    }
    if (!selection.time && family.keys.size() == 1) return {{0, 1.0}};
    if (!family.timeline) {
        throw UsageError(selection.time ? "--time: the family has no timeline"
                                        : "the family has no timeline; say --at or --weights");
    }
    return family.timeline->at(selection.time.value_or(0));
}

}  // namespace interleaf
