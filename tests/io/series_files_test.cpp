#include "io/series_files.h"

#include <filesystem>
#include <string_view>
#include <vector>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "io/vtk/vtk_samples.h"

namespace interleaf {
namespace {

namespace fs = std::filesystem;

std::string collection(std::string_view steps) {
    return fmt::format("<VTKFile type='Collection'><Collection>{}</Collection></VTKFile>", steps);
}

std::vector<double> times_of(const std::vector<fs::path>& files) {
    return series_files(files).times;
}

}  // namespace

TEST_CASE("a collection gives the files and their times, in the order of time") {
    const ScratchFolder folder;
    put(folder / "a.vtu", "");
    put(folder / "b.vtu", "");
    const fs::path file = folder / "run.pvd";
    const auto read = [&](std::string_view steps) {
        put(file, collection(steps));
        return series_files(std::span(&file, 1));
    };
    const SeriesFiles series =
        read("<DataSet timestep='2.5' file='b.vtu'/><DataSet timestep='-1' file='a.vtu'/>");
    CHECK(series.files == std::vector<fs::path>{folder / "a.vtu", folder / "b.vtu"});
    CHECK(series.times == std::vector<double>{-1, 2.5});

    const auto error = [&](std::string_view steps) { return input_error_of([&] { read(steps); }); };
    CHECK(error("<DataSet timestep='0' file='c.vtu'/>")
              .ends_with("run.pvd: DataSet 0 (counted from 0): there is "
                         "no file \"c.vtu\""));
    CHECK(error("<DataSet timestep='x' file='a.vtu'/>").ends_with("timestep \"x\", expected a number"));
    CHECK(error("").ends_with("has no files, expected DataSet elements"));
    CHECK(error("<DataSet timestep='1' file='a.vtu'/><DataSet timestep='1' file='b.vtu'/>")
              .ends_with("are both at time 1, expected one file per time, or parts with different numbers"));
    CHECK(error("<DataSet timestep='1' part='x' file='a.vtu'/>")
              .ends_with("DataSet: part: \"x\", expected a whole number in [0, 2^32 - 2]"));
}

TEST_CASE("files of a collection without times are numbered by steps, and parts belong to the file before") {
    const ScratchFolder folder;
    for (const char* const name : {"a", "b", "c", "d", "e"}) put(folder / name, "");
    const fs::path file = folder / "run.pvd";
    const auto read = [&](std::string_view steps) {
        put(file, collection(steps));
        return series_files(std::span(&file, 1));
    };
    using Files = std::vector<fs::path>;
    const SeriesFiles untimed = read(
        "<DataSet part='1' file='a'/><DataSet part='2' file='b'/><DataSet file='c'/>"
        "<DataSet part='1' file='d'/><DataSet part='0' file='e'/>");
    CHECK(untimed.times == std::vector<double>{0, 1, 2});
    CHECK(untimed.files == Files{folder / "a", folder / "c", folder / "e"});
    CHECK(untimed.further_parts == std::vector<Files>{{folder / "b"}, {folder / "d"}, {}});
    const SeriesFiles timed = read("<DataSet timestep='2.5' file='a'/><DataSet part='1' file='b'/>");
    CHECK(timed.times == std::vector<double>{2.5});
    CHECK(timed.further_parts == std::vector<Files>{{folder / "b"}});
}

TEST_CASE("a series is called as its list or first file, without the endings") {
    CHECK(series_name("a/run.pvd") == "run");
    CHECK(series_name("a/run.vtu.series") == "run");
    CHECK(series_name("a/run.1.VTK.Series") == "run.1");
    CHECK(series_name("a/run.series") == "run");
    CHECK(series_name("a/run.x.series") == "run.x");
    CHECK(series_name("a/run.vtu.vtk") == "run.vtu");
}

TEST_CASE("parts of a collection at one time become one mesh, in the order of their numbers") {
    const ScratchFolder folder;
    const auto legacy = [](std::string_view rest) {
        return fmt::format("# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n{}\n", rest);
    };
    const std::string field = "POINT_DATA 3\nSCALARS u double\nLOOKUP_TABLE default\n";
    const std::string lower = "POINTS 3 double\n0 0 0 1 0 0 1 1 0\nPOLYGONS 1 4\n3 0 1 2\n";
    const std::string upper = "POINTS 3 double\n0 0 0 1 1 0 0 1 0\nPOLYGONS 1 4\n3 1 2 0\n";
    put(folder / "lower.vtk", legacy(lower + field + "1 2 3"));
    put(folder / "upper.vtk", legacy(upper + field + "1 3 4"));
    put(folder / "bare.vtk", legacy(upper));
    put(folder / "empty.vtk", legacy("POINTS 0 double"));
    const fs::path file = folder / "run.pvd";
    const auto read = [&](std::string_view steps) {
        put(file, collection(steps));
        return series_files(std::span(&file, 1));
    };
    const SeriesFiles series = read(
        "<DataSet timestep='2' part='0' file='lower.vtk'/><DataSet timestep='1' part='10' file='upper.vtk'/>"
        "<DataSet timestep='1' part='3' file='empty.vtk'/><DataSet timestep='1' part='9' file='lower.vtk'/>");
    CHECK(series.times == std::vector<double>{1, 2});
    CHECK(series.files == std::vector<fs::path>{folder / "empty.vtk", folder / "lower.vtk"});
    REQUIRE(series.further_parts.size() == 2);
    CHECK(series.further_parts[0] == std::vector<fs::path>{folder / "lower.vtk", folder / "upper.vtk"});
    CHECK(series.further_parts[1].empty());
    const FieldMesh mesh = read_step_mesh(series, 0);
    CHECK(mesh.triangles == std::vector<std::array<Index, 3>>{{0, 1, 2}, {4, 5, 3}});
    CHECK(mesh.cell_of == std::vector<Index>{0, 1});
    REQUIRE(mesh.point_fields.size() == 1);
    CHECK(mesh.point_fields.front().values == std::vector<double>{1, 2, 3, 1, 3, 4});
    CHECK(read_step_mesh(series, 1) == read_field_mesh(folder / "lower.vtk"));

    const SeriesFiles unlike =
        read("<DataSet file='lower.vtk' timestep='0'/><DataSet part='1' file='bare.vtk' timestep='0'/>");
    CHECK(input_error_of([&] {
              read_step_mesh(unlike, 0);
          }).ends_with("bare.vtk: a piece has other fields, expected those of the first piece"));
    CHECK(input_error_of([&] {
              read(
                  "<DataSet file='lower.vtk' timestep='0'/><DataSet part='1' file='./lower.vtk' "
                  "timestep='0'/>");
          }).ends_with("lower.vtk is there twice at time 0"));
}

TEST_CASE(
    "a file series in JSON gives the files and their times, in the order of time, and names what is wrong") {
    const ScratchFolder folder;
    put(folder / "a.vtu", "");
    put(folder / "b.vtu", "");
    const fs::path file = folder / "run.vtu.Series";
    const auto read = [&](std::string_view text) {
        put(file, text);
        return series_files(std::span(&file, 1));
    };
    const auto read_files = [&](std::string_view files) {
        return read(fmt::format(R"({{"file-series-version": "1.0", "files": {}}})", files));
    };
    const SeriesFiles series = read_files(
        fmt::format(R"([{{"name": "b.vtu", "time": 2.5}}, {{"name": "{}", "time": -1, "iter": 7}}])",
                    (folder / "a.vtu").string()));
    CHECK(series.files == std::vector<fs::path>{folder / "a.vtu", folder / "b.vtu"});
    CHECK(series.times == std::vector<double>{-1, 2.5});
    CHECK_FALSE(series.are_steps);

    const auto check_error = [&](std::string_view files, std::string_view end) {
        CAPTURE(files);
        const std::string error = input_error_of([&] { read_files(files); });
        CAPTURE(error);
        CHECK(error.starts_with(file.string() + ": "));
        CHECK(error.ends_with(end));
    };
    check_error(R"([{"name": "c.vtu", "time": 0}])", R"(: files[0].name: there is no file "c.vtu")");
    check_error(R"([{"name": "", "time": 0}])", R"(: files[0].name: there is no file "")");
    check_error(R"([{"name": 7, "time": 0}])", ": files[0].name: is 7, expected a text");
    check_error(R"([{"time": 0}])", R"(: files[0]: has no "name")");
    check_error(R"([{"name": "a.vtu"}])", R"(: files[0]: has no "time")");
    check_error(R"([{"name": "a.vtu", "time": "0"}])", R"(: files[0].time: is "0", expected a number)");
    check_error(R"([{"name": "a.vtu", "time": 1e999}])", "number overflow parsing '1e999'");
    check_error(R"(["a.vtu"])", R"(: files[0]: is "a.vtu", expected an object)");
    check_error("{}", ": files: is an object, expected an array");
    check_error("[]", ": files: has no files, expected at least one");
    check_error(R"([{"name": "a.vtu", "time": 1}, {"name": "b.vtu", "time": 1}])",
                "are both at time 1, expected one file per time");
    CHECK(input_error_of([&] { read("[]"); }).ends_with(": document: is an array, expected an object"));
    CHECK(input_error_of([&] { read("{}"); }).ends_with(R"(: document: has no "file-series-version")"));
    CHECK(input_error_of([&] {
              read(R"({"file-series-version": "2.0", "files": []})");
          }).ends_with(R"(: file-series-version: is "2.0", expected "1.0")"));
    CHECK(input_error_of([&] { read("<VTKFile/>"); }).starts_with(file.string() + ": "));
}

TEST_CASE("times of files are the one number in which their names differ, or 0, 1, 2") {
    CHECK(times_of({"a/u2-007.vtk", "a/u2-010.vtk", "a/u2-200.vtk"}) == std::vector<double>{7, 10, 200});
    CHECK(times_of({"u1-1.vtk", "u2-2.vtk"}) == std::vector<double>{0, 1});
    CHECK(times_of({"u3.vtk", "u2.vtk"}) == std::vector<double>{0, 1});
    CHECK(times_of({"first.vtk", "then.vtk"}) == std::vector<double>{0, 1});
    CHECK(times_of({"u5.vtk"}) == std::vector<double>{0});
}

TEST_CASE("every format with triangles is a step of a series") {
    const ScratchFolder folder;
    put(folder / "a.vtu", sample_grid({}));
    put(folder / "a.vtk", sample_legacy(true, true));
    put(folder / "a.obj", "v 0 0 0 1 0 0.5\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 3 1 2\n");
    put(folder / "empty.vtk",
        "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n");
    CHECK(read_field_mesh(folder / "a.vtu") == sample_mesh());
    CHECK(read_field_mesh(folder / "a.vtk") == legacy_sample_mesh());
    const FieldMesh mesh = read_field_mesh(folder / "a.obj");
    CHECK(mesh.triangles == std::vector<std::array<Index, 3>>{{2, 0, 1}});
    REQUIRE(mesh.point_fields.size() == 1);
    CHECK(mesh.point_fields.front().values == std::vector<double>{1, 0, 0.5, 0, 0, 0, 0, 0, 0});
    CHECK(input_error_of([&] {
              read_field_mesh(folder / "empty.vtk");
          }).ends_with("empty.vtk: has no triangles, expected at least one"));
}

}  // namespace interleaf
