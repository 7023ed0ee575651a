// Hierarchy files in the plain form: header, root triangles, preorder bits, midpoints, positions.
#include <cstring>

#include "fuzz/hierarchy_parts.h"
#include "fuzz/target.h"

namespace interleaf::fuzz {

namespace {

using hierarchy_format::Header;

std::vector<Bytes> parts_of(ByteSpan file) {
    if (file.size() < sizeof(Header) + sizeof(std::uint32_t)) return {};
    const Header header = header_at(file);
    ByteSpan rest = file.first(file.size() - sizeof(std::uint32_t));
    std::vector<Bytes> parts;
    parts.push_back(take(rest, sizeof(Header)));
    parts.push_back(take(rest, sizeof(Triangle) * std::uint64_t{header.root_triangles}));
    parts.push_back(take(rest, sizeof(std::uint64_t) * hierarchy_format::word_count(header)));
    parts.push_back(take(rest, sizeof(Index) * std::uint64_t{header.midpoints}));
    parts.push_back(take(rest, rest.size()));
    return parts;
}

/// Sets the counts by the sizes of the parts, which are cut to whole elements.
void repair_counts(std::vector<Bytes>& parts) {
    parts[0].resize(sizeof(Header));
    Header header = header_at(parts[0]);
    header.root_triangles = static_cast<std::uint32_t>(parts[1].size() / sizeof(Triangle));
    header.midpoints = static_cast<std::uint32_t>(parts[3].size() / sizeof(Index));
    header.vertices = static_cast<std::uint32_t>(parts[4].size() / sizeof(glm::vec3));
    std::memcpy(parts[0].data(), &header, sizeof(header));
    parts[1].resize(sizeof(Triangle) * header.root_triangles);
    parts[2].resize(sizeof(std::uint64_t) * hierarchy_format::word_count(header));
    parts[3].resize(sizeof(Index) * header.midpoints);
    parts[4].resize(sizeof(glm::vec3) * header.vertices);
}

Bytes file_of(std::vector<Bytes> parts, bool keeps_counts) {
    if (!keeps_counts) repair_counts(parts);
    Bytes file;
    for (const Bytes& part : parts) append(file, part);
    append_checksum(file);
    return file;
}

}  // namespace

const Target target{read_hierarchy_bytes, parts_of, file_of, own_size};

}  // namespace interleaf::fuzz
