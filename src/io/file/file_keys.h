// Keys as the files of one format hold them, before they are a family.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// Where a key comes from, if a file may hold several keys.
struct KeySource {
    std::string name;
    std::size_t file = 0;  ///< index of its file
};

/// The keys of several files, in the files' order.
struct FileKeys {
    std::vector<Hierarchy> keys{};  ///< positions relative to the origin
    std::optional<glm::dvec3>
        origin{};                      ///< subtracted from all positions (family/origin.h); none without one
    std::vector<KeySource> sources{};  ///< one per key; none if each key has a file and is called like it
    std::vector<std::string> remarks{};  ///< sentences about content that was read differently than written
};

/// Files that can be read, but are not keys as they are.
struct Misfit {
    std::string reason;  ///< names the file, the place and what was expected
};

}  // namespace interleaf
