// Exports on a separate thread, without a window.
#include "app/storage/family_export.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "messages.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "app/sample_family.h"

using namespace interleaf;

namespace {

/// What an export says in the end; waits at most ten seconds.
std::optional<Message> result_of(FamilyExport& exporting) {
    for (int i = 0; i < 1000; ++i) {
        if (auto message = exporting.take_result(5)) return message;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("an export that has ended says what was written, and where") {
    const ScratchFolder folder;
    FamilyExport exporting;
    CHECK_FALSE(exporting.is_working());
    exporting.begin(std::make_shared<const Family>(sample_family()), {{0, 1}}, folder / "a.glb", 0);
    CHECK(exporting.is_working());
    const auto message = result_of(exporting);
    REQUIRE(message);
    CHECK_FALSE(exporting.is_working());
    CHECK_FALSE(message->is_fault());
    CHECK(contains(message->text, "Exported a.glb in " + folder.path().string()));
    CHECK(std::filesystem::exists(folder / "a.glb"));
}

TEST_CASE("an export is cancelled, or has just ended, and a failed one is a fault") {
    const ScratchFolder folder;
    FamilyExport exporting;
    exporting.begin(std::make_shared<const Family>(sample_family()), {{0, 1}}, folder / "a.pvd", 0);
    exporting.cancel();
    const auto message = result_of(exporting);
    REQUIRE(message);
    CHECK_FALSE(message->is_fault());
    CHECK(contains(message->text, std::filesystem::exists(folder / "a.pvd") ? "Exported" : "cancelled"));

    exporting.begin(std::make_shared<const Family>(sample_family()), {{0, 1}}, folder / "none" / "a.glb", 0);
    const auto fault = result_of(exporting);
    REQUIRE(fault);
    CHECK(fault->is_fault());
    CHECK(contains(fault->text, "a.glb"));
}
