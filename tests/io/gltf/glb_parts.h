// A .glb file taken apart by the plainest means, without the reader.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace interleaf {

struct GlbParts {
    nlohmann::json document;
    std::string_view body;
};

inline std::uint32_t word_at(std::string_view bytes, std::size_t place) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.substr(place, 4).data(), 4);
    return word;
}

/// \pre \p bytes is a .glb file with both chunks, and outlives the result
inline GlbParts glb_parts(std::string_view bytes) {
    const std::size_t text_size = word_at(bytes, 12);
    return {nlohmann::json::parse(bytes.substr(20, text_size)), bytes.substr(28 + text_size)};
}

/// The bytes of an accessor that begins where its view does.
inline std::string_view array_of(const GlbParts& parts, const nlohmann::json& accessor) {
    const nlohmann::json& described = parts.document["accessors"][accessor.get<std::size_t>()];
    const nlohmann::json& view = parts.document["bufferViews"][described["bufferView"].get<std::size_t>()];
    return parts.body.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
}

template <typename T>
std::vector<T> values_of(const GlbParts& parts, const nlohmann::json& accessor) {
    const std::string_view bytes = array_of(parts, accessor);
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

}  // namespace interleaf
