// The parts that both forms of a hierarchy file share: the first 32 bytes, the field table, the checksum of
// the bytes read, and the form of error messages. docs/file-formats.md describes both layouts byte by byte.
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

/// The header of the plain file of \p hierarchy.
Header header_of(const Hierarchy& hierarchy);

/// The number of words of preorder bits.
std::uint64_t word_count(const Header& header);

/// The field table as stored in the file. Each field has one byte for its kind, one byte for the length of
/// its name, and the name.
/// \pre each name has at most max_field_name bytes
std::vector<std::byte> field_table(std::span<const Field> fields);

/// The number of bytes of the table of \p fields.
std::uint64_t table_size(std::span<const FieldName> fields);

/// The number of bytes of the plain file with the counts of \p header and with \p fields.
std::uint64_t plain_size(const Header& header, std::span<const FieldName> fields);

/// The CRC-32 in the last four bytes of the plain file of \p hierarchy, with \p positions instead of its own.
std::uint32_t plain_checksum(const Hierarchy& hierarchy, std::span<const glm::vec3> positions);

/// Appends the checksum of \p bytes.
void append_checksum(std::vector<std::byte>& bytes);

/// Throws an InputError "NAME: PLACE: WHAT".
[[noreturn]] void fail(std::string_view name, std::string_view place, std::string_view what);

/// The root complex of a file.
/// \throw InputError naming \p name, if the triangles are not an orientable manifold that uses all vertices
RootComplex root_complex(Index vertex_count, std::vector<Triangle> triangles, std::string_view name);

/// Throws an InputError unless there is a root, and there are no more root vertices than vertices.
void require_counts(const Header& header, std::string_view name);

/// Throws an InputError unless \p size is \p expected. The message says whether the file is cut off or too
/// long.
void require_size(std::uint64_t size, std::uint64_t expected, std::string_view name);

/// The bytes of a file, read front to back from any source, with the checksum of all bytes read so far.
class SummedInput {
  public:
    /// \param fill  fills a span with the bytes that follow those of its previous call
    explicit SummedInput(std::function<void(std::span<std::byte>)> fill) : fill_(std::move(fill)) {}

    void read(std::span<std::byte> bytes);

    /// The number of bytes read so far.
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

    /// Reads the checksum at the end of the file.
    /// \throw InputError if it is not the checksum of all bytes before it
    void read_checksum(std::string_view name);

  private:
    std::function<void(std::span<std::byte>)> fill_;
    std::uint64_t position_ = 0;
    std::uint32_t checksum_ = 0;
};

/// Reads the table of the fields that \p header counts, from a file of \p size bytes.
/// \throw InputError if the file ends within the table, a kind does not exist, or a name is empty
std::vector<FieldName> read_field_table(const Header& header, SummedInput& input, std::uint64_t size,
                                        std::string_view name);

}  // namespace interleaf::hierarchy_format
