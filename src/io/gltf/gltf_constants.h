// The numbers of the glTF 2.0 specification that the reader and the writer share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace interleaf::gltf {

// The container (section 4 of the specification).
inline constexpr std::uint32_t magic = 0x46546C67;  // "glTF"
inline constexpr std::uint32_t version = 2;
inline constexpr std::size_t header_size = 12;
inline constexpr std::size_t chunk_header_size = 8;
inline constexpr std::uint32_t json_chunk = 0x4E4F534A;    // "JSON"
inline constexpr std::uint32_t binary_chunk = 0x004E4942;  // "BIN"

// Buffer views.
inline constexpr int no_target = 0;
inline constexpr int array_buffer = 34962;
inline constexpr int element_array_buffer = 34963;

/// componentType of an accessor.
enum class Component : std::uint16_t {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126,
};

// Attributes.
inline constexpr std::string_view position = "POSITION";
inline constexpr std::string_view normal = "NORMAL";
inline constexpr std::string_view color = "COLOR_0";

/// The `generator` of our own files. A program that has changed a file since puts its own name there.
inline constexpr std::string_view generator = "Interleaf";

/// The member of `extras` of a mesh, or of the scene, that holds what glTF has no place for (docs/file-formats.md).
inline constexpr std::string_view extras_member = "interleaf";

}  // namespace interleaf::gltf
