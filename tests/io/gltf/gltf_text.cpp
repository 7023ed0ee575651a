#include "io/gltf/gltf_text.h"

#include <cstdint>

#include <fmt/core.h>

namespace interleaf {

namespace {

template <typename T>
void append(std::string& bytes, const std::vector<T>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// A document of one mesh at one node.
std::string document(const std::string& mesh, const std::string& arrays, const std::string& buffer,
                     std::size_t size) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],)"
        R"("meshes":[{}],{},"buffers":[{{"byteLength":{},"uri":"{}"}}]}})",
        mesh, arrays, size, buffer);
}

std::string data_uri(const std::string& bytes) {
    return "data:application/octet-stream;base64," + base64_of(bytes);
}

}  // namespace

std::string base64_of(const std::string& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i)
            three = three << 8 | (n + i < bytes.size() ? static_cast<unsigned char>(bytes[n + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            text += n + i <= bytes.size() ? digits[three >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::string SquareText::bytes() const {
    std::string all;
    append(all, positions);
    for (const auto& target : deltas) append(all, target);
    for (const auto& numbers : scalars) append(all, numbers);
    return all;
}

std::string SquareText::text(const std::string& uri) const {
    std::string accessors;
    std::string views;
    std::string targets;
    for (std::size_t n = 0; n <= deltas.size(); ++n) {
        const char* const comma = n == 0 ? "" : ",";
        accessors += fmt::format(R"({}{{"bufferView":{},"componentType":5126,"count":{},"type":"VEC3"}})",
                                 comma, n, positions.size());
        views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})", comma,
                             12 * n * positions.size(), 12 * positions.size());
        if (n > 0) targets += fmt::format(R"({}{{"POSITION":{}}})", n == 1 ? "" : ",", n);
    }
    std::size_t place = 12 * (deltas.size() + 1) * positions.size();
    for (std::size_t n = 0; n < scalars.size(); ++n) {
        accessors += fmt::format(R"(,{{"bufferView":{},"componentType":5126,"count":{},"type":"SCALAR"}})",
                                 deltas.size() + 1 + n, scalars[n].size());
        views +=
            fmt::format(R"(,{{"buffer":0,"byteOffset":{},"byteLength":{}}})", place, 4 * scalars[n].size());
        place += 4 * scalars[n].size();
    }
    const std::string mesh = fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":0}}{}}}]{}}})",
                                         targets.empty() ? "" : fmt::format(R"(,"targets":[{}])", targets),
                                         extras.empty() ? "" : fmt::format(R"(,"extras":{})", extras));
    std::string all = document(mesh, fmt::format(R"("accessors":[{}],"bufferViews":[{}])", accessors, views),
                               uri.empty() ? data_uri(bytes()) : uri, bytes().size());
    const std::string bare = R"({"mesh":0})";
    all.replace(all.find(bare), bare.size(), fmt::format(R"({{"mesh":0{}}})", node));
    all.insert(all.size() - 1, rest);
    return all;
}

std::string sparse_square() {
    std::string bytes;
    append(bytes, std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    append(bytes, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3});
    append(bytes, std::vector<std::uint16_t>{2, 0});
    append(bytes, std::vector<glm::vec3>{{0, 0, 5}});
    return document(
        R"({"primitives":[{"attributes":{"POSITION":0},"indices":1,"targets":[{"POSITION":2}]}]})",
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},)"
        R"({"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,)"
        R"("indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":3}}}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12},)"
        R"({"buffer":0,"byteOffset":60,"byteLength":4},{"buffer":0,"byteOffset":64,"byteLength":12}])",
        data_uri(bytes), bytes.size());
}

std::string packed_square() {
    std::string bytes;
    append(bytes, std::vector<std::uint8_t>{0, 0, 0, 9, 255, 0, 0, 9, 255, 255, 0, 9, 0, 255, 0, 9});
    return document(
        R"({"primitives":[{"mode":6,"attributes":{"POSITION":0}}]})",
        R"("accessors":[{"bufferView":0,"componentType":5121,"normalized":true,"count":4,"type":"VEC3"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":16,"byteStride":4}])",
        data_uri(bytes), bytes.size());
}

}  // namespace interleaf
