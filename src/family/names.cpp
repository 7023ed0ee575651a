#include "family/names.h"

#include <fmt/core.h>

#include "text/characters.h"
#include "text/shown_text.h"

namespace interleaf {

std::string fault_of_name(std::string_view name, std::string_view bearer) {
    if (name.empty()) return fmt::format("{} needs a name", bearer);
    if (!is_printable(name))
        return fmt::format("the name of {} is not UTF-8 without control characters", bearer);
    return "";
}

std::string unused_name(std::string_view wanted,
                        const std::function<bool(const std::string& name)>& is_taken) {
    const std::string stem = wanted.empty() ? "key" : shown_text(wanted);
    std::string name = stem;
    for (unsigned number = 2; is_taken(name); ++number) name = fmt::format("{} {}", stem, number);
    return name;
}

}  // namespace interleaf
