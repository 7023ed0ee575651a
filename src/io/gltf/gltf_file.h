// A glTF 2.0 file as bytes: the container, the JSON document and the buffers, which may be inside the file,
// in data URIs, or in files of the same folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/text/json_place.h"

namespace interleaf {

struct GltfFile {
    std::string name;  ///< what messages call the file
    nlohmann::json document;
    std::vector<std::string> buffers;
    std::size_t byte_count = 0;  ///< of the file and of the files of its buffers

    JsonPlace root() const { return {document, name}; }

    /// The elements of the array \p member of the document, such as `meshes`; 0 if there is no such array.
    std::size_t count(std::string_view member) const;

    /// Element \p index of the array \p member.
    /// \throw InputError if there is no such element
    JsonPlace element(std::string_view member, std::size_t index) const;
};

/// Takes a .glb or a .gltf apart.
/// \param folder      where the files of buffers are, and nowhere else
/// \throw InputError  naming the file, the place and what was expected
GltfFile parse_gltf_file(std::string_view bytes, std::string name, const std::filesystem::path& folder);

}  // namespace interleaf
