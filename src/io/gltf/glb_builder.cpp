#include "io/gltf/glb_builder.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "hierarchy/error.h"
#include "io/gltf/gltf_constants.h"

namespace interleaf {

namespace {

using nlohmann::ordered_json;

ordered_json accessor_json(gltf::Component component, std::size_t count, std::string_view type) {
    return {{"componentType", static_cast<int>(component)}, {"count", count}, {"type", type}};
}

ordered_json vector_json(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

void pad(std::string& bytes, char padding) {
    bytes.append((4 - bytes.size() % 4) % 4, padding);
}

void append_number(std::string& bytes, std::size_t number) {
    const auto word = static_cast<std::uint32_t>(number);
    bytes.append(reinterpret_cast<const char*>(&word), sizeof(word));
}

}  // namespace

std::size_t GlbBuilder::add(const void* data, std::size_t size, int target, ordered_json accessor) {
    pad(bytes_, '\0');
    ordered_json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
    if (target != gltf::no_target) view["target"] = target;
    bytes_.append(static_cast<const char*>(data), size);
    accessor["bufferView"] = views_.size();
    views_.push_back(std::move(view));
    accessors_.push_back(std::move(accessor));
    return accessors_.size() - 1;
}

std::size_t GlbBuilder::add_vectors(std::span<const glm::vec3> vectors, GlbBounds bounds) {
    ordered_json accessor = accessor_json(gltf::Component::float32, vectors.size(), "VEC3");
    if (bounds == GlbBounds::with && !vectors.empty()) {
        glm::vec3 least = vectors.front();
        glm::vec3 most = least;
        for (const glm::vec3& v : vectors) {
            least = glm::min(least, v);
            most = glm::max(most, v);
        }
        accessor["min"] = vector_json(least);
        accessor["max"] = vector_json(most);
    }
    return add(vectors.data(), vectors.size_bytes(), gltf::array_buffer, std::move(accessor));
}

std::size_t GlbBuilder::add_scalars(std::span<const float> values) {
    return add(values.data(), values.size_bytes(), gltf::array_buffer,
               accessor_json(gltf::Component::float32, values.size(), "SCALAR"));
}

std::size_t GlbBuilder::add_animation(std::span<const float> values, GlbBounds bounds) {
    ordered_json accessor = accessor_json(gltf::Component::float32, values.size(), "SCALAR");
    if (bounds == GlbBounds::with) {
        const auto [least, most] = std::ranges::minmax(values);
        accessor["min"] = ordered_json::array({least});
        accessor["max"] = ordered_json::array({most});
    }
    return add(values.data(), values.size_bytes(), gltf::no_target, std::move(accessor));
}

std::size_t GlbBuilder::add_animation(std::span<const glm::vec3> values) {
    return add(values.data(), values.size_bytes(), gltf::no_target,
               accessor_json(gltf::Component::float32, values.size(), "VEC3"));
}

std::size_t GlbBuilder::add_indices(std::span<const Triangle> triangles, std::size_t vertex_count) {
    const std::size_t count = 3 * triangles.size();
    if (vertex_count > 0xffff)
        return add(triangles.data(), triangles.size_bytes(), gltf::element_array_buffer,
                   accessor_json(gltf::Component::uint32, count, "SCALAR"));
    std::vector<std::uint16_t> narrow;
    narrow.reserve(count);
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle) narrow.push_back(static_cast<std::uint16_t>(vertex));
    return add(narrow.data(), sizeof(std::uint16_t) * count, gltf::element_array_buffer,
               accessor_json(gltf::Component::uint16, count, "SCALAR"));
}

std::string GlbBuilder::file(ordered_json document) const {
    const std::size_t body_size = (bytes_.size() + 3) / 4 * 4;
    document["bufferViews"] = views_;
    document["accessors"] = accessors_;
    document["buffers"] = ordered_json::array({{{"byteLength", body_size}}});
    std::string text = document.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    pad(text, ' ');
    const std::size_t size = gltf::header_size + 2 * gltf::chunk_header_size + text.size() + body_size;
    if (size > max_glb_size)
        throw InputError(
            fmt::format("the file would have {} bytes, and a .glb file has at most {}", size, max_glb_size));
    std::string file;
    file.reserve(size);
    for (const std::size_t number : {std::size_t{gltf::magic}, std::size_t{gltf::version}, size})
        append_number(file, number);
    append_number(file, text.size());
    append_number(file, gltf::json_chunk);
    file += text;
    append_number(file, body_size);
    append_number(file, gltf::binary_chunk);
    file += bytes_;
    pad(file, '\0');
    return file;
}

}  // namespace interleaf
