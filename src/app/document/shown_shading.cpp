#include "app/document/shown_shading.h"

#include <algorithm>
#include <cstddef>

namespace interleaf {

Shading shown_shading(const Display& display, const Family& family, const Weights& weights) {
    std::size_t largest = 0;
    for (const Weight& weight : weights)
        largest = std::max(largest, family.keys[weight.key].hierarchy->leaf_count());
    return display.shading.value_or(usual_shading(largest));
}

Shading shown_shading(const Session& session) {
    return shown_shading(session.display, session.family(), session.weights());
}

}  // namespace interleaf
