// glTF files as families, keys and meshes: what the program wrote, what others write, and hostile files.
#include "io/gltf/gltf_reader.h"

#include <algorithm>
#include <random>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "io/gltf/glb_export.h"
#include "io/gltf/gltf_text.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/read_files.h"
#include "io/samples.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// A square of two triangles whose four corners are six vertices, as at the seam of a texture.
const std::vector<glm::vec3> split_square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<glm::vec3> up(6, glm::vec3(0, 0, 1));

SquareText split() {
    return {.positions = split_square, .deltas = {up, std::vector<glm::vec3>(6, glm::vec3(0))}};
}

Family read_text_as_family(const std::string& text, std::vector<std::string>* changes = nullptr) {
    const ScratchFolder folder(memory_folder());
    put(folder / "a.gltf", text);
    return read_gltf_family(folder / "a.gltf", changes);
}

std::string error_of(const std::string& text) {
    return input_error_of([&] { read_text_as_family(text); });
}

}  // namespace

TEST_CASE("an exported family comes back: names, order, timeline, domain, fields and the union's positions") {
    std::mt19937 random(21);
    Family family = sample_family(random);
    for (Key& key : family.keys) {
        Hierarchy hierarchy = *key.hierarchy;
        hierarchy.fields = {{"Größe", FieldKind::scalar, Buffer<float>(hierarchy.vertex_count(), 2)},
                            {"color", FieldKind::color, Buffer<float>(3 * hierarchy.vertex_count(), 0.5F)}};
        key.hierarchy = std::move(hierarchy);
    }
    family.timeline = Timeline({{0, 2}, {1, 0}, {2.5, 1}}, {Basis::spline});
    family.origin = {500'000, 5'400'000, 0};
    const ScratchFolder folder;
    export_glb({family, std::nullopt, {}}, {folder / "a.glb"});
    std::vector<std::string> changes;
    const Family read = read_gltf_family(folder / "a.glb", &changes);
    CHECK(read.name == family.name);
    CHECK(read.timeline == family.timeline);
    CHECK(read.domain == family.domain);
    CHECK(read.origin == family.origin);
    REQUIRE(read.keys.size() == 3);
    const UnionMesh whole = unite(family, {{0, 0}, {1, 0}, {2, 0}});
    for (std::size_t key = 0; key < 3; ++key) {
        CHECK(read.keys[key].name == family.keys[key].name);
        const Hierarchy& hierarchy = *read.keys[key].hierarchy;
        CHECK(check(hierarchy).empty());
        CHECK(std::ranges::equal(hierarchy.roots.triangles(), whole.triangles));
        float farthest = 0;
        for (std::size_t v = 0; v < whole.vertex_count(); ++v)
            farthest = std::max(farthest, glm::distance(hierarchy.positions[v], whole.positions[key][v]));
        CHECK(farthest < 1e-6);
        const Field* const scalar = find_field(hierarchy.fields, {"Größe", FieldKind::scalar});
        REQUIRE(scalar != nullptr);
        CHECK(scalar->values[0] == 2);
        const Field* const color = find_field(hierarchy.fields, {"color", FieldKind::color});
        REQUIRE(color != nullptr);
        CHECK(color->values[0] == doctest::Approx(0.5).epsilon(1e-6));
    }
}

TEST_CASE("a file of segments comes back whole: hierarchies to the last bit, timeline, fields and origin") {
    std::mt19937 random(22);
    Family family = sample_family(random);
    for (Key& key : family.keys) {
        Hierarchy hierarchy = *key.hierarchy;
        hierarchy.fields = {{"heat", FieldKind::scalar, Buffer<float>(hierarchy.vertex_count(), 2)}};
        key.hierarchy = std::move(hierarchy);
    }
    family.timeline = Timeline({{0, 2}, {1, 0}, {2.5, 0}, {3, 1}});
    family.origin = {500'000, 5'400'000, 0};
    const ScratchFolder folder;
    export_glb({.family = family, .weights = std::nullopt, .form = {}, .segments = true}, {folder / "a.glb"});
    std::vector<std::string> changes;
    const Family read = read_gltf_family(folder / "a.glb", &changes);
    CHECK_FALSE(mentions(changes, "only the first"));
    CHECK(read.name == family.name);
    CHECK(read.timeline == family.timeline);
    CHECK(read.domain == family.domain);
    CHECK(read.origin == family.origin);
    REQUIRE(read.keys.size() == family.keys.size());
    for (std::size_t key = 0; key < read.keys.size(); ++key) {
        CHECK(read.keys[key].name == family.keys[key].name);
        CHECK(serialize_hierarchy(*read.keys[key].hierarchy) ==
              serialize_hierarchy(*family.keys[key].hierarchy));
    }
}

TEST_CASE(
    "offsets and units come back from a file of one key, and later files are brought to those of the first") {
    std::mt19937 random(24);
    const Family sample = sample_family(random);
    const ScratchFolder folder;
    const auto write = [&](const char* file, double offset, float value) {
        Family family;
        family.name = "one";
        Hierarchy hierarchy = *sample.keys.front().hierarchy;
        hierarchy.fields = {{"heat", FieldKind::scalar, Buffer<float>(hierarchy.vertex_count(), value)}};
        family.keys.push_back({"one", std::move(hierarchy)});
        family.field_scales = {{.field = "heat", .offset = offset, .unit = "K"}};
        export_glb({family, std::nullopt, {}}, {folder / file});
    };
    write("a.glb", 300, 0.5F);
    write("b.glb", 310, 0.25F);
    const auto value_in = [](const Key& key) {
        return find_field(key.hierarchy->fields, {"heat", FieldKind::scalar})->values[0];
    };
    const std::vector<FieldScale> scales{{.field = "heat", .offset = 300, .unit = "K"}};
    const Family one = read_gltf_family(folder / "a.glb");
    CHECK(one.field_scales == scales);
    CHECK(value_in(one.keys.front()) == 0.5F);

    const std::vector<fs::path> files{folder / "a.glb", folder / "b.glb"};
    const Family both = read_keys(files);
    CHECK(both.field_scales == scales);
    REQUIRE(both.keys.size() == 2);
    CHECK(value_in(both.keys[0]) == 0.5F);
    CHECK(value_in(both.keys[1]) == 10.25F);

    write_hierarchy(*one.keys.front().hierarchy, folder / "c.ilh");
    const std::vector<fs::path> mixed{folder / "a.glb", folder / "c.ilh"};
    const Family mixture = read_keys(mixed);
    CHECK(mixture.field_scales == scales);
    CHECK(value_in(mixture.keys[1]) == -299.5F);
}

TEST_CASE("damaged keys of a file of segments are an error that names the place") {
    std::mt19937 random(23);
    Family family = sample_family(random);
    family.timeline = Timeline({{0, 2}, {1, 0}});
    const ScratchFolder folder;
    export_glb({.family = family, .weights = std::nullopt, .form = {}, .segments = true}, {folder / "a.glb"});
    const std::string bytes = content(folder / "a.glb");
    const auto error_with = [&](std::string_view text) {
        std::string damaged = bytes;
        constexpr std::string_view mark = "\"hierarchy\":\"";
        damaged.replace(damaged.find(mark) + mark.size(), text.size(), text);
        put(folder / "b.glb", damaged);
        return input_error_of([&] { read_gltf_family(folder / "b.glb"); });
    };
    CHECK(contains(error_with("*"), "b.glb: scenes[0].extras.interleaf.keys[0].hierarchy"));
    CHECK(contains(error_with("*"), "expected base64"));
    CHECK(contains(error_with("AAAA"), "keys[0].hierarchy: the key: "));
    // Another program may have changed the meshes, so the first segment counts.
    std::string foreign = bytes;
    foreign.replace(foreign.find("Interleaf"), 9, "Blunderer");
    put(folder / "c.glb", foreign);
    CHECK(read_gltf_family(folder / "c.glb").keys.size() == 2);
}

TEST_CASE("extras that do not fit are a remark, and the keys are read all the same") {
    SquareText square = split();
    square.extras = R"({"targetNames":["a","b"],"interleaf":{"version":2,"base":"x","keys":[{"name":"y"}]}})";
    std::vector<std::string> changes;
    const Family read = read_text_as_family(square.text(), &changes);
    CHECK(read.keys.size() == 3);
    CHECK(read.keys[1].name == "a");
    CHECK(mentions(changes, "expected the name of a target or of the base"));
}

TEST_CASE("an animation that shows one key at each time is the timeline; any other is a remark") {
    const auto read = [](const std::vector<float>& weights, const std::string& interpolation,
                         std::vector<std::string>& changes) {
        SquareText square = split();
        square.scalars = {{0.5F, 1, 3}, weights};
        square.rest = R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],)"
                      R"("samplers":[{"input":3,"output":4)" +
                      interpolation + "}]}]";
        return read_text_as_family(square.text(), &changes);
    };
    std::vector<std::string> changes;
    const Family linear = read({0, 0, 0, 1, 1, 0}, "", changes);
    CHECK(linear.timeline == Timeline({{0.5, 0}, {1, 2}, {3, 1}}));
    const Family stepped = read({0, 0, 0, 1, 1, 0}, R"(,"interpolation":"STEP")", changes);
    CHECK(stepped.timeline == Timeline({{0.5, 0}, {1, 2}, {3, 1}}, {Basis::hold}));
    CHECK_FALSE(mentions(changes, "animation"));

    const Family blended = read({0, 0, 0.5F, 0.5F, 1, 0}, "", changes);
    CHECK(mentions(changes, "passed over: it blends targets at its times"));
    CHECK(blended.timeline->keys().size() == 3);
    read({0, 0, 0, 1, 1, 0}, R"(,"interpolation":"CUBICSPLINE")", changes);
    CHECK(mentions(changes, "neither LINEAR nor STEP"));
    CHECK(contains(input_error_of([&] {
                       read({0, 0, 0, 1}, "", changes);
                   }),
                   "animations[0].samplers[0]: has 3 times and 4 weights, expected 2 weights per time"));
}

TEST_CASE("vertices are welded where the base and all targets agree") {
    const Family read = read_text_as_family(split().text());
    REQUIRE(read.keys.size() == 3);
    CHECK(read.keys[0].name == "base");
    CHECK(read.keys[2].name == "target 2");
    CHECK(read.keys[0].hierarchy->vertex_count() == 4);
    CHECK(read.keys[1].hierarchy->positions[0] == glm::vec3(0, 0, 1));

    SquareText torn = split();
    torn.deltas[0][3].z = 2;  // two vertices of a corner part, so that the triangles would share one vertex
    std::vector<std::string> changes;
    CHECK(read_text_as_family(torn.text(), &changes).keys[0].hierarchy->vertex_count() == 6);
    CHECK(mentions(changes, "Welded vertices would make no manifold"));
}

TEST_CASE("nodes place a mesh, and a mirror keeps the outside outside") {
    SquareText square = split();
    square.node = R"(,"translation":[10,0,0],"scale":[-2,1,1])";
    const Hierarchy key = *read_text_as_family(square.text()).keys[0].hierarchy;
    CHECK(std::ranges::count(key.positions, glm::vec3(8, 0, 0)) == 1);
    for (const auto& [a, b, c] : key.roots.triangles())
        CHECK(glm::cross(key.positions[b] - key.positions[a], key.positions[c] - key.positions[a]).z > 0);
    square.node = R"(,"scale":[1e300,1e300,1])";
    CHECK(contains(error_of(square.text()), "is put beyond the range of floats by its node"));
    square.node = R"(,"children":[0])";
    CHECK(contains(error_of(square.text()), "nodes[0]: has two parents"));
}

TEST_CASE("a mesh without area is a key, unwelded") {
    const SquareText point{.positions = std::vector<glm::vec3>(6, glm::vec3(1)), .deltas = {}};
    CHECK(read_text_as_family(point.text()).keys[0].hierarchy->vertex_count() == 6);
}

TEST_CASE("sparse targets, normalized integers and interleaved vertices are read") {
    const Family sparse = read_text_as_family(sparse_square());
    CHECK(sparse.keys[1].hierarchy->positions[2] == glm::vec3(1, 1, 5));
    const Family packed = read_text_as_family(packed_square());
    CHECK(packed.keys[0].hierarchy->positions[2].x == doctest::Approx(1));
    CHECK(packed.keys[0].hierarchy->positions[1].y == 0);
}

TEST_CASE("buffers are files of the same folder and of no other") {
    const ScratchFolder folder;
    const SquareText square = split();
    fs::create_directory(folder / "in");
    put(folder / "in/a b.bin", square.bytes());
    put(folder / "out.bin", square.bytes());
    fs::create_symlink(folder / "out.bin", folder / "in/link.bin");
    const auto error = [&](const std::string& uri) {
        put(folder / "in/a.gltf", square.text(uri));
        return input_error_of([&] { read_gltf_family(folder / "in/a.gltf"); });
    };
    CHECK(error("a%20b.bin").empty());
    CHECK(contains(error("../out.bin"), "expected the name of a file in the same folder"));
    CHECK(contains(error("%2e%2e%2fout.bin"), "expected the name of a file in the same folder"));
    CHECK(contains(error("/etc/hostname"), "expected the name of a file in the same folder"));
    CHECK(contains(error("https://example.org/a.bin"), "expected the name of a file in the same folder"));
    CHECK(contains(error("link.bin"), "a link that leads out of the folder"));
    CHECK(contains(error("none.bin"), "buffers[0].uri: is \"none.bin\""));
    CHECK(contains(error("a%2"), "a % without two hexadecimal digits"));
}

TEST_CASE("a mesh without targets is a key, and a mesh to fit") {
    const ScratchFolder folder;
    put(folder / "a.gltf", SquareText{.positions = split_square, .deltas = {}}.text());
    const Family read = read_gltf_family(folder / "a.gltf");
    REQUIRE(read.keys.size() == 1);
    CHECK(read.keys[0].name == "a");
    CHECK_FALSE(read.timeline);
    const SurfaceFile surface = read_surface(folder / "a.gltf");
    CHECK(surface.positions.size() == 6);
    CHECK(surface.triangles.size() == 2);
}

TEST_CASE("several files give all their keys, under unique names") {
    const ScratchFolder folder;
    put(folder / "a.gltf", split().text());
    put(folder / "b.gltf", split().text());
    const std::vector<fs::path> files{folder / "a.gltf", folder / "b.gltf"};
    const Family read = read_keys(files);
    CHECK(read.keys.size() == 6);
    CHECK(check(read).empty());
}

TEST_CASE("skins, cameras and further meshes are passed over with a word") {
    SquareText square = split();
    square.rest = R"(,"skins":[{}],"cameras":[{}])";
    std::vector<std::string> changes;
    read_text_as_family(square.text(), &changes);
    CHECK(mentions(changes, "a.gltf: Skins were passed over."));
    CHECK(mentions(changes, "a.gltf: Cameras were passed over."));
}

TEST_CASE("faults are named with their place") {
    const std::string good = split().text();
    const auto with = [&](std::string_view from, std::string_view to) {
        std::string text = good;
        const std::size_t place = text.find(from);
        REQUIRE(place != std::string::npos);
        return error_of(text.replace(place, from.size(), to));
    };
    CHECK(contains(with("\"2.0\"", "\"1.0\""), "asset.version: is \"1.0\", expected a version 2"));
    CHECK(contains(with("\"count\":6", "\"count\":7"), "accessors[0]: needs 84 bytes of a buffer view"));
    CHECK(contains(with("\"count\":6", "\"count\":-1"), "accessors[0].count: is -1"));
    CHECK(contains(with("\"VEC3\"", "\"VEC2\""), "is 0, expected the number of an accessor of type VEC3"));
    CHECK(contains(with("5126", "5130"), "accessors[0].componentType"));
    CHECK(contains(with("\"byteLength\":", "\"byteLength\":9"), "bufferViews[0]: ends at byte"));
    CHECK(contains(with("\"POSITION\":0", "\"POSITION\":99"), "accessors: has"));
    CHECK(contains(with("\"mesh\":0", "\"mesh\":1"), "nodes[0].mesh: is 1"));
    CHECK(contains(with("\"asset\"", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"asset\""),
                   "extensionsRequired[0]"));
    CHECK(contains(error_of("{}"), "has no \"asset\""));
    CHECK(contains(error_of(""), "a.gltf"));
}

TEST_CASE("accessors that ask for more than the file can have are refused before memory is taken") {
    const std::string good = split().text();
    std::string text = good;
    const std::string view = "\"bufferView\":0,";
    text.erase(text.find(view), view.size());
    text.replace(text.find("\"count\":6"), 9, "\"count\":4000000000");
    CHECK(contains(error_of(text), "takes more numbers than a file of this size can have"));
}

TEST_CASE("random damage gives an error that names the file, or sound keys") {
    const ScratchFolder folder(memory_folder());
    std::mt19937 sample(4);
    Family family = sample_family(sample);
    family.timeline = Timeline({{0, 0}, {1, 1}, {2, 2}});
    export_glb({family, std::nullopt, {}}, {folder / "whole.glb"});
    const std::string whole = content(folder / "whole.glb");
    int sound = 0;
    for (unsigned seed = 0; seed < trials(600); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::string bytes = whole;
        for (auto changes = 1 + random() % 4; changes > 0; --changes)
            bytes[random() % (seed % 2 == 0 ? bytes.size() : 2500)] = static_cast<char>(random());
        if (seed % 5 == 0) bytes.resize(random() % bytes.size());
        put(folder / "a.glb", bytes);
        const std::string error = input_error_of([&] {
            const Family read = read_gltf_family(folder / "a.glb");
            CHECK(check(read).empty());
            for (const Key& key : read.keys) CHECK(check(*key.hierarchy).empty());
            ++sound;
        });
        if (!error.empty()) CHECK(error.starts_with((folder / "a.glb").string() + ": "));
    }
    CHECK(sound > 10);
}

}  // namespace interleaf
