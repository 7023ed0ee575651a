// The keys of a family in the extras of a glTF scene, each as the bytes of a compressed hierarchy file. A file of
// segments has no mesh that shows all keys, so only these bring the family back.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "family/family.h"
#include "io/file/file_keys.h"
#include "io/gltf/gltf_file.h"
#include "io/text/json_place.h"

namespace interleaf {

/// What `extras.interleaf` of the scene holds: the members of composition_text(), and the member `hierarchy` of
/// each key, in base64.
nlohmann::ordered_json scene_extras(const Family& family);

/// What scene_extras() gave; none in other files.
std::optional<JsonPlace> own_scene_extras(const GltfFile& file);

/// The keys in \p own, relative to the origin that it names.
/// \param own         of own_scene_extras()
/// \throw InputError  naming the place and what was expected
FileKeys read_scene_keys(const JsonPlace& own);

}  // namespace interleaf
