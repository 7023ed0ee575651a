#include "io/family/family_file.h"

#include <algorithm>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "io/hierarchy/hierarchy_file.h"
#include "io/mesh/mesh_writer.h"
#include "io/read_files.h"
#include "io/samples.h"

namespace interleaf {

namespace fs = std::filesystem;

namespace {

void check_same(const Family& a, const Family& b) {
    CHECK(a.name == b.name);
    REQUIRE(a.keys.size() == b.keys.size());
    for (std::size_t i = 0; i < a.keys.size(); ++i) {
        CAPTURE(i);
        CHECK(a.keys[i].name == b.keys[i].name);
        CHECK(is_same(*a.keys[i].hierarchy, *b.keys[i].hierarchy));
    }
    CHECK(a.timeline == b.timeline);
    CHECK(a.domain == b.domain);
    CHECK(a.path == b.path);
    CHECK(a.time_source == b.time_source);
    CHECK(a.origin == b.origin);
    CHECK(a.field_scales == b.field_scales);
    CHECK(a.time_unit == b.time_unit);
}

/// A family file in \p folder, beside the keys a.ilh and b.ilh over one root complex, and other.ilh over
/// another.
class KeyFolder {
  public:
    KeyFolder() {
        std::mt19937 random(1);
        write_hierarchy(random_hierarchy(random, false, 3), folder_ / "a.ilh");
        write_hierarchy(random_hierarchy(random, false, 9), folder_ / "b.ilh");
        write_hierarchy(random_hierarchy(random, true, 0), folder_ / "other.ilh");
    }
    fs::path operator/(std::string_view name) const { return folder_ / name; }
    std::string error_of(std::string_view json) const {
        put(folder_ / "family.json", json);
        return input_error_of([&] { read_family(folder_ / "family.json"); });
    }
    Family family(std::string_view json) const {
        put(folder_ / "family.json", json);
        return read_family(folder_.path());
    }

  private:
    ScratchFolder folder_;
};

/// A family file with the given list of keys and additional members.
std::string with_keys(std::string_view keys, std::string_view members = "") {
    return std::string(R"({"format": "interleaf-family", "version": 1, "name": "f", "keys": )")
        .append(keys)
        .append(members)
        .append("}");
}

std::string with_file(std::string_view file) {
    return with_keys(std::string(R"([{"name": "a", "file": ")").append(file).append("\"}]"));
}

std::string with_members(std::string_view members) {
    return with_keys(R"([{"name": "a", "file": "a.ilh"}, {"name": "b", "file": "b.ilh"}])",
                     std::string(", ").append(members));
}

/// \param interpolation  the text of the member, perhaps followed by others
std::string with_interpolation(int version, std::string_view interpolation) {
    std::string json = with_members(std::string(R"("timeline": {"interpolation": )")
                                        .append(interpolation)
                                        .append(R"(, "keys": [{"time": 0, "key": "a"}]})"));
    return json.replace(json.find("\"version\": 1"), 12, "\"version\": " + std::to_string(version));
}

std::string with_origin(std::string_view origin) {
    std::string json = with_members(std::string(R"("origin": )").append(origin));
    json.replace(json.find("1,"), 1, "2");
    return json;
}

std::string with_timeline(std::string_view keys) {
    return with_members(
        std::string(R"("timeline": {"interpolation": "linear", "keys": )").append(keys).append("}"));
}

std::string with_domain(std::string_view triangles) {
    return with_members(
        std::string(R"("domain": {"vertices": [{"at": [0, 0], "key": "a"}, )"
                    R"({"at": [1, 0], "key": "b"}, {"at": [0, 1], "key": "a"}], "triangles": )")
            .append(triangles)
            .append("}"));
}

/// \param members  further members of a domain of one triangle
std::string with_path(int version, std::string_view members) {
    std::string json = with_domain(std::string("[[0, 1, 2]], ").append(members));
    return json.replace(json.find("\"version\": 1"), 12, "\"version\": " + std::to_string(version));
}

}  // namespace

TEST_CASE("a family file holds what was written") {
    for (unsigned seed = 0; seed < 10; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const ScratchFolder folder;
        Family family = sample_family(random);
        if (seed % 2 == 1) family.timeline.reset();
        if (seed % 3 == 1) family.domain.reset();
        if (seed % 4 > 1) family.origin = {static_cast<double>(random() % 10'000'000), -0.5, 1e300};
        write_family(family, folder / "new/fämily");
        check_same(read_family(folder / "new/fämily"), family);
        check_same(read_family(folder / "new/fämily/family.json"), family);
    }
}

TEST_CASE("every interpolation is written and read again, in version 2 where version 1 does not know it") {
    const ScratchFolder folder;
    std::mt19937 random(3);
    Family family = sample_family(random);
    for (const Basis basis : bases())
        for (const std::size_t degree : {0U, 3U}) {
            if (degree > 0 && basis != Basis::bernstein) continue;
            family.timeline = Timeline({{0, 0}, {1, 0}}, {.basis = basis, .degree = degree});
            write_family(family, folder / "f");
            CHECK(read_family(folder / "f").timeline == family.timeline);
            CHECK(contains(content(folder / "f/family.json"),
                           basis == Basis::linear ? "\"version\": 1," : "\"version\": 2,"));
        }
}

TEST_CASE("a path and whether it drives are written and read again, in version 2") {
    for (unsigned seed = 0; seed < 6; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> coordinate(-1e3, 1e3);
        const ScratchFolder folder;
        Family family = sample_family(random);
        REQUIRE(family.domain);
        std::vector<PathPoint> points{{-1.0 / 3, {coordinate(random), coordinate(random)}}};
        for (unsigned i = 0; i < 10 * seed; ++i)
            points.push_back({points.back().time + 0.1, {coordinate(random), coordinate(random)}});
        family.path = DomainPath(std::move(points));
        if (seed % 2 == 1) family.time_source = TimeSource::path;
        if (seed % 3 == 1) family.timeline.reset();
        write_family(family, folder / "f");
        check_same(read_family(folder / "f"), family);
        const std::string text = content(folder / "f/family.json");
        CHECK(contains(text, "\"version\": 2,"));
        CHECK(contains(text, "\"path_drives\": true") == (seed % 2 == 1));
    }
}

TEST_CASE("a family whose parts turn is written and read again, in version 2") {
    std::mt19937 random(1);
    const ScratchFolder folder;
    Family family = sample_family(random);
    family.blend = BlendKind::turning;
    write_family(family, folder / "f");
    CHECK(read_family(folder / "f").blend == BlendKind::turning);
    const std::string text = content(folder / "f/family.json");
    CHECK(contains(text, "\"version\": 2,"));
    CHECK(contains(text, "\"blend\": \"turning\""));
    family.blend = BlendKind::straight;
    write_family(family, folder / "g");
    CHECK(read_family(folder / "g").blend == BlendKind::straight);
    CHECK_FALSE(contains(content(folder / "g/family.json"), "blend"));
}

TEST_CASE("a timeline of steps is written and read again, in version 2") {
    std::mt19937 random(1);
    const ScratchFolder folder;
    Family family = sample_family(random);
    REQUIRE(family.timeline);
    family.timeline = family.timeline->with_unit(TimeUnit::steps);
    write_family(family, folder / "f");
    check_same(read_family(folder / "f"), family);
    CHECK(contains(content(folder / "f/family.json"), "\"version\": 2,"));
    CHECK(contains(content(folder / "f/family.json"), "\"unit\": \"steps\""));
}

TEST_CASE("a path is read from version 2 on") {
    const KeyFolder keys;
    const std::string_view path = R"("path": [{"time": 0, "at": [0, 0]}, {"time": 1.5, "at": [0.5, 2]}])";
    const Family family = keys.family(with_path(2, path));
    CHECK(family.path == DomainPath({{0, {0, 0}}, {1.5, {0.5, 2}}}));
    CHECK(family.time_source == TimeSource::keys);
    const std::string driving = std::string(path) + R"(, "path_drives": true)";
    CHECK(keys.family(with_path(2, driving)).time_source == TimeSource::path);
    CHECK(keys.family(with_path(2, R"("path_drives": false)")).time_source == TimeSource::keys);
    const Family old = keys.family(with_path(1, driving));
    CHECK_FALSE(old.path);
    CHECK(old.time_source == TimeSource::keys);
}

TEST_CASE("a path of the largest number of points is written and read again") {
    std::mt19937 random(1);
    const ScratchFolder folder;
    Family family = sample_family(random);
    std::vector<PathPoint> points;
    for (std::size_t i = 0; i < DomainPath::max_points; ++i)
        points.push_back({static_cast<double>(i) / 60, {0.1 / static_cast<double>(i + 1), 1.0 / 3}});
    family.path = DomainPath(std::move(points));
    write_family(family, folder / "f");
    CHECK(read_family(folder / "f").path == family.path);
}

TEST_CASE("an origin is read from version 2 on, and no version 2 is written for the origin 0") {
    std::mt19937 random(1);
    const ScratchFolder folder;
    Family family = sample_family(random);
    write_family(family, folder / "f");
    CHECK(contains(content(folder / "f/family.json"), "\"version\": 1,"));
    CHECK_FALSE(contains(content(folder / "f/family.json"), "origin"));
    family.origin = {500'000, 5'400'000, -0.25};
    write_family(family, folder / "f");
    CHECK(contains(content(folder / "f/family.json"), "\"version\": 2,"));
    CHECK(contains(content(folder / "f/family.json"), "\"origin\": [500000.0,5400000.0,-0.25]"));

    const KeyFolder keys;
    CHECK(keys.family(with_origin("[1, -2.5, 3e6]")).origin == glm::dvec3(1, -2.5, 3e6));
    CHECK(keys.family(with_members(R"("origin": [1, 2, 3])")).origin == glm::dvec3(0));
}

TEST_CASE("offsets and units are written and read again, from version 2 on") {
    const KeyFolder keys;
    const ScratchFolder folder;
    Family family = keys.family(with_timeline(R"([{"time": 0, "key": "a"}])"));
    write_family(family, folder / "f");
    CHECK_FALSE(contains(content(folder / "f/family.json"), "scales"));
    family.time_unit = "ms";
    family.field_scales = {{"T", 300.1, "K"}, {"p", -2e9, ""}, {"v \"x\"", 0, "m/s²"}};
    write_family(family, folder / "f");
    CHECK(contains(content(folder / "f/family.json"), "\"version\": 2"));
    CHECK(contains(content(folder / "f/family.json"), R"({"field":"T","offset":300.1,"unit":"K"})"));
    check_same(read_family(folder / "f"), family);
    family.field_scales.clear();
    write_family(family, folder / "f");
    CHECK(contains(content(folder / "f/family.json"), "\"version\": 2"));
    CHECK(read_family(folder / "f").time_unit == "ms");

    CHECK(keys.family(with_members(R"("scales": [{"field": "T", "offset": 1}])")).field_scales.empty());
    const auto error = [&](std::string_view scales) {
        std::string json = with_members(std::string(R"("scales": )").append(scales));
        return keys.error_of(json.replace(json.find("1,"), 1, "2"));
    };
    CHECK(error(R"([{"field": "T", "offset": 1}])").empty());
    CHECK(contains(error(R"([{"offset": 1}])"), "scales[0]"));
    CHECK(contains(error(R"([{"field": ""}])"), "scales[0].field: is \"\", expected the name of a field"));
    CHECK(contains(error(R"([{"field": "T"}, {"field": "T"}])"), "expected a field that no other scale has"));
    CHECK(contains(error(R"([{"field": "T", "unit": "a\nb"}])"), "scales[0].unit"));
    CHECK(contains(error(R"([{"field": "T", "offset": "1"}])"), "scales[0].offset"));
    CHECK(contains(error("7"), "scales"));
}

TEST_CASE("landmarks are written and read to the last bit, from version 2 on, and faults are named") {
    std::mt19937 random(1);
    const ScratchFolder folder;
    Family family = sample_family(random);
    family.landmarks = {{"nose", glm::normalize(glm::dvec3(1, 2, 3))}, {"tail é", {0, 0, -1}}};
    write_family(family, folder / "f");
    CHECK(contains(content(folder / "f/family.json"), "\"version\": 2,"));
    CHECK(read_family(folder / "f").landmarks == family.landmarks);

    const KeyFolder keys;
    const auto with_landmarks = [](int version, std::string_view landmarks) {
        std::string text = with_members(fmt::format(R"("landmarks": [{}])", landmarks));
        return text.replace(text.find("\"version\": 1"), 12, fmt::format("\"version\": {}", version));
    };
    const std::string nose = R"({"name": "nose", "direction": [0, 1, 0]})";
    CHECK(keys.family(with_landmarks(2, nose)).landmarks.size() == 1);
    CHECK(keys.family(with_landmarks(1, nose)).landmarks.empty());
    const auto fault = [&](const std::string& landmarks) {
        return input_error_of([&] { keys.family(with_landmarks(2, landmarks)); });
    };
    CHECK(contains(fault(nose + "," + nose), "landmarks[1].name: is \"nose\""));
    CHECK(contains(fault(R"({"name": "", "direction": [0, 1, 0]})"), "landmarks[0].name: is \"\""));
    CHECK(contains(fault(R"({"name": "a", "direction": [0, 1, 1]})"), "landmarks[0].direction: "));

    family.landmarks.push_back({"nose", {1, 1, 0}});
    const std::string refused = input_error_of([&] { write_family(family, folder / "g"); });
    CHECK(contains(refused, "two landmarks are called \"nose\""));
    CHECK(contains(refused, "landmark 2 is not a unit vector"));
}

TEST_CASE("key files have the names of their keys, and nothing is written outside the folder") {
    std::mt19937 random(1);
    const ScratchFolder folder;
    write_family(sample_family(random), folder / "f");
    CHECK(folder.entry_count() == 1);
    CHECK(fs::exists(folder / "f/Würfel.ilh"));
    CHECK(fs::exists(folder / "f/---a-b.ilh"));
    CHECK(fs::exists(folder / "f/..-a-b.ilh") == false);

    Family long_names;
    long_names.keys.push_back(
        {std::string(99, 'x') + "ä" + std::string(300, 'y'), random_hierarchy(random, false, 0)});
    long_names.keys.push_back(
        {std::string(99, 'x') + "ö" + std::string(300, 'y'), random_hierarchy(random, false, 1)});
    write_family(long_names, folder / "long");
    CHECK(fs::exists(folder / ("long/" + std::string(99, 'x') + ".ilh")));
    CHECK(fs::exists(folder / ("long/" + std::string(99, 'x') + "-2.ilh")));
    check_same(read_family(folder / "long"), long_names);
}

TEST_CASE("writing over a family leaves only the files of the new family and files of others") {
    std::mt19937 random(2);
    const ScratchFolder folder;
    Family family = sample_family(random);
    write_family(family, folder.path());
    put(folder / "notes.ilh", "not ours");
    const std::size_t count = folder.entry_count();

    write_family(family, folder.path());
    CHECK(folder.entry_count() == count);
    CHECK(fs::exists(folder / "Würfel.ilh"));

    family.keys[0].hierarchy = random_hierarchy(random, false, 30);
    write_family(family, folder.path());
    CHECK(folder.entry_count() == count);
    CHECK(fs::exists(folder / "Würfel-2.ilh"));
    CHECK_FALSE(fs::exists(folder / "Würfel.ilh"));
    check_same(read_family(folder.path()), family);
    CHECK(content(folder / "notes.ilh") == "not ours");
}

TEST_CASE("an old family stays readable when the new one cannot be completed") {
    std::mt19937 random(3);
    const ScratchFolder folder;
    const Family old_family = sample_family(random);
    write_family(old_family, folder / "f");
    // A folder called family.json makes the last step, the rename, fail.
    fs::rename(folder / "f/family.json", folder / "f/saved.json");
    fs::create_directory(folder / "f/family.json");
    Family new_family = old_family;
    new_family.keys[0].hierarchy = random_hierarchy(random, false, 30);
    CHECK(contains(machine_error_of([&] { write_family(new_family, folder / "f"); }), "Is a directory"));
    check_same(read_family(folder / "f/saved.json"), old_family);
}

TEST_CASE("a family that could not be read again is not written") {
    std::mt19937 random(4);
    const ScratchFolder folder;
    const auto error_with = [&](auto&& change) {
        Family family = sample_family(random);
        change(family);
        return input_error_of([&] { write_family(family, folder / "f"); });
    };
    CHECK(contains(error_with([](Family& f) { f.keys[0].name = "\xff"; }), "the name of key 0 is not UTF-8"));
    CHECK(contains(error_with([](Family& f) { f.keys[1].name = "a\nb"; }), "the name of key 1"));
    CHECK(contains(error_with([](Family& f) { f.name = "\x1b[2J"; }), "the family's name"));
    CHECK(contains(error_with([](Family& f) { f.keys[1].name = f.keys[0].name; }), "Würfel"));
    CHECK(contains(error_with([](Family& f) { f.keys.clear(); }), "at least one"));
    CHECK_FALSE(fs::exists(folder / "f"));
}

TEST_CASE("a single key or mesh is a family of one") {
    std::mt19937 random(5);
    const ScratchFolder folder;
    const Hierarchy hierarchy = random_hierarchy(random, true, 12);
    write_hierarchy(hierarchy, folder / "Kugel ü.ilh");
    const auto read_key = [&](std::string_view name) {
        const std::vector<std::filesystem::path> files{folder / name};
        return read_keys(files);
    };
    const Family one = read_key("Kugel ü.ilh");
    CHECK(one.keys.size() == 1);
    CHECK(one.name == "Kugel ü");
    CHECK(one.keys[0].name == "Kugel ü");
    CHECK(is_same(*one.keys[0].hierarchy, hierarchy));
    CHECK_FALSE(one.timeline.has_value());
    CHECK_FALSE(one.domain.has_value());

    const std::vector<Triangle> triangle{{2, 0, 1}};
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    put(folder / "mesh.OBJ", obj_text(triangle, positions));
    CHECK(std::ranges::equal(read_key("mesh.OBJ").keys[0].hierarchy->positions, positions));

    put(folder / "key.stl", "");
    CHECK(contains(input_error_of([&] { read_key("key.stl"); }), "ends in .ilh, .obj, .glb or .gltf"));
    CHECK(contains(input_error_of([&] { read_family(folder.path()); }), "is a folder without family.json"));
}

TEST_CASE("unknown members are ignored, and timeline and domain may be missing") {
    const KeyFolder folder;
    const Family family = folder.family(with_members(R"("note": {"by": "us"})"));
    CHECK(family.keys.size() == 2);
    CHECK_FALSE(family.timeline.has_value());
    CHECK_FALSE(family.domain.has_value());
    CHECK(folder.family(with_timeline(R"([{"time": 0, "key": "b"}])")).timeline->keys()[0].key == 1);
    CHECK(folder.family(with_domain("[[0, 1, 2]]")).domain->vertices()[1].key == 1);
}

TEST_CASE("a hostile family file is rejected with the place and what was expected") {
    struct Case {
        std::string json;
        std::string_view expected;
    };
    std::string too_many = "[[0, 1, 2]";
    for (int i = 0; i < 4096; ++i) too_many += ", [0, 1, 2]";
    const std::vector<Case> cases{
        {"", "family.json: parse error at line 1, column 1"},
        {"{\n  \"format\": oops}", "family.json: parse error at line 2, column 1"},
        {std::string(200'000, '['), "family.json: parse error"},
        {R"({"format": 1e999})", "family.json: line 1: number overflow"},
        {"{\"format\": \"\xff\"}", "family.json: parse error"},
        {"[]", "family.json: document: is an array, expected an object"},
        {"{}", "family.json: document: has no \"format\""},
        {R"({"format": "other"})", R"(format: is "other", expected "interleaf-family")"},
        {R"({"format": "interleaf-family"})", "has no \"version\""},
        {R"({"format": "interleaf-family", "version": 3})", "version: is 3, expected 1 or 2"},
        {R"({"format": "interleaf-family", "version": 1.5})", "version: is 1.5, expected 1 or 2"},
        {R"({"format": "interleaf-family", "version": "1"})", "version: is \"1\", expected a number"},
        {R"({"format": "interleaf-family", "version": 1, "keys": []})", "has no \"name\""},
        {R"({"format": "interleaf-family", "version": 1, "name": "\u001b[2J", "keys": []})",
         R"(name: is "\u001b[2J", expected a name without control characters)"},
        {R"({"format": "interleaf-family", "version": 1, "name": "a\u009b2J", "keys": []})",
         R"(name: is "a\u009b2J", expected a name without control characters)"},
        {with_keys("{}"), "keys: is an object, expected an array"},
        {with_keys("[]"), "keys: the family has no key"},
        {with_keys("[7]"), "keys[0]: is 7, expected an object"},
        {with_keys(R"([{"name": "a"}])"), "keys[0]: has no \"file\""},
        {with_keys(R"([{"name": "", "file": "a.ilh"}])"),
         "keys[0].name: is \"\", expected a name that is not empty"},
        {with_keys(R"([{"name": "a", "file": "a.ilh"}, {"name": "a", "file": "b.ilh"}])"),
         "keys[1].name: is \"a\", the same as keys[0]"},
        {with_keys(R"([{"name": "a", "file": "a.ilh"}, {"name": "b", "file": "./a.ilh"}])"),
         "keys[1].file: is also the file of keys[0]"},
        {with_keys(R"([{"name": "a", "file": "a.ilh"}, {"name": "o", "file": "other.ilh"}])"),
         "family.json: keys[1]: key o: 7 root triangles, 6 root vertices, 3 boundary edges, 1 component, "
         "expected 8 root triangles, 6 root vertices, 0 boundary edges, 1 component as key a has"},
        {with_file("missing.ilh"), "keys[0].file: is \"missing.ilh\": No such file"},
        {with_file("family.json"), "family.json: signature: is not that of a hierarchy file"},
        {with_file(""), "keys[0].file: is \"\", expected a path relative to the family's folder"},
        {with_file("/etc/passwd"), "keys[0].file: is \"/etc/passwd\", expected a path relative"},
        {with_file("../a.ilh"), "keys[0].file: is \"../a.ilh\", expected a path relative"},
        {with_file("x/../a.ilh"), "expected a path relative"},
        {with_file("a.ilh\\u0000.txt"), "expected a path relative"},
        {with_file("."), "is a folder, expected a file"},
        {with_origin("7"), "origin: is 7, expected an array"},
        {with_origin("[1, 2]"), "origin: is an array, expected three numbers"},
        {with_origin("[1, 2, 3, 4]"), "origin: is an array, expected three numbers"},
        {with_origin("[1, 2, null]"), "origin[2]: is null, expected a number"},
        {with_origin("[1, 2, 1e999]"), "1e999"},
        {with_members(R"("timeline": [])"), "timeline: is an array, expected an object"},
        {with_members(R"("timeline": null)"), "timeline: is null, expected an object"},
        {with_members(R"("timeline": {"keys": []})"), "timeline: has no \"interpolation\""},
        {with_members(R"("timeline": {"interpolation": "cubic", "keys": []})"),
         R"(timeline.interpolation: is "cubic", expected "linear")"},
        {with_interpolation(1, R"("hold")"), R"(interpolation: is "hold", expected "linear" in version 1)"},
        {with_interpolation(2, R"("cubic")"),
         R"(expected "linear" or "hold" or "bernstein" or "catmull-rom")"},
        {with_interpolation(2, R"("linear", "degree": 2)"), "degree: is 2, expected no degree: only"},
        {with_interpolation(2, R"("bernstein", "degree": 0)"),
         "degree: is 0, expected a degree of at least 1"},
        {with_interpolation(2, R"("bernstein", "degree": -1)"), "timeline.degree: is -1"},
        {with_interpolation(2, R"("bernstein", "degree": 1.5)"), "timeline.degree: is 1.5"},
        {with_timeline("[]"), "family.json: timeline: "},
        {with_timeline(R"([{"key": "a"}])"), "timeline.keys[0]: has no \"time\""},
        {with_timeline(R"([{"time": "0", "key": "a"}])"),
         "timeline.keys[0].time: is \"0\", expected a number"},
        {with_timeline(R"([{"time": 0, "key": "a"}, {"time": 1, "key": "c"}])"),
         "timeline.keys[1].key: is \"c\", expected the name of a key"},
        {with_timeline(R"([{"time": 0, "key": 0}])"), "timeline.keys[0].key: is 0, expected a text"},
        {with_timeline(R"([{"time": 1, "key": "a"}, {"time": 1, "key": "b"}])"), "family.json: timeline: "},
        {with_members(R"("domain": {"vertices": [], "triangles": []})"), "domain.triangles: 0 triangles"},
        {with_members(R"("domain": {"vertices": [{"at": [0], "key": "a"}], "triangles": []})"),
         "domain.vertices[0].at: is an array, expected two numbers"},
        {with_members(R"("domain": {"vertices": [{"at": [0, 0], "key": "z"}], "triangles": []})"),
         "domain.vertices[0].key: is \"z\", expected the name of a key"},
        {with_path(2, R"("path": 7)"), "domain.path: is 7, expected an array"},
        {with_path(2, R"("path": [])"), "domain.path: the path has no point; it needs at least one"},
        {with_path(2, R"("path": [3])"), "domain.path[0]: is 3, expected an object"},
        {with_path(2, R"("path": [{"at": [0, 0]}])"), "domain.path[0]: has no \"time\""},
        {with_path(2, R"("path": [{"time": 0}])"), "domain.path[0]: has no \"at\""},
        {with_path(2, R"("path": [{"time": "0", "at": [0, 0]}])"),
         "domain.path[0].time: is \"0\", expected a number"},
        {with_path(2, R"("path": [{"time": 0, "at": [0, 0, 0]}])"),
         "domain.path[0].at: is an array, expected two numbers"},
        {with_path(2, R"("path": [{"time": 1, "at": [0, 0]}, {"time": 1, "at": [1, 0]}])"),
         "domain.path: path point 1 is at time 1, but times must ascend"},
        {with_path(2, R"("path_drives": true)"),
         "domain.path_drives: is true, expected false: the domain has no path"},
        {with_path(2, R"("path_drives": 1)"), "domain.path_drives: is 1, expected true or false"},
        {with_domain("[[0, 1]]"), "domain.triangles[0]: is an array, expected three vertices"},
        {with_domain("[[0, 1, 3]]"), "domain.triangles[0][2]: is 3, expected a whole number from 0, below 3"},
        {with_domain("[[0, 1, -1]]"), "domain.triangles[0][2]: is -1, expected"},
        {with_domain("[[0, 1, 4294967297]]"), "domain.triangles[0][2]: is 4294967297, expected"},
        {with_domain("[[0, 1, 2.0]]"), "domain.triangles[0][2]: is 2.0, expected a whole number"},
        {with_domain("[[0, 1, 1]]"), "family.json: domain: "},
        {with_domain("[[0, 1, 2], [1, 2, 0]]"), "family.json: domain: "},
        {with_domain(too_many + "]"), "domain.triangles: 4097 triangles, expected 1 to 4096"},
    };
    const KeyFolder folder;
    for (const Case& hostile : cases) {
        const std::string error = folder.error_of(hostile.json);
        INFO("expected: ", hostile.expected, "   got: ", error);
        CHECK(contains(error, hostile.expected));
        CHECK_FALSE(contains(error, "\x1b"));
    }
}

TEST_CASE("a link may lead to a key inside the family's folder and nowhere else") {
    const KeyFolder folder;
    fs::create_directory(folder / "family-other");
    fs::rename(folder / "other.ilh", folder / "family-other/o.ilh");
    fs::create_directory(folder / "family");
    fs::rename(folder / "a.ilh", folder / "family/a.ilh");
    put(folder / "family/family.json", with_file("link.ilh"));
    const auto error = [&] { return input_error_of([&] { read_family(folder / "family"); }); };

    fs::create_symlink("a.ilh", folder / "family/link.ilh");
    CHECK(error().empty());
    fs::remove(folder / "family/link.ilh");
    fs::create_symlink("../b.ilh", folder / "family/link.ilh");
    CHECK(contains(error(), "keys[0].file: is \"link.ilh\", a link that leads out of the family's folder"));

    // A folder whose name begins like the family's folder is outside, too.
    put(folder / "family/family.json", with_file("up/o.ilh"));
    fs::create_directory_symlink("../family-other", folder / "family/up");
    CHECK(contains(error(), "a link that leads out of the family's folder"));
}

TEST_CASE("a family file beyond the limit is rejected by its size") {
    const KeyFolder folder;
    CHECK(contains(folder.error_of(std::string((16 << 20) + 1, ' ')),
                   "size: 16777217 bytes, expected at most 16777216"));
}

}  // namespace interleaf
