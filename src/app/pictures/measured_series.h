// A series of figures that a thread measures piece by piece, while the window shows the pieces that are there. The
// window never waits for the thread.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace interleaf {

/// \tparam Figures  copyable; its default is the empty series
template <typename Figures>
class MeasuredSeries {
  public:
    /// Changes the series that the window will see.
    using Publish = std::function<void(const std::function<void(Figures&)>& change)>;

    /// Measures until it is done or asked to stop.
    using Measure = std::function<void(const std::stop_token& stop, const Publish& publish)>;

    MeasuredSeries() = default;
    MeasuredSeries(const MeasuredSeries&) = delete;
    MeasuredSeries& operator=(const MeasuredSeries&) = delete;
    ~MeasuredSeries() = default;

    /// Gives up the present work, and begins anew with an empty series. The new work begins when the thread has left
    /// the old one, at a later call of series() if need be: two at once would take twice the memory.
    void begin(Measure measure) {
        clear();
        is_taken_ = false;
        next_ = std::move(measure);
        start_next();
    }

    /// Gives up the present work. The series is empty.
    void clear() {
        thread_.request_stop();
        next_ = nullptr;
        shown_ = nullptr;
        series_ = {};
        is_taken_ = true;
    }

    /// The series as far as it is measured.
    const Figures& series() {
        start_next();
        if (is_taken_ || !shown_) return series_;
        const std::scoped_lock lock(shown_->mutex);
        series_ = shown_->measured;
        is_taken_ = shown_->is_over;
        return series_;
    }

    /// Whether series() has not returned the whole series yet.
    bool is_working() const { return !is_taken_; }

  private:
    /// What one work shares with the window.
    struct Work {
        std::mutex mutex;  ///< guards the members below
        Figures measured{};
        bool is_over = false;
    };

    /// Starts the work that waits, if there is one, once the thread is free.
    void start_next() {
        if (!next_ || is_busy()) return;
        shown_ = running_ = std::make_shared<Work>();
        thread_ = std::jthread(
            [work = running_, measure = std::exchange(next_, nullptr)](const std::stop_token& stop) {
                try {
                    measure(stop, [&work](const auto& change) {
                        const std::scoped_lock lock(work->mutex);
                        change(work->measured);
                    });
                } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
                    // The series ends here, such as at a blend that is too large to measure. Without it the window
                    // still shows everything else.
                }
                const std::scoped_lock lock(work->mutex);
                work->is_over = true;
            });
    }

    bool is_busy() const {
        if (!running_) return false;
        const std::scoped_lock lock(running_->mutex);
        return !running_->is_over;
    }

    Figures series_{};
    bool is_taken_ = true;           ///< whether series_ is all that can be measured
    Measure next_;                   ///< waits for the thread; null for none
    std::shared_ptr<Work> running_;  ///< what the thread does; null before the first work
    std::shared_ptr<Work> shown_;    ///< the same unless it was given up; null for none
    std::jthread thread_;
};

}  // namespace interleaf
