#include "fuzz/hierarchy_parts.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "hierarchy/checker.h"
#include "io/hierarchy_file.h"

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
