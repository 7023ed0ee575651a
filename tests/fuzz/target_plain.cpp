// Hierarchy files in the plain form. The parts are header, field table, root triangles, preorder bits,
// midpoints, positions and values of the fields.
#include <cstring>

#include "fuzz/hierarchy_parts.h"
#include "fuzz/target.h"

namespace interleaf::fuzz {

namespace {

using hierarchy_format::Header;

enum Part { head, table, roots, bits, midpoints, positions, values };

std::vector<Bytes> parts_of(ByteSpan file) {
    if (file.size() < sizeof(Header) + sizeof(std::uint32_t)) return {};
    const Header header = header_at(file);
    ByteSpan rest = file.first(file.size() - sizeof(std::uint32_t));
    std::vector<Bytes> parts;
    parts.push_back(take(rest, sizeof(Header)));
    parts.push_back(take(rest, field_table(rest, header.fields).size));
    parts.push_back(take(rest, sizeof(Triangle) * std::uint64_t{header.root_triangles}));
    parts.push_back(take(rest, sizeof(std::uint64_t) * hierarchy_format::word_count(header)));
    parts.push_back(take(rest, sizeof(Index) * std::uint64_t{header.midpoints}));
    parts.push_back(take(rest, sizeof(glm::vec3) * std::uint64_t{header.vertices}));
    parts.push_back(take(rest, rest.size()));
    return parts;
}

/// Cuts the parts to whole elements, and sets the counts to the sizes of the parts.
void repair_counts(std::vector<Bytes>& parts) {
    const FieldTable fields = field_table(parts[table], ~0U);
    parts[head].resize(sizeof(Header));
    Header header = header_at(parts[head]);
    header.fields = fields.fields;
    header.root_triangles = static_cast<std::uint32_t>(parts[roots].size() / sizeof(Triangle));
    header.midpoints = static_cast<std::uint32_t>(parts[midpoints].size() / sizeof(Index));
    header.vertices = static_cast<std::uint32_t>(parts[positions].size() / sizeof(glm::vec3));
    std::memcpy(parts[head].data(), &header, sizeof(header));
    parts[table].resize(fields.size);
    parts[roots].resize(sizeof(Triangle) * header.root_triangles);
    parts[bits].resize(sizeof(std::uint64_t) * hierarchy_format::word_count(header));
    parts[midpoints].resize(sizeof(Index) * header.midpoints);
    parts[positions].resize(sizeof(glm::vec3) * header.vertices);
    parts[values].resize(sizeof(float) * fields.components * header.vertices);
}

Bytes file_of(std::vector<Bytes> parts, bool keeps_counts) {
    if (!keeps_counts) repair_counts(parts);
    Bytes file;
    for (const Bytes& part : parts) append(file, part);
    append_checksum(file);
    return file;
}

}  // namespace

const Target target{"plain", read_hierarchy_bytes, parts_of, file_of, own_size};

}  // namespace interleaf::fuzz
