// Tests of the settings: they survive a round trip, and no file can do harm.
#include "app/storage/settings.h"

#include <algorithm>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <sys/stat.h>

#include "app/environment.h"
#include "app/storage/import_settings.h"
#include "app/storage/user_folders.h"

using namespace interleaf;

namespace fs = std::filesystem;

namespace {

Settings sample_settings() {
    return {.recent_files = {"/a/five keys/family.json", "/b/sphere.ilh"},
            .recent_folders = {"/a/five keys", "/b"},
            .imports = {{"/b/sphere.ilh",
                         {.tolerance = 0.01,
                          .newest = 2U,
                          .fields = {"u", "p"},
                          .displacement = "v",
                          .warp = ChosenWarp{"u", -0.5},
                          .every = 3,
                          .roots = "/b/roots.ilh"}}},
            .last_folder = "/b/ä",
            .window_size = glm::ivec2(1280, 800),
            .appearance = {.theme = Theme::light,
                           .text_scale = 1.25F,
                           .panels = {.left = 300, .right = std::nullopt, .timeline = 200},
                           .closed_sections = {"Lines", "Weights"}},
            .trackball = true,
            .axes = false,
            .up = UpAxis::z,
            .shortcuts = {{"Play", "K or Space"}, {"no command", "no key"}}};
}

std::string error_of(std::string_view json) {
    return input_error_of([&] { parse_settings(json, "FILE"); });
}

}  // namespace

TEST_CASE("settings that are written come back") {
    const ScratchFolder folder;
    const fs::path file = folder / "new/folder/settings.json";
    change_settings(file, [](Settings& settings) { settings = sample_settings(); });
    const LoadedSettings loaded = load_settings(file);
    CHECK(loaded.settings == sample_settings());
    CHECK(loaded.message.empty());
}

TEST_CASE("a change keeps what another program has written meanwhile") {
    const ScratchFolder folder;
    const fs::path file = folder / "settings.json";
    change_settings(file, [](Settings& settings) { remember(settings.recent_files, "/first"); });
    change_settings(file, [](Settings& settings) { settings.window_size = {640, 480}; });
    change_settings(file, [](Settings& settings) { remember(settings.recent_files, "/second"); });
    const Settings settings = load_settings(file).settings;
    CHECK(settings.recent_files == std::vector<fs::path>{"/second", "/first"});
    CHECK(settings.window_size == glm::ivec2(640, 480));
}

TEST_CASE("without a file the settings are the defaults, silently") {
    const ScratchFolder folder;
    const LoadedSettings loaded = load_settings(folder / "settings.json");
    CHECK(loaded.settings == Settings{});
    CHECK(loaded.message.empty());
    CHECK(folder.entry_count() == 0);
}

TEST_CASE("what is remembered comes first, once, and the oldest goes") {
    std::vector<fs::path> recent;
    for (int i = 0; i < 20; ++i) remember(recent, "/file" + std::to_string(i));
    REQUIRE(recent.size() == max_recent_paths);
    CHECK(recent.front() == "/file19");
    CHECK(recent.back() == "/file8");
    remember(recent, "/x/../file10/");
    remember(recent, "/file10");
    CHECK(recent.front() == "/file10");
    CHECK(std::ranges::count(recent, fs::path("/file10")) == 1);
    // The path is an element of the list itself.
    remember(recent, recent.back());
    CHECK(recent.size() == max_recent_paths);
}

TEST_CASE("however its path is written, a document is remembered once, as it was written last") {
    const ScratchFolder folder;
    fs::create_directory(folder / "torus");
    put(folder / "torus" / "family.json", "{}");
    fs::create_directory_symlink(folder / "torus", folder / "link");
    std::vector<fs::path> recent;
    const fs::path slash = folder / "torus" / "";
    for (const fs::path& path : {folder / "torus" / "family.json", slash, folder / "link",
                                 folder / "link" / "family.json", folder / "x" / ".." / "torus"}) {
        CAPTURE(path);
        remember_document(recent, path);
        CHECK(recent.size() == 1);
    }
    CHECK(recent.front() == folder / "torus");
    remember_document(recent, folder / "link" / "family.json");
    CHECK(recent == std::vector<fs::path>{folder / "link"});
    remember_document(recent, folder / "key.ilh");
    CHECK(recent.size() == 2);
    // The list holds an unresolved path from an older version.
    recent.push_back(folder / "torus" / "family.json");
    remember_document(recent, folder / "torus");
    CHECK(recent == std::vector<fs::path>{folder / "torus", folder / "key.ilh"});
}

TEST_CASE("a relative path is remembered as an absolute one") {
    std::vector<fs::path> recent;
    remember(recent, "file");
    CHECK(recent.front() == fs::current_path() / "file");
}

TEST_CASE("members that are not known are passed over, lists are cut and made unique") {
    CHECK(parse_settings(R"({"future": [1, {"x": null}]})", "FILE") == Settings{});
    std::string files;
    for (int i = 0; i < 30; ++i) files += R"("/same", "/f)" + std::to_string(i) + "\", ";
    const Settings settings = parse_settings("{\"recent files\": [" + files + "\"/end\"]}", "FILE");
    REQUIRE(settings.recent_files.size() == max_recent_paths);
    CHECK(settings.recent_files[0] == "/same");
    CHECK(settings.recent_files[2] == "/f1");
}

TEST_CASE("damage is named with its place") {
    CHECK(error_of("").starts_with("FILE: parse error"));
    CHECK(error_of("[]") == "FILE: document: is an array, expected an object");
    CHECK(error_of(R"({"recent files": 3})") == "FILE: recent files: is 3, expected an array");
    CHECK(error_of(R"({"recent files": ["/a", 3]})") == "FILE: recent files[1]: is 3, expected a text");
    CHECK(error_of(R"({"recent folders": ["a"]})") ==
          "FILE: recent folders[0]: is \"a\", expected an absolute path");
    CHECK(error_of("{\"last folder\": \"/a\\u0000b\"}").ends_with("expected an absolute path"));
    CHECK(error_of(R"({"appearance": {"theme": "pink"}})") ==
          "FILE: appearance.theme: is \"pink\", expected \"dark\" or \"light\"");
    CHECK(error_of(R"({"appearance": {"text size": 40}})") ==
          "FILE: appearance.text size: is 40, expected a number from 0.75 to 2");
    CHECK(error_of(R"({"appearance": {"panels": {"left": -1}}})")
              .ends_with("expected a number from 0 to 32768"));
    CHECK(error_of(R"({"appearance": {"closed": [1]}})").ends_with("expected a text"));
    CHECK(error_of(R"({"window": {"width": 640}})") == "FILE: window: has no \"height\"");
    for (const char* size : {"0", "-1", "1e9", "40000", "1.5", "\"640\"", "null"}) {
        CAPTURE(size);
        CHECK(error_of(std::string(R"({"window": {"height": 480, "width": )") + size + "}}")
                  .starts_with("FILE: window.width: is "));
    }
    CHECK(
        error_of(std::string((1 << 20) + 1, ' ')).starts_with("FILE: size: 1048577 bytes, expected at most"));
    CHECK_FALSE(error_of(std::string(1 << 20, '[')).empty());
    CHECK_FALSE(error_of("{\"last folder\": \"/\xff\"}").empty());
}

TEST_CASE("a damaged file gives the defaults and one message, and is kept") {
    const ScratchFolder folder;
    const fs::path file = folder / "settings.json";
    put(file, "{\"recent files\": [\"/a\"");
    const LoadedSettings loaded = load_settings(file);
    CHECK(loaded.settings == Settings{});
    CHECK(loaded.message.starts_with(file.string() + ": parse error"));
    CHECK(loaded.message.ends_with("the file is kept as settings.json.damaged"));
    CHECK(content(folder / "settings.json.damaged") == "{\"recent files\": [\"/a\"");
    CHECK(load_settings(file).message.empty());
    change_settings(file, [](Settings& settings) { settings = sample_settings(); });
    CHECK(load_settings(file).settings == sample_settings());
    CHECK(content(folder / "settings.json.damaged") == "{\"recent files\": [\"/a\"");
}

TEST_CASE("what is no file at all does no harm either") {
    const ScratchFolder folder;
    const fs::path file = folder / "settings.json";
    SUBCASE("a folder") {
        fs::create_directory(file);
    }
    SUBCASE("a pipe without a writer") {
        REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
    }
    SUBCASE("a link to nothing") {
        fs::create_symlink("nowhere", file);
    }
    SUBCASE("a file too large") {
        put(file, "{}");
        fs::resize_file(file, std::uintmax_t{1} << 40);
    }
    const LoadedSettings loaded = load_settings(file);
    CHECK(loaded.settings == Settings{});
    CHECK_FALSE(loaded.message.empty());
    change_settings(file, [](Settings& settings) { settings = sample_settings(); });
    CHECK(load_settings(file).settings == sample_settings());
}

TEST_CASE("a path that is not UTF-8 is not remembered, the others are") {
    const ScratchFolder folder;
    const fs::path file = folder / "settings.json";
    change_settings(file, [](Settings& settings) {
        settings.recent_files = {"/a", "/\xff", "/b"};
        settings.last_folder = "/\xff";
    });
    const Settings settings = load_settings(file).settings;
    CHECK(settings.recent_files == std::vector<fs::path>{"/a", "/b"});
    CHECK(settings.last_folder.empty());
}

TEST_CASE("settings that cannot be written say so") {
    const ScratchFolder folder;
    put(folder / "file", "");
    const fs::path file = folder / "file/settings.json";
    CHECK(machine_error_of([&] { change_settings(file, [](Settings&) {}); }).starts_with(file.string()));
}

TEST_CASE("the folders follow the XDG specification, and are none where nothing says where") {
    const EnvironmentChange config("XDG_CONFIG_HOME", "/c");
    const EnvironmentChange state("XDG_STATE_HOME", "/s");
    const EnvironmentChange home("HOME", "/h");
    CHECK(settings_file() == fs::path("/c/interleaf/settings.json"));
    CHECK(state_folder() == fs::path("/s/interleaf"));

    // The specification demands that relative paths are ignored. Empty counts as unset.
    const EnvironmentChange relative_config("XDG_CONFIG_HOME", "c");
    const EnvironmentChange empty_state("XDG_STATE_HOME", "");
    CHECK(settings_file() == fs::path("/h/.config/interleaf/settings.json"));
    CHECK(state_folder() == fs::path("/h/.local/state/interleaf"));

    const EnvironmentChange no_home("HOME", std::nullopt);
    CHECK_FALSE(settings_file());
    CHECK_FALSE(state_folder());
}

TEST_CASE(
    "the options of a series are kept as long as the series is recent and they are not the usual ones") {
    const ScratchFolder folder;
    const fs::path file = folder / "settings.json";
    const auto remember_now = [&](const char* series, const ImportChoices& choices) {
        change_settings(file, [&](Settings& settings) { remember_series(settings, series, choices); });
        return load_settings(file).settings;
    };
    CHECK(remember_now("/run.pvd", {.every = 2}).imports.at("/run.pvd").every == 2);
    CHECK(remember_now("/run.pvd", {}).imports.empty());
    CHECK(remember_now("/run.pvd", {.every = 3}).imports.size() == 1);
    change_settings(file, [](Settings& settings) {
        for (std::size_t n = 0; n < max_recent_paths; ++n)
            remember(settings.recent_files, "/other" + std::to_string(n));
    });
    CHECK(load_settings(file).settings.imports.empty());
}

TEST_CASE("options of a series that no import has are dropped, and all other settings stay") {
    for (const char* const choices : {R"({"every": 0})", R"({"every": 4294967295})", R"({"newest": 3})",
                                      R"({"tolerance": 2})", R"({"warp": "u"})", "3"}) {
        CAPTURE(choices);
        const Settings settings =
            parse_settings(R"({"recent files": ["/a.pvd", "/run.pvd"], "imports": {"/run.pvd": )" +
                               std::string(choices) + R"(, "/a.pvd": {"every": 3}}})",
                           "FILE");
        CHECK(settings.recent_files.size() == 2);
        REQUIRE(settings.imports.size() == 1);
        CHECK(settings.imports.at("/a.pvd").every == 3);
    }
}

TEST_CASE("options of a series that are no UTF-8 are left out, and the others are kept") {
    const ScratchFolder folder;
    const fs::path file = folder / "settings.json";
    const ImportChoices choices{.tolerance = 0.01,
                                .fields = {"u\xff", "p"},
                                .displacement = "v\xff",
                                .warp = ChosenWarp{"u\xff", 2},
                                .every = every_limit - 1,
                                .roots = "/b/\xff.ilh"};
    change_settings(file, [&](Settings& settings) { remember_series(settings, "/run.pvd", choices); });
    CHECK(load_settings(file).settings.imports.at("/run.pvd") ==
          ImportChoices{.tolerance = 0.01, .fields = {"p"}, .every = every_limit - 1});
}
