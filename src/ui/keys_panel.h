// The list of a family's keys.
#pragma once

#include <span>
#include <string>

#include "family/weights.h"

namespace interleaf {

struct KeyRow {
    std::string name;
    std::size_t leaves;
    unsigned deepest;  ///< level
};

/// Keys that are active in \p weights stand out.
void keys_panel(std::span<const KeyRow> keys, const Weights& weights);

}  // namespace interleaf
