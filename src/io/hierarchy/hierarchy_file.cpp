#include "io/hierarchy/hierarchy_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "io/file/input_file.h"
#include "io/file/safe_write.h"
#include "io/hierarchy/compressed_hierarchy.h"
#include "io/hierarchy/coordinate_grid.h"
#include "io/hierarchy/hierarchy_format.h"
#include "io/text/joined_text.h"

namespace interleaf {

namespace {

using hierarchy_format::fail;
using hierarchy_format::Header;
using hierarchy_format::SummedInput;
using Bytes = std::span<const std::byte>;

constexpr std::size_t min_plain_file_size = sizeof(Header) + sizeof(std::uint32_t);

void check_signature(Bytes head, std::string_view name) {
    const Header expected;
    const Bytes signature = std::as_bytes(std::span(expected.signature));
    const std::size_t length = std::min(head.size(), signature.size());
    if (std::ranges::equal(head.first(length), signature.first(length))) return;
    if (length == signature.size() && std::ranges::equal(head.first(4), signature.first(4)))
        fail(name, "signature", "its line ends are damaged, as by a transfer in text mode");
    fail(name, "signature", "is not that of a hierarchy file (.ilh)");
}

/// Reads the header of a file of \p size bytes and checks that the file has one of the two forms.
Header read_header(SummedInput& input, std::uint64_t size, std::string_view name) {
    std::array<std::byte, sizeof(Header)> bytes;
    const auto head = std::span(bytes).first(std::min<std::uint64_t>(size, sizeof(Header)));
    input.read(head);
    check_signature(head, name);
    if (size < min_plain_file_size)
        fail(name, "size",
             fmt::format("{} bytes, expected at least {}: it is cut off", size, min_plain_file_size));

    Header header;
    std::memcpy(&header, bytes.data(), sizeof(Header));
    if (header.version != hierarchy_format::plain_version &&
        header.version != hierarchy_format::compressed_version)
        fail(name, "version", fmt::format("is {}, expected 1 or 2", header.version));
    if (header.fields > max_field_count)
        fail(name, "field count", fmt::format("is {}, expected at most {}", header.fields, max_field_count));
    return header;
}

Hierarchy read_plain(const Header& header, SummedInput& input, std::uint64_t size, std::string_view name) {
    const std::vector<FieldName> fields = hierarchy_format::read_field_table(header, input, size, name);
    hierarchy_format::require_size(size, hierarchy_format::plain_size(header, fields), name);
    hierarchy_format::require_counts(header, name);

    std::vector<Triangle> roots(header.root_triangles);
    Hierarchy hierarchy;
    hierarchy.bits.resize(hierarchy_format::word_count(header));
    hierarchy.midpoints.resize(header.midpoints);
    hierarchy.positions.resize(header.vertices);
    input.read_values(roots);
    input.read_values(hierarchy.bits);
    input.read_values(hierarchy.midpoints);
    input.read_values(hierarchy.positions);
    for (const FieldName& field : fields) {
        hierarchy.fields.push_back({field.name, field.kind, {}});
        hierarchy.fields.back().values.resize(component_count(field.kind) * std::size_t{header.vertices});
        input.read_values(hierarchy.fields.back().values);
    }
    input.read_checksum(name);
    hierarchy.roots = hierarchy_format::root_complex(header.root_vertices, std::move(roots), name);
    return hierarchy;
}

Hierarchy read_either_form(SummedInput input, std::uint64_t size, std::string_view name) {
    const Header header = read_header(input, size, name);
    const bool is_plain = header.version == hierarchy_format::plain_version;
    Hierarchy hierarchy = (is_plain ? read_plain : read_compressed)(header, input, size, name);
    if (const std::vector<std::string> violations = check(hierarchy); !violations.empty())
        fail(name, "hierarchy", joined(violations, "; "));
    return hierarchy;
}

template <typename Value>
void append(std::vector<std::byte>& bytes, std::span<const Value> values) {
    const Bytes source = std::as_bytes(values);
    bytes.insert(bytes.end(), source.begin(), source.end());
}

std::vector<std::byte> plain_bytes(const Hierarchy& hierarchy, std::span<const glm::vec3> positions) {
    const Header header = hierarchy_format::header_of(hierarchy);
    const std::vector<FieldName> fields = labels(hierarchy.fields);
    const Bytes head = std::as_bytes(std::span<const Header>(&header, 1));
    std::vector<std::byte> bytes(head.begin(), head.end());
    bytes.reserve(hierarchy_format::plain_size(header, fields));
    append(bytes, Bytes(hierarchy_format::field_table(hierarchy.fields)));
    append(bytes, hierarchy.roots.triangles());
    append(bytes, std::span<const std::uint64_t>(hierarchy.bits));
    append(bytes, std::span<const Index>(hierarchy.midpoints));
    append(bytes, positions);
    for (const Field& field : hierarchy.fields) append(bytes, std::span<const float>(field.values));
    hierarchy_format::append_checksum(bytes);
    return bytes;
}

}  // namespace

Hierarchy parse_hierarchy(Bytes bytes, std::string_view name) {
    SummedInput input([rest = bytes](std::span<std::byte> target) mutable {
        std::memcpy(target.data(), rest.data(), target.size());
        rest = rest.subspan(target.size());
    });
    return read_either_form(std::move(input), bytes.size(), name);
}

Hierarchy read_hierarchy(const std::filesystem::path& file) {
    InputFile input(file);
    return read_either_form(SummedInput([&](std::span<std::byte> target) { input.read(target); }),
                            input.size(), file.string());
}

bool is_compressed_hierarchy(const std::filesystem::path& file) {
    InputFile input(file);
    SummedInput summed([&](std::span<std::byte> target) { input.read(target); });
    return read_header(summed, input.size(), file.string()).version == hierarchy_format::compressed_version;
}

std::vector<std::byte> serialize_hierarchy(const Hierarchy& hierarchy, const HierarchyFileOptions& options) {
    std::span<const glm::vec3> positions = hierarchy.positions;
    Buffer<glm::vec3> rounded;
    if (options.rounding_bits > 0) {
        rounded = rounded_positions(positions, options.rounding_bits);
        positions = rounded;
    }
    if (options.compressed)
        if (auto bytes = compressed_bytes(hierarchy, positions)) return *std::move(bytes);
    return plain_bytes(hierarchy, positions);
}

void write_hierarchy(const Hierarchy& hierarchy, const std::filesystem::path& file,
                     const HierarchyFileOptions& options) {
    write_file(file, serialize_hierarchy(hierarchy, options));
}

}  // namespace interleaf
