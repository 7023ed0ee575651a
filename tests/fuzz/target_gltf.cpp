// glTF files. The parts of a .glb are its JSON and its buffer; any other file is one part. The text of a
// .gltf cannot name files of the folder, because that folder holds only the file itself.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "fuzz/hierarchy_parts.h"
#include "fuzz/scratch_file.h"
#include "fuzz/target.h"

#include "family/family.h"
#include "hierarchy/checker.h"
#include "io/gltf/gltf_arrays.h"
#include "io/gltf/gltf_reader.h"

namespace interleaf::fuzz {

namespace {

constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

std::uint32_t word_at(ByteSpan bytes, std::size_t place) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + place, sizeof(word));
    return word;
}

void append_word(Bytes& bytes, std::size_t number) {
    const auto word = static_cast<std::uint32_t>(number);
    append(bytes, std::as_bytes(std::span(&word, 1)));
}

Inspection read(ByteSpan bytes) {
    static const ScratchFile file("mesh.glb");
    file.set_content(bytes);
    return [family = read_gltf_family(file.path())]() -> std::string {
        if (const auto violations = check(family); !violations.empty())
            return "unsound: " + violations.front();
        for (const Key& key : family.keys)
            if (const auto violations = check(*key.hierarchy); !violations.empty())
                return "unsound: " + violations.front();
        return "";
    };
}

std::vector<Bytes> parts_of(ByteSpan file) {
    if (file.size() < header_size + 2 * chunk_header_size || word_at(file, 0) != 0x46546C67)
        return whole_as_part(file);
    const std::size_t text_size = word_at(file, header_size);
    ByteSpan rest = file.subspan(header_size + chunk_header_size);
    if (text_size + chunk_header_size > rest.size()) return {};
    std::vector<Bytes> parts{take(rest, text_size)};
    take(rest, chunk_header_size);
    parts.push_back(take(rest, rest.size()));
    return parts;
}

Bytes file_of(std::vector<Bytes> parts, bool keeps_counts) {
    if (parts.size() < 2) return first_part(std::move(parts), keeps_counts);
    const std::size_t size = header_size + 2 * chunk_header_size + parts[0].size() + parts[1].size();
    Bytes file;
    for (const std::size_t number : {std::size_t{0x46546C67}, std::size_t{2}, size, parts[0].size()})
        append_word(file, number);
    append_word(file, 0x4E4F534A);
    append(file, parts[0]);
    append_word(file, parts[1].size());
    append_word(file, 0x004E4942);
    append(file, parts[1]);
    return file;
}

/// Sparse accessors stand for numbers that the file does not have.
std::uint64_t content_size(ByteSpan file) {
    return file.size() + sizeof(float) * GltfArrays::extra_numbers;
}

}  // namespace

const Target target{"gltf", read, parts_of, file_of, content_size};

}  // namespace interleaf::fuzz
