// Several keys on the command line, patterns, and `interleaf family`.
#include <array>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {
namespace {

constexpr std::array<const char*, 3> names = {
    INTERLEAF_FIVE_KEYS "/sphere.ilh", INTERLEAF_FIVE_KEYS "/star.ilh", INTERLEAF_FIVE_KEYS "/bone.ilh"};

/// flow.1.obj, flow.2.obj and flow.10.obj: the same faces, moved by 1, 2 and 10 along x.
void write_series(const ScratchFolder& folder) {
    for (const std::string number : {"1", "2", "10"}) {
        std::string text = "v ";
        text.append(number).append(" 0 0\nv ").append(number).append(" 1 0\nv ");
        text.append(number).append(" 0 1\nf 1 2 3\n");
        put(folder / ("flow." + number + ".obj"), text);
    }
}

TEST_CASE("family makes a folder of keys that can be opened") {
    const ScratchFolder folder;
    const Outcome made = run_interleaf({"family", names[0], names[1], names[2], "-o", folder / "three"});
    CHECK(made.status == 0);
    CHECK(made.output.empty());
    CHECK(made.errors.empty());
    const Family family = read_family(folder / "three");
    REQUIRE(family.keys.size() == 3);
    CHECK(family.name == "sphere to bone");
    CHECK(family.keys[0].name == "sphere");
    CHECK(family.keys[2].name == "bone");
    CHECK(family.timeline->end() == 2);
    CHECK(family.domain->triangles().size() == 1);
    CHECK(run_interleaf({"check", folder / "three"}).output ==
          (folder / "three").string() + ": sound, 3 keys\n");
    CHECK(run_interleaf({"export", folder / "three", "--at", "0,0", "-o", folder / "u.obj"}).status == 0);
}

TEST_CASE("family takes files of any name, and writes names that can be read back") {
    const ScratchFolder folder;
    const std::filesystem::path odd = folder / "a\u009b2J\n.ilh";
    std::filesystem::copy_file(names[0], odd);
    const Outcome made = run_interleaf({"family", odd, names[1], "-o", folder / "two"});
    CHECK(made.status == 0);
    CHECK(made.errors.empty());
    const Family family = read_family(folder / "two");
    CHECK(family.keys[0].name == "a\\xc2\\x9b2J\\x0a");
    CHECK(family.name == "a\\xc2\\x9b2J\\x0a to star");
}

TEST_CASE("a family of compressed keys is the same family in fewer bytes") {
    const ScratchFolder folder;
    REQUIRE(run_interleaf({"family", names[0], names[1], "-o", folder / "plain"}).status == 0);
    REQUIRE(run_interleaf({"family", names[0], names[1], "--compress", "-o", folder / "small"}).status == 0);
    const Family plain = read_family(folder / "plain");
    const Family small = read_family(folder / "small");
    REQUIRE(small.keys.size() == 2);
    for (const std::size_t key : {0U, 1U}) {
        CHECK(small.keys[key].hierarchy->bits == plain.keys[key].hierarchy->bits);
        CHECK(small.keys[key].hierarchy->positions == plain.keys[key].hierarchy->positions);
    }
    CHECK(is_compressed_hierarchy(folder / "small/star.ilh"));
    CHECK_FALSE(is_compressed_hierarchy(folder / "plain/star.ilh"));
    CHECK(run_interleaf({"check", folder / "small"}).output ==
          (folder / "small").string() + ": sound, 2 keys\n");
}

TEST_CASE("keys in another numbering get the roots of the first key, and check and family report it") {
    const ScratchFolder folder;
    const Hierarchy star_key = read_hierarchy(names[1]);
    // The same key with its root vertices in reverse order.
    const Index count = star_key.roots.vertex_count();
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : star_key.roots.triangles())
        triangles.push_back({count - 1 - a, count - 1 - b, count - 1 - c});
    Hierarchy reversed = star_key;
    reversed.roots = RootComplex(count, triangles);
    for (Index v = 0; v < count; ++v) reversed.positions[v] = star_key.positions[count - 1 - v];
    std::filesystem::create_directory(folder / "f");
    write_hierarchy(reversed, folder / "f/star.ilh");
    std::filesystem::copy_file(names[0], folder / "f/sphere.ilh");
    put(folder / "f/family.json",
        R"({"format": "interleaf-family", "version": 1, "name": "f", "keys": [)"
        R"({"name": "sphere", "file": "sphere.ilh"}, {"name": "star", "file": "star.ilh"}]})");
    const Outcome checked = run_interleaf({"check", folder / "f"});
    CHECK(checked.status == 0);
    CHECK(contains(checked.output, "/f: sound, 2 keys\n"));
    CHECK(contains(checked.output, "/f: key star: its roots were renumbered to match key sphere\n"));

    const Outcome made = run_interleaf({"family", names[0], folder / "f/star.ilh", "-o", folder / "g"});
    CHECK(made.status == 0);
    CHECK(is_one_message(made.errors));
    CHECK(contains(made.errors, "key star: its roots were renumbered to match key sphere"));
    CHECK(content(folder / "g/sphere.ilh") == content(names[0]));
    const Family family = read_family(folder / "g");
    CHECK(family.keys[1].hierarchy->roots == star_key.roots);
    CHECK(family.keys[1].hierarchy->leaf_count() == star_key.leaf_count());
    CHECK(contains(run_interleaf({"check", folder / "g"}).output, "sound, 2 keys\n"));
}

TEST_CASE("a series of meshes is opened by a pattern or by name, in numerical order") {
    const ScratchFolder folder;
    write_series(folder);
    const std::string pattern = folder / "flow.*.obj";
    CHECK(run_interleaf({"check", pattern}).output == pattern + ": sound, 3 keys\n");
    const Outcome info = run_interleaf({"info", pattern});
    CHECK(info.status == 0);
    CHECK(contains(info.output, "flow.1 to flow.10"));

    // Half a second after flow.2, the blend is halfway between flow.2 and flow.10.
    CHECK(run_interleaf({"export", pattern, "--time", "1.5", "-o", folder / "u.obj"}).status == 0);
    CHECK(content(folder / "u.obj") == "v 6 0 0\nv 6 1 0\nv 6 0 1\nf 1 2 3\n");

    for (const std::vector<std::string>& words :
         {std::vector<std::string>{pattern},
          {folder / "flow.10.obj", folder / "flow.1.obj", folder / "flow.2.obj"}}) {
        std::vector<std::string> line{"family"};
        line.insert(line.end(), words.begin(), words.end());
        line.insert(line.end(), {"-o", folder / "series"});
        CHECK(run_interleaf(line).status == 0);
        const Family family = read_family(folder / "series");
        REQUIRE(family.keys.size() == 3);
        CHECK(family.keys[0].name == "flow.1");
        CHECK(family.keys[2].name == "flow.10");
    }
}

TEST_CASE("several keys that do not match exit with 1, and the message says which keys and where") {
    const ScratchFolder folder;
    write_series(folder);
    put(folder / "flow.2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 1\n");
    struct Fault {
        std::vector<std::string> arguments;
        std::string part;
    };
    const std::vector<Fault> faults = {
        {{folder / "none.*.obj"}, "none.*.obj: no file matches"},
        {{folder / "f*/a.obj"}, "f*/a.obj: expected * only in the name of the file"},
        {{names[0], folder / "flow.1.obj"}, "flow.1.obj: key flow.1: 1 root triangles"},
        {{names[0], folder / "missing.ilh"}, "missing.ilh: there is no such file"},
        {{names[0], INTERLEAF_FIVE_KEYS},
         "five-keys: expected a file that ends in .ilh, .obj, .glb or .gltf"}};
    for (const Fault& fault : faults)
        for (const std::string command : {"view", "", "family"}) {
            std::vector<std::string> line;
            if (!command.empty()) line.push_back(command);
            line.insert(line.end(), fault.arguments.begin(), fault.arguments.end());
            if (command == "family") line.insert(line.end(), {"-o", folder / "f"});
            const Outcome outcome = run_interleaf(line);
            CAPTURE(command);
            CAPTURE(outcome.errors);
            CHECK(outcome.status == 1);
            CHECK(is_one_message(outcome.errors));
            CHECK(contains(outcome.errors, fault.part));
        }
    CHECK_FALSE(std::filesystem::exists(folder / "f"));
}

TEST_CASE("meshes with different faces are not a family, and the viewer offers to fit them") {
    const ScratchFolder folder;
    write_series(folder);
    put(folder / "flow.2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 1\n");
    const Outcome family = run_interleaf({"family", folder / "flow.*.obj", "-o", folder / "f"});
    CHECK(family.status == 1);
    CHECK(is_one_message(family.errors));
    CHECK(contains(
        family.errors,
        "flow.2.obj: line 4: a face of the vertices (2, 3, 1), expected (1, 2, 3) as in line 4 of "));
    CHECK(contains(family.errors, "`interleaf fit` makes keys of meshes with different faces"));
    CHECK_FALSE(std::filesystem::exists(folder / "f"));
    for (const std::vector<std::string>& line :
         {std::vector<std::string>{"view", folder / "flow.*.obj"}, {folder / "flow.*.obj"}}) {
        const Outcome outcome = run_interleaf(line);
        CHECK(outcome.status == 3);  // only the display for the offer is missing
        CHECK(contains(outcome.errors, "no display"));
    }
}

TEST_CASE("check takes a pattern or a folder of meshes to fit, and checks each mesh") {
    const ScratchFolder folder;
    const std::string closed = "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    put(folder / "a.off", closed);
    put(folder / "b.off", closed);
    for (const std::filesystem::path& path : {folder / "*.off", folder.path()}) {
        const Outcome outcome = run_interleaf({"check", path});
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 0);
        CHECK(contains(outcome.output, "a.off: sound, a mesh to fit a key to\n"));
        CHECK(contains(outcome.output, "b.off: sound, a mesh to fit a key to\n"));
    }
    put(folder / "b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    const Outcome outcome = run_interleaf({"check", folder / "*.off"});
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.output, "a.off: sound"));
    CHECK(contains(outcome.errors, "b.off: "));
}

TEST_CASE("a broken mesh among others is an error, not an offer to fit") {
    const ScratchFolder folder;
    write_series(folder);
    put(folder / "flow.2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 9\n");
    const Outcome outcome = run_interleaf({"view", folder / "flow.*.obj"});
    CHECK(outcome.status == 1);
    CHECK(is_one_message(outcome.errors));
    CHECK(contains(outcome.errors, "flow.2.obj: line 4: vertex 9 does not exist"));
}

TEST_CASE("several keys are viewed as one family") {
    for (const std::vector<std::string>& line :
         {std::vector<std::string>{names[0], names[1]}, {"view", names[0], names[1], "--time", "0.5"}}) {
        const Outcome outcome = run_interleaf(line);
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 3);  // all files were read, only the display is missing
        CHECK(contains(outcome.errors, "no display"));
    }
}

}  // namespace
}  // namespace interleaf
