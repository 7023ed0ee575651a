// Fields in the program: info lists them, render shows or rejects them, export writes them.
#include <algorithm>
#include <memory>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/mesh/mesh_writer.h"
#include "io/mesh/obj_keys.h"

namespace interleaf {
namespace {

using nlohmann::json;

/// A key of the built-in family, with its height and a color as fields.
Hierarchy key_with_fields(const std::string& name) {
    Hierarchy key = read_hierarchy(std::filesystem::path(INTERLEAF_FIVE_KEYS) / (name + ".ilh"));
    Field height{"height", FieldKind::scalar, {}};
    Field color{"color", FieldKind::color, {}};
    for (const glm::vec3& p : key.positions) {
        height.values.push_back(p.y);
        color.values.insert(color.values.end(), {0.5F + 0.25F * p.x, 0.5F, 0.5F - 0.25F * p.z});
    }
    key.fields = {height, color};
    return key;
}

/// Writes a family of sphere and bone. Only the sphere has the fields "plain" and "a\"b".
std::string write_sample(const ScratchFolder& folder) {
    Family family{.name = "fields", .keys = {}, .timeline = {}, .domain = {}};
    Hierarchy sphere = key_with_fields("sphere");
    const Buffer<float> ones(sphere.vertex_count(), 1);
    sphere.fields.push_back({"plain", FieldKind::scalar, ones});
    family.keys = {{"sphere", std::move(sphere)}, {"bone", key_with_fields("bone")}};
    family.timeline.emplace(std::vector<TimelineKey>{{0, 0}, {1, 1}});
    write_family(family, folder / "family");
    return folder / "family";
}

/// Renders a small picture, and returns the bytes of its file.
std::string rendered(std::vector<std::string> choice) {
    choice.insert(choice.begin(), {"render", "-o", "-", "--format", "png", "--size", "160x120"});
    const Outcome outcome = run_interleaf(choice);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    return outcome.output;
}

TEST_CASE("info lists fields with the range over all keys, and each key's own") {
    const ScratchFolder folder;
    const std::string family = write_sample(folder);
    const Outcome text = run_interleaf({"info", family});
    REQUIRE_MESSAGE(text.status == 0, text.errors);
    CHECK(contains(text.output, "\nfields\n"));
    CHECK(contains(text.output, "height  -"));
    CHECK(contains(text.output, "color         color\n"));
    CHECK(contains(text.output, "plain  1 to 1\n"));

    const json figures = json::parse(run_interleaf({"info", family, "--json"}).output);
    REQUIRE(figures.at("fields").size() == 3);
    CHECK(figures["fields"][0]["name"] == "height");
    CHECK(figures["fields"][0]["kind"] == "scalar");
    CHECK(figures["fields"][1]["kind"] == "color");
    CHECK(figures["keys"][1]["fields"].size() == 2);
    float least = 0;
    for (const json& key : figures["keys"]) least = std::min(least, key["fields"][0]["min"].get<float>());
    CHECK(figures["fields"][0]["min"].get<float>() == least);
    CHECK(json::parse(run_interleaf({"info", INTERLEAF_FIVE_KEYS, "--json"}).output)["fields"].empty());
    CHECK_FALSE(contains(run_interleaf({"info", INTERLEAF_FIVE_KEYS}).output, "fields"));
}

TEST_CASE("every way to color by a field gives another picture") {
    const ScratchFolder folder;
    const std::string family = write_sample(folder);
    const std::vector<std::vector<std::string>> choices = {{},
                                                           {"--color", "checker"},
                                                           {"--color", "height"},
                                                           {"--color", "color"},
                                                           {"--color", "field:plain"},
                                                           {"--color", "height", "--color-map", "magma"},
                                                           {"--color", "height", "--color-map", "coolwarm"},
                                                           {"--color", "height", "--range", "-0.1,0.2"}};
    std::vector<std::string> pictures;
    for (std::vector<std::string> choice : choices) {
        choice.insert(choice.begin(), {family, "--weights", "sphere=1"});
        pictures.push_back(rendered(choice));
    }
    std::ranges::sort(pictures);
    CHECK(std::ranges::adjacent_find(pictures) == pictures.end());
    CHECK(rendered({family, "--weights", "sphere=1", "--color", "plain"}) ==
          rendered({family, "--weights", "sphere=1"}));
    CHECK(rendered({family, "--time", "0.5", "--color", "field:height"}) ==
          rendered({family, "--time", "0.5", "--color", "height"}));
}

TEST_CASE("a field that does not exist is refused, and the message names the existing fields") {
    const ScratchFolder folder;
    const std::string family = write_sample(folder);
    const auto error_of = [&](std::vector<std::string> choice) {
        choice.insert(choice.begin(), {"render", "-o", folder / "a.png"});
        const Outcome outcome = run_interleaf(choice);
        CHECK(outcome.status == 2);
        CHECK(is_one_message(outcome.errors));
        return outcome.errors;
    };
    CHECK(contains(error_of({family, "--color", "heigth"}),
                   "--color: no field is called 'heigth'; there are height, color, plain"));
    CHECK(contains(error_of({INTERLEAF_FIVE_KEYS, "--color", "heigth"}),
                   "--color: expected plain, level, origin, common, checker, angle, curvature or moved, got "
                   "'heigth'; the keys have no fields"));
    CHECK(contains(error_of({family, "--time", "0.5", "--color", "field:plain"}),
                   "--color: key 'bone' has no field 'plain'"));
    CHECK(contains(error_of({family, "--color", "height", "--color-map", "jet"}),
                   "--color-map: expected viridis, magma or coolwarm, got 'jet'"));
    for (const std::string range : {"1", "1,2,3", "2,1", "1,1", "a,b", "0,1e39", "nan,1"}) {
        CAPTURE(range);
        CHECK(
            contains(error_of({family, "--color", "height", "--range", range}), "--range: expected MIN,MAX"));
    }
    error_of({family, "--range", "0,1"});
    CHECK(run_interleaf({"view", family, "--color", "heigth"}).status == 2);
}

TEST_CASE("exports carry the fields that the active keys share") {
    const ScratchFolder folder;
    const std::string family = write_sample(folder);
    for (const std::string name : {"u.obj", "u.ply", "u.ilh"})
        REQUIRE(run_interleaf({"export", family, "--time", "0.3", "-o", folder / name}).status == 0);
    REQUIRE(run_interleaf({"export", family, "--time", "0.3", "--compress", "-o", folder / "c.ilh"}).status ==
            0);

    const Hierarchy key = read_hierarchy(folder / "u.ilh");
    REQUIRE(key.fields.size() == 2);
    CHECK(key.fields[0].label() == FieldName{"height", FieldKind::scalar});
    for (std::size_t v = 0; v < key.vertex_count(); ++v)
        REQUIRE(key.fields[0].values[v] == key.positions[v].y);
    CHECK(read_hierarchy(folder / "c.ilh").fields[1].values == key.fields[1].values);

    const Hierarchy mesh = read_obj(folder / "u.obj");
    REQUIRE(mesh.fields.size() == 1);
    CHECK(mesh.fields[0].values.size() == key.fields[1].values.size());
    CHECK(contains(content(folder / "u.ply"),
                   "property float z\nproperty float height\nproperty uchar red\nproperty uchar green\n"
                   "property uchar blue\nelement face"));

    REQUIRE(run_interleaf({"export", family, "--weights", "sphere=1", "-o", folder / "s.ilh"}).status == 0);
    CHECK(read_hierarchy(folder / "s.ilh").fields.size() == 3);
}

TEST_CASE("render shows the colors of an OBJ") {
    const ScratchFolder folder;
    const Hierarchy key = key_with_fields("icosahedron");
    const std::string text = obj_text(key.roots.triangles(), key.positions, key.fields);
    put(folder / "m.obj", text);
    CHECK_FALSE(rendered({folder / "m.obj", "--color", "color"}) == rendered({folder / "m.obj"}));
}

}  // namespace
}  // namespace interleaf
