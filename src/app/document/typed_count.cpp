#include "app/document/typed_count.h"

#include <cmath>
#include <limits>

#include "text/parsed_number.h"

namespace interleaf {

std::optional<Index> typed_count(std::string_view text) {
    if (const std::optional<Index> count = parsed_number<Index>(text)) return count;
    if (text.find_first_of("eE") == std::string_view::npos) return std::nullopt;
    const std::optional<double> value = parsed_number<double>(text);
    if (!value || *value < 0 || *value > std::numeric_limits<Index>::max() || *value != std::floor(*value))
        return std::nullopt;
    return static_cast<Index>(*value);
}

}  // namespace interleaf
