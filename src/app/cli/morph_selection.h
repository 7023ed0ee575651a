// Which morph of which family a command works on: FAMILY, --at, --time and --weights, as `render` and
// `export` share them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "family/family.h"

namespace interleaf {

struct NamedWeight {
    std::string key;
    double value;
};

/// At most one of `at`, `time` and `weights` is set.
struct MorphSelection {
    std::vector<std::filesystem::path> family;        ///< what open_family() takes: none for the built-in one
    std::optional<glm::dvec2> at;                     ///< point of the parameter domain
    std::optional<double> time;                       ///< seconds on the timeline
    std::optional<std::vector<NamedWeight>> weights;  ///< used as given
};

/// The weights that \p selection stands for in \p family. Points and times outside the domain and the
/// timeline are moved to the nearest inside. Without a choice it is time 0, or the only key; none where the
/// family has several keys and no timeline. \throw UsageError when the family lacks the domain, the timeline
/// or the key that is asked for
std::optional<Weights> chosen_weights(const MorphSelection& selection, const Family& family);

/// The same where weights are needed.
/// \throw UsageError as chosen_weights(), and where there are none
Weights selected_weights(const MorphSelection& selection, const Family& family);

}  // namespace interleaf
