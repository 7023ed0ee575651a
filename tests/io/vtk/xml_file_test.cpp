#include "io/vtk/xml_file.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/vtk/data_block.h"
#include "io/vtk/vtk_samples.h"

namespace interleaf {
namespace {

using namespace std::string_view_literals;

/// The text with the first \p from replaced.
std::string with(std::string text, std::string_view from, std::string_view to) {
    const std::size_t place = text.find(from);
    REQUIRE(place != std::string::npos);
    return text.replace(place, from.size(), to);
}

std::string xml_error(const std::string& text) {
    return input_error_of([&] { parse_vtk_xml(text, "grid.vtu"); });
}

/// A .vtu with one cell per type, of \p corner_count points, and with more elements in its piece.
std::string grid_of_type(int type, int corner_count, std::string_view more = "") {
    std::string ids;
    for (int n = 0; n < corner_count; ++n) ids += fmt::format("{} ", n);
    return fmt::format(
        "<VTKFile type='UnstructuredGrid' version='0.1'><UnstructuredGrid>"
        "<Piece NumberOfPoints='6' NumberOfCells='1'><Points><DataArray type='Float64' "
        "NumberOfComponents='2' "
        "format='ascii'>0 0 1 0 1 1 0 1 2 0 2 1</DataArray></Points><Cells>"
        "<DataArray type='Int32' Name='connectivity' format='ascii'>{}</DataArray>"
        "<DataArray type='Int32' Name='offsets' format='ascii'>{}</DataArray>"
        "<DataArray type='Int64' Name='types' format='ascii'>{}</DataArray></Cells>{}"
        "</Piece></UnstructuredGrid></VTKFile>",
        ids, corner_count, type, more);
}

constexpr std::string_view two_triangles =
    "<Piece NumberOfPoints='4' NumberOfPolys='1' NumberOfStrips='1' NumberOfVerts='1'>"
    "<CellData><DataArray type='Int8' Name='n' format='ascii'>0 1 2</DataArray>{}</CellData>"
    "<Points><DataArray type='Float32' NumberOfComponents='3' format='ascii'>0 0 0 1 0 0 1 1 0 0 1 "
    "0</DataArray>"
    "</Points><Verts><DataArray type='Int32' Name='connectivity' format='ascii'>3</DataArray>"
    "<DataArray type='Int32' Name='offsets' format='ascii'>1</DataArray></Verts>"
    "<Strips><DataArray type='Int32' Name='connectivity' format='ascii'>0 2 3</DataArray>"
    "<DataArray type='Int32' Name='offsets' format='ascii'>3</DataArray></Strips>"
    "<Polys><DataArray type='Int32' Name='connectivity' format='ascii'>0 1 2</DataArray>"
    "<DataArray type='Int32' Name='offsets' format='ascii'>3</DataArray></Polys></Piece>";

std::string poly_data(std::string_view more = "") {
    return fmt::format("<VTKFile type='PolyData'><PolyData>{}</PolyData></VTKFile>",
                       fmt::format(fmt::runtime(two_triangles), more));
}

}  // namespace

TEST_CASE("every encoding of a grid gives the same mesh") {
    for (const XmlStyle& style : all_xml_styles()) {
        CAPTURE(name_of(style));
        CHECK(parse_vtk_xml(sample_grid(style), "grid.vtu") == sample_mesh());
    }
}

TEST_CASE("a grid that is cut off anywhere is refused, and never read beyond its end") {
    for (const XmlStyle& style : all_xml_styles()) {
        const std::string whole = sample_grid(style);
        const std::size_t used =
            whole.rfind(style.encoding == VtkEncoding::words || style.encoding == VtkEncoding::inline_base64
                            ? "</VTKFile"
                            : "\n</AppendedData");
        for (std::size_t size = 0; size < used; ++size) {
            CAPTURE(name_of(style));
            CAPTURE(size);
            CHECK(xml_error(whole.substr(0, size)).starts_with("grid.vtu: "));
        }
    }
}

TEST_CASE("header and data of a block may be encoded separately") {
    const std::string joined = sample_grid({.encoding = VtkEncoding::inline_base64});
    // 28 bytes: the size, then seven shorts and their padding.
    const std::string separate = with(joined, "DgAAAAMA/P8FAAYABwAIAAkA", "DgAAAC== AwD8/wUABgAHAAgACQA=");
    CHECK(parse_vtk_xml(separate, "grid.vtu") == sample_mesh());
}

TEST_CASE("blanks around numbers in attributes, formats in capitals and missing formats change nothing") {
    const std::string words = sample_grid({});
    CHECK(parse_vtk_xml(with(words, "NumberOfPoints=\"5\"", "NumberOfPoints=\"        5\""), "grid.vtu") ==
          sample_mesh());
    CHECK(parse_vtk_xml(with(words, "format=\"ascii\"", "format=\"ASCII\""), "grid.vtu") == sample_mesh());
    CHECK(parse_vtk_xml(with(words, "format=\"ascii\"", ""), "grid.vtu") == sample_mesh());
    const std::string raw = sample_grid({.encoding = VtkEncoding::appended_raw});
    CHECK(parse_vtk_xml(with(raw, "format=\"appended\" offset=\"0\"", "offset=\" 0 \""), "grid.vtu") ==
          sample_mesh());
    CHECK(
        xml_error(with(words, "format=\"ascii\"", "format=\"hex\"")).find("format \"hex\", expected ascii") !=
        std::string::npos);
}

TEST_CASE("polygons are numbered before strips, and two components of points are three with 0") {
    const FieldMesh mesh = parse_vtk_xml(poly_data(), "a.vtp");
    CHECK(mesh.triangles == std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}});
    CHECK(mesh.cell_of == std::vector<Index>{1, 2});
    REQUIRE(mesh.triangle_fields.size() == 1);
    CHECK(mesh.triangle_fields.front().values == std::vector<double>{1, 2});
    CHECK(parse_vtk_xml(grid_of_type(5, 3), "a.vtu").points[2] == glm::dvec3(1, 1, 0));
}

TEST_CASE("copies and hidden cells are left out, and so are arrays of VTK") {
    const auto with_marks = [](std::string_view name, std::string_view marks) {
        return parse_vtk_xml(
            poly_data(
                fmt::format("<DataArray type='UInt8' Name='{}' format='ascii'>{}</DataArray>", name, marks)),
            "a.vtp");
    };
    CHECK(with_marks("vtkGhostType", "0 0 1").cell_of == std::vector<Index>{1});
    CHECK(with_marks("vtkGhostType", "0 32 0").cell_of == std::vector<Index>{2});
    CHECK(with_marks("vtkGhostType", "0 4 2").cell_of == std::vector<Index>{1, 2});
    CHECK(with_marks("vtkGhostLevels", "0 2 0").cell_of == std::vector<Index>{2});
    CHECK(with_marks("vtkOriginalCellIds", "7 8 9").triangle_fields.size() == 1);
}

TEST_CASE("a unit is the text of its key without the spaces and lines around it") {
    const auto unit_of = [](std::string_view text) {
        return parse_vtk_xml(
                   grid_of_type(5, 3,
                                fmt::format("<PointData><DataArray type='Int8' Name='T' format='ascii'>"
                                            "<InformationKey name='UNITS_LABEL' location='vtkDataArray'>{}"
                                            "</InformationKey>0 1 2 3 4 5</DataArray></PointData>",
                                            text)),
                   "grid.vtu")
            .point_fields.at(0)
            .unit;
    };
    CHECK(unit_of("m/s") == "m/s");
    CHECK(unit_of("\n          m / s\n        ") == "m / s");
    CHECK(unit_of("\r\n\tK\r\n") == "K");
    CHECK(unit_of("\n  \n").empty());
    CHECK(unit_of("").empty());
}

TEST_CASE("cells of other kinds are refused by name") {
    CHECK(xml_error(grid_of_type(22, 6)) ==
          "grid.vtu: cell 0 (counted from 0): quadratic triangles, expected triangles or quadrilaterals");
    CHECK(xml_error(grid_of_type(10, 4)).find(": tetrahedra, expected") != std::string::npos);
    CHECK(xml_error(grid_of_type(69, 6)).find(": Lagrange triangles of 6 points") != std::string::npos);
    CHECK(xml_error(grid_of_type(7, 5)).find(": polygons of 5 points") != std::string::npos);
    CHECK(xml_error(grid_of_type(99, 5)).find(": cell type 99, expected") != std::string::npos);
    CHECK(xml_error(grid_of_type(5, 4)).find(": triangles of 4 points") != std::string::npos);
    CHECK(parse_vtk_xml(grid_of_type(69, 3), "a.vtu").triangles.size() == 1);
    CHECK(parse_vtk_xml(grid_of_type(7, 4), "a.vtu").triangles.size() == 2);
    CHECK(parse_vtk_xml(grid_of_type(21, 3), "a.vtu").triangles.empty());
}

TEST_CASE("a field may have values that are not finite, points may not") {
    const FieldMesh mesh = parse_vtk_xml(with(sample_grid({}), "-2", "nan"), "grid.vtu");
    CHECK(std::isnan(mesh.point_fields.front().values[1]));
}

TEST_CASE("the time of a file is its one finite TimeValue") {
    const auto time_of_grid = [](std::string_view array) {
        const std::string text = with(grid_of_type(5, 3), "<UnstructuredGrid>",
                                      fmt::format("<UnstructuredGrid><FieldData>{}</FieldData>", array));
        return parse_vtk_xml(text, "a.vtu").time;
    };
    const auto array = [](std::string_view name, std::string_view tuples, std::string_view value) {
        return fmt::format("<DataArray type='Float64' Name='{}' {} format='ascii'>{}</DataArray>", name,
                           tuples, value);
    };
    CHECK_FALSE(parse_vtk_xml(grid_of_type(5, 3), "a.vtu").time);
    CHECK(time_of_grid(array("CYCLE", "", "7") + array("TimeValue", "NumberOfTuples='1'", "0.25")) == 0.25);
    CHECK(time_of_grid(array("TIME", "", "-2")) == -2.0);
    CHECK_FALSE(time_of_grid(array("TimeValue", "NumberOfTuples='2'", "0 1")));
    CHECK_FALSE(time_of_grid(array("TimeValue", "NumberOfTuples='0'", "")));
    CHECK_FALSE(time_of_grid(array("TimeValue", "NumberOfTuples='1'", "nan")));
    CHECK_FALSE(time_of_grid(array("TimeValue", "NumberOfTuples='1'", "")));
    CHECK_FALSE(time_of_grid(array("TimeValue", "NumberOfTuples='one'", "1")));
    CHECK_FALSE(time_of_grid(array("TimeValue", "NumberOfComponents='-1'", "1")));
    CHECK_FALSE(time_of_grid(array("TimeValue", "", "0 1")));
    CHECK_FALSE(time_of_grid(array("TimeValue", "NumberOfTuples=' '", "0 1")));
    CHECK_FALSE(time_of_grid("<DataArray type='String' Name='TIME' NumberOfTuples='1'>49 0</DataArray>"));
    CHECK(time_of_grid(array("TIME", "", "0 1") + array("TimeValue", "", "2") + array("TIME", "", "3")) ==
          2.0);
}

TEST_CASE("faults are named with their place") {
    const std::string words = sample_grid({});
    CHECK(xml_error(with(words, "-2", "two")) ==
          "grid.vtu: point field \"u <K>\": point 1 (counted from 0): \"two\", expected a number of type "
          "Float64");
    CHECK(xml_error(with(words, "0 1 4 ", "0 1 5 ")) ==
          "grid.vtu: Cells connectivity: value 2 (counted from 0): 5, expected a whole number in [0, 5)");
    CHECK(xml_error(with(words, "3 7 8", "3 2 8")) ==
          "grid.vtu: cell 1 (counted from 0): ends at corner 2, expected one in [3, 21]");
    CHECK(xml_error(with(words, "NumberOfPoints=\"5\"", "NumberOfPoints=\"6\"")) ==
          "grid.vtu: Points: ends after 15 numbers, expected 18");
    CHECK(xml_error(with(words, "Int16", "Float16")) ==
          "grid.vtu: cell field \"level\": type \"Float16\", expected one such as Float32 or Int64");
    CHECK(xml_error("solid") == "grid.vtu: expected a VTK file, with <VTKFile> at its beginning");
    CHECK(xml_error("<VTKFile type='ImageData'/>") ==
          "grid.vtu: data of type \"ImageData\", expected UnstructuredGrid or PolyData");

    const std::string raw = sample_grid({.encoding = VtkEncoding::appended_raw});
    CHECK(xml_error(with(raw, "offset=\"0\"", "offset=\"5000\"")).find("offset \"5000\"") !=
          std::string::npos);
    CHECK(xml_error(with(raw, "Float64", "Float32")) ==
          "grid.vtu: point field \"u <K>\": 40 bytes of data, expected 20");
    const XmlStyle compressed{.encoding = VtkEncoding::appended_raw, .is_compressed = true};
    const std::string packed = sample_grid(compressed);
    CHECK(xml_error(with(packed, "vtkZLibDataCompressor", "vtkLZ4DataCompressor")) ==
          "grid.vtu: compressed by \"vtkLZ4DataCompressor\", expected vtkZLibDataCompressor");
}

TEST_CASE("a mesh of several pieces in one file, or in several, is one mesh") {
    const std::string one = poly_data();
    const std::size_t begin = one.find("<Piece");
    const std::string piece = one.substr(begin, one.find("</PolyData>") - begin);
    const FieldMesh joined = parse_vtk_xml(with(one, "</PolyData>", piece + "</PolyData>"), "a.vtp");
    CHECK(joined.points.size() == 8);
    CHECK(joined.triangles[2] == std::array<Index, 3>{4, 5, 6});
    CHECK(joined.triangle_fields.front().values == std::vector<double>{1, 2, 1, 2});
    CHECK(joined.cell_of == std::vector<Index>{1, 2, 4, 5});

    const ScratchFolder folder;
    put(folder / "a0.vtp", one);
    put(folder / "a1.vtp", one);
    put(folder / "empty.vtp",
        "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='0'/></PolyData></VTKFile>");
    const auto parallel = [&](std::string_view pieces) {
        put(folder / "a.pvtp",
            fmt::format("<VTKFile type='PPolyData'><PPolyData>{}</PPolyData></VTKFile>", pieces));
        return read_vtk_xml(folder / "a.pvtp");
    };
    const std::string first = "<Piece Source='a0.vtp'/>";
    CHECK(parallel(fmt::format("<Piece Source='empty.vtp'/>{}<Piece Source='a1.vtp'/>", first)) == joined);
    CHECK(input_error_of([&] { parallel(first + first); }).ends_with("the piece \"a0.vtp\" is there twice"));
    CHECK(machine_error_of([&] { parallel("<Piece Source='b.vtp'/>"); }).find("b.vtp: cannot open") !=
          std::string::npos);
}

TEST_CASE(
    "pieces with different fields are refused in any order, but pieces without cells need no fields of "
    "cells") {
    const auto piece = [](std::string_view point_fields, bool has_cells) {
        return fmt::format(
            "<Piece NumberOfPoints='3' NumberOfPolys='{}'><PointData>{}</PointData>"
            "<Points><DataArray type='Float32' NumberOfComponents='3'>0 0 0 1 0 0 1 1 0</DataArray></Points>"
            "<CellData><DataArray type='Int8' Name='n'>7</DataArray></CellData>"
            "<Polys><DataArray type='Int32' Name='connectivity'>0 1 2</DataArray>"
            "<DataArray type='Int32' Name='offsets'>3</DataArray></Polys></Piece>",
            has_cells ? 1 : 0, point_fields);
    };
    const auto grid = [](const std::string& first, const std::string& second) {
        return fmt::format("<VTKFile type='PolyData'><PolyData>{}{}</PolyData></VTKFile>", first, second);
    };
    const std::string u = "<DataArray type='Int8' Name='u'>1 2 3</DataArray>";
    const std::string v = "<DataArray type='Int8' Name='v'>4 5 6</DataArray>";
    const std::vector<std::string> pieces = {piece("", true), piece(u, true), piece(v, true),
                                             piece(u + v, true)};
    for (const std::string& first : pieces)
        for (const std::string& second : pieces)
            CHECK(xml_error(grid(first, second)) ==
                  (first == second
                       ? ""
                       : "grid.vtu: a piece has other fields, expected those of the first piece"));
    CHECK(parse_vtk_xml(grid(piece(u + v, true), piece(v + u, true)), "a.vtp").point_fields[1].values ==
          std::vector<double>{4, 5, 6, 4, 5, 6});

    for (const bool is_first : {false, true}) {
        const FieldMesh mesh = parse_vtk_xml(grid(piece(u, is_first), piece(u, !is_first)), "a.vtp");
        CHECK(mesh.points.size() == 6);
        CHECK(mesh.triangles.size() == 1);
        REQUIRE(mesh.triangle_fields.size() == 1);
        CHECK(mesh.triangle_fields.front().values == std::vector<double>{7});
    }
}

TEST_CASE("sizes that lie take no memory") {
    const std::string grid = sample_grid({.encoding = VtkEncoding::appended_raw});
    const std::string huge = with(grid, "NumberOfPoints=\"5\"", "NumberOfPoints=\"4294967294\"");
    CHECK(xml_error(huge).find("more than a file of its size can have") != std::string::npos);
    CHECK(xml_error(with(sample_grid({}), "NumberOfCells=\"7\"", "NumberOfCells=\"4000000000\""))
              .find("the file ends too early") != std::string::npos);

    // Arrays that share their data, or are compressed beyond measure, use up a budget.
    BlockBudget budget{12};
    const ArrayPlace place{"grid.vtu", "Points", "point", 2};
    const auto read = [&] {
        read_block(EncodedBytes("\x08\0\0\0eight888"sv, EncodedBytes::Form::raw), DataType::float32, {},
                   place, budget);
    };
    CHECK(input_error_of(read).empty());
    CHECK(input_error_of(read) == "grid.vtu: Points: 8 bytes, more than a file of its size can have");
}

}  // namespace interleaf
