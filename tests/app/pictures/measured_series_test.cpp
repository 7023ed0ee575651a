// A series that is measured on a thread: new work begins at once for the window, whatever the thread does.
#include "app/pictures/measured_series.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

using Series = MeasuredSeries<std::vector<int>>;

/// The series when it is whole.
std::vector<int> whole(Series& series) {
    for (int i = 0; i < 1000; ++i) {
        const std::vector<int> now = series.series();
        if (!series.is_working()) return now;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("the series is not whole within ten seconds");
}

Series::Measure measure_of(int figure) {
    return [figure](const std::stop_token&, const Series::Publish& publish) {
        publish([&](std::vector<int>& figures) { figures.push_back(figure); });
    };
}

}  // namespace

TEST_CASE("new work does not wait for a piece in progress, and that piece is not shown") {
    std::atomic<bool> may_end = false;
    std::atomic<bool> is_stopped = false;
    Series series;
    series.begin([&](const std::stop_token& stop, const Series::Publish& publish) {
        while (!may_end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        is_stopped = stop.stop_requested();
        publish([](std::vector<int>& figures) { figures.push_back(1); });
    });
    series.begin(measure_of(2));
    series.begin(measure_of(3));
    CHECK(series.series().empty());
    CHECK(series.is_working());
    may_end = true;
    CHECK(whole(series) == std::vector<int>{3});
    CHECK(is_stopped);
}

TEST_CASE("cleared work leaves nothing, and does not wait either") {
    std::atomic<bool> may_end = false;
    Series series;
    series.begin([&](const std::stop_token&, const Series::Publish& publish) {
        while (!may_end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        publish([](std::vector<int>& figures) { figures.push_back(1); });
    });
    series.clear();
    CHECK_FALSE(series.is_working());
    may_end = true;
    CHECK(series.series().empty());
    series.begin(measure_of(2));
    CHECK(whole(series) == std::vector<int>{2});
}

TEST_CASE("work that throws ends the series where it is") {
    Series series;
    series.begin([](const std::stop_token&, const Series::Publish& publish) {
        publish([](std::vector<int>& figures) { figures.push_back(1); });
        throw std::runtime_error("too large");
    });
    CHECK(whole(series) == std::vector<int>{1});
}
