// Tests of typed paths: their meaning, and their completion by Tab.
#include "ui/browser/typed_path.h"

#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "ui/browser/breadcrumbs.h"

using namespace interleaf;

namespace fs = std::filesystem;

namespace {

std::string meant(std::string_view text) {
    return typed_path(text, "/seen/here", "/home/anna").string();
}

}  // namespace

TEST_CASE("a typed path is relative to the shown folder, and ~ is the home folder") {
    CHECK(meant("a.ilh") == "/seen/here/a.ilh");
    CHECK(meant("./b/../a.ilh") == "/seen/here/a.ilh");
    CHECK(meant("..") == "/seen");
    CHECK(meant("../../../..") == "/");
    CHECK(meant("/") == "/");
    CHECK(meant("/x//y/") == "/x/y");
    CHECK(meant("~") == "/home/anna");
    CHECK(meant("~/a/") == "/home/anna/a");
    CHECK(meant("a~") == "/seen/here/a~");
    CHECK(meant("flow.*.obj") == "/seen/here/flow.*.obj");
    CHECK(meant(".") == "/seen/here");
}

TEST_CASE("blanks and quotation marks around a pasted path are ignored") {
    CHECK(meant("  /a b/c \n") == "/a b/c");
    CHECK(meant("'/a b/c'") == "/a b/c");
    CHECK(meant("\"~/c\"") == "/home/anna/c");
    CHECK(meant("'a") == "/seen/here/'a");
    CHECK(meant("   ") == "/seen/here");
}

TEST_CASE("Tab completes as far as the names agree") {
    const ScratchFolder folder;
    for (const char* name :
         {"flow.1.ilh", "flow.12.ilh", "Sphere.ilh", ".secret", "käse", "käfer", "odd\xff"})
        put(folder / name, "");
    fs::create_directories(folder / "inner/deep");
    const auto complete = [&](std::string_view text) {
        return completed_path(text, folder.path(), folder / "inner").text;
    };
    CHECK(complete("f") == "flow.1");
    CHECK(complete("flow.1") == "flow.1");
    CHECK(complete("flow.12") == "flow.12.ilh");
    CHECK(complete("sph") == "Sphere.ilh");
    CHECK(complete("FLOW") == "flow.1");
    CHECK(complete("i") == "inner/");
    CHECK(complete("inner/") == "inner/deep/");
    CHECK(complete("~") == "~/");
    CHECK(complete("~/d") == "~/deep/");
    CHECK(complete("./inner/d") == "./inner/deep/");
    CHECK(complete(".s") == ".secret");
    CHECK(complete("x") == "x");
    CHECK(complete("missing/x") == "missing/x");
    // The completion is cut between characters: the two names differ after the a umlaut.
    CHECK(complete("k") == "kä");
    CHECK(complete("odd") == "odd");
    CHECK(complete((folder / "Sph").string()) == (folder / "Sphere.ilh").string());
    CHECK(completed_path("flow.1", folder.path(), "/").names == 2);
    CHECK(completed_path("x", folder.path(), "/").names == 0);
}

TEST_CASE("a character is not cut where names share only its first bytes") {
    const ScratchFolder folder;
    put(folder / "aä", "");
    put(folder / "aö", "");
    CHECK(completed_path("a", folder.path(), "/").text == "a");
}

TEST_CASE("names that differ in case keep the typed text") {
    const ScratchFolder folder;
    put(folder / "Flow", "");
    put(folder / "fLow", "");
    CHECK(completed_path("flo", folder.path(), "/").text == "flo");
}

TEST_CASE("the path to a folder begins at the root") {
    CHECK(folders_on_the_way("/a/b c") == std::vector<fs::path>{"/", "/a", "/a/b c"});
    CHECK(folders_on_the_way("/") == std::vector<fs::path>{"/"});
}
