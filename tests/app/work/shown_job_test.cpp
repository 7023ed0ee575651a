// Work on a separate thread with its progress in front of the window: the result, an error, and cancellation.
#include "app/work/shown_job.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <string_view>
#include <thread>

#include <doctest/doctest.h>

#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

constexpr Rect window_area{0, 0, 800, 600};

bool happens(const std::function<bool()>& condition) {
    for (int i = 0; i < 1000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

/// Work that goes on until it is released or cancelled.
struct HeldWork {
    std::atomic<bool> is_released = false;

    int operator()(const Progress& progress) {
        while (!is_released) {
            if (!progress("holding", 0.5)) throw Cancelled();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return 7;
    }
};

void show_frame(HeadlessGui& gui, ShownJob<int>& job, double now) {
    gui.begin_frame({0, 0}, false);
    job.show(window_area, now);
    gui.end_frame();
}

}  // namespace

TEST_CASE("work that is done before its progress is due shows none") {
    HeadlessGui gui({800, 600});
    ShownJob<int> job;
    CHECK_FALSE(job.is_working());
    CHECK_FALSE(job.is_over());
    job.start(
        "Work", [](const Progress&) { return 7; }, 0, 1);
    CHECK(job.is_working());
    REQUIRE(job.is_over_within(std::chrono::seconds(10)));
    show_frame(gui, job, 0.5);
    CHECK_FALSE(job.is_shown());
    CHECK(job.is_over());
    CHECK(job.take() == 7);
    CHECK_FALSE(job.is_working());
}

TEST_CASE("the result of work whose progress was shown is due when the progress has closed") {
    HeadlessGui gui({800, 600});
    HeldWork work;
    ShownJob<int> job;
    job.start(
        "Work", [&](const Progress& progress) { return work(progress); }, 0, 1);
    show_frame(gui, job, 0.5);
    CHECK_FALSE(job.is_shown());
    show_frame(gui, job, 1.5);
    CHECK(job.is_shown());
    work.is_released = true;
    job.wait();
    CHECK_FALSE(job.is_over());
    show_frame(gui, job, 1.6);
    REQUIRE(job.is_over());
    CHECK(job.take() == 7);
}

TEST_CASE("work that is cancelled says so, and an error arrives where the result is taken") {
    HeldWork work;
    ShownJob<int> job;
    job.start(
        "Work", [&](const Progress& progress) { return work(progress); }, 0, 1);
    job.cancel();
    REQUIRE(happens([&] { return job.is_over(); }));
    CHECK_THROWS_AS(job.take(), Cancelled);
    CHECK_FALSE(job.is_working());
    job.start(
        "Work", [](const Progress&) -> int { throw InputError("broken"); }, 0, 1);
    REQUIRE(happens([&] { return job.is_over(); }));
    CHECK_THROWS_WITH_AS(job.take(), "broken", InputError);
}
