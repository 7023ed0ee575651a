#include "io/vtk/xml_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/file/input_file.h"
#include "io/text/json_place.h"
#include "io/text/words.h"
#include "io/vtk/vtk_piece.h"
#include "io/vtk/xml_document.h"
#include "text/characters.h"

namespace interleaf {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t max_vtk_file_size = std::uint64_t{4} << 30U;

/// Whether the array has values that morph, rather than numbers of VTK or texts.
bool is_xml_field(const pugi::xml_node& array) {
    const std::string_view type = array.attribute("type").value();
    return type != "String" && !std::string_view(array.attribute("Name").value()).starts_with("vtk");
}

/// The unit that VTK keeps with an array. VTK writes it on a line of its own.
std::string unit_of(const pugi::xml_node& array) {
    return std::string(
        without_blanks(array.find_child_by_attribute("InformationKey", "name", "UNITS_LABEL").child_value()));
}

/// Reads one element "Piece".
class XmlPieceReader {
  public:
    XmlPieceReader(XmlDocument& document, pugi::xml_node element) : document_(document), element_(element) {}

    VtkPiece read() {
        read_points();
        if (document_.type() == "PolyData")
            for (const PolyCells& kind : poly_cells) read_cells(element_.child(kind.element), kind);
        else
            read_cells(element_.child("Cells"), {"Cells", "NumberOfCells", 0});
        piece_.point_fields = read_fields("PointData", "point", piece_.points.size());
        piece_.cell_fields = read_fields("CellData", "cell", piece_.cells.ends.size());
        read_marks();
        return std::move(piece_);
    }

  private:
    /// Cells of one kind; the type is 0 if the cells have types of their own.
    struct PolyCells {
        const char* element;
        const char* count;
        std::uint8_t type;
    };

    /// In the order in which VTK numbers the cells.
    static constexpr std::array<PolyCells, 4> poly_cells = {{
        {"Verts", "NumberOfVerts", vertex_cells},
        {"Lines", "NumberOfLines", line_cells},
        {"Polys", "NumberOfPolys", polygon_cells},
        {"Strips", "NumberOfStrips", strip_cells},
    }};

    ArrayPlace place(std::string name, std::string element, std::size_t tuples, std::size_t width = 1) const {
        return {document_.file(), std::move(name), std::move(element), tuples, width};
    }

    NumberArray numbers(const pugi::xml_node& array, const ArrayPlace& place) {
        NumberArray read = document_.numbers(array, place);
        piece_.content_size += read.bytes.size();
        return read;
    }

    void read_points() {
        const std::size_t count = document_.count(element_, "NumberOfPoints");
        const pugi::xml_node array = element_.child("Points").child("DataArray");
        if (!array && count == 0) return;
        const std::size_t width = document_.count(array, "NumberOfComponents", 3);
        if (width != 2 && width != 3) document_.fail(fmt::format("Points: {} components, expected 3", width));
        const ArrayPlace where = place("Points", "point", count, width);
        const std::vector<double> values = finite_numbers(numbers(array, where), where);
        piece_.points.reserve(count);
        for (std::size_t n = 0; n < values.size(); n += width)
            piece_.points.emplace_back(values[n], values[n + 1], width == 3 ? values[n + 2] : 0);
    }

    /// Appends cells to the piece.
    void read_cells(const pugi::xml_node& cells, const PolyCells& kind) {
        const std::size_t count = document_.count(element_, kind.count, 0);
        if (count == 0) return;
        const auto name = [&](const char* array) { return fmt::format("{} {}", kind.element, array); };
        const auto array_of = [&](const char* array) {
            return cells.find_child_by_attribute("DataArray", "Name", array);
        };
        const ArrayPlace at_ends = place(name("offsets"), "cell", count);
        std::vector<Index> ends = indices_below(numbers(array_of("offsets"), at_ends), no_index, at_ends);
        const ArrayPlace at_corners = place(name("connectivity"), "value", ends.back());
        const std::vector<Index> corners =
            indices_below(numbers(array_of("connectivity"), at_corners), piece_.points.size(), at_corners);
        const ArrayPlace at_types = place(name("types"), "cell", count);
        const std::vector<std::uint8_t> types =
            kind.type == 0 ? small_numbers(numbers(array_of("types"), at_types), at_types)
                           : std::vector<std::uint8_t>(count, kind.type);
        append_cells(piece_.cells, {types, std::move(ends), corners}, document_.file());
    }

    std::vector<MeshField> read_fields(const char* section, const char* element, std::size_t tuples) {
        std::vector<MeshField> fields;
        for (const pugi::xml_node array : element_.child(section).children("DataArray")) {
            if (!is_xml_field(array) || tuples == 0) continue;
            const std::string name = array.attribute("Name").value();
            // Some writers write 0 components for one.
            const std::size_t width =
                std::max<std::size_t>(document_.count(array, "NumberOfComponents", 1), 1);
            const ArrayPlace where =
                place(fmt::format("{} field {}", element, in_quotes(name)), element, tuples, width);
            fields.push_back({name, width, doubles_of(numbers(array, where)), unit_of(array)});
        }
        return fields;
    }

    void read_marks() {
        for (const char* name : {"vtkGhostType", "vtkGhostLevels"}) {
            const pugi::xml_node array =
                element_.child("CellData").find_child_by_attribute("DataArray", "Name", name);
            if (!array || piece_.cells.ends.empty()) continue;
            const ArrayPlace where = place(name, "cell", piece_.cells.ends.size());
            piece_.is_left_out = left_out_cells(small_numbers(numbers(array, where), where),
                                                std::string_view(name) == "vtkGhostLevels");
        }
    }

    XmlDocument& document_;
    pugi::xml_node element_;
    VtkPiece piece_;
};

/// The time that \p array is; none if it is not one finite number. A damaged time does not spoil the mesh.
std::optional<double> time_of_array(XmlDocument& document, const pugi::xml_node& array) {
    try {
        if (document.count(array, "NumberOfTuples", 1) != 1 ||
            document.count(array, "NumberOfComponents", 1) > 1)
            return std::nullopt;
        // Without a number of values, the words tell it.
        Words words(array.text().get());
        words.next();
        const bool has_number = !without_blanks(array.attribute("NumberOfTuples").value()).empty();
        if (!has_number && !words.next().empty()) return std::nullopt;
        return time_in(document.numbers(array, {document.file(), "TimeValue", "value", 1}));
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// The first time among the arrays of the data set.
std::optional<double> time_of(XmlDocument& document) {
    for (const pugi::xml_node array : document.data_set().child("FieldData").children("DataArray"))
        if (is_time_array(array.attribute("Name").value()))
            if (const std::optional<double> time = time_of_array(document, array)) return time;
    return std::nullopt;
}

FieldMesh mesh_of_document(XmlDocument& document) {
    if (document.type() != "UnstructuredGrid" && document.type() != "PolyData")
        document.fail(fmt::format("data of type {}, expected UnstructuredGrid or PolyData",
                                  in_quotes(document.type())));
    FieldMesh mesh;
    for (const pugi::xml_node element : document.data_set().children("Piece"))
        append(mesh, mesh_of(XmlPieceReader(document, element).read(), document.file()), document.file());
    mesh.time = time_of(document);
    return mesh;
}

/// Reads the files that a .pvtu or .pvtp file names.
FieldMesh mesh_of_pieces(const XmlDocument& document, const fs::path& folder) {
    FieldMesh mesh;
    std::set<fs::path> files;
    for (const pugi::xml_node element : document.data_set().children("Piece")) {
        const std::string source = element.attribute("Source").value();
        const fs::path file = folder / source;
        if (source.empty()) document.fail("a piece without a file, expected Source");
        if (!files.insert(file.lexically_normal()).second)
            document.fail(fmt::format("the piece {} is there twice", in_quotes(source)));
        XmlDocument piece(read_text(file, max_vtk_file_size), file.string());
        append(mesh, mesh_of_document(piece), file.string());
    }
    return mesh;
}

}  // namespace

FieldMesh parse_vtk_xml(std::string text, const std::string& name) {
    XmlDocument document(std::move(text), name);
    return mesh_of_document(document);
}

FieldMesh read_vtk_xml(const fs::path& file) {
    XmlDocument document(read_text(file, max_vtk_file_size), file.string());
    const bool has_pieces = document.type() == "PUnstructuredGrid" || document.type() == "PPolyData";
    return has_pieces ? mesh_of_pieces(document, file.parent_path()) : mesh_of_document(document);
}

}  // namespace interleaf
