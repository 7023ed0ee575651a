// Tests of the folder in which landmark files are looked for.
#include "app/landmarks/landmark_files.h"

#include <doctest/doctest.h>

using namespace interleaf;

namespace fs = std::filesystem;

TEST_CASE("landmark files are looked for beside their mesh, or else where the last one was") {
    CHECK(folder_of({.index = 0, .name = "rod", .file = "/meshes/rod.obj"}, "/last") == "/meshes");
    CHECK(folder_of({.index = 0, .name = "rod", .file = "rod.obj"}, "/last") == fs::current_path());
    CHECK(folder_of({.index = 0, .name = "key", .file = {}}, "/last") == "/last");
}
