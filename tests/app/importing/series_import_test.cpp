// Imports of series: offsets of fields that are far from 0, and units.
#include "app/importing/series_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "family/family_fields.h"
#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/morph.h"

using namespace interleaf;

namespace {

/// A step of a series over the unit square, with a field "T" far from 0.
struct FarStep {
    std::vector<glm::dvec2> points;
    std::vector<Triangle> triangles;
    std::vector<double> values;

    /// The piecewise linear function of the values at \p place.
    double at(const glm::dvec2& place) const {
        constexpr double rounding = 1e-9;
        for (const auto& [a, b, c] : triangles) {
            const glm::dvec2 u = points[b] - points[a];
            const glm::dvec2 v = points[c] - points[a];
            const glm::dvec2 to = place - points[a];
            const double area = u.x * v.y - u.y * v.x;
            const double s = (to.x * v.y - to.y * v.x) / area;
            const double t = (u.x * to.y - u.y * to.x) / area;
            if (s > -rounding && t > -rounding && s + t < 1 + rounding)
                return values[a] + s * (values[b] - values[a]) + t * (values[c] - values[a]);
        }
        return std::nan("");
    }
};

FarStep far_step(std::mt19937& random, double time) {
    const std::vector<glm::vec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    AdaptiveMesh mesh(RootComplex(4, {{1, 2, 0}, {3, 0, 2}}), corners);
    for (int round = 0; round < 40; ++round)
        mesh.refine({{static_cast<Index>(random() % mesh.leaf_count())}});
    const Hierarchy key = mesh.freeze();
    FarStep step;
    for (const Leaf& leaf : leaves_of(key)) step.triangles.push_back(leaf.vertices);
    for (const glm::vec3& position : key.positions) {
        step.points.emplace_back(position.x, position.y);
        step.values.push_back(300 +
                              0.1 * std::sin(5.0 * double{position.x} + 3.0 * double{position.y} + time));
    }
    return step;
}

std::string file_of(const FarStep& step) {
    std::string text = fmt::format(
        "# vtk DataFile Version 3.0\nfar\nASCII\nDATASET POLYDATA\nPOINTS {} double\n", step.points.size());
    for (const glm::dvec2& point : step.points) text += fmt::format("{} {} 0\n", point.x, point.y);
    text += fmt::format("POLYGONS {} {}\n", step.triangles.size(), 4 * step.triangles.size());
    for (const auto& [a, b, c] : step.triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
    text += fmt::format("POINT_DATA {}\nSCALARS T double\nLOOKUP_TABLE default\n", step.points.size());
    for (const double value : step.values) text += fmt::format("{:.17g}\n", value);
    return text;
}

/// An OBJ file of a sphere with \p around meridians and half as many bands between its poles.
std::string sphere_file(unsigned around) {
    const unsigned bands = around / 2;
    std::string text = "v 0 0 1\nv 0 0 -1\n";
    for (unsigned band = 1; band < bands; ++band)
        for (unsigned m = 0; m < around; ++m) {
            const double polar = 3.14159265 * band / bands;
            const double angle = 2 * 3.14159265 * m / around;
            text += fmt::format("v {} {} {}\n", std::sin(polar) * std::cos(angle),
                                std::sin(polar) * std::sin(angle), std::cos(polar));
        }
    const auto at = [&](unsigned band, unsigned m) {
        return band == 0 ? 1U : band == bands ? 2U : 3U + (band - 1) * around + m % around;
    };
    for (unsigned band = 0; band < bands; ++band)
        for (unsigned m = 0; m < around; ++m) {
            const unsigned a = at(band, m), b = at(band, m + 1), c = at(band + 1, m), d = at(band + 1, m + 1);
            if (band > 0) text += fmt::format("f {} {} {}\n", a, c, b);
            if (band + 1 < bands) text += fmt::format("f {} {} {}\n", b, c, d);
        }
    return text;
}

ImportedSeries import_files(const ScratchFolder& folder, const ImportChoices& choices) {
    const std::filesystem::path pattern = folder / "far-*.vtk";
    return import_series(series_files(std::span(&pattern, 1)), "far", choices, {});
}

}  // namespace

TEST_CASE(
    "blends of a field of 300 +- 0.1 are those of the steps to a millionth of the range, at 100,000 points") {
    std::mt19937 random(3);
    const std::array<FarStep, 2> steps = {far_step(random, 0), far_step(random, 1)};
    const ScratchFolder folder;
    for (std::size_t n = 0; n < steps.size(); ++n)
        put(folder / fmt::format("far-{}.vtk", n), file_of(steps[n]));
    const ImportedSeries imported = import_files(folder, {});
    REQUIRE(imported.family.field_scales == std::vector<FieldScale>{{"T", 300, ""}});
    double low = 1e9;
    double high = -1e9;
    for (const FarStep& step : steps)
        for (const double value : step.values) {
            low = std::min(low, value);
            high = std::max(high, value);
        }

    const Weights weights = {{0, 0.375}, {1, 0.625}};
    UnionMesh mesh = unite(imported.family, weights);
    CHECK(mesh.leaf_count() > steps[0].triangles.size());
    unite_fields(imported.family, weights, mesh);
    const Field blended = morphed_field(mesh.fields[0], weight_values(weights));
    const auto positions = morph(mesh, weight_values(weights));
    std::uniform_real_distribution<double> parts(0, 1);
    double largest = 0;
    for (int trial = 0; trial < 100'000; ++trial) {
        const Triangle& corners = mesh.triangles[random() % mesh.leaf_count()];
        std::array<double, 3> part = {parts(random), parts(random), parts(random)};
        const double sum = part[0] + part[1] + part[2];
        glm::dvec2 place(0);
        double ours = 300;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3& corner = positions[corners[c]];
            place += part[c] / sum * glm::dvec2(corner.x, corner.y);
            ours += part[c] / sum * double{blended.values[corners[c]]};
        }
        largest =
            std::max(largest, std::abs(ours - (0.375 * steps[0].at(place) + 0.625 * steps[1].at(place))));
    }
    CHECK(largest <= 1e-6 * (high - low));
    CHECK(largest > 0);
}

TEST_CASE("fields near 0 get no offset, and neither does a displacement") {
    const ScratchFolder folder;
    std::mt19937 random(4);
    FarStep step = far_step(random, 0);
    for (double& value : step.values) value -= 300;
    put(folder / "far-0.vtk", file_of(step));
    put(folder / "far-1.vtk", file_of(step));
    CHECK(import_files(folder, {}).family.field_scales.empty());
}

TEST_CASE("an offset holds for the whole series, also where the first step is constant") {
    const ScratchFolder folder;
    std::mt19937 random(4);
    FarStep step = far_step(random, 0);
    put(folder / "far-1.vtk", file_of(step));
    put(folder / "far-2.vtk", file_of(step));
    std::ranges::fill(step.values, 300);
    put(folder / "far-0.vtk", file_of(step));
    const Family family = import_files(folder, {.units = {{"T", "K"}}, .time_unit = "ms"}).family;
    CHECK(family.field_scales == std::vector<FieldScale>{{"T", 300, "K"}});
    CHECK(family.time_unit == "ms");
    CHECK(family.keys[0].hierarchy->fields[0].values[0] == 0);
    CHECK(contains(input_error_of([&] {
                       import_files(folder, {.units = {{"u", "K"}}});
                   }),
                   "no key has a scalar field called \"u\""));
}

TEST_CASE("a unit of a field that is missing is told before any step is recovered") {
    const ScratchFolder folder;
    std::mt19937 random(4);
    put(folder / "far-0.vtk", file_of(far_step(random, 0)));
    put(folder / "far-1.vtk", "broken");
    CHECK(contains(input_error_of([&] {
                       import_files(folder, {.units = {{"u", "K"}}});
                   }),
                   "no key has a scalar field called \"u\""));
}

TEST_CASE("fields have the units that the files have, unless others are chosen") {
    const ScratchFolder folder;
    const auto array = [](const char* name, int components, const char* values, const char* unit) {
        // As VTK writes it: the text of a key is on a line of its own.
        return fmt::format(
            R"(<DataArray type="Float64" Name="{}" NumberOfComponents="{}" format="ascii">
<InformationKey name="UNITS_LABEL" location="vtkDataArray">
          {}
        </InformationKey>
{}
</DataArray>)",
            name, components, unit, values);
    };
    for (const char* const file : {"a-0.vtp", "a-1.vtp"})
        put(folder / file,
            R"(<VTKFile type="PolyData" version="0.1"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys><PointData>)" +
                array("T", 1, "0 1 2", "K") + array("v", 2, "0 1 2 3 4 5", "m/s") +
                array("p", 1, "0 1 2", std::string(65, 'p').c_str()) +
                "</PointData></Piece></PolyData></VTKFile>");
    const std::filesystem::path pattern = folder / "a-*.vtp";
    const auto unit_of = [&](const ImportChoices& choices, const char* field) {
        const Family family = import_series(series_files(std::span(&pattern, 1)), "a", choices, {}).family;
        return scale_of(family.field_scales, field).unit;
    };
    CHECK(unit_of({}, "T") == "K");
    CHECK(unit_of({}, "v y") == "m/s");
    CHECK(unit_of({}, "p").empty());  // too long for a unit
    CHECK(unit_of({.units = {{"T", "mK"}}}, "T") == "mK");
    CHECK(unit_of({.fields = {"T"}}, "T") == "K");
}

TEST_CASE("progress never goes back where no bisection connects the steps and keys are fitted to them") {
    const ScratchFolder folder;
    put(folder / "ball-0.obj", sphere_file(12));
    put(folder / "ball-1.obj", sphere_file(14));
    const std::filesystem::path pattern = folder / "ball-*.obj";
    double reached = 0;
    const ImportedSeries imported =
        import_series(series_files(std::span(&pattern, 1)), "ball", {}, [&](std::string_view, double part) {
            CHECK(part >= reached);
            reached = part;
        });
    CHECK(imported.report.method == SeriesMethod::by_fitting);
    CHECK(reached > 0.5);
}

TEST_CASE("the parts of a step become one key, also where only every second step is taken") {
    const ScratchFolder folder;
    const std::string head = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n";
    put(folder / "lower.vtk", head + "0 0 0 1 0 0 1 1 0\nPOLYGONS 1 4\n3 1 2 0\n");
    put(folder / "upper.vtk", head + "0 0 0 1 1 0 0 1 0\nPOLYGONS 1 4\n3 2 0 1\n");
    std::string sets;
    for (const int time : {0, 1, 2})
        for (const int part : {0, 1})
            sets += fmt::format("<DataSet timestep='{}' part='{}' file='{}.vtk'/>", time, part,
                                part == 0 ? "lower" : "upper");
    const std::filesystem::path file = folder / "run.pvd";
    put(file, fmt::format("<VTKFile type='Collection'><Collection>{}</Collection></VTKFile>", sets));
    const SeriesFiles taken = every_step(series_files(std::span(&file, 1)), 2);
    CHECK(taken.times == std::vector<double>{0, 2});
    const Family family = import_series(taken, "parts", {}, {}).family;
    REQUIRE(family.keys.size() == 2);
    for (const Key& key : family.keys) {
        CHECK(key.hierarchy->leaf_count() == 2);
        CHECK(key.hierarchy->positions.size() == 4);
    }
}

TEST_CASE("an error in a further part of a step names that part first") {
    const ScratchFolder folder;
    const std::string head = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n";
    put(folder / "lower.vtk", head + "0 0 0 1 0 0 1 1 0\nPOLYGONS 1 4\n3 1 2 0\n");
    put(folder / "broken.vtk", head + "0 0 0 1 1 0 0 one 0\n");
    const std::filesystem::path file = folder / "run.pvd";
    put(file,
        "<VTKFile type='Collection'><Collection><DataSet file='lower.vtk'/><DataSet file='lower.vtk'/>"
        "<DataSet part='1' file='broken.vtk'/></Collection></VTKFile>");
    const std::string error =
        input_error_of([&] { import_series(series_files(std::span(&file, 1)), "parts", {}, {}); });
    CAPTURE(error);
    CHECK(error.starts_with((folder / "broken.vtk").string() + ": "));
    CHECK_FALSE(contains(error, "lower.vtk"));
}

TEST_CASE("the report names fields of cells that are left out, once, but not those of our own exports") {
    const ScratchFolder folder;
    const auto notes = [&](std::initializer_list<const char*> cell_fields, const ImportChoices& choices) {
        std::string arrays;
        for (const char* const name : cell_fields) arrays += fmt::format("{} 1 1 double\n7\n", name);
        for (const char* const file : {"a-0.vtk", "a-1.vtk"})
            put(folder / file,
                fmt::format("# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n"
                            "0 0 0 1 0 0 1 1 0\nPOLYGONS 1 4\n3 0 1 2\n"
                            "POINT_DATA 3\nSCALARS u double\nLOOKUP_TABLE default\n0 1 2\n"
                            "CELL_DATA 1\nFIELD FieldData {}\n{}",
                            cell_fields.size(), arrays));
        const std::filesystem::path pattern = folder / "a-*.vtk";
        return import_series(series_files(std::span(&pattern, 1)), "a", choices, {}).report.notes;
    };
    using Notes = std::vector<std::string>;
    CHECK(notes({}, {}).empty());
    CHECK(notes({"p", "stress"}, {}) == Notes{R"(fields of cells are left out: "p", "stress")"});
    CHECK(notes({"p", "stress"}, {.fields = {"u"}}).empty());
    CHECK(notes({"level", "root", "origin"}, {}).empty());
    CHECK(notes({"level", "root"}, {}).empty());
    CHECK(notes({"level", "p", "root"}, {}) == Notes{R"(fields of cells are left out: "p")"});
    CHECK(notes({"level"}, {}) == Notes{R"(fields of cells are left out: "level")"});
    CHECK(notes({"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"}, {}) ==
          Notes{R"(fields of cells are left out: "a", "b", "c", "d", "e", "f", "g", "h" and 2 more)"});
}

TEST_CASE(
    "several files have the times in them, if each has one and these increase, else those of their names") {
    const ScratchFolder folder;
    const auto put_step = [&](const char* file, std::string_view time) {
        put(folder / file,
            fmt::format("# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n{}POINTS 3 double\n"
                        "0 0 0 1 0 0 1 1 0\nPOLYGONS 1 4\n3 0 1 2\n",
                        time.empty() ? "" : fmt::format("FIELD FieldData 1\nTIME 1 1 double\n{}\n", time)));
    };
    const auto timeline = [&](std::vector<const char*> times) {
        std::vector<std::filesystem::path> files;
        for (std::size_t n = 0; n < times.size(); ++n) {
            put_step(fmt::format("a-{}.vtk", n + 3).c_str(), times[n]);
            files.push_back(folder / fmt::format("a-{}.vtk", n + 3));
        }
        Timeline read = *import_series(series_files(files), "a", {}, {}).family.timeline;
        REQUIRE(read.keys().size() == times.size());
        return read;
    };
    const Timeline timed = timeline({"0.5", "0.75", "2"});
    CHECK(timed.keys()[0].time == 0.5);
    CHECK(timed.keys()[1].time == 0.75);
    CHECK(timed.keys()[2].time == 2);
    CHECK(timed.unit() == TimeUnit::seconds);
    for (const auto& times : std::vector<std::vector<const char*>>{{"0.5", "", "2"},
                                                                   {"", "1", "2"},
                                                                   {"0.5", "0.5", "2"},
                                                                   {"2", "1", "0"},
                                                                   {"7"},
                                                                   {"-1e308", "0", "1e308"}}) {
        const Timeline named = timeline(times);
        CHECK(named.begin() == (times.size() == 1 ? 0 : 3));
        CHECK(named.unit() == TimeUnit::steps);
    }

    put_step("a-3.vtk", "8");
    put_step("a-4.vtk", "9");
    const std::filesystem::path list = folder / "a.vtk.series";
    put(list,
        R"({"file-series-version": "1.0", "files": [{"name": "a-3.vtk", "time": 1}, {"name": "a-4.vtk", "time": 2}]})");
    CHECK(import_series(series_files(std::span(&list, 1)), "a", {}, {}).family.timeline->begin() == 1);
}
