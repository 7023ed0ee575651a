#include "io/gltf/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/family/family_format.h"
#include "io/file/input_file.h"
#include "io/gltf/gltf_constants.h"
#include "io/text/base64.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// Extensions that change nothing about the surface begin like this.
constexpr std::array<std::string_view, 4> harmless_extensions = {"KHR_materials_", "KHR_texture_",
                                                                 "KHR_lights_", "KHR_mesh_quantization"};
constexpr std::uint64_t max_buffer_size = std::uint64_t{1} << 30;

std::uint32_t word_of(std::string_view bytes, std::size_t place) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + place, sizeof(word));
    return word;
}

struct Chunks {
    std::string_view text;
    std::optional<std::string_view> body;
};

[[noreturn]] void refuse(std::string_view name, std::string_view place, std::string_view what) {
    throw InputError(fmt::format("{}: {}: {}", name, place, what));
}

/// The chunks of a .glb file. Chunks of other kinds are passed over, as the specification asks.
Chunks chunks_of(std::string_view bytes, std::string_view name) {
    if (bytes.size() < gltf::header_size + gltf::chunk_header_size)
        refuse(name, "header", "the file ends in it");
    if (const std::uint32_t version = word_of(bytes, 4); version != gltf::version)
        refuse(name, "version", fmt::format("is {}, expected {}", version, gltf::version));
    if (const std::uint32_t length = word_of(bytes, 8); length != bytes.size())
        refuse(name, "length", fmt::format("is {}, expected the size of the file, {}", length, bytes.size()));
    Chunks chunks;
    std::size_t place = gltf::header_size;
    for (std::size_t number = 0; place < bytes.size(); ++number) {
        const std::string at = fmt::format("chunk {}", number);
        if (bytes.size() - place < gltf::chunk_header_size) refuse(name, at, "the file ends in its header");
        const std::size_t size = word_of(bytes, place);
        const std::uint32_t kind = word_of(bytes, place + 4);
        place += gltf::chunk_header_size;
        if (size > bytes.size() - place)
            refuse(name, at,
                   fmt::format("has {} bytes, but the file has only {} more", size, bytes.size() - place));
        const std::string_view content = bytes.substr(place, size);
        if (number == 0 && kind != gltf::json_chunk) refuse(name, at, "is not JSON");
        if (number == 0) chunks.text = content;
        if (kind == gltf::binary_chunk && !chunks.body) chunks.body = content;
        place += size;
    }
    return chunks;
}

/// \p uri with %20 and the like replaced.
std::string decoded(std::string_view uri, const JsonPlace& place) {
    const auto digit = [](char c) -> std::uint32_t {
        if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0');
        const char small = static_cast<char>(c | 0x20);
        return small >= 'a' && small <= 'f' ? static_cast<std::uint32_t>(small - 'a') + 10 : 16;
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        const std::uint32_t high = i + 2 < uri.size() ? digit(uri[i + 1]) : 16;
        const std::uint32_t low = i + 2 < uri.size() ? digit(uri[i + 2]) : 16;
        if (high > 15 || low > 15) place.fail("has a % without two hexadecimal digits behind it");
        text += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return text;
}

/// The content of a file in \p folder itself.
std::string content_of(const JsonPlace& place, const std::string& uri, const fs::path& folder) {
    const std::string text = decoded(uri, place);
    const bool is_name = !text.empty() && text != "." && text != ".." &&
                         text.find_first_of(std::string_view("/\\:\0", 4)) == std::string::npos;
    if (!is_name)
        place.fail(fmt::format("is {}, expected the name of a file in the same folder", in_quotes(text)));
    std::error_code error;
    const fs::path file = fs::canonical(folder / family_format::path_of(text), error);
    if (error) place.fail(fmt::format("is {}: {}", in_quotes(text), error.message()));
    if (file.parent_path() != fs::canonical(folder))
        place.fail(fmt::format("is {}, a link that leads out of the folder", in_quotes(text)));
    return read_text(file, max_buffer_size);
}

std::string buffer_of(const JsonPlace& buffer, std::size_t index, const Chunks& chunks,
                      const fs::path& folder, std::size_t& byte_count) {
    const std::size_t size = buffer.member("byteLength").index_below(max_buffer_size);
    const auto uri = buffer.optional_member("uri");
    std::string bytes;
    if (!uri) {
        if (index > 0 || !chunks.body) buffer.fail("has no \"uri\", and the file has no binary chunk for it");
        bytes = *chunks.body;
    } else if (const std::string text = uri->string(); text.starts_with("data:")) {
        constexpr std::string_view mark = ";base64,";
        const std::size_t begin = text.find(mark);
        if (begin == std::string::npos) uri->fail("is a data URI that is not base64");
        auto decoded_bytes = from_base64(std::string_view(text).substr(begin + mark.size()));
        if (!decoded_bytes) uri->fail("is a data URI with a character that is not base64");
        bytes = *std::move(decoded_bytes);
    } else {
        bytes = content_of(*uri, text, folder);
        byte_count += bytes.size();
    }
    if (bytes.size() < size)
        buffer.fail(fmt::format("has {} bytes, expected \"byteLength\", {}", bytes.size(), size));
    bytes.resize(size);
    return bytes;
}

void check_extensions(const JsonPlace& root) {
    const auto required = root.optional_member("extensionsRequired");
    for (std::size_t i = 0; required && i < required->size(); ++i) {
        const std::string name = required->element(i).string();
        if (std::ranges::none_of(harmless_extensions,
                                 [&](std::string_view known) { return name.starts_with(known); }))
            required->element(i).fail(fmt::format("is {}, which is not known", in_quotes(name)));
    }
}

}  // namespace

std::size_t GltfFile::count(std::string_view member) const {
    const auto array = root().optional_member(member);
    return array ? array->size() : 0;
}

JsonPlace GltfFile::element(std::string_view member, std::size_t index) const {
    const JsonPlace array = root().member(member);
    if (index >= array.size())
        array.fail(fmt::format("has {} elements, and number {} is used", array.size(), index));
    return array.element(index);
}

GltfFile parse_gltf_file(std::string_view bytes, std::string name, const fs::path& folder) {
    const bool is_binary = bytes.size() >= 4 && word_of(bytes, 0) == gltf::magic;
    const Chunks chunks = is_binary ? chunks_of(bytes, name) : Chunks{.text = bytes, .body = {}};
    GltfFile file{.name = std::move(name), .document = {}, .buffers = {}, .byte_count = bytes.size()};
    file.document = parse_json(chunks.text, file.name);
    const JsonPlace version = file.root().member("asset").member("version");
    if (!version.string().starts_with("2.")) version.fail_expecting("a version 2");
    check_extensions(file.root());
    for (std::size_t i = 0; i < file.count("buffers"); ++i) {
        file.buffers.push_back(buffer_of(file.element("buffers", i), i, chunks, folder, file.byte_count));
        if (file.byte_count > 2 * max_buffer_size) file.root().fail("has buffers of more than 2 GiB");
    }
    return file;
}

}  // namespace interleaf
