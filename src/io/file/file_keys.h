// Keys as the files of one format hold them, before they are a family.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "family/field_scale.h"
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
    std::vector<FieldScale> scales{};  ///< offsets and units of the fields
    std::vector<std::string> remarks{};  ///< sentences about content that was read differently than written
};

/// Adds the keys \p one of one file to \p all, the keys of the files before it. Values of a field get the offset that
/// the field has there already.
/// \param file  the name of a key without source, and the index of the file
/// \throw InputError if a value with the other offset is no finite float
void append_keys(FileKeys& all, FileKeys one, KeySource file);

/// Files that can be read, but are not keys as they are.
struct Misfit {
    std::string reason;  ///< names the file, the place and what was expected
};

}  // namespace interleaf
