#include "io/hierarchy/compressed_hierarchy.h"

#include <array>
#include <cstring>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/hierarchy/bisection_decisions.h"
#include "io/hierarchy/byte_planes.h"
#include "io/hierarchy/coordinate_grid.h"
#include "io/hierarchy/field_planes.h"
#include "io/hierarchy/position_planes.h"
#include "io/hierarchy/zstd_frame.h"

namespace interleaf {

namespace {

using hierarchy_format::fail;
using hierarchy_format::Header;
using Bytes = std::span<const std::byte>;
using Parts = std::vector<Bytes>;

constexpr std::int32_t no_grid = 0x7fffffff;

/// The part after the header. If there are fields, the size of their frame and their table follow. Then come
/// the frames, and the checksum of everything before it.
struct Extension {
    std::uint64_t decisions = 0;
    std::uint64_t connectivity_size = 0;  ///< bytes of the first frame
    std::uint64_t positions_size = 0;     ///< bytes of the second frame
    std::int32_t grid_exponent = no_grid;
    std::uint32_t plain_checksum = 0;
};
static_assert(sizeof(Extension) == 32);

/// Everything between the header and the frames.
struct Preamble {
    Extension extension;
    std::uint64_t fields_size = 0;  ///< bytes of the third frame; none without fields
    std::vector<FieldName> fields;
};

constexpr std::uint64_t min_file_size = sizeof(Header) + sizeof(Extension) + sizeof(std::uint32_t);

/// The largest plain file, in bytes, that a compressed file of \p size bytes may stand for. So the size of
/// the file limits the memory that its reader takes.
constexpr std::uint64_t max_content(std::uint64_t size) {
    return (std::uint64_t{16} << 20) + 64 * size;
}

/// Whether edges can be counted in an Index.
bool has_countable_edges(const Header& header) {
    return 3 * std::uint64_t{header.root_triangles} + 2 * std::uint64_t{header.vertices} +
               std::uint64_t{header.midpoints} <
           no_index - 1;
}

/// The sum of the sizes of the frames.
/// \throw InputError if the sum does not fit 64 bits
std::uint64_t frames_size(const Preamble& preamble, std::string_view name) {
    std::uint64_t sum = 0;
    for (const std::uint64_t size :
         {preamble.extension.connectivity_size, preamble.extension.positions_size, preamble.fields_size}) {
        if (size > (~std::uint64_t{0} >> 1) - sum) fail(name, "size", "the sizes of its parts are too large");
        sum += size;
    }
    return sum;
}

/// Reads the size of the fields' frame, and the field table.
void read_labels(const Header& header, hierarchy_format::SummedInput& input, std::uint64_t size,
                 std::string_view name, Preamble& preamble) {
    if (header.fields == 0) return;
    if (size - input.position() < sizeof(std::uint64_t))
        fail(name, "size", fmt::format("{} bytes: it is cut off", size));
    preamble.fields_size = input.read_value<std::uint64_t>();
    preamble.fields = hierarchy_format::read_field_table(header, input, size, name);
}

Preamble read_preamble(const Header& header, hierarchy_format::SummedInput& input, std::uint64_t size,
                       std::string_view name) {
    if (size < min_file_size)
        fail(name, "size", fmt::format("{} bytes, expected at least {}: it is cut off", size, min_file_size));
    Preamble preamble;
    preamble.extension = input.read_value<Extension>();
    read_labels(header, input, size, name, preamble);
    const Extension& extension = preamble.extension;
    const std::uint64_t frames = frames_size(preamble, name);
    hierarchy_format::require_size(size, input.position() + frames + sizeof(std::uint32_t), name);
    hierarchy_format::require_counts(header, name);

    const std::uint64_t content = hierarchy_format::plain_size(header, preamble.fields);
    if (content > max_content(size))
        fail(name, "counts",
             fmt::format("stand for {} bytes, expected at most {} in a file of {}", content,
                         max_content(size), size));
    if (!has_countable_edges(header)) fail(name, "counts", "are too large");
    const std::uint64_t nodes = header.root_triangles + 2 * std::uint64_t{header.midpoints};
    if (extension.decisions > nodes)
        fail(name, "decision count",
             fmt::format("is {}, expected at most the {} nodes", extension.decisions, nodes));
    if (extension.grid_exponent != no_grid && (extension.grid_exponent < CoordinateGrid::min_exponent ||
                                               extension.grid_exponent > CoordinateGrid::max_exponent))
        fail(name, "grid exponent",
             fmt::format("is {}, expected {} to {}, or none", extension.grid_exponent,
                         CoordinateGrid::min_exponent, CoordinateGrid::max_exponent));
    return preamble;
}

std::optional<CoordinateGrid> grid_at(std::int32_t exponent) {
    if (exponent == no_grid) return std::nullopt;
    return CoordinateGrid(exponent);
}

/// The root triangles as differences from the previous triangle, corner by corner.
Buffer<std::byte> root_planes(std::span<const Triangle> roots) {
    Buffer<std::byte> bytes;
    bytes.resize(roots.size() * BytePlanes::bytes_a_row);
    const BytePlanes planes(bytes);
    Triangle before{};
    for (std::size_t row = 0; row < roots.size(); before = roots[row++])
        for (std::size_t corner = 0; corner < 3; ++corner)
            planes.set_difference(row, corner, roots[row][corner] - before[corner]);
    return bytes;
}

std::vector<Triangle> roots_of(std::span<std::byte> bytes) {
    const BytePlanes planes(bytes);
    std::vector<Triangle> roots;
    roots.reserve(planes.rows());
    Triangle triangle{};
    for (std::size_t row = 0; row < planes.rows(); ++row) {
        for (std::size_t corner = 0; corner < 3; ++corner) triangle[corner] += planes.difference(row, corner);
        roots.push_back(triangle);
    }
    return roots;
}

/// Calls \p make. If \p make throws an InputError, adds \p place to its message.
template <typename Make>
auto made_at(std::string_view name, std::string_view place, Make make) {
    try {
        return make();
    } catch (const InputError& error) {
        fail(name, place, error.what());
    }
}

/// The planes of \p bytes, with \p rows bytes each.
Parts plane_parts(Bytes bytes, std::size_t rows) {
    Parts parts;
    for (std::size_t begin = 0; begin < bytes.size(); begin += rows)
        parts.push_back(bytes.subspan(begin, rows));
    return parts;
}

/// Appends the frame of \p parts.
/// \return the size of the frame
std::uint64_t append_sized_frame(std::vector<std::byte>& bytes, const Parts& parts) {
    const std::size_t begin = bytes.size();
    append_frame(bytes, parts);
    return bytes.size() - begin;
}

}  // namespace

Hierarchy read_compressed(const Header& header, hierarchy_format::SummedInput& input, std::uint64_t size,
                          std::string_view name) {
    const Preamble preamble = read_preamble(header, input, size, name);
    const Extension& extension = preamble.extension;
    Buffer<std::byte> frames;
    frames.resize(frames_size(preamble, name));
    input.read(frames);
    input.read_checksum(name);
    const Bytes first = Bytes(frames).first(extension.connectivity_size);
    const Bytes second = Bytes(frames).subspan(first.size(), extension.positions_size);
    const Bytes third = Bytes(frames).last(preamble.fields_size);

    const std::size_t roots_size = BytePlanes::bytes_a_row * std::size_t{header.root_triangles};
    Buffer<std::byte> content =
        made_at(name, "connectivity", [&] { return frame_content(first, roots_size + extension.decisions); });
    const auto root_bytes = std::span(content).first(roots_size);
    const auto decisions = std::span(content).subspan(roots_size);

    Hierarchy hierarchy;
    hierarchy.roots = hierarchy_format::root_complex(header.root_vertices, roots_of(root_bytes), name);
    Connectivity connectivity = made_at(name, "connectivity", [&] {
        return rebuilt_connectivity(hierarchy.roots, header.midpoints, header.vertices, decisions);
    });
    hierarchy.bits = std::move(connectivity.bits);
    hierarchy.midpoints = std::move(connectivity.midpoints);
    hierarchy.positions = made_at(name, "positions", [&] {
        Buffer<std::byte> planes =
            frame_content(second, BytePlanes::bytes_a_row * std::size_t{header.vertices});
        return positions_of(planes, connectivity, grid_at(extension.grid_exponent));
    });
    if (header.fields > 0)
        hierarchy.fields = made_at(name, "fields", [&] {
            Buffer<std::byte> planes =
                frame_content(third, field_planes_size(preamble.fields, header.vertices));
            return fields_of(planes, preamble.fields, connectivity);
        });
    if (const std::uint32_t computed = hierarchy_format::plain_checksum(hierarchy, hierarchy.positions);
        computed != extension.plain_checksum)
        fail(name, "checksum of the content",
             fmt::format("is {:08x}, expected {:08x}", extension.plain_checksum, computed));
    return hierarchy;
}

std::optional<std::vector<std::byte>> compressed_bytes(const Hierarchy& hierarchy,
                                                       std::span<const glm::vec3> positions) {
    Header header = hierarchy_format::header_of(hierarchy);
    if (!has_countable_edges(header)) return std::nullopt;
    const std::uint64_t content = hierarchy_format::plain_size(header, labels(hierarchy.fields));
    header.version = hierarchy_format::compressed_version;
    const DecidedConnectivity decided = open_decisions(hierarchy);
    const std::optional<CoordinateGrid> grid = grid_of(positions);

    Extension extension;
    extension.decisions = decided.decisions.size();
    if (grid) extension.grid_exponent = grid->exponent();
    extension.plain_checksum = hierarchy_format::plain_checksum(hierarchy, positions);

    // Room for the header, the extension and the size of the fields' frame, which are not known yet.
    const std::size_t extension_end = sizeof(Header) + sizeof(Extension);
    const bool has_fields = !hierarchy.fields.empty();
    std::vector<std::byte> bytes(extension_end + (has_fields ? sizeof(std::uint64_t) : 0));
    const std::vector<std::byte> table = hierarchy_format::field_table(hierarchy.fields);
    bytes.insert(bytes.end(), table.begin(), table.end());
    const Buffer<std::byte> roots = root_planes(hierarchy.roots.triangles());
    Parts connectivity = plane_parts(roots, header.root_triangles);
    connectivity.push_back(decided.decisions);
    extension.connectivity_size = append_sized_frame(bytes, connectivity);

    const Buffer<std::byte> differences = position_planes(positions, decided.connectivity, grid);
    extension.positions_size = append_sized_frame(bytes, plane_parts(differences, header.vertices));

    if (has_fields) {
        const Buffer<std::byte> values = field_planes(hierarchy.fields, decided.connectivity);
        const std::uint64_t size = append_sized_frame(bytes, plane_parts(values, header.vertices));
        std::memcpy(bytes.data() + extension_end, &size, sizeof(size));
    }

    std::memcpy(bytes.data(), &header, sizeof(Header));
    std::memcpy(bytes.data() + sizeof(Header), &extension, sizeof(Extension));
    hierarchy_format::append_checksum(bytes);
    if (content > max_content(bytes.size())) return std::nullopt;
    return bytes;
}

}  // namespace interleaf
