// The search in the list of keys.
#pragma once

#include <string>

namespace interleaf {

struct KeySearch {
    std::string text;          ///< only keys that match it are shown
    bool is_shown = false;     ///< the field is shown even for a short list
    bool only_active = false;  ///< only active keys are shown
    bool operator==(const KeySearch&) const = default;
};

}  // namespace interleaf
