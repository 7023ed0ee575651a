// `interleaf import` and the series that `export` writes: from files to a family and back.
#include <filesystem>
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

}  // namespace

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
