// `interleaf check` on every kind of damage. tests/data/make-bad makes the files.
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <sys/stat.h>

namespace interleaf {
namespace {

namespace fs = std::filesystem;

/// For each file or family folder in tests/data/bad, the words that the message must contain, in this order.
const std::map<std::string, std::vector<std::string>> damage = {
    {"empty.ilh", {"size: 0 bytes", "expected at least 36", "cut off"}},
    {"not-a-key.ilh", {"signature: is not that of a hierarchy file"}},
    {"cut.ilh", {"size: 106 bytes", "expected 136", "cut off"}},
    {"cut-header.ilh", {"size: 20 bytes", "expected at least 36", "cut off"}},
    {"grown.ilh", {"size: 140 bytes", "expected 136", "too long"}},
    {"signature.ilh", {"signature: is not that of a hierarchy file"}},
    {"text-mode.ilh", {"signature: its line ends are damaged", "text mode"}},
    {"version.ilh", {"version: is 99, expected 1 or 2"}},
    {"field-count.ilh", {"field count: is 4294967295, expected"}},
    {"checksum.ilh", {"checksum: is c78c2d86, expected d7960eb7"}},
    {"midpoint-count.ilh", {"size: 136 bytes, expected 9126805632 by its counts"}},
    {"vertex-count.ilh", {"size: 136 bytes, expected 148 by its counts"}},
    {"no-roots.ilh", {"root triangle count: is 0, expected at least 1"}},
    {"root-vertex-count.ilh", {"root vertex count: is 6, expected at most the 5 vertices"}},
    {"root-index.ilh", {"root complex: triangle 0 has the vertices (7, 2, 0), expected indices below 4"}},
    {"root-corner-twice.ilh",
     {"root complex: triangle 0 has the vertices (1, 1, 0), expected three different"}},
    {"roots-not-manifold.ilh", {"root complex: edge (0, 1) belongs to 3 triangles", "expected at most two"}},
    {"roots-orientation.ilh",
     {"root complex: triangles 0 and 1 run along edge", "expected a consistent orientation"}},
    {"roots-twin.ilh", {"root complex: triangles 0 and 1 have the same vertices"}},
    {"roots-touch.ilh",
     {"root complex: vertex 0 joins triangles that share no edge there, expected a manifold"}},
    {"root-vertex-unused.ilh", {"root complex: vertex 4 belongs to no triangle"}},
    {"bits-run-out.ilh", {"hierarchy: ", "root 0, node 3: bisected, but all 2 midpoints are used up"}},
    {"bits-left-over.ilh", {"hierarchy: 2 nodes follow the last root's tree"}},
    {"bits-unused.ilh", {"hierarchy: bits after the last node are set, expected 0"}},
    {"midpoints-used-up.ilh", {"hierarchy: ", "root 0, node 3: bisected, but all 2 midpoints are used up"}},
    {"midpoints-left-over.ilh", {"hierarchy: ", "1 midpoints are left over"}},
    {"too-deep.ilh",
     {"hierarchy: root 0, node 64: bisected at level 64, expected leaves at most 64 levels deep"}},
    {"misnumbered.ilh", {"hierarchy: root 0, node 0: the midpoint is vertex 3, expected 4"}},
    {"gap-in-numbers.ilh", {"hierarchy: root 0, node 0: the midpoint is vertex 5, expected 4"}},
    {"hanging.ilh",
     {"hierarchy: vertex 4 bisects edge (2, 0) on one side only: it is a hanging node on the other"}},
    {"edge-of-another.ilh", {"hierarchy: root 1, node 3: vertex 4 bisects edge (2, 3), expected (0, 2)"}},
    {"vertex-unused.ilh", {"hierarchy: vertex 5 is no midpoint"}},
    {"position-nan.ilh", {"hierarchy: vertex 4 is at (0.5, nan, 0), expected finite coordinates"}},
    {"position-infinite.ilh", {"hierarchy: vertex 0 is at (inf, 0, 0), expected finite coordinates"}},
    {"compressed-cut.ilh", {"size: 132 bytes, expected 141", "cut off"}},
    {"compressed-checksum.ilh", {"checksum: is 006b5066, expected a16b5066"}},
    {"compressed-content-checksum.ilh", {"checksum of the content: is 12345678, expected b6c93321"}},
    {"compressed-sizes.ilh", {"size: the sizes of its parts are too large"}},
    {"compressed-counts.ilh",
     {"counts: stand for 22011707424 bytes, expected at most 16786240 in a file of 141"}},
    {"compressed-decisions.ilh", {"decision count: is 3, expected at most the 1 nodes"}},
    {"compressed-decision-value.ilh", {"connectivity: decision 0 is 2, expected 0 or 1"}},
    {"compressed-bisected.ilh", {"connectivity: node 0: bisected, but there are only 0 midpoints"}},
    {"compressed-grid.ilh", {"grid exponent: is 200, expected -149 to 127"}},
    {"compressed-frame.ilh", {"connectivity: cannot be decompressed: "}},
    {"compressed-frame-size.ilh", {"connectivity: holds 12 bytes, expected 13"}},
    {"compressed-vertices.ilh", {"connectivity: 0 bisected nodes and 3 vertices, expected 0 and 4"}},

    {"family-no-json", {"family.json: parse error at line 3"}},
    {"family-cut", {"family.json: parse error at line 1, column 114", "unexpected end of input"}},
    {"family-not-utf-8", {"family.json: parse error at line 1", "ill-formed UTF-8", "b\\xe4"}},
    {"family-number-too-large", {"family.json: line 1: number overflow", "1e999"}},
    {"family-array", {"family.json: document: is an array, expected an object"}},
    {"family-format", {R"(family.json: format: is "gltf", expected "interleaf-family")"}},
    {"family-version", {"family.json: version: is 3, expected 1 or 2"}},
    {"family-keys-type", {"family.json: keys: is an object, expected an array"}},
    {"family-no-keys", {"family.json: keys: the family has no key; it needs at least one"}},
    {"family-key-without-file", {"family.json: keys[0]: has no \"file\""}},
    {"family-name-type", {"family.json: name: is 7, expected a text"}},
    {"family-name-control",
     {R"(family.json: name: is "\u001b[2Jgone", expected a name without control characters)"}},
    {"family-name-twice", {R"(family.json: keys[1].name: is "a", the same as keys[0])"}},
    {"family-file-twice", {"family.json: keys[1].file: is also the file of keys[0]"}},
    {"family-file-missing", {R"(family.json: keys[1].file: is "c.ilh": No such file)"}},
    {"family-file-outside", {R"(keys[1].file: is "../family-outside/a.ilh", expected a path relative to)"}},
    {"family-file-outside-by-way",
     {"keys[1].file: is \"sub/../../family-outside/a.ilh\", expected a path relative"}},
    {"family-file-absolute", {R"(keys[1].file: is "/etc/hostname", expected a path relative)"}},
    {"family-file-null", {R"(keys[1].file: is "b.ilh\u0000.txt", expected a path relative)"}},
    {"family-file-too-long", {"keys[1].file: is \"nnn", "File name too long"}},
    {"family-file-is-folder", {"family-file-is-folder: is a folder, expected a file"}},
    {"family-file-is-text", {"family.json: signature: is not that of a hierarchy file"}},
    {"family-key-damaged", {"family-key-damaged/c.ilh: size: 106 bytes, expected 136", "cut off"}},
    {"family-roots-differ", {"family.json: keys[1]: key c: 1 root triangles", "expected 2", "as key a has"}},
    {"family-marking-differs", {"family.json: keys[1]: key c: root ", "refinement edge", "key a"}},
    {"family-timeline-type", {"family.json: timeline: is an array, expected an object"}},
    {"family-timeline-order", {"family.json: timeline: timeline key 2 is at time 1, but times must ascend"}},
    {"family-timeline-key", {R"(family.json: timeline.keys[1].key: is "c", expected the name of a key)"}},
    {"family-timeline-empty", {"family.json: timeline: the timeline has no key"}},
    {"family-timeline-interpolation",
     {"family.json: timeline.interpolation: is \"magic\", expected", "\"linear\""}},
    {"family-domain-overlap", {"family.json: domain: domain triangles 0 and 1 overlap"}},
    {"family-domain-no-area", {"family.json: domain: domain triangle 0 has no area"}},
    {"family-domain-index",
     {"family.json: domain.triangles[0][2]: is 3, expected a whole number from 0, below 3"}},
    {"family-domain-negative", {"family.json: domain.triangles[0][2]: is -1, expected a whole number"}},
    {"family-domain-vertex-unused", {"family.json: domain: domain vertex 3 belongs to no triangle"}},
    {"family-domain-vertex-on-edge", {"family.json: domain: domain vertex 3 lies on triangle 0"}},
    {"family-domain-empty", {"family.json: domain.triangles: 0 triangles, expected 1 to 4096"}},

    {"missing-vertex.obj", {"line 6: vertex 9 does not exist, there are 4"}},
    {"vertex-zero.obj", {"line 5: vertex 0 does not exist, they are counted from 1"}},
    {"vertex-before.obj", {"line 5: vertex -5 does not exist, there are 4 before this line"}},
    {"coordinate.obj", {R"(line 2: "zero" is not a coordinate, expected three finite numbers)"}},
    {"coordinate-nan.obj",
     {"line 2: a coordinate is not a finite number within the range of floats, and faces use the vertex"}},
    {"crossing.obj", {"line 5: a face of 4 corners that crosses itself"}},
    {"decimal-commas.obj", {R"(line 1: "0,5" is not a coordinate, expected three finite numbers)"}},
    {"not-text.obj", {"is not text, expected lines that begin with v and f"}},
    {"coordinate-too-large.obj", {R"(line 2: "1e39" is not a coordinate, expected three finite numbers)"}},
    {"two-coordinates.obj", {"line 2: a vertex of 2 coordinates, expected three"}},
    {"corner.obj", {R"(line 5: "three" is not a corner, expected the number of a vertex)"}},
    {"two-corners.obj", {"line 5: a face of 2 vertices, expected 3 to 100000"}},
    {"no-faces.obj", {"is a point cloud: it has 4 vertices, but no faces"}},
    {"corner-twice.obj",
     {"faces, as triangles", "triangle 0 has the vertices (0, 1, 1), expected three different ones"}},
    {"not-manifold.obj",
     {"faces, as triangles", "edge (0, 1) belongs to 3 triangles", "expected at most two"}},
    {"orientation.obj",
     {"faces, as triangles", "triangles 0 and 1 run along edge", "a consistent orientation"}},
    {"polygon.obj",
     {"faces, as triangles", "triangle 2 has the vertices (0, 3, 0), expected three different ones"}},
};

bool has_in_order(const std::string& text, const std::vector<std::string>& words) {
    std::size_t place = 0;
    for (const std::string& word : words) {
        place = text.find(word, place);
        if (place == std::string::npos) return false;
        place += word.size();
    }
    return true;
}

/// A folder that contains the key k.ilh and the family families/f.
class FamilyFolder {
  public:
    FamilyFolder() {
        fs::create_directories(family());
        const fs::path key = fs::path(INTERLEAF_BAD_FILES) / "family-cut" / "a.ilh";
        fs::copy_file(key, folder_ / "k.ilh");
        fs::copy_file(key, family() / "a.ilh");
    }
    fs::path family() const { return folder_.path() / "families" / "f"; }
    fs::path folder() const { return folder_.path(); }
    Outcome check_with(const std::string& name) const {
        put(family() / "family.json",
            R"({"format": "interleaf-family", "version": 1, "name": "f", "keys":
            [{"name": "a", "file": "a.ilh"}, {"name": "k", "file": ")" +
                name + "\"}]}");
        return run_interleaf({"check", family()});
    }

  private:
    ScratchFolder folder_;
};

TEST_CASE("every kind of damage exits with 1 and names the file, the place and what was expected") {
    for (const auto& [name, words] : damage) {
        CAPTURE(name);
        const std::string file = std::string(INTERLEAF_BAD_FILES "/") + name;
        const Outcome outcome = run_interleaf({"check", file});
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 1);
        CHECK(outcome.output.empty());
        CHECK(is_one_message(outcome.errors));
        CHECK(contains(outcome.errors, file));
        CHECK(has_in_order(outcome.errors, words));
    }
}

TEST_CASE("every damaged file has its message") {
    CHECK(damage.size() >= 90);
    std::set<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(INTERLEAF_BAD_FILES))
        files.insert(entry.path().filename());
    CHECK(files.erase("family-outside") == 1);  // a good key outside the families that name it
    for (const std::string& file : files) {
        CAPTURE(file);
        CHECK(damage.contains(file));
        CHECK((!fs::is_regular_file(fs::path(INTERLEAF_BAD_FILES) / file) ||
               fs::file_size(fs::path(INTERLEAF_BAD_FILES) / file) < 4096));
    }
    CHECK(files.size() == damage.size());
}

TEST_CASE("a family can name files inside its folder, also through links, and no others") {
    const FamilyFolder folder;
    const fs::path family = folder.family();
    fs::create_directory(family / "sub");
    fs::copy_file(folder.folder() / "k.ilh", family / "sub/k.ilh");
    CHECK(folder.check_with("sub/k.ilh").status == 0);
    CHECK(folder.check_with("sub//./k.ilh").status == 0);
    fs::create_symlink("sub/k.ilh", family / "inside.ilh");
    CHECK(folder.check_with("inside.ilh").status == 0);
    fs::create_directory_symlink("sub", family / "inner");
    CHECK(folder.check_with("inner/k.ilh").status == 0);

    fs::create_symlink("../../k.ilh", family / "outside.ilh");
    fs::create_directory_symlink("../..", family / "out");
    fs::create_directory_symlink(folder.folder(), family / "far");
    fs::create_symlink("outside.ilh", family / "link-to-link.ilh");
    fs::create_symlink("loop.ilh", family / "loop.ilh");
    const std::map<std::string, std::string> refused = {
        {"outside.ilh", "a link that leads out of the family's folder"},
        {"link-to-link.ilh", "a link that leads out of the family's folder"},
        {"out/k.ilh", "a link that leads out of the family's folder"},
        {"far/k.ilh", "a link that leads out of the family's folder"},
        {"sub/../../../k.ilh", "expected a path relative to the family's folder, without"},
        {"sub/..", "expected a path relative to the family's folder, without"},
        {"loop.ilh", "Too many levels of symbolic links"},
        {"a.ilh/k.ilh", "Not a directory"},
        {"sub/missing/k.ilh", "No such file or directory"},
        {"sub/" + std::string(256, 'x'), "File name too long"},
        {std::string(5000, '/') + "k", "expected a path relative to"},
    };
    for (const auto& [name, words] : refused) {
        CAPTURE(name);
        const Outcome outcome = folder.check_with(name);
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 1);
        CHECK(is_one_message(outcome.errors));
        CHECK(contains(outcome.errors, (family / "family.json").string() + ": keys[1].file: "));
        CHECK(contains(outcome.errors, words));
    }
}

TEST_CASE("a pipe, a device or a folder in place of a file is refused at once") {
    const FamilyFolder folder;
    REQUIRE(::mkfifo((folder.family() / "pipe.ilh").c_str(), 0600) == 0);
    fs::create_symlink("pipe.ilh", folder.family() / "link-to-pipe.ilh");
    fs::create_symlink("/dev/zero", folder.family() / "device.ilh");
    fs::create_directory(folder.family() / "folder.ilh");
    for (const std::string name : {"pipe.ilh", "link-to-pipe.ilh", "device.ilh", "folder.ilh"}) {
        CAPTURE(name);
        const Outcome of_family = folder.check_with(name);
        CHECK(of_family.status == 1);
        CHECK(is_one_message(of_family.errors));
        const Outcome of_file = run_interleaf({"check", folder.family() / name});
        CHECK(of_file.status == 1);
        CHECK(is_one_message(of_file.errors));
    }
    REQUIRE(fs::remove(folder.family() / "family.json"));
    REQUIRE(::mkfifo((folder.family() / "family.json").c_str(), 0600) == 0);
    const Outcome outcome = run_interleaf({"check", folder.family()});
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "family.json: is a device, pipe or socket, expected a file"));
}

TEST_CASE("messages show names of files in UTF-8, and escape bytes that are not UTF-8 or move the cursor") {
    const ScratchFolder folder;
    const std::map<std::string, std::string> names = {
        {"Würfel 三 \xf0\x9f\x8e\xb2.ilh", "Würfel 三 \xf0\x9f\x8e\xb2.ilh"},
        {"two\nlines.ilh", "two\\x0alines.ilh"},
        {"es\x1b[2Jcape.ilh", "es\\x1b[2Jcape.ilh"},
        {"c1\xc2\x9b"
         "2J.ilh",
         "c1\\xc2\\x9b2J.ilh"},
        {"latin\xe4.ilh", "latin\\xe4.ilh"},
        {"cut\xf0\x9f\x8e.ilh", "cut\\xf0\\x9f\\x8e.ilh"},
        {"overlong\xc0\xaf\xe0\x80\xaf.ilh", "overlong\\xc0\\xaf\\xe0\\x80\\xaf.ilh"},
        {"surrogate\xed\xa0\x80.ilh", "surrogate\\xed\\xa0\\x80.ilh"},
        {"beyond\xf4\x90\x80\x80.ilh", "beyond\\xf4\\x90\\x80\\x80.ilh"},
    };
    for (const auto& [name, shown] : names) {
        CAPTURE(shown);
        const std::string file = folder / name;
        put(file, "no key");
        const Outcome bad = run_interleaf({"check", file});
        CHECK(bad.status == 1);
        CHECK(bad.errors == "interleaf: " + (folder / shown).string() +
                                ": signature: is not that of a hierarchy file (.ilh)\n");
        fs::copy_file(INTERLEAF_FIVE_KEYS "/icosahedron.ilh", file, fs::copy_options::overwrite_existing);
        CHECK(run_interleaf({"check", file}).output == (folder / shown).string() + ": sound, 1 key\n");
        const Outcome info = run_interleaf({"info", file});
        CHECK(info.status == 0);
        CHECK(contains(info.output, shown.substr(0, shown.size() - 4) + "\n"));
    }
}

}  // namespace
}  // namespace interleaf
