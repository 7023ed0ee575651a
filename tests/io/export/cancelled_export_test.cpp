// The progress of exports of whole families, and their cancellation.
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "io/export/export.h"
#include "io/formats.h"
#include "io/samples.h"

namespace interleaf {
namespace {

/// A family whose timeline passes all keys.
Family moving_family() {
    std::mt19937 random(31);
    Family family = sample_family(random);
    family.timeline = Timeline({{0, 0}, {1, 1}, {2, 2}});
    return family;
}

std::size_t file_count(const ScratchFolder& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path()),
                                                  std::filesystem::directory_iterator()));
}

/// Whether \p format holds one blend: it cannot be written where none is chosen.
bool needs_blend(const Format& format, const Family& family) {
    const ScratchFolder folder;
    try {
        format.write({.family = family, .weights = std::nullopt},
                     {folder.path() / ("a" + std::string(format.extension))});
        return false;
    } catch (const UsageError& error) {
        CHECK(error.what() == std::string(no_default_blend));
        return true;
    }
}

}  // namespace

TEST_CASE("the progress of an export rises, and an export that is cancelled at any report leaves no file") {
    const Family family = moving_family();
    std::size_t whole_family_formats = 0;
    for (const Format& format : formats()) {
        if (!format.is_exported() || needs_blend(format, family)) continue;
        ++whole_family_formats;
        for (const bool segments : {false, true}) {
            CAPTURE(format.extension);
            CAPTURE(segments);
            const auto reports_of = [&](const ScratchFolder& folder, int cancelled_report) {
                int reports = 0;
                double last = 0;
                format.write({.family = family,
                              .weights = std::nullopt,
                              .segments = segments,
                              .progress =
                                  [&](std::string_view stage, double part) {
                                      CHECK_FALSE(stage.empty());
                                      CHECK(part >= last);
                                      CHECK(part <= 1);
                                      last = part;
                                      return reports++ != cancelled_report;
                                  }},
                             {folder.path() / ("a" + std::string(format.extension))});
                return reports;
            };
            const ScratchFolder whole;
            const int reports = reports_of(whole, std::numeric_limits<int>::max());
            CHECK(reports >= 3);
            CHECK(file_count(whole) >= 1);
            for (int report = 0; report < reports; ++report) {
                const ScratchFolder folder;
                CHECK_THROWS_AS(reports_of(folder, report), Cancelled);
                CHECK(file_count(folder) == 0);
            }
        }
    }
    CHECK(whole_family_formats >= 3);
}

}  // namespace interleaf
