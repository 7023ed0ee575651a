// Tests of the document's files without a window: opening, saving and questions.
#include "app/storage/document_files.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <random>
#include <string>
#include <thread>

#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "app/document/edit_commands.h"
#include "app/document/path_commands.h"
#include "app/environment.h"
#include "app/sample_family.h"
#include "app/window/commands.h"
#include "app/window/view_clipboard.h"
#include "hierarchy/adaptive_mesh.h"
#include "io/family/family_file.h"
#include "io/file/file_pattern.h"
#include "io/file/folder_lock.h"
#include "io/hierarchy/hierarchy_file.h"
#include "ui/browser/folder_listing.h"
#include "ui/headless_gui.h"

using namespace interleaf;

namespace fs = std::filesystem;

namespace {

/// The first root bisected, and what that takes.
Hierarchy bisected_key(const RootComplex& roots, const std::vector<glm::vec3>& corners) {
    std::vector<glm::vec3> positions = corners;
    AdaptiveMesh mesh(roots, corners, [&](Index a, Index b, Index) {
        positions.push_back(0.5F * (positions[a] + positions[b]));
        return positions.back();
    });
    mesh.refine({{Index{0}}});
    return mesh.freeze();
}

/// Whether \p condition is fulfilled within ten seconds.
bool comes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 1000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

/// Saves, and waits until that is done.
void save(DocumentFiles& files) {
    files.grant(FileWish::save);
    REQUIRE(comes_true([&] {
        files.look_after(0);
        return !files.is_saving();
    }));
}

/// Opens a document as the window does, on a worker, and waits until it is there.
void open_in_window(DocumentFiles& files, const fs::path& path) {
    files.open({path});
    REQUIRE(comes_true([&] {
        files.act(1, 0);
        return !files.is_asking();
    }));
}

/// A step of a series: a square of two triangles with a field.
std::string square_step() {
    return "# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
           "0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\nPOINT_DATA 4\nSCALARS u double\n"
           "LOOKUP_TABLE default\n0 1 2 1\n";
}

void change(ViewerState& state) {
    edit(
        state, "Rename", [](const Family&) { return named("changed"); }, 0);
}

}  // namespace

TEST_CASE("a document is saved where it was read from only if it is one family in a folder") {
    const ScratchFolder folder;
    fs::create_directory(folder / "torus");
    CHECK_FALSE(family_folder({folder / "torus"}));  // a folder of keys or meshes is no place of a family
    put(folder / "torus" / "family.json", "{}");
    CHECK(family_folder({folder / "torus"}) == folder / "torus");
    CHECK(family_folder({folder / "torus" / ""}) == folder / "torus");
    fs::create_directories(folder / "odd" / "family.json");
    CHECK_FALSE(family_folder({folder / "odd"}));
    put(folder / "odd" / "family.json" / "family.json", "{}");
    CHECK(family_folder({folder / "odd" / "family.json"}) == folder / "odd" / "family.json");
    CHECK(family_folder({folder / "torus" / "family.json"}) == folder / "torus");
    CHECK_FALSE(family_folder({}));
    CHECK_FALSE(family_folder({folder / "a.obj"}));
    CHECK_FALSE(family_folder({folder / "a.ilh", folder / "b.ilh"}));
    CHECK_FALSE(family_folder({folder / "torus", folder / "torus"}));
    CHECK(family_folder({"family.json"}) == fs::current_path());
}

TEST_CASE("opening replaces a document without changes, and what the window shows of it stays") {
    const ScratchFolder folder;
    write_family(named("second"), folder / "second");
    ViewerState state(named("first"));
    state.session.display.wireframe = !state.session.display.wireframe;
    state.help_shown = true;
    state.appearance.theme = Theme::light;
    const Display display = state.session.display;
    DocumentFiles files(state, {}, true);
    files.open({folder / "second"});
    CHECK_FALSE(files.is_asking());
    CHECK(state.document.family().name == "second");
    CHECK(state.document.folder() == folder / "second");
    CHECK_FALSE(state.document.is_changed());
    CHECK(state.document.undo_step() == nullptr);
    CHECK(state.session.display == display);
    CHECK(state.help_shown);
    CHECK(state.appearance.theme == Theme::light);
    CHECK(files.recent_files().front() == folder / "second");
}

TEST_CASE("files are opened in the order in which the browser lists them") {
    std::mt19937 random(3);
    std::vector<FolderEntry> entries;
    std::vector<fs::path> files;
    for (int i = 0; i < 400; ++i) {
        std::string name;
        for (auto size = 1 + random() % 6; size > 0; --size) name += "0017aAbB-._"[random() % 11];
        if (std::ranges::find(files, fs::path(name)) != files.end()) continue;
        files.emplace_back(name);
        entries.push_back({.name = name, .label = name, .order = NaturalName(name)});
    }
    sort_naturally(files);
    const auto shown = shown_entries(entries, {.type = {"All", {}}, .hidden = true}, {});
    REQUIRE(shown.size() == files.size());
    for (std::size_t i = 0; i < files.size(); ++i) CHECK(entries[shown[i]].name == files[i]);
}

TEST_CASE("files of any name make keys that can be saved") {
    const ScratchFolder folder;
    const std::string name = "a\u009b2J\n\xff.ilh";
    write_hierarchy(*named("first").keys.front().hierarchy, folder / name);
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    files.open({folder / name});
    CHECK(state.message.empty());
    CHECK(state.document.family().name == "a\\xc2\\x9b2J\\x0a\\xff");
    files.add_keys({folder / name}, 0);
    REQUIRE(state.document.family().keys.size() == 2);
    CHECK(state.selected_key == 1);  // what was added is shown, and has a place offered
    CHECK(state.session.weights() == Weights{{1, 1.0}});
    CHECK(state.message.text.find("has been added as the last key") != std::string::npos);
    CHECK_FALSE(state.message.is_fault());
    CHECK(state.message.offer == MessageOffer::timeline);
    write_family(state.document.family(), folder / "saved");
    CHECK(read_family(folder / "saved").keys[1].name == state.document.family().keys[1].name);
}

TEST_CASE("a folder of keys is opened and added as if they had been chosen together, and read again") {
    const ScratchFolder folder;
    write_family(named("second"), folder / "second");
    fs::remove(folder / "second" / "family.json");
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    files.open({folder / "second"});
    CHECK(state.message.empty());
    CHECK(state.document.family().keys.size() == 5);
    CHECK_FALSE(state.document.folder());
    CHECK(files.recent_files().front() == folder / "second");
    files.add_keys({folder / "second"}, 0);
    CHECK(state.document.family().keys.size() == 10);
    CHECK(state.message.text.find("5 keys have been added") != std::string::npos);
    CHECK(state.message.offer == MessageOffer::none);
    undo(state, 0);
    files.grant(FileWish::reopen);
    CHECK(state.document.family().keys.size() == 5);
    CHECK(state.document.undo_step() == nullptr);
}

TEST_CASE("a folder of meshes is offered to be fitted") {
    const ScratchFolder folder;
    fs::create_directory(folder / "meshes");
    for (const char* name : {"meshes/m2.off", "meshes/m10.off", "meshes/note.txt"})
        put(folder / name, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    files.open({folder / "meshes"});
    REQUIRE(files.fitting().offered() != nullptr);
    CHECK(files.fitting().offered()->choices().turns.size() == 2);
    CHECK(state.document.family().name == "first");
}

TEST_CASE("before changes are lost by opening, reading again or quitting, it asks, and nothing happens yet") {
    const ScratchFolder folder;
    write_family(named("second"), folder / "second");
    for (const FileWish wish : {FileWish::open, FileWish::reopen, FileWish::quit, FileWish::none}) {
        ViewerState state(named("first"));
        DocumentFiles files(state, {}, true);
        change(state);
        if (wish == FileWish::none) {
            files.open({folder / "second"});
        } else {
            files.grant(wish);
        }
        CHECK(files.is_asking());
        CHECK(state.document.family().name == "changed");
        CHECK(state.document.is_changed());
        CHECK_FALSE(state.quit_wanted);
    }
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    files.grant(FileWish::quit);
    CHECK_FALSE(files.is_asking());
    CHECK(state.quit_wanted);
}

TEST_CASE("a document with a folder is saved there at once, one without asks where") {
    const ScratchFolder folder;
    ViewerState state(named("first"), folder / "first");
    DocumentFiles files(state, {}, true);
    change(state);
    save(files);
    CHECK_FALSE(files.is_asking());
    CHECK(state.message.empty());
    CHECK_FALSE(state.document.is_changed());
    CHECK(read_family(folder / "first").name == "changed");
    undo(state, 0);
    CHECK(state.document.is_changed());

    ViewerState homeless(named("first"));
    DocumentFiles its_files(homeless, {}, true);
    its_files.grant(FileWish::save);
    CHECK(its_files.is_asking());
}

TEST_CASE("where it cannot be saved the document stays changed, and it says so") {
    const ScratchFolder folder;
    put(folder / "file", "in the way");
    ViewerState state(named("first"), folder / "file");
    DocumentFiles files(state, {}, true);
    change(state);
    save(files);
    CHECK_FALSE(state.message.empty());
    CHECK(state.document.is_changed());
    CHECK(content(folder / "file") == "in the way");
}

TEST_CASE("while it is saved the document can be edited, and what was edited meanwhile is not saved") {
    const ScratchFolder folder;
    fs::create_directory(folder / "first");
    ViewerState state(named("first"), folder / "first");
    DocumentFiles files(state, {}, true);
    change(state);
    std::optional<FolderLock> other(folder / "first");  // delays the save
    files.grant(FileWish::save);
    CHECK(files.is_saving());
    CHECK_FALSE(files.is_asking());
    files.look_after(10);
    CHECK(state.document.is_changed());
    edit(
        state, "Rename", [](const Family&) { return named("changed again"); }, 0);
    CHECK_FALSE(fs::exists(folder / "first" / "family.json"));
    other.reset();
    REQUIRE(comes_true([&] {
        files.look_after(0);
        return !files.is_saving();
    }));
    CHECK(state.message.empty());
    CHECK(read_family(folder / "first").name == "changed");
    CHECK(state.document.is_changed());
    undo(state, 0);
    CHECK_FALSE(state.document.is_changed());
    redo(state, 0);

    // Leaving the document waits for the save.
    files.grant(FileWish::save);
    files.grant(FileWish::quit);
    CHECK_FALSE(files.is_saving());
    CHECK_FALSE(files.is_asking());
    CHECK(state.quit_wanted);
    CHECK(read_family(folder / "first").name == "changed again");
}

TEST_CASE("what cannot be opened or added leaves the document as it is, and it says why") {
    const ScratchFolder folder;
    put(folder / "bad.ilh", "not a hierarchy");
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    const auto before = state.document.snapshot();
    for (const fs::path& file : {folder / "bad.ilh", folder / "none.ilh"}) {
        CAPTURE(file.string());
        files.open({file});
        CHECK(state.message.text.find(file.filename().string()) != std::string::npos);
        state.message.clear();
        files.add_keys({file}, 0);
        CHECK(state.message.text.find(file.filename().string()) != std::string::npos);
        state.message.clear();
        CHECK(state.document.snapshot() == before);
        CHECK(files.recent_files().empty());
    }
}

TEST_CASE("what goes wrong with the settings while another document is opened is still said") {
    const ScratchFolder folder;
    put(folder / "config", "in the way");
    const EnvironmentChange config("XDG_CONFIG_HOME", (folder / "config").string());
    const EnvironmentChange own("XDG_STATE_HOME", (folder / "state").string());
    write_family(named("second"), folder / "second");
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, false);
    CHECK(state.message.empty());
    open_in_window(files, folder / "second");
    CHECK(state.document.family().name == "second");
    CHECK(state.message.text.find((folder / "config").string()) != std::string::npos);
}

TEST_CASE("that an autosave cannot be removed is said, also when another document is opened meanwhile") {
    const ScratchFolder folder;
    const EnvironmentChange config("XDG_CONFIG_HOME", (folder / "config").string());
    const EnvironmentChange own("XDG_STATE_HOME", (folder / "state").string());
    write_family(named("second"), folder / "second");
    ViewerState state(named("first"), folder / "first");
    DocumentFiles files(state, {}, false);
    change(state);
    files.look_after(1);
    files.look_after(3);
    const fs::path all = folder / "state" / "interleaf" / "recovery";
    fs::path autosave;
    REQUIRE(comes_true([&] {
        if (!fs::exists(all) || fs::is_empty(all)) return false;
        autosave = fs::directory_iterator(all)->path();
        return fs::exists(autosave / "recovery.json");
    }));
    fs::remove(autosave / "family" / "family.json");
    fs::create_directories(autosave / "family" / "family.json" / "in the way");
    files.grant(FileWish::save);
    open_in_window(files, folder / "second");
    CHECK(state.document.family().name == "second");
    double now = 4;
    CHECK(comes_true([&] {
        files.look_after(++now);
        return state.message.text.find(autosave.string()) != std::string::npos;
    }));
}

TEST_CASE("the window goes on while files are read, and its document stays until they are whole") {
    const ScratchFolder folder;
    const EnvironmentChange config("XDG_CONFIG_HOME", (folder / "config").string());
    const EnvironmentChange own("XDG_STATE_HOME", (folder / "state").string());
    write_family(named("second"), folder / "second");
    write_family(named("third"), folder / "broken");
    put(folder / "broken" / "a.ilh", "no key");
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, false);
    const auto first = state.document.snapshot();
    open_in_window(files, folder / "broken");
    CHECK(state.document.snapshot() == first);
    CHECK(state.message.text.find("a.ilh") != std::string::npos);
    open_in_window(files, folder / "second");
    CHECK(state.document.family().name == "second");
    CHECK(files.recent_files().front() == folder / "second");
    CHECK_FALSE(files.is_working());
}

TEST_CASE("keys that do not match are kept with the message, and go with it") {
    const ScratchFolder folder;
    const RootComplex roots(4, {{0, 1, 2}, {2, 1, 3}});
    const RootComplex turned(4, {{1, 2, 0}, {2, 1, 3}});
    const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    write_hierarchy(bisected_key(roots, corners), folder / "a.ilh");
    write_hierarchy(bisected_key(turned, corners), folder / "b.ilh");

    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    const auto before = state.document.snapshot();
    files.open({folder / "a.ilh", folder / "b.ilh"});
    REQUIRE(state.message.mismatch);
    CHECK(state.message.text.find("refinement edge") != std::string::npos);
    CHECK(state.message.mismatch->key.name == "b");
    CHECK(state.message.mismatch->reference.name == "a");
    CHECK(state.message.mismatch->mismatch.root == 0);
    CHECK(state.document.snapshot() == before);
    files.open({folder / "none.ilh"});
    CHECK_FALSE(state.message.empty());
    CHECK(state.message.mismatch == nullptr);

    // The keys do not match those of the document either when they are added.
    files.add_keys({folder / "a.ilh"}, 0);
    REQUIRE(state.message.mismatch);
    CHECK(state.message.mismatch->key.name == "a 2");
    CHECK(state.message.mismatch->mismatch.kind == RootMismatch::Kind::counts);
    CHECK(state.document.snapshot() == before);
    state.message.clear();
    CHECK(state.message.mismatch == nullptr);
}

TEST_CASE("keys of a family are added to the document as a step of it") {
    const ScratchFolder folder;
    write_family(named("second"), folder / "second");
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    files.add_keys({folder / "second"}, 0);
    CHECK_FALSE(state.message.is_fault());
    CHECK(state.document.family().keys.size() == 10);
    CHECK(state.document.family().name == "first");
    CHECK(state.document.family().timeline == sample_family().timeline);
    REQUIRE(state.document.undo_step());
    CHECK(*state.document.undo_step() == "Add 5 keys");
}

TEST_CASE(
    "a file changed by others is reported once, in a while, and read again on demand; own saving is not") {
    const ScratchFolder folder;
    write_family(named("first"), folder / "first");
    ViewerState state(read_family(folder / "first"), folder / "first");
    DocumentFiles files(state, {folder / "first"}, true);
    change(state);
    save(files);
    files.look_after(10);
    CHECK(state.message.empty());

    write_family(named("other"), folder / "first");
    const fs::path file = folder / "first" / "family.json";
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(5));
    files.look_after(11);
    CHECK(state.message.empty());
    files.look_after(13);
    CHECK(state.message.text.find(file.string()) != std::string::npos);
    state.message.clear();
    files.look_after(20);
    CHECK(state.message.empty());
    files.grant(FileWish::reopen);
    CHECK(state.document.family().name == "other");
    CHECK(state.document.folder() == folder / "first");
    CHECK_FALSE(state.document.is_changed());
}

TEST_CASE("a series is opened again with the options of its import, also by a later program") {
    const ScratchFolder folder;
    const EnvironmentChange config("XDG_CONFIG_HOME", (folder / "config").string());
    const EnvironmentChange own("XDG_STATE_HOME", (folder / "state").string());
    for (int n = 0; n < 4; ++n) put(folder / ("step-" + std::to_string(n) + ".vtk"), square_step());
    const fs::path pattern = folder / "step-*.vtk";
    HeadlessGui gui({800, 600});
    const auto arrive = [&](DocumentFiles& files) {
        REQUIRE(comes_true([&] {
            gui.begin_frame({0, 0}, false);
            files.show({0, 0, 800, 600}, 0);
            gui.end_frame();
            files.act(1, 0);
            return !files.is_asking();
        }));
    };
    ViewerState state(named("first"));
    {
        DocumentFiles files(state, {}, false);
        files.open({pattern});
        arrive(files);
        CHECK(state.document.family().keys.size() == 4);
        CHECK(files.recent_files().front() == pattern);  // not one of the steps
        change_settings(*settings_file(),
                        [&](Settings& settings) { remember_series(settings, pattern, {.every = 2}); });
    }
    DocumentFiles files(state, {}, false);
    files.open_recent(0);
    arrive(files);
    CHECK(state.document.family().keys.size() == 2);
    const auto opened = state.document.snapshot();
    files.grant(FileWish::reopen);
    arrive(files);
    CHECK(state.document.snapshot() != opened);
    CHECK(state.document.family().keys.size() == 2);
    files.open({pattern});  // as new
    arrive(files);
    CHECK(state.document.family().keys.size() == 4);
    CHECK(files.settings().imports.empty());
}

TEST_CASE("a series that the command line has imported is remembered as a whole, keys as the first of them") {
    const ScratchFolder folder;
    const EnvironmentChange config("XDG_CONFIG_HOME", (folder / "config").string());
    const EnvironmentChange own("XDG_STATE_HOME", (folder / "state").string());
    std::vector<fs::path> steps, keys;
    for (int n = 0; n < 3; ++n) {
        put(steps.emplace_back(folder / ("step-" + std::to_string(n) + ".vtk")), square_step());
        put(keys.emplace_back(folder / ("key-" + std::to_string(n) + ".ilh")), "");
    }
    ViewerState state(named("first"));
    CHECK(DocumentFiles(state, steps, false).recent_files().front() == folder / "step-*.vtk");
    CHECK(DocumentFiles(state, {steps[1]}, false).recent_files().front() == steps[1]);
    CHECK(DocumentFiles(state, keys, false).recent_files().front() == keys[0]);
}

TEST_CASE("a theme of one run is not remembered, a chosen one is, and everything else of the window") {
    const ScratchFolder folder;
    const EnvironmentChange config("XDG_CONFIG_HOME", (folder / "config").string());
    const EnvironmentChange own("XDG_STATE_HOME", (folder / "state").string());
    write_family(named("second"), folder / "second");
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, false);
    state.appearance.theme = Theme::light;
    state.has_theme_of_run = true;
    state.appearance.text_scale = 1.5F;
    open_in_window(files, folder / "second");  // another document is still of this run
    files.remember_window({640, 480}, {});
    Appearance kept = load_settings(*settings_file()).settings.appearance;
    CHECK(kept.theme == Theme::dark);
    CHECK(kept.text_scale == 1.5F);
    state.has_theme_of_run = false;
    files.remember_window({640, 480}, {});
    CHECK(load_settings(*settings_file()).settings.appearance.theme == Theme::light);
}

TEST_CASE("a family is saved with its own choice of what drives, not with that of one run") {
    const ScratchFolder folder;
    Family family = named("first");
    family.path = DomainPath({{0, {-1, -1}}, {4, {1, 1}}});
    family.time_source = TimeSource::keys;
    ViewerState state(std::move(family), folder / "first");
    DocumentFiles files(state, {}, true);
    drive_in_this_run(state, TimeSource::path, 0);
    save(files);
    CHECK(read_family(folder / "first").time_source == TimeSource::keys);
    CHECK(path_drives(state));
    choose_time_source(state, TimeSource::keys, 0);
    undo(state, 0);
    save(files);
    CHECK(read_family(folder / "first").time_source == TimeSource::keys);
    choose_time_source(state, TimeSource::keys, 0);
    choose_time_source(state, TimeSource::path, 0);
    save(files);
    CHECK(read_family(folder / "first").time_source == TimeSource::path);
}

TEST_CASE("the axis of a view is not remembered as the one that points up, a chosen axis is") {
    const ScratchFolder folder;
    const EnvironmentChange config("XDG_CONFIG_HOME", (folder / "config").string());
    const EnvironmentChange own("XDG_STATE_HOME", (folder / "state").string());
    const auto remembered = [] { return load_settings(*settings_file()).settings.up; };
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, false);
    command_of(CommandId::z_up).run(state, 0);
    CHECK(state.camera.up == UpAxis::z);
    files.remember_window({640, 480}, {});
    CHECK(remembered() == UpAxis::z);
    take_viewpoint(state, parse_viewpoint("30,20"));
    CHECK(state.camera.up == UpAxis::y);
    files.remember_window({800, 600}, {});
    CHECK(remembered() == UpAxis::z);
    ViewerState later(named("first"));
    const DocumentFiles of_later(later, {}, false);
    CHECK(later.camera.up == UpAxis::z);
}

TEST_CASE("quitting asks while a film is in the making") {
    ViewerState state(named("first"));
    DocumentFiles files(state, {}, true);
    state.makes_film = true;
    files.grant(FileWish::quit);
    CHECK(files.is_asking());
    CHECK_FALSE(state.quit_wanted);
}
