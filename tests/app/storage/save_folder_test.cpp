// Tests of the folder where saving starts.
#include "app/storage/save_folder.h"

#include "scratch_folder.h"
#include <doctest/doctest.h>

using namespace interleaf;

namespace fs = std::filesystem;

TEST_CASE(
    "saving begins beside the document, or where a person was last, or is; never among built-in families") {
    const ScratchFolder folder;
    for (const char* name : {"families", "families/five-keys", "work", "work/torus", "last", "current"})
        fs::create_directory(folder / name);
    for (const char* name : {"families/five-keys/family.json", "work/torus/family.json"})
        put(folder / name, "{}");
    fs::create_directory_symlink(folder / "families", folder / "link");

    SaveSurroundings around{.document = folder / "work" / "torus",
                            .last = folder / "last",
                            .current = folder / "current",
                            .builtin = folder / "families"};
    CHECK(folder_to_save_in(around) == folder / "work");
    around.document = folder / "families" / "five-keys";
    CHECK(folder_to_save_in(around) == folder / "last");
    around.document = folder / "link" / "five-keys";
    CHECK(folder_to_save_in(around) == folder / "last");
    around.document.reset();
    CHECK(folder_to_save_in(around) == folder / "last");
    // A family was opened from there last: the next family goes beside it.
    around.last = folder / "work" / "torus";
    CHECK(folder_to_save_in(around) == folder / "work");
    for (const fs::path& last : {fs::path(), folder / "families" / "five-keys", folder / "families"}) {
        around.last = last;
        CHECK(folder_to_save_in(around) == folder / "current");
    }
    for (const fs::path& current : {fs::path(), fs::path("/"), folder / "families"}) {
        around.current = current;
        CHECK(folder_to_save_in(around).empty());
    }
}
