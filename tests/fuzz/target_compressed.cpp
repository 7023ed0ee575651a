// Hierarchy files in the compressed form. The parts are the 64 bytes before the frames and the contents of
// the frames: planes of root triangles, decisions, planes of positions. Joining compresses the parts again,
// and adds the checksum of the content if there is any content.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "fuzz/hierarchy_parts.h"
#include "fuzz/target.h"
#include <zstd.h>

#include "hierarchy/error.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf::fuzz {

namespace {

using hierarchy_format::Header;

constexpr std::size_t decision_count_place = 32;
constexpr std::size_t first_size_place = 40;
constexpr std::size_t second_size_place = 48;
constexpr std::size_t content_checksum_place = 60;
constexpr std::size_t fixed_size = 64;
constexpr std::uint64_t row_size = 12;

std::uint64_t number_at(ByteSpan bytes, std::size_t place) {
    std::uint64_t number = 0;
    std::memcpy(&number, bytes.data() + place, sizeof(number));
    return number;
}

void set_number(Bytes& bytes, std::size_t place, std::uint64_t number) {
    std::memcpy(bytes.data() + place, &number, sizeof(number));
}

/// The content of a frame, if it is small; empty if the frame is damaged.
Bytes decompressed(ByteSpan frame) {
    constexpr unsigned long long most = 1 << 20;
    const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
    Bytes content(size <= most ? size : 0);
    const std::size_t result = ZSTD_decompress(content.data(), content.size(), frame.data(), frame.size());
    content.resize(ZSTD_isError(result) != 0 ? 0 : result);
    return content;
}

Bytes compressed(ByteSpan content) {
    Bytes frame(ZSTD_compressBound(content.size()));
    frame.resize(ZSTD_compress(frame.data(), frame.size(), content.data(), content.size(), 1));
    return frame;
}

enum Part { head, table, roots, decisions, positions, values };

std::vector<Bytes> parts_of(ByteSpan file) {
    if (file.size() < fixed_size + sizeof(std::uint32_t)) return {};
    const Header header = header_at(file);
    ByteSpan rest = file.first(file.size() - sizeof(std::uint32_t));
    std::vector<Bytes> parts;
    parts.push_back(take(rest, fixed_size));
    if (header.fields > 0) take(rest, sizeof(std::uint64_t));  // the size of the third frame
    parts.push_back(take(rest, field_table(rest, header.fields).size));
    const Bytes connectivity = decompressed(take(rest, number_at(file, first_size_place)));
    ByteSpan content = connectivity;
    parts.push_back(take(content, row_size * header.root_triangles));
    parts.push_back(take(content, content.size()));
    parts.push_back(decompressed(take(rest, number_at(file, second_size_place))));
    parts.push_back(decompressed(rest));
    return parts;
}

void repair_counts(std::vector<Bytes>& parts) {
    const FieldTable fields = field_table(parts[table], ~0U);
    parts[head].resize(fixed_size);
    Header header = header_at(parts[head]);
    header.fields = fields.fields;
    header.root_triangles = static_cast<std::uint32_t>(parts[roots].size() / row_size);
    header.vertices = static_cast<std::uint32_t>(parts[positions].size() / row_size);
    std::memcpy(parts[head].data(), &header, sizeof(header));
    parts[table].resize(fields.size);
    parts[roots].resize(row_size * header.root_triangles);
    parts[positions].resize(row_size * header.vertices);
    parts[values].resize((fields.components + 2) / 3 * row_size * header.vertices);  // columns in threes
    set_number(parts[head], decision_count_place, parts[decisions].size());
}

/// The checksum that the reader expected, taken from its message; none if it reported another error.
std::string expected_content_checksum(const Bytes& file) {
    constexpr std::string_view begin = "key: checksum of the content: is ";
    constexpr std::string_view middle = "00000000, expected ";
    try {
        parse_hierarchy(file, "key");
    } catch (const InputError& error) {
        const std::string message = error.what();
        if (message.starts_with(begin)) return message.substr(begin.size() + middle.size());
    }
    return {};
}

Bytes file_of(std::vector<Bytes> parts, bool keeps_counts) {
    if (!keeps_counts) repair_counts(parts);
    append(parts[roots], parts[decisions]);
    const Bytes first = compressed(parts[roots]);
    const Bytes second = compressed(parts[positions]);
    const Bytes third = compressed(parts[values]);

    Bytes file = parts[head];
    file.resize(fixed_size);
    set_number(file, first_size_place, first.size());
    set_number(file, second_size_place, second.size());
    const bool has_fields = header_at(file).fields > 0;
    if (has_fields) {
        file.resize(fixed_size + sizeof(std::uint64_t));
        set_number(file, fixed_size, third.size());
        append(file, parts[table]);
    }
    append(file, first);
    append(file, second);
    if (has_fields) append(file, third);
    append_checksum(file);
    if (const std::string expected = expected_content_checksum(file); !expected.empty()) {
        const auto checksum = static_cast<std::uint32_t>(std::strtoul(expected.c_str(), nullptr, 16));
        std::memcpy(file.data() + content_checksum_place, &checksum, sizeof(checksum));
        file.resize(file.size() - sizeof(checksum));
        append_checksum(file);
    }
    return file;
}

/// The largest content that the reader accepts.
std::uint64_t content_size(ByteSpan file) {
    const std::vector<Bytes> parts = parts_of(file);
    if (parts.empty()) return file.size();
    const std::uint64_t limit = (std::uint64_t{16} << 20) + 64 * file.size();
    return std::min(limit, plain_file_size(header_at(file), field_table(parts[table], ~0U).components));
}

}  // namespace

const Target target{"compressed", read_hierarchy_bytes, parts_of, file_of, content_size};

}  // namespace interleaf::fuzz
