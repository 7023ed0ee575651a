// Imports on a separate thread: the result, a cancelled one, and the question for a tolerance.
#include "app/importing/import_job.h"

#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "app/storage/series_importing.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

/// A square of two triangles along one of its diagonals, with a field.
std::string square(bool is_other_diagonal) {
    return fmt::format(
        "# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
        "0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 2 8\n{}POINT_DATA 4\nSCALARS u double\n"
        "LOOKUP_TABLE default\n0 1 2 1\n",
        is_other_diagonal ? "3 0 1 3\n3 1 2 3\n" : "3 0 1 2\n3 0 2 3\n");
}

void wait_for(const std::function<bool()>& condition) {
    for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    REQUIRE(condition());
}

}  // namespace

TEST_CASE(
    "a job imports a series, and names its family after the first file, or the list without its endings") {
    const ScratchFolder folder;
    put(folder / "a.vtk", square(false));
    put(folder / "b.vtk", square(false));
    BackgroundJob<ImportedSeries> job(import_work({folder / "a.vtk", folder / "b.vtk"}, {}));
    wait_for([&] { return job.state().is_done; });
    const ImportedSeries imported = job.take();
    CHECK(imported.family.name == "a");
    CHECK(imported.family.keys.size() == 2);
    CHECK(sentences_of(imported.report).starts_with("2 steps over 1 roots, found by "));

    put(folder / "run.vtk.series",
        R"({"file-series-version": "1.0", "files": [{"name": "a.vtk", "time": 0}]})");
    BackgroundJob<ImportedSeries> listed(import_work({folder / "run.vtk.series"}, {}));
    wait_for([&] { return listed.state().is_done; });
    CHECK(listed.take().family.name == "run");
}

TEST_CASE("a job that is cancelled ends, and says so") {
    const ScratchFolder folder;
    std::vector<std::filesystem::path> files;
    for (int n = 0; n < 2000; ++n) files.emplace_back(folder / "a.vtk");
    put(folder / "a.vtk", square(false));
    BackgroundJob<ImportedSeries> job(import_work(files, {}));
    job.cancel();
    wait_for([&] { return job.state().is_done; });
    CHECK_THROWS_AS(job.take(), Cancelled);
}

TEST_CASE("the window asks for a tolerance where a series needs one") {
    const ScratchFolder folder;
    put(folder / "a.vtk", square(false));
    put(folder / "b.vtk", square(true));
    HeadlessGui gui({800, 600});
    const Rect area{0, 0, 800, 600};
    SeriesImporting importing;
    std::size_t keys = 0;
    std::optional<std::string> error;
    const auto frame = [&] {
        gui.begin_frame({0, 0}, false);
        importing.show(area, 0);
        gui.end_frame();
        if (const auto failed = importing.update(0)) error = failed;
    };
    importing.start(
        {folder / "a.vtk", folder / "b.vtk"}, {},
        [&](const ImportedSeries& imported, const ImportChoices&) { keys = imported.family.keys.size(); }, 0);
    wait_for([&] {
        frame();
        return !importing.is_working();
    });
    CHECK_FALSE(error);
    CHECK(keys == 0);
    CHECK(importing.is_open());  // the question
}
