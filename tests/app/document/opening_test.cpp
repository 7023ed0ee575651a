// Opening: what files are, decided in one place.
#include "app/document/opening.h"

#include <string>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>

#include "app/document/builtin_family.h"
#include "app/sample_family.h"
#include "io/family/family_file.h"
#include "io/gltf/glb_export.h"
#include "io/hierarchy/hierarchy_file.h"

using namespace interleaf;

namespace fs = std::filesystem;

namespace {

constexpr std::string_view corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
constexpr std::string_view tetrahedron = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// One file or folder of each kind.
struct Samples {
    Samples() {
        const Family family = sample_family();
        write_family(family, folder / "family");
        write_hierarchy(*family.keys[0].hierarchy, folder / "key.ilh");
        export_glb({family, std::nullopt, {}}, {folder / "family.glb"});
        mesh("m.1.obj", tetrahedron);
        mesh("m.2.obj", tetrahedron);
        mesh("other.obj", "f 1 2 3\n");
        mesh("fan.obj", "f 1 2 3\nf 1 2 4\nf 2 1 3\n");
        mesh("broken.obj", "f 1 2 9\n");
        put(folder / "mesh.off",
            "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
        put(folder / "MESH.STL", "");
        put(folder / "notes.txt", "");
    }
    void mesh(std::string_view name, std::string_view faces) const {
        put(folder / name, std::string(corners) + std::string(faces));
    }
    std::vector<fs::path> paths(std::initializer_list<const char*> names) const {
        std::vector<fs::path> found;
        for (const char* const name : names) found.push_back(folder / name);
        return found;
    }
    Opening open(std::initializer_list<const char*> names) const { return open_files(paths(names)); }
    std::string error(std::initializer_list<const char*> names) const {
        return input_error_of([&] { open(names); });
    }
    std::string family_error(std::initializer_list<const char*> names) const {
        return input_error_of([&] { open_family(paths(names)); });
    }

    ScratchFolder folder;
};

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a family file, its folder, and no path are families") {
    const Samples samples;
    for (const char* const name : {"family", "family/family.json"}) {
        const Opening opened = samples.open({name});
        REQUIRE(std::holds_alternative<OpenedFamily>(opened));
        CHECK(std::get<OpenedFamily>(opened).family.keys.size() == sample_family().keys.size());
    }
    const Opening builtin = open_files({});
    REQUIRE(std::holds_alternative<OpenedFamily>(builtin));
    CHECK(std::get<OpenedFamily>(builtin).family.keys.size() == 5);
    CHECK(open_family({}).name == read_family(builtin_family_folder()).name);
}

TEST_CASE("steps of a series are to be imported, which commands do at once") {
    const Samples samples;
    put(samples.folder / "s1.vtk",
        "# vtk DataFile Version 3.0\ns\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n"
        "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n");
    const Opening opened = samples.open({"s1.vtk"});
    REQUIRE(std::holds_alternative<SeriesToImport>(opened));
    CHECK(std::get<SeriesToImport>(opened).files == samples.paths({"s1.vtk"}));
    CHECK(open_family(samples.paths({"s1.vtk"})).keys.size() == 1);

    put(samples.folder / "s.vtk.series",
        R"({"file-series-version": "1.0", "files": [{"name": "s1.vtk", "time": 0.5}]})");
    CHECK(std::holds_alternative<SeriesToImport>(samples.open({"s.vtk.series"})));
    const Family listed = open_family(samples.paths({"s.vtk.series"}));
    CHECK(listed.name == "s");
    CHECK(listed.keys.front().name == "s1");
    REQUIRE(listed.timeline);
    CHECK(listed.timeline->begin() == 0.5);
}

TEST_CASE("files of keys are keys, and only meshes can be fitted instead") {
    const Samples samples;
    const auto keys = [&](std::initializer_list<const char*> names) {
        Opening opened = samples.open(names);
        REQUIRE(std::holds_alternative<OpenedKeys>(opened));
        return std::get<OpenedKeys>(std::move(opened));
    };
    const OpenedKeys one = keys({"key.ilh"});
    CHECK(one.family.name == "key");
    CHECK(one.files == samples.paths({"key.ilh"}));
    CHECK_FALSE(one.can_be_fitted());
    CHECK(keys({"m.1.obj"}).can_be_fitted());
    const OpenedKeys series = keys({"m.2.obj", "m.1.obj"});
    CHECK(series.can_be_fitted());
    CHECK(series.files == samples.paths({"m.1.obj", "m.2.obj"}));
    REQUIRE(series.family.timeline);
    CHECK(series.family.timeline->unit() == TimeUnit::steps);
    CHECK(series.family.keys.size() == 2);
    CHECK(keys({"m.*.obj"}).files.size() == 2);
    const OpenedKeys gltf = keys({"family.glb"});
    CHECK(gltf.family.keys.size() == sample_family().keys.size());
    CHECK(gltf.family.timeline == sample_family().timeline);
    CHECK(gltf.can_be_fitted());
    CHECK(keys({"family.glb", "family.glb"}).family.keys.size() == 2 * gltf.family.keys.size());
}

TEST_CASE("a mesh of a format without keys makes all meshes ones to fit, without another reason") {
    const Samples samples;
    for (const auto& names : {std::initializer_list<const char*>{"mesh.off"},
                              {"MESH.STL"},
                              {"m.1.obj", "mesh.off"},
                              {"other.obj", "mesh.off", "MESH.STL"}}) {
        const Opening opened = samples.open(names);
        REQUIRE(std::holds_alternative<MeshesToFit>(opened));
        CHECK(std::get<MeshesToFit>(opened).files == samples.paths(names));
        CHECK(std::get<MeshesToFit>(opened).reason.empty());
    }
}

TEST_CASE("meshes that are no keys together are meshes to fit, and the reason says where they differ") {
    const Samples samples;
    const Opening different = samples.open({"m.1.obj", "other.obj"});
    REQUIRE(std::holds_alternative<MeshesToFit>(different));
    CHECK(contains(std::get<MeshesToFit>(different).reason, "other.obj: line 5: a face of the vertices"));
    const Opening fan = samples.open({"fan.obj", "m.1.obj"});
    REQUIRE(std::holds_alternative<MeshesToFit>(fan));
    CHECK(contains(std::get<MeshesToFit>(fan).reason, "fan.obj: faces, as triangles"));
    put(samples.folder / "far.1.obj", "v 3e38 0 0\nv 3.0001e38 0 0\nv 3e38 1e34 0\nf 1 2 3\n");
    put(samples.folder / "far.2.obj", "v -3e38 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Opening far = samples.open({"far.1.obj", "far.2.obj"});
    REQUIRE(std::holds_alternative<MeshesToFit>(far));
    CHECK(contains(std::get<MeshesToFit>(far).reason, "far.2.obj: vertex 1 (counted from 1): is too far"));
}

TEST_CASE("a broken file among meshes is an error, not a reason to fit") {
    const Samples samples;
    CHECK(contains(samples.error({"m.1.obj", "broken.obj"}), "broken.obj: line 5: vertex 9 does not exist"));
    CHECK(contains(samples.error({"broken.obj", "m.1.obj"}), "broken.obj: line 5: vertex 9 does not exist"));
    CHECK(contains(samples.error({"fan.obj"}), "fan.obj: faces, as triangles"));
}

TEST_CASE("other files and mixtures are errors that say what was expected") {
    const Samples samples;
    CHECK(contains(samples.error({"notes.txt"}),
                   "notes.txt: expected a folder, or a file that ends in .json, .ilh, .obj, .glb or .gltf"));
    CHECK(contains(samples.error({"key.ilh", "notes.txt"}),
                   "notes.txt: expected a file that ends in .ilh, .obj"));
    CHECK(contains(samples.error({"key.ilh", "mesh.off"}),
                   "mesh.off: expected a file that ends in .ilh, .obj, .glb or .gltf"));
    CHECK(contains(samples.error({"key.ilh", "family"}),
                   "family: expected a file that ends in .ilh, .obj, .glb or .gltf"));
    CHECK(contains(samples.error({"nothing.ilh"}), "nothing.ilh: there is no such file"));
}

TEST_CASE("where nothing is fitted, meshes to fit are an error") {
    const Samples samples;
    CHECK(contains(samples.family_error({"mesh.off"}),
                   "mesh.off: expected a folder, or a file that ends in .json, .ilh, .obj, .glb or .gltf"));
    CHECK(contains(samples.family_error({"m.1.obj", "mesh.off"}),
                   "mesh.off: expected a file that ends in .ilh, .obj, .glb or .gltf; `interleaf fit` makes "
                   "keys of other"));
    CHECK(contains(samples.family_error({"m.1.obj", "other.obj"}), "other.obj: line 5: a face of"));
}

TEST_CASE("a folder stands for its keys, or else for its meshes") {
    const Samples samples;
    CHECK(is_family_folder(samples.folder / "family"));
    CHECK(files_in_folder(samples.folder / "family").empty());
    CHECK(files_in_folder(samples.folder.path()) == samples.paths({"key.ilh"}));
    fs::remove(samples.folder / "key.ilh");
    CHECK(files_in_folder(samples.folder.path()).size() == 8);
    CHECK(std::holds_alternative<MeshesToFit>(samples.open({""})));
}
