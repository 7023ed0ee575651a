// What the two forms of a hierarchy file have in common: the first 32 bytes, the table of fields, the
// checksum over what was read, and how a fault is told. docs/file-formats.md gives both layouts byte by byte.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"

namespace interleaf::hierarchy_format {

static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie in the file");
static_assert(sizeof(Triangle) == 12 && sizeof(glm::vec3) == 12);

inline constexpr std::uint32_t plain_version = 1;
inline constexpr std::uint32_t compressed_version = 2;

struct Header {
    std::array<unsigned char, 8> signature{0x89, 'I', 'L', 'H', '\r', '\n', 0x1a, '\n'};
    std::uint32_t version = plain_version;
    std::uint32_t fields = 0;
    std::uint32_t root_vertices = 0;
    std::uint32_t root_triangles = 0;
    std::uint32_t midpoints = 0;
    std::uint32_t vertices = 0;
};
static_assert(sizeof(Header) == 32);

/// The header of \p hierarchy as a plain file.
Header header_of(const Hierarchy& hierarchy);

/// Words of preorder bits.
std::uint64_t word_count(const Header& header);

/// The field table as it stands in the file: for each field a byte for its kind, one for the length of its
/// name, the name. \pre each at most max_field_name bytes
std::vector<std::byte> field_table(std::span<const Field> fields);

/// Bytes of the table of \p fields.
std::uint64_t table_size(std::span<const FieldName> fields);

/// Bytes of the plain file with the counts of \p header and \p fields.
std::uint64_t plain_size(const Header& header, std::span<const FieldName> fields);

/// CRC-32 of the plain file of \p hierarchy: what its last four bytes hold.
std::uint32_t plain_checksum(const Hierarchy& hierarchy, std::span<const glm::vec3> positions);

/// Appends the checksum of \p bytes.
void append_checksum(std::vector<std::byte>& bytes);

/// Throws an InputError "NAME: PLACE: WHAT".
[[noreturn]] void fail(std::string_view name, std::string_view place, std::string_view what);

/// The root complex of a file.
RootComplex root_complex(Index vertex_count, std::vector<Triangle> triangles, std::string_view name);

/// Fails unless there are roots, and no more root vertices than vertices.
void require_counts(const Header& header, std::string_view name);

/// Fails unless \p size is \p expected, saying whether the file is cut off or too long.
void require_size(std::uint64_t size, std::uint64_t expected, std::string_view name);

/// Bytes of a file, front to back, from wherever they come, with the checksum of all that were read.
class SummedInput {
  public:
    /// \p fill fills a span with the bytes that follow those it gave before.
    explicit SummedInput(std::function<void(std::span<std::byte>)> fill) : fill_(std::move(fill)) {}

    void read(std::span<std::byte> bytes);

    /// Bytes that were read.
    std::uint64_t position() const { return position_; }

    template <typename Values>
    void read_values(Values& values) {
        read(std::as_writable_bytes(std::span(values)));
    }

    template <typename Value>
    Value read_value() {
        std::array<Value, 1> value;
        read_values(value);
        return value[0];
    }

    /// Reads the checksum that ends the file.
    /// \throw InputError if it is not that of all bytes before
    void read_checksum(std::string_view name);

  private:
    std::function<void(std::span<std::byte>)> fill_;
    std::uint64_t position_ = 0;
    std::uint32_t checksum_ = 0;
};

/// Reads the table of the fields that \p header counts, from a file of \p size bytes.
/// \throw InputError if the file ends within, a kind is none or a name is empty
std::vector<FieldName> read_field_table(const Header& header, SummedInput& input, std::uint64_t size,
                                        std::string_view name);

}  // namespace interleaf::hierarchy_format
