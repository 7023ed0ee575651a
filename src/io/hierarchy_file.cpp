#include "io/hierarchy_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "io/crc32.h"
#include "io/input_file.h"
#include "io/joined_text.h"
#include "io/safe_write.h"

namespace interleaf {

namespace {

static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie in the file");
static_assert(sizeof(Triangle) == 12 && sizeof(glm::vec3) == 12);

using Bytes = std::span<const std::byte>;

constexpr std::uint32_t file_version = 1;

struct Header {
    std::array<unsigned char, 8> signature{0x89, 'I', 'L', 'H', '\r', '\n', 0x1a, '\n'};
    std::uint32_t version = file_version;
    std::uint32_t fields = 0;
    std::uint32_t root_vertices = 0;
    std::uint32_t root_triangles = 0;
    std::uint32_t midpoints = 0;
    std::uint32_t vertices = 0;
};
static_assert(sizeof(Header) == 32);

constexpr std::size_t smallest_file = sizeof(Header) + sizeof(std::uint32_t);

[[noreturn]] void fail(std::string_view name, std::string_view place, std::string_view what) {
    throw InputError(fmt::format("{}: {}: {}", name, place, what));
}

std::uint64_t word_count(const Header& header) {
    return (std::uint64_t{header.root_triangles} + 2 * std::uint64_t{header.midpoints} + 63) / 64;
}

/// Size of the file that \p header describes. Counts have 32 bits, so 64 bits cannot overflow.
std::uint64_t file_size(const Header& header) {
    return smallest_file + sizeof(Triangle) * std::uint64_t{header.root_triangles} + 8 * word_count(header) +
           sizeof(Index) * std::uint64_t{header.midpoints} +
           sizeof(glm::vec3) * std::uint64_t{header.vertices};
}

void check_signature(Bytes head, std::string_view name) {
    const Header expected;
    const Bytes signature = std::as_bytes(std::span(expected.signature));
    const std::size_t length = std::min(head.size(), signature.size());
    if (std::ranges::equal(head.first(length), signature.first(length))) return;
    if (length == signature.size() && std::ranges::equal(head.first(4), signature.first(4)))
        fail(name, "signature", "its line ends are damaged, as by a transfer in text mode");
    fail(name, "signature", "is not that of a hierarchy file (.ilh)");
}

/// The header, once the file is known to be as large as it says. \p head is the beginning of a file of \p
/// size bytes.
Header checked_header(Bytes head, std::uint64_t size, std::string_view name) {
    check_signature(head, name);
    if (size < smallest_file)
        fail(name, "size", fmt::format("{} bytes, expected at least {}: it is cut off", size, smallest_file));

    Header header;
    std::memcpy(&header, head.data(), sizeof(Header));
    if (header.version != file_version)
        fail(name, "version", fmt::format("is {}, expected {}", header.version, file_version));
    if (header.fields != 0)
        fail(name, "field count", fmt::format("is {}, expected 0 in version 1", header.fields));
    if (const std::uint64_t expected = file_size(header); size != expected)
        fail(name, "size",
             fmt::format("{} bytes, expected {} by its counts: it is {}", size, expected,
                         size < expected ? "cut off" : "too long"));
    if (header.root_triangles == 0) fail(name, "root triangle count", "is 0, expected at least 1");
    // The file's size bounds the vertices and only so the root vertices, of which a root complex is made.
    if (header.root_vertices > header.vertices)
        fail(name, "root vertex count",
             fmt::format("is {}, expected at most the {} vertices", header.root_vertices, header.vertices));
    return header;
}

void check_checksum(Bytes bytes, std::string_view name) {
    std::uint32_t stored;
    std::memcpy(&stored, bytes.last(sizeof(stored)).data(), sizeof(stored));
    const std::uint32_t computed = crc32(bytes.first(bytes.size() - sizeof(stored)));
    if (stored != computed)
        fail(name, "checksum",
             fmt::format("is {:08x}, expected {:08x} by the content: it is damaged", stored, computed));
}

template <typename Value>
std::vector<Value> take(Bytes& bytes, std::size_t count) {
    std::vector<Value> values(count);
    const std::span target = std::as_writable_bytes(std::span(values));
    std::ranges::copy(bytes.first(target.size()), target.begin());
    bytes = bytes.subspan(target.size());
    return values;
}

template <typename Value>
void append(std::vector<std::byte>& bytes, std::span<const Value> values) {
    const Bytes source = std::as_bytes(values);
    bytes.insert(bytes.end(), source.begin(), source.end());
}

}  // namespace

Hierarchy parse_hierarchy(Bytes bytes, std::string_view name) {
    const Header header = checked_header(bytes, bytes.size(), name);
    check_checksum(bytes, name);

    Bytes rest = bytes.subspan(sizeof(Header));
    Hierarchy hierarchy;
    try {
        hierarchy.roots = RootComplex(header.root_vertices, take<Triangle>(rest, header.root_triangles));
    } catch (const InputError& error) {
        fail(name, "root complex", error.what());
    }
    hierarchy.bits = take<std::uint64_t>(rest, word_count(header));
    hierarchy.midpoints = take<Index>(rest, header.midpoints);
    hierarchy.positions = take<glm::vec3>(rest, header.vertices);

    if (const std::vector<std::string> violations = check(hierarchy); !violations.empty())
        fail(name, "hierarchy", joined(violations, "; "));
    return hierarchy;
}

Hierarchy read_hierarchy(const std::filesystem::path& file) {
    InputFile input(file);
    std::vector<std::byte> bytes(std::min<std::uint64_t>(input.size(), sizeof(Header)));
    input.read(bytes);
    checked_header(bytes, input.size(), file.string());

    bytes.resize(input.size());
    input.read(std::span(bytes).subspan(sizeof(Header)));
    return parse_hierarchy(bytes, file.string());
}

std::vector<std::byte> serialize_hierarchy(const Hierarchy& hierarchy) {
    Header header;
    header.root_vertices = hierarchy.roots.vertex_count();
    header.root_triangles = hierarchy.roots.triangle_count();
    header.midpoints = static_cast<std::uint32_t>(hierarchy.midpoints.size());
    header.vertices = static_cast<std::uint32_t>(hierarchy.positions.size());

    std::vector<std::byte> bytes;
    bytes.reserve(file_size(header));
    append(bytes, std::span<const Header>(&header, 1));
    append(bytes, hierarchy.roots.triangles());
    append(bytes, std::span<const std::uint64_t>(hierarchy.bits));
    append(bytes, std::span<const Index>(hierarchy.midpoints));
    append(bytes, std::span<const glm::vec3>(hierarchy.positions));
    const std::uint32_t checksum = crc32(bytes);
    append(bytes, std::span<const std::uint32_t>(&checksum, 1));
    return bytes;
}

void write_hierarchy(const Hierarchy& hierarchy, const std::filesystem::path& file) {
    write_file(file, serialize_hierarchy(hierarchy));
}

}  // namespace interleaf
