#include "fuzz/hierarchy_parts.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "hierarchy/checker.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf::fuzz {

Inspection read_hierarchy_bytes(ByteSpan file) {
    return [key = parse_hierarchy(file, "key.ilh")]() -> std::string {
        if (!check(key).empty()) return "unsound: " + check(key).front();
        const Bytes plain = serialize_hierarchy(key);
        const Bytes compressed = serialize_hierarchy(key, {.compressed = true, .rounding_bits = 0});
        if (serialize_hierarchy(parse_hierarchy(plain, "plain")) != plain) return "changed by the plain form";
        if (serialize_hierarchy(parse_hierarchy(compressed, "compressed")) != plain)
            return "changed by the compressed form";
        return {};
    };
}

hierarchy_format::Header header_at(ByteSpan file) {
    hierarchy_format::Header header;
    std::memcpy(&header, file.data(), sizeof(header));
    return header;
}

FieldTable field_table(ByteSpan bytes, std::uint32_t max_fields) {
    FieldTable table;
    while (table.fields < max_fields && table.size + 2 <= bytes.size()) {
        const auto kind = std::to_integer<std::uint64_t>(bytes[table.size]);
        const std::uint64_t size = 2 + std::to_integer<std::uint64_t>(bytes[table.size + 1]);
        if (size > bytes.size() - table.size) break;
        table.size += size;
        table.components += kind;
        ++table.fields;
    }
    return table;
}

std::uint64_t plain_file_size(const hierarchy_format::Header& header, std::uint64_t components) {
    return sizeof(header) + sizeof(Triangle) * std::uint64_t{header.root_triangles} +
           sizeof(std::uint64_t) * hierarchy_format::word_count(header) +
           sizeof(Index) * std::uint64_t{header.midpoints} +
           (sizeof(glm::vec3) + sizeof(float) * components) * header.vertices + sizeof(std::uint32_t);
}

void append_checksum(Bytes& bytes) {
    hierarchy_format::append_checksum(bytes);
}

Bytes take(ByteSpan& rest, std::uint64_t size) {
    const ByteSpan front = rest.first(std::min<std::uint64_t>(size, rest.size()));
    rest = rest.subspan(front.size());
    return {front.begin(), front.end()};
}

void append(Bytes& bytes, ByteSpan more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

}  // namespace interleaf::fuzz
