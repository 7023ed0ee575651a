#include "io/vtk/legacy_file.h"

#include <optional>
#include <string>
#include <string_view>

#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "io/vtk/vtk_samples.h"

namespace interleaf {
namespace {

FieldMesh legacy_mesh(std::string_view rest) {
    return parse_legacy_vtk(fmt::format("# vtk DataFile Version 2.0\ntitle\nASCII\n{}", rest), "a.vtk");
}

/// A square with more sections.
FieldMesh square_with(std::string_view sections) {
    return legacy_mesh(
        fmt::format("DATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n{}", sections));
}

std::string legacy_error(std::string_view sections) {
    return input_error_of([&] { square_with(sections); });
}

}  // namespace

TEST_CASE("words and bytes of each version of the legacy format give the same mesh") {
    for (const bool is_binary : {false, true})
        for (const bool is_version_5 : {false, true}) {
            CAPTURE(is_binary);
            CAPTURE(is_version_5);
            CHECK(parse_legacy_vtk(sample_legacy(is_binary, is_version_5), "a.vtk") == legacy_sample_mesh());
        }
}

TEST_CASE("a legacy file that is cut off is refused, or has lost a field at its end") {
    for (const bool is_binary : {false, true})
        for (const bool is_version_5 : {false, true}) {
            const std::string whole = sample_legacy(is_binary, is_version_5);
            for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
                CAPTURE(is_binary);
                CAPTURE(is_version_5);
                CAPTURE(size);
                std::optional<FieldMesh> mesh;
                const std::string error = input_error_of(
                    [&] { mesh = parse_legacy_vtk(std::string_view(whole).substr(0, size), "a.vtk"); });
                if (mesh)
                    CHECK(*mesh != legacy_sample_mesh());
                else
                    CHECK(error.starts_with("a.vtk: "));
            }
        }
}

TEST_CASE("the time of a legacy file is the one number TIME or TimeValue of the data set") {
    const std::string polygon = "POLYGONS 1 5\n4 0 1 2 3\n";
    CHECK_FALSE(square_with(polygon).time);
    const std::string field = "FIELD FieldData 2\nCYCLE 1 1 int\n7\nTIME 1 1 double\n0.25\n";
    CHECK(square_with(field + polygon).time == 0.25);
    CHECK(square_with("FIELD FieldData 1\nTimeValue 1 1 float\n-2\n" + polygon).time == -2.0);
    CHECK_FALSE(square_with("FIELD FieldData 1\nTIME 1 2 double\n0 1\n" + polygon).time);
    const std::string several =
        "FIELD FieldData 3\nTIME 1 2 double\n0 1\nTimeValue 1 1 double\n2\nTIME 1 1 double\n3\n";
    CHECK(square_with(several + polygon).time == 2.0);
    CHECK_FALSE(square_with("FIELD FieldData 1\nTIME 1 1 double\ninf\n" + polygon).time);
    CHECK_FALSE(square_with(polygon + "POINT_DATA 4\nFIELD FieldData 1\nTIME 1 4 double\n0 1 2 3\n").time);
}

TEST_CASE("polygons, strips, vertices and lines are numbered in the order of VTK") {
    const FieldMesh mesh = square_with(
        "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\nPOLYGONS 1 5\n4 0 1 2 3\nLINES 1 3\n2 0 1\n"
        "CELL_DATA 3\nSCALARS s int 2\n0 1 2 3 4 5\nNORMALS n float\n"
        "0 0 1 0 0 2 0 0 3\n");
    CHECK(mesh.triangles == std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {3, 1, 2}});
    CHECK(mesh.cell_of == std::vector<Index>{1, 1, 2, 2});
    REQUIRE(mesh.triangle_fields.size() == 2);
    CHECK(mesh.triangle_fields[0].components == 2);
    CHECK(mesh.triangle_fields[0].values == std::vector<double>{2, 3, 2, 3, 4, 5, 4, 5});
    CHECK(mesh.triangle_fields[1].values == std::vector<double>{0, 0, 2, 0, 0, 2, 0, 0, 3, 0, 0, 3});
}

TEST_CASE("fields of a legacy file have the units that VTK writes behind them") {
    const auto noted = [](std::string_view key, std::string_view location, std::string_view data) {
        return fmt::format("METADATA\nINFORMATION 1\nNAME {} LOCATION {}\nDATA {}\n\n", key, location, data);
    };
    const auto unit = [&](std::string_view text) { return noted("UNITS_LABEL", "vtkDataArray", text); };
    const FieldMesh mesh = square_with(
        unit("m") + "POLYGONS 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS T int\nLOOKUP_TABLE default\n0 1 2 3\n" +
        unit("%C2%B0C") + "FIELD FieldData 3\nu 1 4 int\n0 1 2 3\n" +
        "METADATA\nCOMPONENT_NAMES\nDATA\nINFORMATION 2\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 "
        "3\n"
        "NAME UNITS_LABEL LOCATION vtkDataArray\nDATA m%20/%20s\n\n" +
        "v 1 4 int\n0 1 2 3\nw 1 4 int\n0 1 2 3\n" + noted("UNITS_LABEL", "other", "K"));
    REQUIRE(mesh.point_fields.size() == 4);
    CHECK(mesh.point_fields[0].unit == "°C");
    CHECK(mesh.point_fields[1].unit == "m / s");
    CHECK(mesh.point_fields[2].unit.empty());
    CHECK(mesh.point_fields[3].unit.empty());
}

TEST_CASE("marked cells of a legacy file are left out") {
    const FieldMesh mesh = square_with(
        "POLYGONS 2 8\n3 0 1 2\n3 0 2 3\nCELL_DATA 2\n"
        "SCALARS vtkGhostType unsigned_char\nLOOKUP_TABLE default\n1 0\n");
    CHECK(mesh.cell_of == std::vector<Index>{1});
    CHECK(mesh.triangle_fields.empty());
}

TEST_CASE("faults of a legacy file are named with their place") {
    CHECK(input_error_of([] { legacy_mesh("DATASET STRUCTURED_POINTS\n"); }) ==
          "a.vtk: \"dataset\" \"structured_points\", expected DATASET UNSTRUCTURED_GRID or DATASET POLYDATA");
    CHECK(legacy_error("POLYGONS 1 4\n3 0 1 4\n") == "a.vtk: cells: point 4, expected one in [0, 4)");
    CHECK(legacy_error("POLYGONS 2 4\n3 0 1 2\n") == "a.vtk: polygons: ends within cell 1 (counted from 0)");
    CHECK(legacy_error("POLYGONS 1 4\n7 0 1 2\n") == "a.vtk: polygons: ends within cell 0 (counted from 0)");
    CHECK(legacy_error("POLYGONS 4000000000 4000000000\n3 0 1 2\n").find("the file ends too early") !=
          std::string::npos);
    CHECK(legacy_error("POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\nSCALARS u float\n1 2 x 4\n") ==
          "a.vtk: field \"u\": point 2 (counted from 0): \"x\", expected a number of type Float32");
    CHECK(legacy_error("POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\nSCALARS u int\n1 2 nan 4\n") ==
          "a.vtk: field \"u\": point 2 (counted from 0): \"nan\", expected a number of type Int32");
    CHECK(legacy_error("POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS u float\n1 2 3\n") ==
          "a.vtk: field \"u\": 3 values, expected 1 for each of the 4 points");
    CHECK(legacy_error("POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\nSCALARS u string\na b c d\n") ==
          "a.vtk: u: type \"string\", expected one such as float or int");
    CHECK(legacy_error("FACES 1 4\n").find("\"faces\", expected a section") != std::string::npos);
    CHECK(input_error_of([] { parse_legacy_vtk("ply\n", "a.vtk"); }).find("expected a VTK file") !=
          std::string::npos);
}

}  // namespace interleaf
