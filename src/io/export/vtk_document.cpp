#include "io/export/vtk_document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <libdeflate.h>

namespace interleaf {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they are in memory");

constexpr std::uint8_t vtk_triangle = 5;  // vtkCellType.h

constexpr std::string_view components_word = "NumberOfComponents";

struct Deflater {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

template <typename Number>
constexpr const char* vtk_type = nullptr;
template <>
constexpr const char* vtk_type<std::uint8_t> = "UInt8";
template <>
constexpr const char* vtk_type<std::int32_t> = "Int32";
template <>
constexpr const char* vtk_type<std::uint32_t> = "UInt32";
template <>
constexpr const char* vtk_type<float> = "Float32";
template <>
constexpr const char* vtk_type<double> = "Float64";

/// The arrays that follow the XML, and the elements that name them.
class AppendedArrays {
  public:
    /// Appends an array.
    /// \param unit  of its numbers; empty for none
    /// \return its element
    template <typename Number>
    std::string add(std::string_view name, std::size_t components, std::span<const Number> numbers,
                    std::string_view count = components_word, std::string_view unit = {}) {
        const std::size_t offset = bytes_.size();
        append_block(std::as_bytes(numbers));
        std::string element =
            fmt::format("<DataArray type=\"{}\" Name=\"{}\" {}=\"{}\" format=\"appended\" offset=\"{}\"",
                        vtk_type<Number>, xml_escaped(name), count, components, offset);
        if (unit.empty()) return element + "/>\n";
        return fmt::format(
            "{}>\n<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}"
            "</InformationKey>\n</DataArray>\n",
            element, xml_escaped(unit));
    }

    const std::string& bytes() const { return bytes_; }

  private:
    /// A header (the number of parts, the size of a part, the size of a shorter last part, the compressed sizes),
    /// then the compressed parts.
    void append_block(std::span<const std::byte> block) {
        constexpr std::size_t part = std::size_t{1} << 20U;
        const std::size_t parts = (block.size() + part - 1) / part;
        append_size(parts);
        append_size(part);
        append_size(block.size() % part);
        std::string packed;
        for (std::size_t n = 0; n < parts; ++n) {
            const auto plain = block.subspan(n * part, std::min(part, block.size() - n * part));
            std::string room(libdeflate_zlib_compress_bound(deflater_.get(), plain.size()), '\0');
            const std::size_t size = libdeflate_zlib_compress(deflater_.get(), plain.data(), plain.size(),
                                                              room.data(), room.size());
            append_size(size);
            packed.append(room, 0, size);
        }
        bytes_ += packed;
    }

    void append_size(std::uint64_t size) {
        const auto raw = std::bit_cast<std::array<char, sizeof size>>(size);
        bytes_.append(raw.data(), raw.size());
    }

    std::string bytes_;
    std::unique_ptr<libdeflate_compressor, Deflater> deflater_{libdeflate_alloc_compressor(6)};
};

std::string points_element(const VtkSurface& surface, AppendedArrays& arrays) {
    if (surface.origin == glm::dvec3(0))
        return arrays.add("Points", 3,
                          std::span(reinterpret_cast<const float*>(surface.positions.data()),
                                    3 * surface.positions.size()));
    std::vector<double> places;
    places.reserve(3 * surface.positions.size());
    for (const glm::vec3& position : surface.positions) {
        const glm::dvec3 place = surface.origin + glm::dvec3(position);
        places.insert(places.end(), {place.x, place.y, place.z});
    }
    return arrays.add("Points", 3, std::span<const double>(places));
}

/// The number of fields from \p first on that are the components of one vector, "u x", "u y" and "u z", as import
/// names them: 2 or 3; otherwise 1.
std::size_t vector_components(std::span<const Field> fields, std::size_t first) {
    constexpr std::array<std::string_view, 3> axes = {" x", " y", " z"};
    std::string_view stem = fields[first].name;
    if (!stem.ends_with(axes[0]) || stem.size() == axes[0].size()) return 1;
    stem.remove_suffix(axes[0].size());
    if (std::ranges::find(fields, stem, &Field::name) != fields.end()) return 1;
    std::size_t count = 0;
    while (count < axes.size() && first + count < fields.size()) {
        const Field& field = fields[first + count];
        if (field.kind != FieldKind::scalar || field.name != std::string(stem) + std::string(axes[count]))
            break;
        ++count;
    }
    return std::max<std::size_t>(count, 1);
}

/// A vector, which has the unit of its first component. Components with an offset make it an array of doubles.
std::string vector_element(std::span<const Field> components, std::span<const FieldScale> scales,
                           AppendedArrays& arrays) {
    std::vector<double> offsets;
    offsets.reserve(components.size());
    for (const Field& component : components) offsets.push_back(scale_of(scales, component.name).offset);
    const std::string unit = scale_of(scales, components.front().name).unit;
    std::string_view stem = components.front().name;
    stem.remove_suffix(2);
    if (std::ranges::any_of(offsets, [](double offset) { return offset != 0; })) {
        std::vector<double> sums;
        sums.reserve(components.size() * components.front().values.size());
        for (std::size_t vertex = 0; vertex < components.front().values.size(); ++vertex)
            for (std::size_t c = 0; c < components.size(); ++c)
                sums.push_back(double{components[c].values[vertex]} + offsets[c]);
        return arrays.add(stem, components.size(), std::span<const double>(sums), components_word, unit);
    }
    std::vector<float> values;
    values.reserve(components.size() * components.front().values.size());
    for (std::size_t vertex = 0; vertex < components.front().values.size(); ++vertex)
        for (const Field& component : components) values.push_back(component.values[vertex]);
    return arrays.add(stem, components.size(), std::span<const float>(values), components_word, unit);
}

std::string scalar_element(const Field& field, const FieldScale& scale, AppendedArrays& arrays) {
    if (scale.offset == 0)
        return arrays.add(field.name, 1, std::span<const float>(field.values), components_word, scale.unit);
    std::vector<double> values;
    values.reserve(field.values.size());
    for (const float value : field.values) values.push_back(double{value} + scale.offset);
    return arrays.add(field.name, 1, std::span<const double>(values), components_word, scale.unit);
}

std::string color_element(const Field& field, AppendedArrays& arrays) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(field.values.size());
    for (const float part : field.values) bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * part)));
    return arrays.add(field.name, component_count(field.kind), std::span<const std::uint8_t>(bytes));
}

/// Per leaf, in preorder, the number of its root.
std::vector<std::uint32_t> roots_of(std::span<const LeafTag> tags) {
    std::vector<std::uint32_t> roots;
    roots.reserve(tags.size());
    std::uint32_t root = 0;
    std::uint64_t part = 0;  // of the root, in 2^-64 of it: 0 again where its leaves are complete
    for (const LeafTag tag : tags) {
        roots.push_back(root);
        if (tag.level() > 0) part += std::uint64_t{1} << (max_level - tag.level());
        if (part == 0) ++root;
    }
    return roots;
}

std::string cell_data_element(const VtkSurface& surface, AppendedArrays& arrays) {
    std::string text = "<CellData>\n";
    if (!surface.tags.empty()) {
        std::vector<std::uint8_t> levels;
        levels.reserve(surface.tags.size());
        for (const LeafTag tag : surface.tags) levels.push_back(static_cast<std::uint8_t>(tag.level()));
        const std::vector<std::uint32_t> roots = roots_of(surface.tags);
        text += arrays.add("level", 1, std::span<const std::uint8_t>(levels));
        text += arrays.add("root", 1, std::span<const std::uint32_t>(roots));
    }
    if (!surface.leaf_origins.empty()) text += arrays.add("origin", 1, surface.leaf_origins);
    return text + "</CellData>\n";
}

std::string cells_element(const VtkSurface& surface, VtkDataSet data_set, AppendedArrays& arrays) {
    const std::size_t count = surface.triangles.size();
    std::vector<std::int32_t> ends(count);
    for (std::size_t n = 0; n < count; ++n) ends[n] = static_cast<std::int32_t>(3 * (n + 1));
    const std::span corners(reinterpret_cast<const std::int32_t*>(surface.triangles.data()), 3 * count);
    std::string text = arrays.add("connectivity", 1, corners);
    text += arrays.add("offsets", 1, std::span<const std::int32_t>(ends));
    if (data_set == VtkDataSet::polygons) return fmt::format("<Polys>\n{}</Polys>\n", text);
    const std::vector<std::uint8_t> types(count, vtk_triangle);
    text += arrays.add("types", 1, std::span<const std::uint8_t>(types));
    return fmt::format("<Cells>\n{}</Cells>\n", text);
}

}  // namespace

std::string vtk_bytes(const VtkSurface& surface, VtkDataSet data_set) {
    AppendedArrays arrays;
    std::string fields = "<PointData>\n";
    for (std::size_t n = 0; n < surface.fields.size();) {
        const std::size_t count = vector_components(surface.fields, n);
        const Field& field = surface.fields[n];
        if (count > 1)
            fields += vector_element(surface.fields.subspan(n, count), surface.scales, arrays);
        else if (field.kind == FieldKind::scalar)
            fields += scalar_element(field, scale_of(surface.scales, field.name), arrays);
        else
            fields += color_element(field, arrays);
        n += count;
    }
    const std::string cell_data = cell_data_element(surface, arrays);
    const std::string points = points_element(surface, arrays);
    const std::string cells = cells_element(surface, data_set, arrays);
    std::string time;
    if (surface.time)
        time = fmt::format(
            "<FieldData>\n{}</FieldData>\n",
            arrays.add("TimeValue", 1, std::span<const double>(&*surface.time, 1), "NumberOfTuples"));
    const bool is_grid = data_set == VtkDataSet::grid;
    const std::string_view type = is_grid ? "UnstructuredGrid" : "PolyData";
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<{}>\n{}"
        "<Piece NumberOfPoints=\"{}\" "
        "{}=\"{}\">\n{}</PointData>\n{}<Points>\n{}</Points>\n{}</Piece>\n</{}>\n"
        "<AppendedData encoding=\"raw\">\n_",
        type, type, time, surface.positions.size(), is_grid ? "NumberOfCells" : "NumberOfPolys",
        surface.triangles.size(), fields, cell_data, points, cells, type);
    text += arrays.bytes();
    return text + "\n</AppendedData>\n</VTKFile>\n";
}

std::string xml_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '"')
            escaped += "&quot;";
        else
            escaped += c;
    }
    return escaped;
}

}  // namespace interleaf
