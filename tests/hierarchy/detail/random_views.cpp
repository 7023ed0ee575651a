#include "hierarchy/detail/random_views.h"

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf::testing {

ViewPoint random_view(Random& random) {
    const glm::vec3 eye = 3.0F * random.point();
    const glm::vec3 toward = 0.5F * random.point() - eye;
    return {.eye = eye,
            .forward = glm::normalize(toward + glm::vec3(1e-3F, 0, 0)),
            .cosine = 0.7F + 0.29F * static_cast<float>(random.unit())};
}

std::vector<float> random_weights(Random& random, std::size_t count) {
    std::vector<float> weights(count, 1.0F);
    for (std::size_t key = 1; key < count; ++key) {
        weights[key] = static_cast<float>(random.unit()) - 0.1F;
        weights[0] -= weights[key];
    }
    return weights;
}

ViewPoint between(const ViewPoint& a, const ViewPoint& b, float part) {
    return {.eye = glm::mix(a.eye, b.eye, part),
            .forward = glm::normalize(glm::mix(a.forward, b.forward, part)),
            .cosine = glm::mix(a.cosine, b.cosine, part)};
}

DetailedKeys::DetailedKeys(const std::vector<Hierarchy>& family) {
    keys.reserve(family.size());
    details.reserve(family.size());
    for (const Hierarchy& key : family) {
        keys.push_back(&key);
        details.push_back(measure_detail(key));
    }
}

ViewRefinement DetailedKeys::refinement() const {
    std::vector<const KeyDetail*> pointers;
    pointers.reserve(details.size());
    for (const KeyDetail& detail : details) pointers.push_back(&detail);
    return {keys, pointers};
}

void for_random_details(unsigned count, std::size_t keys,
                        const std::function<void(const RandomFamily&, Random&, const DetailedKeys&)>& test) {
    for_random_families(count, keys, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        test(family, random, DetailedKeys(family.keys));
    });
}

}  // namespace interleaf::testing
