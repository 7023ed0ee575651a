#include "io/export/vtk_export.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "family/new_family.h"
#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/error.h"
#include "io/export/time_list.h"
#include "io/samples.h"
#include "io/series_files.h"

namespace interleaf {
namespace {

/// Keys with a scalar and a color, over a timeline; the third entry names the first key again.
Family family_with_fields(unsigned seed, glm::dvec3 origin = glm::dvec3(0)) {
    std::mt19937 random(seed);
    std::vector<Key> keys;
    for (const int rounds : {2, 5, 3}) {
        Hierarchy key = random_hierarchy(random, false, rounds);
        const std::size_t count = key.positions.size();
        key.fields.push_back({"height & <more>", FieldKind::scalar, Buffer<float>(count, 0)});
        for (std::size_t v = 0; v < count; ++v) key.fields[0].values[v] = key.positions[v].z;
        key.fields.push_back({"color", FieldKind::color, Buffer<float>(3 * count, 0.5F)});
        if (rounds == 5) key.fields.push_back({"lonely", FieldKind::scalar, Buffer<float>(count, 1)});
        keys.push_back({fmt::format("key {}", rounds), std::move(key)});
    }
    Family family = family_of_keys("sample", std::move(keys));
    family.timeline = Timeline({{0, 0}, {0.5, 1}, {0.75, 0}, {2, 2}});
    family.origin = origin;
    return family;
}

/// The blend of \p family as a reader should find it.
void check_surface(const FieldMesh& mesh, const Family& family, const Blend& blend) {
    REQUIRE(mesh.triangles.size() == blend.mesh.leaf_count());
    CHECK(std::ranges::equal(mesh.triangles, blend.mesh.triangles));
    REQUIRE(mesh.points.size() == blend.positions.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        CHECK(mesh.points[v] == family.origin + glm::dvec3(blend.positions[v]));
    REQUIRE(!mesh.point_fields.empty());
    CHECK(mesh.point_fields[0].name == "height & <more>");
    CHECK(std::ranges::equal(mesh.point_fields[0].values, blend.fields[0].values));
    REQUIRE(mesh.triangle_fields.size() == 3);
    std::vector<double> parts(blend.mesh.roots.triangle_count(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        CHECK(mesh.triangle_fields[0].values[t] == blend.mesh.tags[t].level());
        const double root = mesh.triangle_fields[1].values[t];
        if (t > 0) CHECK(root >= mesh.triangle_fields[1].values[t - 1]);
        parts.at(static_cast<std::size_t>(root)) +=
            std::exp2(-static_cast<double>(blend.mesh.tags[t].level()));
    }
    CHECK(mesh.triangle_fields[1].name == "root");
    for (const double part : parts) CHECK(part == 1);
}

std::vector<FieldMesh> meshes_of(const SeriesFiles& series) {
    std::vector<FieldMesh> meshes;
    for (const std::filesystem::path& file : series.files) meshes.push_back(read_field_mesh(file));
    return meshes;
}

struct Written {
    SeriesFiles series;
    std::vector<FieldMesh> meshes;
    std::vector<std::string> remarks;
};

Written written_series(const Family& family, const SeriesExportOptions& options) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder / "out.pvd";
    Written written;
    export_pvd({.family = family, .weights = {}, .form = {}, .series = options, .remarks = &written.remarks},
               {file});
    written.series = series_files(std::span(&file, 1));
    written.meshes = meshes_of(written.series);
    for (std::size_t n = 0; n < written.meshes.size(); ++n)
        CHECK(written.meshes[n].time == written.series.times[n]);
    CHECK(folder.entry_count() == written.series.files.size() + 1);
    return written;
}

/// The largest distance between \p mesh and the blend at \p time, at the corners of triangles that are in both.
double distance_from_timeline(const Family& family, double time, const FieldMesh& mesh,
                              const Hierarchy* finest) {
    BlendSeries blends(family, finest);
    const Blend& blend = blends.at(family.timeline->at(time));
    REQUIRE(mesh.points.size() == blend.positions.size());
    double most = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const glm::dvec3 difference = mesh.points[v] - glm::dvec3(blend.positions[v]);
        most = std::max({most, std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
    }
    return most;
}

/// An octahedron of 64 leaves, one of which is bisected many times.
Hierarchy fine_at(Index leaf) {
    std::mt19937 random(1);
    const Hierarchy roots = random_hierarchy(random, false, 0);
    AdaptiveMesh mesh(roots.roots, roots.positions);
    for (int round = 0; round < 3; ++round)
        for (Index place = 0; place < Index{8} << round; ++place) mesh.refine({{place}});
    for (int round = 0; round < 20; ++round) mesh.refine({{leaf}});
    return mesh.freeze();
}

}  // namespace

TEST_CASE("one blend as polygons or as a grid is read again with its fields, levels and keys") {
    for (const glm::dvec3 origin : {glm::dvec3(0), glm::dvec3(5e5, 5.4e6, 0.125)}) {
        const Family family = family_with_fields(11, origin);
        const Weights weights{{1, 0.25}, {2, 0.75}};
        const Export exported{.family = family, .weights = weights};
        const Blend blend = blend_of(exported);
        const ScratchFolder folder;
        export_vtp(exported, {folder / "a.vtp"});
        export_vtu(exported, {folder / "a.vtu"});
        const FieldMesh mesh = read_field_mesh(folder / "a.vtp");
        check_surface(mesh, family, blend);
        CHECK(read_field_mesh(folder / "a.vtu") == mesh);
        // Bits 1 and 2 of the family's keys, where the union has bits 0 and 1.
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            CHECK(mesh.triangle_fields[2].values[t] == 2.0 * blend.mesh.origins[t]);
        REQUIRE(mesh.point_fields.size() == 2);
        CHECK(mesh.point_fields[1].components == 3);
        for (const double part : mesh.point_fields[1].values) CHECK(part == 128);
    }
}

TEST_CASE("files at the keys, over the union of all, interpolate linearly to the timeline") {
    const Family family = family_with_fields(12);
    const auto [series, meshes, remarks] = written_series(family, {.mesh = SeriesUnion::all});
    CHECK(series.times == std::vector<double>{0, 0.5, 0.75, 2});
    CHECK(remarks.empty());
    const Hierarchy finest = finest_of(family, std::vector<std::size_t>{0, 1, 2}, no_index);
    for (std::size_t n = 0; n < meshes.size(); ++n) {
        CHECK(meshes[n].triangles == meshes[0].triangles);
        CHECK(meshes[n].triangle_fields == meshes[0].triangle_fields);
        CHECK(meshes[n].point_fields.size() == 2);
        CHECK(distance_from_timeline(family, series.times[n], meshes[n], &finest) == 0);
    }
    for (std::size_t n = 0; n + 1 < meshes.size(); ++n)
        for (const double part : {0.25, 0.5, 0.875}) {
            FieldMesh between = meshes[n];
            for (std::size_t v = 0; v < between.points.size(); ++v)
                between.points[v] += part * (meshes[n + 1].points[v] - meshes[n].points[v]);
            const double time = series.times[n] + part * (series.times[n + 1] - series.times[n]);
            CHECK(distance_from_timeline(family, time, between, &finest) < 1e-6);
        }
}

TEST_CASE("files of intervals have the union of two keys, and follow one another without a gap") {
    const Family family = family_with_fields(13);
    const auto [series, meshes, remarks] = written_series(family, {.mesh = SeriesUnion::interval});
    REQUIRE(series.times.size() == 6);
    CHECK(series.times[1] == 0.5);
    CHECK(series.times[2] == std::nextafter(0.5, 1));
    for (std::size_t n = 0; n < meshes.size(); n += 2) {
        CHECK(meshes[n].triangles == meshes[n + 1].triangles);
        CHECK(distance_from_timeline(family, series.times[n], meshes[n], nullptr) < 1e-6);
    }
    CHECK(meshes[5].triangles.size() == unite(family, {{0, 1.0}, {2, 0.0}}).leaf_count());
}

TEST_CASE("frames per second are evenly spaced from the begin of the time on") {
    Family family = family_with_fields(14);
    family.timeline = family.timeline->with_interpolation({Basis::catmull_rom});
    const auto [series, meshes, remarks] =
        written_series(family, {.frames_per_second = 4, .mesh = SeriesUnion::interval});
    CHECK(series.times == std::vector<double>{0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2});
    CHECK(remarks.empty());
    for (std::size_t n = 0; n < meshes.size(); ++n)
        CHECK(distance_from_timeline(family, series.times[n], meshes[n], nullptr) == 0);
    CHECK(written_series(family, {.frames_per_second = 0.7}).series.times.size() == 2);
    CHECK(written_series(family, {}).remarks.size() == 1);
}

TEST_CASE("files can be at every step of time, or at chosen times") {
    const Family family = family_with_fields(18);
    const auto [series, meshes, remarks] =
        written_series(family, {.time_step = 0.6, .mesh = SeriesUnion::interval});
    CHECK(series.times == std::vector<double>{0, 0.6, 1.2, 3 * 0.6});
    for (std::size_t n = 0; n < meshes.size(); ++n)
        CHECK(distance_from_timeline(family, series.times[n], meshes[n], nullptr) == 0);
    CHECK(written_series(family, {.time_step = 0.1}).series.times.size() ==
          21);  // the end, too, despite rounding
    CHECK(written_series(family, {.times = {0.25, 2}}).series.times == std::vector<double>{0.25, 2});
}

TEST_CASE("the components of a vector are written as one array") {
    Family family = family_with_fields(19);
    for (Key& key : family.keys) {
        Hierarchy hierarchy = *key.hierarchy;
        const std::size_t count = hierarchy.positions.size();
        hierarchy.fields.clear();
        for (const std::string name : {"v x", "v y", "v z", "w x", "w y", "u", "u x", "u y", "p x"})
            hierarchy.fields.push_back(
                {name, FieldKind::scalar, Buffer<float>(count, name.ends_with('y') ? 2.0F : 1.0F)});
        key.hierarchy = hierarchy;
    }
    const Written written = written_series(family, {.times = {0}});
    std::vector<std::string> names;
    for (const MeshField& field : written.meshes.front().point_fields)
        names.push_back(fmt::format("{} {}", field.name, field.components));
    CHECK(names == std::vector<std::string>{"v 3", "w 2", "u 1", "u x 1", "u y 1", "p x 1"});
    CHECK(written.meshes.front().point_fields[0].values[1] == 2);
}

TEST_CASE("offsets are added in double precision, and units go along") {
    Family family = family_with_fields(23);
    family.field_scales = {{"height & <more>", 1e9, "<m>"}};
    const Weights weights{{0, 0.5}, {1, 0.5}};
    const Export exported{.family = family, .weights = weights};
    const Blend blend = blend_of(exported);
    const ScratchFolder folder;
    export_vtu(exported, {folder / "a.vtu"});
    const FieldMesh mesh = read_field_mesh(folder / "a.vtu");
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        CHECK(mesh.point_fields[0].values[v] == double{blend.fields[0].values[v]} + 1e9);
    CHECK(contains(content(folder / "a.vtu"),
                   "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">&lt;m&gt;</"));
}

TEST_CASE("a series is written with the same bytes each time") {
    const Family family = family_with_fields(29);
    const ScratchFolder folder;
    for (const char* name : {"a", "b"}) {
        std::filesystem::create_directory(folder / name);
        export_pvd({.family = family, .weights = {}}, {folder / name / "run.pvd"});
    }
    const std::filesystem::path file = folder / "a/run.pvd";
    std::vector<std::filesystem::path> files = series_files(std::span(&file, 1)).files;
    CHECK(files.size() == 4);
    files.push_back(file);
    for (const std::filesystem::path& each : files)
        CHECK(content(each) == content(folder / "b" / each.filename().string()));
}

TEST_CASE("times are read from a text, and faults are named with their line") {
    const ScratchFolder folder;
    put(folder / "t.txt", "# times\n0, 0.5\n\n1e0 2 # end\n");
    CHECK(read_times(folder / "t.txt") == std::vector<double>{0, 0.5, 1, 2});
    const auto fault = [&](const char* text) {
        put(folder / "t.txt", text);
        return input_error_of([&] { read_times(folder / "t.txt"); });
    };
    CHECK(contains(fault("0\n1 x\n"), "t.txt: line 2: \"x\", expected a time"));
    CHECK(contains(fault("0\n1\n1\n"), "t.txt: line 3: time 1 after 1, expected a later one"));
    CHECK(contains(fault("# none\n"), "t.txt: has no times"));
}

TEST_CASE("unions of intervals are taken where that of all keys is much larger, with a word") {
    std::vector<Key> keys;
    for (Index place = 0; place < 16; ++place) keys.push_back({fmt::format("{}", place), fine_at(4 * place)});
    const Family family = family_of_keys("spread", std::move(keys));
    const Written written = written_series(family, {});
    REQUIRE(written.remarks.size() == 1);
    CHECK(contains(written.remarks.front(), "over 4 times"));
    CHECK(written.series.times.size() == 30);
    CHECK(written_series(family, {.mesh = SeriesUnion::all}).series.times.size() == 16);
}

TEST_CASE("a series needs a file, a timeline and a number of frames") {
    const auto error = [](const Family& family, const SeriesExportOptions& options,
                          const OutputTarget& target) {
        return text_of_thrown<UsageError>(
            [&] { export_pvd({.family = family, .weights = {}, .form = {}, .series = options}, target); });
    };
    Family family = family_with_fields(16);
    CHECK(contains(error(family, {}, {}), "expected a file for -o"));
    CHECK(contains(error(family, {.frames_per_second = 0}, {"a.pvd"}),
                   "--fps: expected a number of frames per second above 0"));
    CHECK(contains(error(family, {.frames_per_second = 1e9}, {"a.pvd"}), "at most 100000"));
    CHECK(contains(error(family, {.time_step = 0}, {"a.pvd"}), "--every: 0 gives no number of files"));
    CHECK(contains(input_error_of([&] {
                       export_pvd({.family = family, .weights = {}, .form = {}, .series = {.times = {3}}},
                                  {"a.pvd"});
                   }),
                   "time 3 is outside the time of the family, 0 to 2"));
    family.timeline.reset();
    CHECK(error(family, {}, {"a.pvd"}) == no_default_blend);
}

}  // namespace interleaf
