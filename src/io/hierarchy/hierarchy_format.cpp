#include "io/hierarchy/hierarchy_format.h"

#include <algorithm>
#include <cassert>

#include <fmt/core.h>
#include <libdeflate.h>

#include "hierarchy/error.h"

namespace interleaf::hierarchy_format {

namespace {

template <typename Values>
std::uint32_t continued(std::uint32_t checksum, const Values& values) {
    const auto bytes = std::as_bytes(std::span(values));
    // Given no address, libdeflate takes it that the checksum begins.
    return bytes.empty() ? checksum : libdeflate_crc32(checksum, bytes.data(), bytes.size());
}

}  // namespace

Header header_of(const Hierarchy& hierarchy) {
    Header header;
    header.fields = static_cast<std::uint32_t>(hierarchy.fields.size());
    header.root_vertices = hierarchy.roots.vertex_count();
    header.root_triangles = hierarchy.roots.triangle_count();
    header.midpoints = static_cast<std::uint32_t>(hierarchy.midpoints.size());
    header.vertices = static_cast<std::uint32_t>(hierarchy.positions.size());
    return header;
}

std::uint64_t word_count(const Header& header) {
    return (std::uint64_t{header.root_triangles} + 2 * std::uint64_t{header.midpoints} + 63) / 64;
}

std::vector<std::byte> field_table(std::span<const Field> fields) {
    std::vector<std::byte> table;
    for (const Field& field : fields) {
        assert(field.name.size() <= max_field_name);
        table.push_back(static_cast<std::byte>(field.kind));
        table.push_back(static_cast<std::byte>(field.name.size()));
        const auto name = std::as_bytes(std::span(field.name));
        table.insert(table.end(), name.begin(), name.end());
    }
    return table;
}

std::uint64_t table_size(std::span<const FieldName> fields) {
    std::uint64_t size = 0;
    for (const FieldName& field : fields) size += 2 + field.name.size();
    return size;
}

// Counts have 32 bits, and there are few fields, so 64 bits cannot overflow.
std::uint64_t plain_size(const Header& header, std::span<const FieldName> fields) {
    std::uint64_t components = 0;
    for (const FieldName& field : fields) components += component_count(field.kind);
    return sizeof(Header) + table_size(fields) + sizeof(float) * components * header.vertices +
           sizeof(Triangle) * std::uint64_t{header.root_triangles} + 8 * word_count(header) +
           sizeof(Index) * std::uint64_t{header.midpoints} +
           sizeof(glm::vec3) * std::uint64_t{header.vertices} + sizeof(std::uint32_t);
}

std::uint32_t plain_checksum(const Hierarchy& hierarchy, std::span<const glm::vec3> positions) {
    std::uint32_t checksum = continued(0, std::array{header_of(hierarchy)});
    checksum = continued(checksum, field_table(hierarchy.fields));
    checksum = continued(checksum, hierarchy.roots.triangles());
    checksum = continued(checksum, hierarchy.bits);
    checksum = continued(checksum, hierarchy.midpoints);
    checksum = continued(checksum, positions);
    for (const Field& field : hierarchy.fields) checksum = continued(checksum, field.values);
    return checksum;
}

void append_checksum(std::vector<std::byte>& bytes) {
    const std::array checksum = {continued(0, bytes)};
    const auto end = std::as_bytes(std::span(checksum));
    bytes.insert(bytes.end(), end.begin(), end.end());
}

void fail(std::string_view name, std::string_view place, std::string_view what) {
    throw InputError(fmt::format("{}: {}: {}", name, place, what));
}

RootComplex root_complex(Index vertex_count, std::vector<Triangle> triangles, std::string_view name) {
    try {
        // More vertices than corners would only take memory until they are found to be unused.
        if (vertex_count > 3 * triangles.size())
            throw InputError(
                fmt::format("there are {} vertices, more than corners of triangles", vertex_count));
        return {vertex_count, std::move(triangles)};
    } catch (const InputError& error) {
        fail(name, "root complex", error.what());
    }
}

void require_counts(const Header& header, std::string_view name) {
    if (header.root_triangles == 0) fail(name, "root triangle count", "is 0, expected at least 1");
    // Vertices are borne out by the size of the file, root vertices only by them.
    if (header.root_vertices > header.vertices)
        fail(name, "root vertex count",
             fmt::format("is {}, expected at most the {} vertices", header.root_vertices, header.vertices));
}

void require_size(std::uint64_t size, std::uint64_t expected, std::string_view name) {
    if (size != expected)
        fail(name, "size",
             fmt::format("{} bytes, expected {} by its counts: it is {}", size, expected,
                         size < expected ? "cut off" : "too long"));
}

// Blocks that stay in the cache until they are summed: so memory is passed over once, not twice.
void SummedInput::read(std::span<std::byte> bytes) {
    position_ += bytes.size();
    constexpr std::size_t block_size = 256 << 10;
    while (!bytes.empty()) {
        const auto block = bytes.first(std::min(bytes.size(), block_size));
        fill_(block);
        checksum_ = continued(checksum_, block);
        bytes = bytes.subspan(block.size());
    }
}

void SummedInput::read_checksum(std::string_view name) {
    const std::uint32_t computed = checksum_;
    const auto stored = read_value<std::uint32_t>();
    if (stored != computed)
        fail(name, "checksum",
             fmt::format("is {:08x}, expected {:08x} by the content: it is damaged", stored, computed));
}

std::vector<FieldName> read_field_table(const Header& header, SummedInput& input, std::uint64_t size,
                                        std::string_view name) {
    const auto fail_at = [name](std::uint32_t field, std::string_view what) {
        fail(name, fmt::format("field {}", field), what);
    };
    std::vector<FieldName> fields;
    for (std::uint32_t n = 0; n < header.fields; ++n) {
        const auto require = [&](std::uint64_t bytes) {
            if (size - input.position() < bytes) fail_at(n, "the file is cut off in the table of fields");
        };
        require(2);
        const auto [kind, length] = input.read_value<std::array<std::uint8_t, 2>>();
        if (kind != component_count(FieldKind::scalar) && kind != component_count(FieldKind::color))
            fail_at(n, fmt::format("the kind is {}, expected 1 (scalar) or 3 (color)", kind));
        if (length == 0) fail_at(n, "the name is empty");
        require(length);
        FieldName field{std::string(length, ' '), static_cast<FieldKind>(kind)};
        input.read_values(field.name);
        fields.push_back(std::move(field));
    }
    return fields;
}

}  // namespace interleaf::hierarchy_format
