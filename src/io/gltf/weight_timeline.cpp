#include "io/gltf/weight_timeline.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "family/interpolation.h"
#include "hierarchy/error.h"
#include "io/gltf/gltf_arrays.h"

namespace interleaf {

namespace {

/// The key that a row of weights shows; none if it shows several, or a part of one.
std::optional<std::size_t> only_key(std::span<const float> weights) {
    constexpr float slack = 1e-4F;
    std::size_t shown = 0;
    for (std::size_t t = 0; t < weights.size(); ++t) {
        if (std::abs(weights[t]) <= slack) continue;
        if (std::abs(weights[t] - 1) > slack || shown != 0) return std::nullopt;
        shown = t + 1;
    }
    return shown;
}

/// Whether \p channel moves the weights of a node that shows \p mesh.
bool moves_weights(const GltfFile& file, const JsonPlace& channel, std::size_t mesh) {
    const JsonPlace target = channel.member("target");
    const auto node = target.optional_member("node");
    if (!node || target.member("path").string() != "weights") return false;
    const auto shown = file.element("nodes", node->index_below(file.count("nodes"))).optional_member("mesh");
    return shown && shown->index_below(file.count("meshes")) == mesh;
}

std::optional<JsonPlace> sampler_of_weights(const GltfFile& file, std::size_t mesh) {
    for (std::size_t a = 0; a < file.count("animations"); ++a) {
        const JsonPlace animation = file.element("animations", a);
        const JsonPlace channels = animation.member("channels");
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (!moves_weights(file, channels.element(c), mesh)) continue;
            const JsonPlace samplers = animation.member("samplers");
            return samplers.element(channels.element(c).member("sampler").index_below(samplers.size()));
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<Timeline> weight_timeline(const GltfFile& file, std::size_t mesh, std::size_t targets,
                                        std::vector<std::string>& remarks) {
    const auto sampler = sampler_of_weights(file, mesh);
    if (!sampler) return std::nullopt;
    const auto pass_over = [&remarks](std::string_view reason) {
        remarks.push_back(fmt::format("The animation of the weights was passed over: {}.", reason));
        return std::nullopt;
    };
    const auto given = sampler->optional_member("interpolation");
    const std::string interpolation = given ? given->string() : "LINEAR";
    if (interpolation != "LINEAR" && interpolation != "STEP")
        return pass_over("its interpolation is neither LINEAR nor STEP");
    GltfArrays arrays(file);
    const GltfArray times = arrays.numbers(sampler->member("input"));
    const GltfArray weights = arrays.numbers(sampler->member("output"));
    if (times.values.empty()) sampler->member("input").fail_expecting("an accessor with at least one time");
    if (times.width != 1 || weights.width != 1 || weights.count() != times.count() * targets)
        sampler->fail(fmt::format("has {} times and {} weights, expected {} weights per time", times.count(),
                                  weights.count(), targets));
    std::vector<TimelineKey> keys;
    keys.reserve(times.count());
    for (std::size_t n = 0; n < times.count(); ++n) {
        const auto key = only_key(std::span(weights.values).subspan(n * targets, targets));
        if (!key) return pass_over("it blends targets at its times, and a timeline shows one key at each");
        keys.push_back({double{times.values[n]}, *key});
    }
    try {
        return Timeline(std::move(keys), {interpolation == "STEP" ? Basis::hold : Basis::linear});
    } catch (const InputError& error) {
        sampler->member("input").fail(error.what());
    }
}

}  // namespace interleaf
