#include "app/document/typed_number.h"

#include <cmath>
#include <limits>

namespace interleaf {

std::optional<Index> typed_count(std::string_view text) {
    if (const std::optional<Index> count = typed_number<Index>(text)) return count;
    if (text.find_first_of("eE") == std::string_view::npos) return std::nullopt;
    const std::optional<double> value = typed_number<double>(text);
    if (!value || *value < 0 || *value > std::numeric_limits<Index>::max() || *value != std::floor(*value))
        return std::nullopt;
    return static_cast<Index>(*value);
}

}  // namespace interleaf
