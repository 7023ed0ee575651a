// The command line as a whole: help, version, exit statuses and messages.
#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "io/formats.h"

namespace interleaf {
namespace {

const std::vector<std::string> commands = {"view",  "render", "export", "import", "info",
                                           "check", "make",   "family", "lod"};

TEST_CASE("--version names the program and its version") {
    const Outcome outcome = run_interleaf({"--version"});
    CHECK(outcome.status == 0);
    CHECK(outcome.output == "interleaf " INTERLEAF_VERSION "\n");
    CHECK(outcome.errors.empty());
}

TEST_CASE("--help names every command, and every command has its own help with an example") {
    const Outcome whole = run_interleaf({"--help"});
    CHECK(whole.status == 0);
    for (const std::string& command : commands) {
        CAPTURE(command);
        CHECK(contains(whole.output, "\n  " + command + " "));
        const Outcome own = run_interleaf({command, "--help"});
        CHECK(own.status == 0);
        CHECK(own.errors.empty());
        CHECK(contains(own.output, "Usage: interleaf " + command));
        CHECK(contains(own.output, "Example"));
    }
}

TEST_CASE("help lists the extensions of the table of formats") {
    const auto help = [](const char* command) { return run_interleaf({command, "--help"}).output; };
    const std::string view = help("view");
    const std::string exported = help("export");
    const std::string fit = help("fit");
    for (const Format& format : formats()) {
        const std::string extension(format.extension);
        CAPTURE(extension);
        CHECK(contains(view, extension) == format.is_openable());
        CHECK(contains(exported, "OUT" + extension) == format.is_exported());
        if (format.holds_mesh()) CHECK(contains(fit, extension));
    }
}

TEST_CASE("help prints the same text as --help, for the program and for each command") {
    CHECK(run_interleaf({"help"}).output == run_interleaf({"--help"}).output);
    for (const std::string& command : commands) {
        CAPTURE(command);
        const Outcome outcome = run_interleaf({"help", command});
        CHECK(outcome.status == 0);
        CHECK(outcome.output == run_interleaf({command, "--help"}).output);
    }
}

TEST_CASE("a faulty command line exits with 2 and one message that names the word at fault") {
    struct Fault {
        std::vector<std::string> arguments;
        std::string part;
    };
    const std::vector<Fault> faults = {
        {{"rendr"}, "rendr"},
        {{"help", "rendr"}, "rendr"},
        {{"make", "star", "-o", "a.ilh", "--leaves", "1.5e0"}, "--leaves"},
        {{"make", "star", "-o", "a.ilh", "--leaves", "1e10"}, "--leaves"},
        {{"--no-such-option"}, "--no-such-option"},
        {{"render", "--no-such-option", "-o", "a.png"}, "--no-such-option"},
        {{"render"}, "--output"},
        {{"render", "-o", "a.tiff"}, "tiff"},
        {{"render", "-o", "a"}, "png"},
        {{"render", "-o", "-"}, "--format"},
        {{"render", "-o", "a.png", "--at", "0.3"}, "--at"},
        {{"render", "-o", "a.png", "--at", "0.3,nan"}, "--at"},
        {{"render", "-o", "a.png", "--at", "0.3,0.4x"}, "0.4x"},
        {{"render", "-o", "a.png", "--time", "soon"}, "--time"},
        {{"render", "-o", "a.png", "--time", "1", "--at", "0,0"}, "--at"},
        {{"render", "-o", "a.png", "--size", "0x5"}, "--size"},
        {{"render", "-o", "a.png", "--size", "16385x5"}, "16384"},
        {{"render", "-o", "a.png", "--size", "5"}, "--size"},
        {{"render", "-o", "a.png", "--show", "wireframe,shadows"}, "shadows"},
        {{"render", "-o", "a.png", "--shading", "toon"}, "toon"},
        {{"render", "-o", "a.png", "--color", "pink"}, "pink"},
        {{"render", "-o", "a.png", "--camera", "10"}, "--camera"},
        {{"render", "-o", "a.png", "--camera", "10,91"}, "--camera"},
        {{"render", "-o", "a.png", "--camera", "10,20,0"}, "--camera"},
        {{"render", "-o", "a.png", "--camera", "10,20,roll=x"}, "a roll from -360 to 360"},
        {{"view", "--camera", "10,20,center=1:2"}, "center=X:Y:Z"},
        {{"render", "-o", "a.png", "--line-width", "0"}, "--line-width"},
        {{"render", "-o", "a.mp4", "--transparent"}, "--transparent"},
        {{"export", "-o", "u.obj", "--weights", "star"}, "--weights"},
        {{"export", "-o", "u.obj", "--weights", "star=1,moon=2"}, "moon"},
        {{"export", "-o", "u.obj", "--weights", "star=1e300"}, "--weights"},
        {{"export", "-o", "u.obj", "--weights", "star=1", "--time", "1"}, "--time"},
        {{"export", "-o", "u.stl"}, "stl"},
        {{"export", "-o", "u.obj", "--compress"}, "--compress"},
        {{"export", "-o", "-", "--format", "ply", "--compress"}, "--compress"},
        {{"export", "-o", "u.ilh", "--bits", "16"}, "--compress"},
        {{"export", "-o", "u.ilh", "--compress", "--bits", "25"}, "--bits"},
        {{"export", "-o", "u.obj", "--format", "stl"}, "stl"},
        {{"view", INTERLEAF_FIVE_KEYS "/star.ilh", "--at", "0,0"}, "--at"},
        {{"view", INTERLEAF_FIVE_KEYS "/star.ilh", "--time", "1"}, "--time"},
        {{"view", "--at", "0,0", "--time", "1"}, "--time"},
        {{"info"}, "FILE"},
        {{"check"}, "FILE"},
        {{"family", "-o", "a"}, "KEY"},
        {{"family", "a.ilh"}, "--output"},
        {{"lod", "-o", "a.ilh", "--leaves", "100"}, "FAMILY"},
        {{"lod", "a.ilh", "--leaves", "100"}, "--output"},
        {{"lod", "a.ilh", "-o", "b.ilh"}, "--tolerance"},
        {{"lod", "a.ilh", "-o", "b.ilh", "--leaves", "100", "--tolerance", "0.1"}, "--tolerance"},
        {{"lod", "a.ilh", "-o", "b.ilh", "--leaves", "few"}, "--leaves"},
        {{"lod", "a.ilh", "-o", "b.ilh", "--tolerance", "-0.1"}, "--tolerance"},
        {{"lod", "a.ilh", "-o", "b.ilh", "--tolerance", "nan"}, "--tolerance"},
        {{"lod", INTERLEAF_FIVE_KEYS "/star.ilh", "-o", "a.obj", "--leaves", "100"}, "obj"},
        {{"lod", INTERLEAF_FIVE_KEYS "/star.ilh", "-o", "a.ilh", "--leaves", "19"}, "20 roots"},
        {{"lod", INTERLEAF_FIVE_KEYS, "-o", "-", "--leaves", "100"}, "folder"},
        {{"make", "-o", "a.ilh"}, "SHAPE"},
        {{"make", "star"}, "--output"},
        {{"make", "moon", "-o", "a.ilh"}, "moon"},
        {{"make", "star", "-o", "a.obj"}, "obj"},
        {{"make", "star", "-o", "a.ilh", "--leaves", "100", "--tolerance", "0.1"}, "--tolerance"},
        {{"make", "star", "-o", "a.ilh", "--leaves", "-5"}, "--leaves"},
        {{"make", "star", "-o", "a.ilh", "--leaves", "5"}, "20"},
        {{"make", "star", "-o", "a.ilh", "--tolerance", "0"}, "tolerance"},
        {{"make", "star", "-o", "a.ilh", "--tolerance", "nan"}, "tolerance"},
        {{"make", "five-keys", "-o", "a", "--leaves", "100"}, "--leaves"},
        {{"make", "five-keys", "-o", "a", "--compress"}, "--compress"},
        {{"make", "five-keys", "-o", "a", "--steps", "3"}, "--steps"},
        {{"make", "star", "-o", "a.ilh", "--steps", "3"}, "--steps"},
        {{"make", "star", "-o", "a.ilh", "--distance", "1"}, "--distance"},
        {{"make", "flow", "-o", "-"}, "folder"},
        {{"make", "flow", "-o", "a", "--leaves", "100"}, "--leaves"},
        {{"make", "flow", "-o", "a", "--distance", "1"}, "--distance"},
        {{"make", "flow", "-o", "a", "--steps", "0"}, "1000"},
        {{"make", "flow", "-o", "a", "--steps", "1001"}, "1000"},
        {{"make", "flow", "-o", "a", "--steps", "1.5"}, "--steps"},
        {{"make", "catenoid", "-o", "a", "--tolerance", "0.1"}, "tolerance"},
        {{"make", "catenoid", "-o", "a", "--distance", "nan"}, "--distance"},
        {{"make", "catenoid", "-o", "a", "--distance", "4"}, "distance"},
        {{"make", "star", "-o", "a.ilh", "--bits", "16"}, "--compress"},
        {{"family", "a.ilh", "-o", "a", "--bits", "16"}, "--compress"},
        {{"make", "star", "-o", "a.ilh", "--compress", "--bits", "7"}, "--bits"},
        {{"make", "star", "-o", "a.ilh", "--compress", "--bits", "many"}, "--bits"},
    };
    for (const Fault& fault : faults) {
        std::string line;
        for (const std::string& argument : fault.arguments) line += " " + argument;
        CAPTURE(line);
        const Outcome outcome = run_interleaf(fault.arguments);
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 2);
        CHECK(outcome.output.empty());
        CHECK(is_one_message(outcome.errors));
        CHECK(contains(outcome.errors, fault.part));
    }
}

TEST_CASE("a file that is missing or of the wrong kind exits with 1 and one message that names it") {
    const ScratchFolder folder;
    put(folder / "text.ilh", "not a hierarchy");
    CHECK(run_interleaf({"view", folder / "missing.off"}).status == 1);
    CHECK(run_interleaf({folder / "missing.ply", folder / "missing.obj"}).status == 1);
    for (const std::string name : {"missing.ilh", "missing.json", "text.ilh"}) {
        const std::string file = folder / name;
        const std::vector<std::vector<std::string>> lines = {{file},
                                                             {"view", file},
                                                             {"render", file, "-o", folder / "a.png"},
                                                             {"export", file, "-o", folder / "a.obj"},
                                                             {"info", file},
                                                             {"check", file}};
        for (const std::vector<std::string>& line : lines) {
            CAPTURE(name);
            CAPTURE(line[0]);
            const Outcome outcome = run_interleaf(line);
            CAPTURE(outcome.errors);
            CHECK(outcome.status == 1);
            CHECK(is_one_message(outcome.errors));
            CHECK(contains(outcome.errors, "interleaf: " + file + ": "));
        }
    }
    CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
    CHECK_FALSE(std::filesystem::exists(folder / "a.obj"));
}

TEST_CASE("without a display the viewer exits with 3 and says how to draw without one") {
    const ScratchFolder folder;
    put(folder / "mesh.off", "OFF\n0 0 0\n");
    const std::vector<std::vector<std::string>> lines = {
        {}, {"view"}, {INTERLEAF_FIVE_KEYS}, {folder / "mesh.off"}};
    for (const std::vector<std::string>& line : lines) {
        const Outcome outcome = run_interleaf(line);
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 3);
        CHECK(is_one_message(outcome.errors));
        CHECK(contains(outcome.errors, "no display"));
        CHECK(contains(outcome.errors, "interleaf render --at 0.3,0.4 -o a.png"));
    }
}

TEST_CASE("a display that cannot be opened is the machine's fault, too") {
    const Outcome outcome =
        run_interleaf({"view"}, {.standard_output = {}, .max_file_size = {}, .display = ":4711"});
    CAPTURE(outcome.errors);
    CHECK(outcome.status == 3);
    CHECK(is_one_message(outcome.errors));
    CHECK(contains(outcome.errors, "interleaf render"));
}

TEST_CASE("a full disk exits with 3, keeps the old file whole, and leaves nothing beside it") {
    const ScratchFolder folder;
    put(folder / "u.obj", "old");
    const Outcome outcome = run_interleaf({"export", "--time", "1", "-o", folder / "u.obj"},
                                          {.standard_output = {}, .max_file_size = 8192, .display = {}});
    CAPTURE(outcome.errors);
    CHECK(outcome.status == 3);
    CHECK(is_one_message(outcome.errors));
    CHECK(contains(outcome.errors, (folder / "u.obj").string()));
    CHECK(content(folder / "u.obj") == "old");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a failed write to standard output exits with 3") {
    const std::vector<std::vector<std::string>> lines = {
        {"--help"},         {"info", INTERLEAF_FIVE_KEYS},      {"check", INTERLEAF_FIVE_KEYS},
        {"make", "--list"}, {"make", "icosahedron", "-o", "-"}, {"export", "--format", "obj", "-o", "-"}};
    for (const std::vector<std::string>& line : lines) {
        CAPTURE(line[0]);
        const Outcome outcome =
            run_interleaf(line, {.standard_output = "/dev/full", .max_file_size = {}, .display = {}});
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 3);
        CHECK(is_one_message(outcome.errors));
        CHECK(contains(outcome.errors, "standard output"));
    }
}

TEST_CASE("a file that cannot be created exits with 3 and one message that names it") {
    const ScratchFolder folder;
    put(folder / "file", "");
    const std::vector<std::string> targets = {folder / "missing/a", folder / "file/a"};
    for (const std::string& target : targets) {
        const std::vector<std::vector<std::string>> lines = {
            {"render", "--size", "32x32", "-o", target + ".png"},
            {"export", "-o", target + ".obj"},
            {"make", "icosahedron", "-o", target + ".ilh"}};
        for (const std::vector<std::string>& line : lines) {
            CAPTURE(line[0]);
            const Outcome outcome = run_interleaf(line);
            CAPTURE(outcome.errors);
            CHECK(outcome.status == 3);
            CHECK(is_one_message(outcome.errors));
            CHECK(contains(outcome.errors, target));
        }
    }
    CHECK(run_interleaf({"make", "five-keys", "-o", folder / "file"}).status == 3);
}

}  // namespace
}  // namespace interleaf
