// The family and the morph that a command works on: FAMILY, --at, --time, --along and --weights, which `render` and
// `export` share.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "family/family.h"
#include "family/family_time.h"

namespace interleaf {

struct NamedWeight {
    std::string key;
    double value;
};

/// At most one of `at`, `time` and `weights` is set, and `along` only without `at` and `weights`.
struct MorphSelection {
    std::vector<std::filesystem::path>
        family;                       ///< paths that open_family() takes; empty for the built-in family
    std::optional<glm::dvec2> at;     ///< point of the parameter domain
    std::optional<double> time;       ///< on the timeline or the path, in the unit of its times
    std::optional<TimeSource> along;  ///< to which of the two `time` belongs; by default the family's choice
    std::optional<std::vector<NamedWeight>> weights;  ///< used as given
};

/// \throw UsageError if --along names a part that the family lacks
void require_source(const Family& family, TimeSource along);

/// The weights that \p selection means in \p family. A point outside the domain, or a time outside the
/// timeline or the path, moves to the nearest place inside. Without a choice, the weights are those of the only
/// key, or those of time 0.
/// \return none if nothing is chosen, and the family has several keys and neither a timeline nor a path
/// \throw UsageError if the family lacks the domain, the timeline, the path or the key that is chosen
std::optional<Weights> chosen_weights(const MorphSelection& selection, const Family& family);

/// The same for commands that cannot work without weights.
/// \throw UsageError as chosen_weights(), and where that function returns none
Weights selected_weights(const MorphSelection& selection, const Family& family);

}  // namespace interleaf
