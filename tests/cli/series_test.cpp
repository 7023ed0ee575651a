// `interleaf import` and the series that `export` writes: from files to a family and back.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "cli/process.h"
#include "messages.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/series_files.h"

namespace interleaf {
namespace {

/// A square of two triangles, the first bisected if \p is_bisected, with the field "u", which is \p u everywhere.
std::string square_file(bool is_bisected, double u) {
    const std::string points = "POINTS 5 double\n0 0 0 1 0 0 1 1 0 0 1 0 0.5 0.5 0\n";
    const std::string cells = is_bisected
                                  ? "CELLS 4 16\n3 4 0 1\n3 4 1 2\n3 4 2 3\n3 4 3 0\nCELL_TYPES 4\n5 5 5 5\n"
                                  : "CELLS 2 8\n3 1 2 0\n3 3 0 2\nCELL_TYPES 2\n5 5\n";
    return fmt::format(
        "# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET UNSTRUCTURED_GRID\n{}{}POINT_DATA 5\n"
        "SCALARS u double\nLOOKUP_TABLE default\n{} {} {} {} {}\n",
        points, cells, u, u, u, u, u);
}

/// Three steps, the middle one finer.
std::vector<std::string> put_steps(const ScratchFolder& folder) {
    put(folder / "run-2.vtk", square_file(false, 0));
    put(folder / "run-3.vtk", square_file(true, 0.5));
    put(folder / "run-5.vtk", square_file(false, 1));
    return {folder / "run-2.vtk", folder / "run-3.vtk", folder / "run-5.vtk"};
}

/// A globe of radius \p radius with a field "height", its z coordinate, and a vector field "v" of the coordinates.
std::string globe_file(int meridians, double radius) {
    const int parallels = meridians / 2;
    std::string points = fmt::format("0 0 {}\n", radius);
    std::string cells;
    std::string heights = fmt::format("{} ", radius);
    for (int p = 1; p < parallels; ++p) {
        const double polar = std::numbers::pi * p / parallels;
        for (int m = 0; m < meridians; ++m) {
            const double around = 2 * std::numbers::pi * m / meridians;
            points += fmt::format("{} {} {}\n", radius * std::sin(polar) * std::cos(around),
                                  radius * std::sin(polar) * std::sin(around), radius * std::cos(polar));
            heights += fmt::format("{} ", radius * std::cos(polar));
        }
    }
    points += fmt::format("0 0 {}\n", -radius);
    heights += fmt::format("{} ", -radius);
    const int last = 1 + (parallels - 1) * meridians;
    int count = 0;
    const auto add = [&](int a, int b, int c) {
        cells += fmt::format("3 {} {} {}\n", a, b, c);
        ++count;
    };
    for (int m = 0; m < meridians; ++m) {
        const int next = (m + 1) % meridians;
        add(0, 1 + m, 1 + next);
        for (int p = 0; p + 2 < parallels; ++p) {
            const int upper = 1 + p * meridians;
            const int lower = upper + meridians;
            add(upper + m, lower + m, lower + next);
            add(upper + m, lower + next, upper + next);
        }
        add(last, last - meridians + next, last - meridians + m);
    }
    return fmt::format(
        "# vtk DataFile Version 3.0\nglobe\nASCII\nDATASET POLYDATA\nPOINTS {} double\n{}"
        "POLYGONS {} {}\n{}POINT_DATA {}\nSCALARS height double\nLOOKUP_TABLE default\n{}\n"
        "VECTORS v double\n{}",
        last + 1, points, count, 4 * count, cells, last + 1, heights, points);
}

}  // namespace

TEST_CASE("closed surfaces that move and are meshed anew get fitted keys with their fields") {
    const ScratchFolder folder;
    put(folder / "g1.vtk", globe_file(12, 1));
    put(folder / "g2.vtk", globe_file(16, 1.5));
    const Outcome outcome =
        run_interleaf({"import", folder / "g*.vtk", "--tolerance", "0.01", "-o", folder / "out", "--json"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(contains(outcome.errors, "a key was fitted to each step, because no bisection connects them"));
    const auto report = nlohmann::json::parse(outcome.output);
    CHECK(report["method"] == "fitting");
    CHECK(report["steps"][1]["distance"].get<double>() > 0);
    CHECK(report["steps"][1]["distance"].get<double>() < 0.01);
    CHECK(report["steps"][1]["largest_difference"].get<double>() < 0.05);
    CHECK(report["steps"][0]["integral_error"].get<double>() < 0.01);
    // The globe grows: its points move as far as its surface, although its mesh is another one.
    CHECK(report["steps"][0]["point_motion"].get<double>() <
          1.1 * report["steps"][0]["surface_motion"].get<double>());
    const Family family = read_family(folder / "out");
    CHECK(family.timeline->begin() == 1);
    for (const Key& key : family.keys) {
        const Hierarchy& hierarchy = *key.hierarchy;
        REQUIRE(hierarchy.fields.size() == 4);
        CHECK(hierarchy.fields[1].name == "v x");
        for (std::size_t v = 0; v < hierarchy.positions.size(); ++v) {
            CHECK(std::abs(hierarchy.fields[0].values[v] - hierarchy.positions[v].z) < 1e-4F);
            CHECK(std::abs(hierarchy.fields[2].values[v] - hierarchy.positions[v].y) < 1e-4F);
        }
    }
}

TEST_CASE("fit takes a step of a series as a mesh, with its fields") {
    const ScratchFolder folder;
    put(folder / "g.vtk", globe_file(12, 1));
    const Outcome outcome =
        run_interleaf({"fit", folder / "g.vtk", "--leaves", "300", "-o", folder / "g.ilh"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    const Hierarchy key = read_hierarchy(folder / "g.ilh");
    CHECK(labels(key.fields) == std::vector<FieldName>{{"height"}, {"v x"}, {"v y"}, {"v z"}});
    for (std::size_t v = 0; v < key.positions.size(); ++v)
        CHECK(std::abs(key.fields[0].values[v] - key.positions[v].z) < 1e-4F);
}

TEST_CASE("units are named on the command line, kept, and printed; a series has the figures of a family") {
    const ScratchFolder folder;
    put_steps(folder);
    const std::string series = folder / "run-*.vtk";
    Outcome outcome =
        run_interleaf({"import", series, "--unit", "u=m/s", "--time-unit", "ms", "-o", folder / "out"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(read_family(folder / "out").time_unit == "ms");
    outcome = run_interleaf({"family", folder / "out", "--unit", "u=km/h", "-o", folder / "other"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    outcome = run_interleaf({"info", folder / "other"});
    CHECK(contains(outcome.output, "u  0 to 1 km/h\n"));
    CHECK(contains(outcome.output, "timeline, ms, linear"));
    CHECK(contains(run_interleaf({"import", series, "--unit", "w=m", "-o", folder / "no"}).errors,
                   "no key has a scalar field called \"w\""));
    outcome = run_interleaf({"family", folder / "out", "--unit", "u", "-o", folder / "no"});
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.errors, "--unit: expected FIELD=TEXT, such as T=K, got 'u'"));

    outcome = run_interleaf({"info", series});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(outcome.output.starts_with("family"));
    CHECK(contains(outcome.output, "run-3"));
    CHECK(contains(outcome.output, "timeline, steps, linear"));
}

TEST_CASE("info counts the bytes of all parts of a step") {
    const ScratchFolder folder;
    const std::string head = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n";
    put(folder / "lower.vtk", head + "0 0 0 1 0 0 1 1 0\nPOLYGONS 1 4\n3 1 2 0\n");
    put(folder / "upper.vtk", head + "0.0 0.0 0 1 1 0 0 1 0\nPOLYGONS 1 4\n3 2 0 1\n");
    put(folder / "run.pvd",
        "<VTKFile type='Collection'><Collection><DataSet file='lower.vtk'/>"
        "<DataSet part='1' file='upper.vtk'/></Collection></VTKFile>");
    const Outcome outcome = run_interleaf({"info", folder / "run.pvd", "--json"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(nlohmann::json::parse(outcome.output)["bytes"]["file"] ==
          content(folder / "lower.vtk").size() + content(folder / "upper.vtk").size());
}

TEST_CASE("a key of a field far from 0 is written without its offset, and a word says so") {
    const ScratchFolder folder;
    put(folder / "run-1.vtk", square_file(false, 300));
    put(folder / "run-2.vtk", square_file(true, 300.5));
    REQUIRE(run_interleaf({"import", folder / "run-*.vtk", "-o", folder / "out"}).status == 0);
    CHECK(contains(run_interleaf({"info", folder / "out"}).output, "u  300 to 300.5\n"));
    const Outcome outcome = run_interleaf({"export", folder / "out", "--time", "1", "-o", folder / "a.ilh"});
    CHECK(contains(outcome.errors, "The values of u are the differences from "));
    const Outcome ply = run_interleaf({"export", folder / "out", "--time", "1", "-o", folder / "a.ply"});
    CHECK(ply.errors.empty());
    CHECK(contains(content(folder / "a.ply"), "property double u\n"));
}

TEST_CASE("pictures have a legend, heights and arrows where they are asked for, and faults are named") {
    const ScratchFolder folder;
    put(folder / "run-1.vtk", square_file(true, 0.25));
    put(folder / "run-2.vtk", square_file(true, 1));
    const std::string family = folder / "out";
    REQUIRE(run_interleaf({"import", folder / "run-*.vtk", "-o", family}).status == 0);
    const auto render = [&](std::vector<std::string> choice) {
        choice.insert(choice.begin(), {"render", family, "--size", "240x180", "--color", "u", "--time", "1.5",
                                       "-o", "-", "--format", "png"});
        return run_interleaf(choice);
    };
    std::vector<std::string> pictures;
    for (const std::vector<std::string>& choice : std::vector<std::vector<std::string>>{
             {}, {"--legend"}, {"--height", "u"}, {"--height", "u,0.5"}, {"--arrows", "u,u"}}) {
        const Outcome outcome = render(choice);
        REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
        for (const std::string& other : pictures) CHECK(outcome.output != other);
        pictures.push_back(outcome.output);
    }
    const auto error = [&](std::vector<std::string> choice) {
        const Outcome outcome = render(std::move(choice));
        CHECK(outcome.status == 2);
        return outcome.errors;
    };
    CHECK(contains(error({"--height", "w"}), "--height: no scalar field is called 'w'; there are u"));
    CHECK(contains(error({"--height", "u,2"}), "--height: expected FIELD or FIELD,PART"));
    CHECK(contains(error({"--arrows", "u"}), "--arrows: expected two or three scalars"));
    CHECK(contains(error({"--arrows", "u,w"}), "--arrows: no scalar field is called 'w'"));
}

TEST_CASE("where no key can be fitted either, the message says what was tried") {
    const ScratchFolder folder;
    put(folder / "g1.vtk", globe_file(16, 1.5));
    put(folder / "g2.vtk",
        "# vtk DataFile Version 3.0\nbent\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
        "0 0 0 1 0 0 1 1 0 0 1 1\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\nPOINT_DATA 4\n"
        "SCALARS height double\nLOOKUP_TABLE default\n0 1 2 3\nVECTORS v double\n"
        "0 0 0 0 0 0 0 0 0 0 0 0\n");
    const Outcome outcome = run_interleaf({"import", folder / "g*.vtk", "-o", folder / "out"});
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "g2.vtk: the surface is an open sheet"));
    CHECK(contains(outcome.errors, "a key was to be fitted to each step"));
    CHECK(contains(outcome.errors, "vertices move and no order of corners marks the newest vertex"));
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("an interrupt ends an import, and leaves nothing behind") {
    const ScratchFolder folder;
    put(folder / "g1.vtk", globe_file(40, 1));
    put(folder / "g2.vtk", globe_file(60, 1.5));
    // timeout(1) sends the interrupt and waits. Status 124 means that it had to interrupt the program.
    const std::string command =
        fmt::format("timeout -s INT 0.3 {} import '{}' -o '{}' >/dev/null 2>&1", INTERLEAF_PROGRAM,
                    (folder / "g*.vtk").string(), (folder / "out").string());
    CHECK(WEXITSTATUS(std::system(command.c_str())) == 124);
    CHECK(folder.entry_count() == 2);
}

TEST_CASE("--warp makes a landscape of a field, and says what it lacks") {
    const ScratchFolder folder;
    put_steps(folder);
    const auto import = [&](const std::string& warp) {
        return run_interleaf({"import", folder / "run-*.vtk", "--warp", warp, "-o", folder / "out"});
    };
    REQUIRE(import("u,-3").status == 0);
    const Family family = read_family(folder / "out");
    CHECK(family.keys[0].hierarchy->positions[0].z == 0);
    CHECK(family.keys[1].hierarchy->positions[4].z == -1.5F);
    CHECK(family.keys[2].hierarchy->positions[2].z == -3);
    CHECK(contains(import("w").errors,
                   "run-2.vtk: field w is missing, expected one of the keys' for --warp: u"));
    CHECK(import(",2").status == 2);
}

TEST_CASE("a series of files becomes a family with their times, fields and triangles") {
    const ScratchFolder folder;
    put_steps(folder);
    const Outcome outcome = run_interleaf({"import", folder / "run-*.vtk", "-o", folder / "out", "--json"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    const auto report = nlohmann::json::parse(outcome.output);
    CHECK(report["roots"] == 2);
    CHECK(report["steps"][1]["leaves"] == 4);
    CHECK(report["steps"][1]["time"] == 3);
    CHECK(report["steps"][1]["largest_difference"] == 0);
    const Family family = read_family(folder / "out");
    REQUIRE(family.keys.size() == 3);
    CHECK(family.name == "out");
    CHECK(family.keys[1].name == "run-3");
    CHECK(family.keys[0].hierarchy->leaf_count() == 2);
    CHECK(family.keys[1].hierarchy->leaf_count() == 4);
    CHECK(family.keys[1].hierarchy->fields.front().name == "u");
    CHECK_FALSE(family.domain.has_value());
    REQUIRE(family.timeline.has_value());
    CHECK(family.timeline->begin() == 2);
    CHECK(family.timeline->end() == 5);
}

TEST_CASE("what import makes, export writes as a series that import reads again") {
    const ScratchFolder folder;
    put_steps(folder);
    REQUIRE(run_interleaf({"import", folder / "run-*.vtk", "-o", folder / "a"}).status == 0);
    const Outcome exported =
        run_interleaf({"export", folder / "a", "-o", folder / "b.pvd", "--union", "all"});
    REQUIRE_MESSAGE(exported.status == 0, exported.errors);
    CHECK(read_field_mesh(folder / "b.0001.vtp").triangles.size() == 4);
    const Outcome again = run_interleaf({"import", folder / "b.pvd", "-o", folder / "b"});
    REQUIRE_MESSAGE(again.status == 0, again.errors);
    const Family family = read_family(folder / "b");
    REQUIRE(family.keys.size() == 3);
    CHECK(family.timeline->end() == 5);
    CHECK(family.keys[2].hierarchy->fields.front().values[0] == 1);

    const Outcome alone = run_interleaf({"import", folder / "b.*.vtp", "-o", folder / "c", "--json"});
    REQUIRE_MESSAGE(alone.status == 0, alone.errors);
    CHECK(alone.errors.empty());
    const auto report = nlohmann::json::parse(alone.output);
    CHECK(report["steps"][0]["time"] == 2);
    CHECK(report["steps"][2]["time"] == 5);
    CHECK(read_family(folder / "c").timeline->end() == 5);
}

TEST_CASE("--every takes some of the steps, --field some of the fields") {
    const ScratchFolder folder;
    put_steps(folder);
    const Outcome outcome =
        run_interleaf({"import", folder / "run-*.vtk", "--every", "2", "--field", "u", "-o", folder / "out"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(contains(outcome.output, "2 steps over 2 roots"));
    CHECK(read_family(folder / "out").keys[1].name == "run-5");
}

TEST_CASE("faults of a series are named with the file") {
    const ScratchFolder folder;
    std::vector<std::string> files = put_steps(folder);
    const auto import = [&](const std::vector<std::string>& options) {
        std::vector<std::string> line = {"import", "-o", folder / "out"};
        line.insert(line.end(), options.begin(), options.end());
        line.insert(line.end(), files.begin(), files.end());
        return run_interleaf(line);
    };
    CHECK(import({"--newest", "third"}).status == 2);
    CHECK(import({"--every", "0"}).status == 2);
    put(files[1], "# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET STRUCTURED_GRID\n");
    const Outcome outcome = import({});
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "run-3.vtk: \"dataset\" \"structured_grid\", expected"));
    CHECK_FALSE(contains(outcome.errors, "step 1"));
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace interleaf
