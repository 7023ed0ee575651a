#include "io/file/file_pattern.h"

#include <algorithm>
#include <random>
#include <string>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>

namespace interleaf {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> names_of(const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) names.push_back(file.filename().string());
    return names;
}

/// Whether a pattern matches, by recursion over its first character.
bool matches_literally(std::string_view name, std::string_view pattern) {
    if (pattern.empty()) return name.empty();
    if (pattern.front() == '*')
        return matches_literally(name, pattern.substr(1)) ||
               (!name.empty() && matches_literally(name.substr(1), pattern));
    return !name.empty() && name.front() == pattern.front() &&
           matches_literally(name.substr(1), pattern.substr(1));
}

}  // namespace

TEST_CASE("files that differ only in numbers are a series") {
    CHECK(is_numbered_series({"flow.2.obj", "flow.10.obj"}));
    CHECK(is_numbered_series({"a/x9", "a/x10"}));
    CHECK_FALSE(is_numbered_series({"star.ilh", "bone.ilh"}));
    CHECK_FALSE(is_numbered_series({"flow.2.obj", "flow.b.obj"}));
}

TEST_CASE("a pattern stands for the files that match, in natural order") {
    const ScratchFolder folder;
    for (const char* name :
         {"flow.10.obj", "flow.2.obj", "flow.1.obj", "flow.obj", ".flow.3.obj", "flow.3.OBJ"})
        put(folder / name, "");
    fs::create_directory(folder / "flow.4.obj");
    CHECK(names_of(matching_files(folder / "flow.*.obj")) ==
          std::vector<std::string>{"flow.1.obj", "flow.2.obj", "flow.10.obj"});
    CHECK(names_of(matching_files(folder / "*1*.obj")) ==
          std::vector<std::string>{"flow.1.obj", "flow.10.obj"});
    CHECK(names_of(matching_files(folder / ".*")) == std::vector<std::string>{".flow.3.obj"});
    CHECK(matching_files("missing.obj") == std::vector<fs::path>{"missing.obj"});
    put(folder / "odd*.obj", "");
    put(folder / "odd1.obj", "");
    CHECK(names_of(matching_files(folder / "odd*.obj")) == std::vector<std::string>{"odd*.obj"});

    const auto error = [](const fs::path& path) { return input_error_of([&] { matching_files(path); }); };
    CHECK(error(folder / "no*.obj").ends_with("/no*.obj: no file matches"));
    CHECK(error(folder / "missing/*.obj").ends_with("/missing: there is no such folder"));
    CHECK(error(folder / "flow.1.obj/*").ends_with(": there is no such folder"));
    CHECK(
        error(folder / "m*/a.*.obj").ends_with("expected * only in the name of the file, not in its folder"));
}

TEST_CASE("a pattern matches the same files as its literal recursion") {
    std::mt19937 random(2);
    const ScratchFolder folder;
    std::vector<std::string> names;
    for (int n = 0; n < 30; ++n) {
        std::string name = "x";
        for (auto length = random() % 5; length > 0; --length) name += "ab"[random() % 2];
        put(folder / name, "");
        names.push_back(name);
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (int n = 0; n < 300; ++n) {
        std::string pattern = "x";
        for (auto length = random() % 5; length > 0; --length) pattern += "ab*"[random() % 3];
        if (pattern.find('*') == std::string::npos) continue;
        CAPTURE(pattern);
        std::vector<std::string> expected;
        for (const std::string& name : names)
            if (matches_literally(name, pattern)) expected.push_back(name);
        std::vector<std::string> found;
        if (expected.empty()) {
            REQUIRE(input_error_of([&] { matching_files(folder / pattern); }) != "");
        } else {
            found = names_of(matching_files(folder / pattern));
            std::ranges::sort(found);
            REQUIRE(found == expected);
        }
    }
}

TEST_CASE("a pattern with many asterisks takes little time") {
    const ScratchFolder folder;
    put(folder / std::string(200, 'a'), "");
    std::string pattern;
    for (int n = 0; n < 100; ++n) pattern += "*a";
    CHECK_FALSE(input_error_of([&] { matching_files(folder / (pattern + "b")); }).empty());
}

TEST_CASE("the path of all files is a pattern that matches them alone, or the first file") {
    const ScratchFolder folder;
    for (const char* const name :
         {"step-08.vtk", "step-09.vtk", "step-10.vtk", "a1b.obj", "a2b.obj", "a12b.obj"})
        put(folder / name, "");
    const auto path_of = [&](const std::vector<std::string>& names) {
        std::vector<fs::path> files;
        for (const std::string& name : names) files.push_back(folder / name);
        return path_of_all(files).filename().string();
    };
    CHECK(path_of({"step-08.vtk", "step-09.vtk", "step-10.vtk"}) == "step-*.vtk");
    CHECK(path_of({"a1b.obj", "a2b.obj", "a12b.obj"}) == "a*b.obj");
    CHECK(path_of({"step-08.vtk"}) == "step-08.vtk");
    CHECK(path_of({"step-08.vtk", "step-09.vtk"}) == "step-08.vtk");                 // not all that match
    CHECK(path_of({"step-10.vtk", "step-09.vtk", "step-08.vtk"}) == "step-10.vtk");  // another order
    CHECK(path_of({"step-08.vtk", "a1b.obj"}) == "step-08.vtk");
}

}  // namespace interleaf
