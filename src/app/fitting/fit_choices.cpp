#include "app/fitting/fit_choices.h"

#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <glm/matrix.hpp>

#include "app/document/typed_count.h"
#include "app/fitting/axis_turn.h"
#include "text/parsed_number.h"

namespace interleaf {

namespace {

constexpr Index max_leaves = 10'000'000;
constexpr double min_percent = 0.001;
constexpr double max_percent = 100;
constexpr double max_degrees = 360;

std::optional<double> degrees_of(const FitChoices::Turn& turn) {
    const std::optional<double> degrees = parsed_number<double>(turn.degrees);
    if (!degrees || !(std::abs(*degrees) <= max_degrees)) return {};
    return degrees;
}

}  // namespace

std::string fault_of(const FitChoices& choices, const SphereRoots& roots,
                     const std::vector<std::string>& names) {
    if (choices.by_tolerance) {
        const std::optional<double> percent = parsed_number<double>(choices.tolerance);
        if (!percent || !(*percent >= min_percent && *percent <= max_percent))
            return fmt::format("Tolerance: expected {} to {} % of the box diagonal", min_percent,
                               max_percent);
    } else {
        const std::optional<Index> leaves = typed_count(choices.leaves);
        const Index least = roots.complex.triangle_count();
        if (!leaves || *leaves < least || *leaves > max_leaves)
            return fmt::format("Leaves: expected {}, the number of roots, to {}", least, max_leaves);
    }
    for (std::size_t mesh = 0; mesh < choices.turns.size(); ++mesh)
        if (!degrees_of(choices.turns[mesh]))
            return fmt::format("Turn: expected -360 to 360 degrees for {}", names[mesh]);
    return "";
}

FitOptions fit_options(const FitChoices& choices, const SphereRoots& roots) {
    FitOptions options{
        .roots = roots, .keep_largest = choices.keep_largest, .fill_holes = choices.fill_holes};
    if (choices.by_tolerance)
        options.tolerance = *parsed_number<double>(choices.tolerance) / 100;
    else
        options.leaves = typed_count(choices.leaves);
    return options;
}

PlacingOptions placing_of(const FitChoices& choices) {
    return {.same_size = choices.same_size, .same_center = choices.same_center};
}

std::vector<UpAxis> ups_of(const FitChoices& choices) {
    constexpr std::array<UpAxis, 3> axes{UpAxis::x, UpAxis::y, UpAxis::z};
    std::vector<UpAxis> ups;
    ups.reserve(choices.ups.size());
    for (const std::size_t up : choices.ups) ups.push_back(axes[up]);
    return ups;
}

glm::dmat3 rotation_of(const FitChoices::Turn& turn) {
    return matrix_of({turn.axis, degrees_of(turn).value_or(0)});
}

std::vector<std::array<glm::vec3, 2>> edges_over_mesh(const SphereRoots& roots,
                                                      const FitChoices::Turn& turn) {
    // The turn rotates the surface under the roots. Over a fixed surface, the roots turn the other way.
    const glm::dmat3 rotation = glm::transpose(rotation_of(turn));
    std::vector<std::array<glm::vec3, 2>> edges;
    for (const Triangle& triangle : roots.complex.triangles())
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Index from = triangle[corner];
            const Index to = triangle[(corner + 1) % 3];
            if (from < to)
                edges.push_back(
                    {glm::vec3(rotation * roots.points[from]), glm::vec3(rotation * roots.points[to])});
        }
    return edges;
}

}  // namespace interleaf
