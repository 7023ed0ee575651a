#include "sequence/sequence.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

void check_options(const SequenceOptions& options) {
    constexpr unsigned max_steps = 1000;
    constexpr double min_tolerance = 1e-5;
    constexpr double max_tolerance = 0.05;
    if (options.steps < 1 || options.steps > max_steps)
        throw UsageError(fmt::format("the number of steps must be from 1 to {}", max_steps));
    if (!(options.tolerance >= min_tolerance && options.tolerance <= max_tolerance))
        throw UsageError(
            fmt::format("the tolerance of a sequence must be from {} to {}", min_tolerance, max_tolerance));
}

Family family_of_states(std::string_view name, std::vector<Hierarchy> states, double duration) {
    const std::size_t steps = states.size() - 1;
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(steps).size());
    Family family{.name = std::string(name), .keys = {}, .timeline = {}, .domain = {}};
    std::vector<TimelineKey> entries;
    for (std::size_t step = 0; step <= steps; ++step) {
        family.keys.push_back({fmt::format("step {:0{}}", step, digits), std::move(states[step])});
        entries.push_back({duration * static_cast<double>(step) / static_cast<double>(steps), step});
    }
    family.timeline.emplace(std::move(entries));
    return family;
}

}  // namespace interleaf
