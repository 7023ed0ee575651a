// The timeline that an animation of morph weights stands for, in files of other programs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "family/timeline.h"
#include "io/gltf/gltf_file.h"

namespace interleaf {

/// The timeline of the first animation of the weights of \p mesh, over the keys base, target 1, target 2 and so
/// on. A timeline shows one key at each of its times, so all weights of a time must be 0, or one of them 1.
/// \param targets      the number of targets, at least 1
/// \param remarks      gets a sentence if there is an animation that is no timeline
/// \return             none without such an animation
/// \throw  InputError  naming the place and what was expected
std::optional<Timeline> weight_timeline(const GltfFile& file, std::size_t mesh, std::size_t targets,
                                        std::vector<std::string>& remarks);

}  // namespace interleaf
