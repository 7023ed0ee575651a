#include "io/vtk/vtk_samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include <fmt/core.h>
#include <libdeflate.h>

namespace interleaf {
namespace {

const std::vector<float> sample_points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.1F, 0.2F, 0.3F};
const std::vector<double> sample_temperatures = {0.1, -2, 1.0 / 3, 4e-5, 5};
const std::vector<std::int16_t> sample_levels = {3, -4, 5, 6, 7, 8, 9};
const std::vector<std::int64_t> sample_corners = {0, 1, 4, 0, 1, 2, 3, 2, 0, 2, 0,
                                                  1, 3, 2, 0, 1, 3, 2, 4, 1, 0};
const std::vector<std::int32_t> sample_ends = {3, 7, 8, 10, 14, 18, 21};
const std::vector<std::uint8_t> sample_types = {5, 9, 1, 3, 8, 6, 7};

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (n + k < bytes.size() ? static_cast<unsigned char>(bytes[n + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += n + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63U];
    }
    return text;
}

template <typename Number>
std::string bytes_of(std::span<const Number> numbers, bool is_big_endian) {
    std::string bytes;
    for (const Number number : numbers) {
        std::array<char, sizeof number> one{};
        std::memcpy(one.data(), &number, sizeof number);
        if (is_big_endian == (std::endian::native == std::endian::little)) std::ranges::reverse(one);
        bytes.append(one.data(), one.size());
    }
    return bytes;
}

template <typename Number>
std::string words_of(std::span<const Number> numbers) {
    std::string words;
    for (const Number number : numbers) words += fmt::format("{} ", number);
    return words;
}

std::string deflated(std::string_view bytes) {
    libdeflate_compressor* const compressor = libdeflate_alloc_compressor(6);
    std::string packed(libdeflate_zlib_compress_bound(compressor, bytes.size()), '\0');
    packed.resize(
        libdeflate_zlib_compress(compressor, bytes.data(), bytes.size(), packed.data(), packed.size()));
    libdeflate_free_compressor(compressor);
    return packed;
}

template <typename Number>
constexpr const char* xml_name = nullptr;
template <>
constexpr const char* xml_name<std::uint8_t> = "UInt8";
template <>
constexpr const char* xml_name<std::int16_t> = "Int16";
template <>
constexpr const char* xml_name<std::int32_t> = "Int32";
template <>
constexpr const char* xml_name<std::int64_t> = "Int64";
template <>
constexpr const char* xml_name<float> = "Float32";
template <>
constexpr const char* xml_name<double> = "Float64";

class XmlWriter {
  public:
    explicit XmlWriter(const XmlStyle& style) : style_(style) {}

    template <typename Number>
    std::string array(const char* name, int components, const std::vector<Number>& numbers) {
        const std::string start = fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"",
                                              xml_name<Number>, name, components);
        if (style_.encoding == VtkEncoding::words)
            return fmt::format("{} format=\"ascii\">\n{}\n</DataArray>\n", start,
                               words_of(std::span(numbers)));
        const auto [head, data] = block(bytes_of(std::span(numbers), style_.is_big_endian));
        if (style_.encoding == VtkEncoding::inline_base64)
            return fmt::format("{} format=\"binary\">\n  {}\n</DataArray>\n", start, coded(head, data));
        const std::size_t offset = appended_.size();
        appended_ += style_.encoding == VtkEncoding::appended_raw ? head + data : coded(head, data);
        return fmt::format("{} format=\"appended\" offset=\"{}\"/>\n", start, offset);
    }

    std::string appended() const {
        if (appended_.empty()) return {};
        return fmt::format("<AppendedData encoding=\"{}\">\n  _{}\n</AppendedData>\n",
                           style_.encoding == VtkEncoding::appended_raw ? "raw" : "base64", appended_);
    }

  private:
    struct Block {
        std::string head;
        std::string data;
    };

    std::string size(std::uint64_t number) const {
        if (style_.has_wide_headers)
            return bytes_of(std::span<const std::uint64_t>(&number, 1), style_.is_big_endian);
        const auto narrow = static_cast<std::uint32_t>(number);
        return bytes_of(std::span<const std::uint32_t>(&narrow, 1), style_.is_big_endian);
    }

    Block block(std::string_view bytes) const {
        if (!style_.is_compressed) return {size(bytes.size()), std::string(bytes)};
        constexpr std::size_t part = 16;
        Block result;
        std::string sizes;
        const std::size_t parts = (bytes.size() + part - 1) / part;
        for (std::size_t n = 0; n < parts; ++n) {
            const std::string packed = deflated(bytes.substr(n * part, part));
            sizes += size(packed.size());
            result.data += packed;
        }
        result.head = size(parts) + size(part) + size(bytes.size() % part) + sizes;
        return result;
    }

    /// The header of compressed parts is encoded by itself.
    std::string coded(const std::string& head, const std::string& data) const {
        return style_.is_compressed ? base64(head) + base64(data) : base64(head + data);
    }

    XmlStyle style_;
    std::string appended_;
};

template <typename Number>
std::string legacy_numbers(const std::vector<Number>& numbers, bool is_binary) {
    return (is_binary ? bytes_of(std::span(numbers), true) : words_of(std::span(numbers))) + "\n";
}

std::string legacy_cells(bool is_binary, bool is_version_5) {
    if (is_version_5) {
        std::vector<std::int64_t> offsets = {0};
        offsets.insert(offsets.end(), sample_ends.begin(), sample_ends.end());
        return fmt::format("CELLS {} {}\nOFFSETS vtktypeint64\n{}CONNECTIVITY vtktypeint64\n{}",
                           offsets.size(), sample_corners.size(), legacy_numbers(offsets, is_binary),
                           legacy_numbers(sample_corners, is_binary));
    }
    std::vector<std::int32_t> list;
    std::int32_t begin = 0;
    for (const std::int32_t end : sample_ends) {
        list.push_back(end - begin);
        for (; begin < end; ++begin)
            list.push_back(static_cast<std::int32_t>(sample_corners[static_cast<std::size_t>(begin)]));
    }
    return fmt::format("CELLS {} {}\n{}", sample_ends.size(), list.size(), legacy_numbers(list, is_binary));
}

}  // namespace

std::vector<XmlStyle> all_xml_styles() {
    std::vector<XmlStyle> styles = {{}};
    for (const VtkEncoding encoding :
         {VtkEncoding::inline_base64, VtkEncoding::appended_raw, VtkEncoding::appended_base64})
        for (const bool wide : {false, true})
            for (const bool big : {false, true})
                for (const bool compressed : {false, true})
                    styles.push_back({encoding, wide, big, compressed});
    return styles;
}

std::string name_of(const XmlStyle& style) {
    return fmt::format("encoding {}, headers {}, {} endian, {}", static_cast<int>(style.encoding),
                       style.has_wide_headers ? 64 : 32, style.is_big_endian ? "big" : "little",
                       style.is_compressed ? "compressed" : "plain");
}

std::string sample_grid(const XmlStyle& style) {
    XmlWriter writer(style);
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
        "header_type=\"{}\"{}>\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        style.is_big_endian ? "BigEndian" : "LittleEndian", style.has_wide_headers ? "UInt64" : "UInt32",
        style.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "", sample_points.size() / 3,
        sample_types.size());
    text += "<PointData>\n" + writer.array("u &lt;K>", 1, sample_temperatures) + "</PointData>\n";
    text += "<CellData>\n" + writer.array("level", 1, sample_levels) + "</CellData>\n";
    text += "<Points>\n" + writer.array("Points", 3, sample_points) + "</Points>\n";
    text += "<Cells>\n" + writer.array("connectivity", 1, sample_corners) +
            writer.array("offsets", 1, sample_ends) + writer.array("types", 1, sample_types) + "</Cells>\n";
    return text + "</Piece>\n</UnstructuredGrid>\n" + writer.appended() + "</VTKFile>\n";
}

std::string sample_legacy(bool is_binary, bool is_version_5) {
    std::string text = fmt::format("# vtk DataFile Version {}\na mesh\n{}\nDATASET UNSTRUCTURED_GRID\n",
                                   is_version_5 ? "5.1" : "3.0", is_binary ? "BINARY" : "ASCII");
    text += "FIELD FieldData 1\nTIME 1 1 double\n" + legacy_numbers(std::vector<double>{0.5}, is_binary);
    text +=
        fmt::format("POINTS {} float\n", sample_points.size() / 3) + legacy_numbers(sample_points, is_binary);
    text += "METADATA\nCOMPONENT_NAMES\nX\n\nZ\nINFORMATION 0\n\n" + legacy_cells(is_binary, is_version_5);
    const std::vector<std::int32_t> wide_types(sample_types.begin(), sample_types.end());
    text += fmt::format("CELL_TYPES {}\n", sample_types.size()) + legacy_numbers(wide_types, is_binary);
    text += fmt::format("CELL_DATA {}\nFIELD FieldData 1\nlevel 1 {} short\n", sample_types.size(),
                        sample_types.size());
    text += legacy_numbers(sample_levels, is_binary);
    text += fmt::format("POINT_DATA {}\nSCALARS u%20<K> double{}\nLOOKUP_TABLE default\n",
                        sample_points.size() / 3, is_version_5 ? " 1" : "");
    return text + legacy_numbers(sample_temperatures, is_binary);
}

FieldMesh sample_mesh() {
    FieldMesh mesh;
    for (std::size_t n = 0; n < sample_points.size(); n += 3)
        mesh.points.emplace_back(sample_points[n], sample_points[n + 1], sample_points[n + 2]);
    mesh.triangles = {{0, 1, 4}, {0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {3, 1, 2}, {4, 1, 0}};
    mesh.cell_of = {0, 1, 1, 4, 4, 5, 5, 6};
    mesh.point_fields.push_back({"u <K>", 1, sample_temperatures});
    mesh.triangle_fields.push_back({"level", 1, {3, -4, -4, 7, 7, 8, 8, 9}});
    return mesh;
}

FieldMesh legacy_sample_mesh() {
    FieldMesh mesh = sample_mesh();
    mesh.time = 0.5;
    return mesh;
}

}  // namespace interleaf
