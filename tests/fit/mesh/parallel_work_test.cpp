// Work on another thread: its result, its progress, and its end.
#include "fit/mesh/parallel_work.h"

#include <atomic>
#include <stdexcept>
#include <string_view>
#include <thread>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

/// Works until nobody wants its result any more.
int work_on(const Progress& progress, double part) {
    while (progress("working", part)) std::this_thread::yield();
    throw Cancelled();
}

}  // namespace

TEST_CASE("work on another thread brings its result, or what it throws") {
    ParallelWork<int> work([](const Progress&) { return 7; });
    CHECK(work.wait("waiting", {}) == 7);
    ParallelWork<int> failing([](const Progress&) -> int { throw std::runtime_error("no result"); });
    CHECK_THROWS_WITH_AS(failing.wait("waiting", {}), "no result", std::runtime_error);
}

TEST_CASE("waiting for work on another thread tells how far the work is, and can be cancelled") {
    ParallelWork<int> work([](const Progress& progress) { return work_on(progress, 0.25); });
    double told = 0;
    const Progress until_told = [&](std::string_view stage, double part) {
        CHECK(stage == "waiting");
        told = part;
        return part < 0.25;
    };
    CHECK_THROWS_AS(work.wait("waiting", until_told), Cancelled);
    CHECK(told == 0.25);
    CHECK_FALSE(work.is_done());
}

TEST_CASE("work on another thread ends before the object that began it is gone") {
    std::atomic<bool> has_begun = false;
    std::atomic<bool> has_ended = false;
    {
        const ParallelWork<int> work([&](const Progress& progress) {
            has_begun = true;
            try {
                return work_on(progress, 0);
            } catch (const Cancelled&) {
                has_ended = true;
                throw;
            }
        });
        while (!has_begun) std::this_thread::yield();
        CHECK_FALSE(has_ended);
    }
    CHECK(has_ended);
}
