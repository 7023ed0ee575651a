// A series of figures that a thread measures piece by piece, while the window shows the pieces that are there.
#pragma once

#include <exception>
#include <functional>
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

    /// Ends the present work, and begins anew with an empty series.
    void begin(Measure measure) {
        clear();
        is_taken_ = is_over_ = false;
        thread_ = std::jthread([this, measure = std::move(measure)](const std::stop_token& stop) {
            try {
                measure(stop, [this](const auto& change) {
                    const std::scoped_lock lock(mutex_);
                    change(measured_);
                });
            } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
                // The series ends here, such as at a blend that is too large to measure. Without it the window
                // still shows everything else.
            }
            const std::scoped_lock lock(mutex_);
            is_over_ = true;
        });
    }

    /// Ends the present work. The series is empty.
    void clear() {
        thread_ = {};
        series_ = measured_ = {};
        is_taken_ = is_over_ = true;
    }

    /// The series as far as it is measured.
    const Figures& series() {
        if (is_taken_) return series_;
        const std::scoped_lock lock(mutex_);
        series_ = measured_;
        is_taken_ = is_over_;
        return series_;
    }

    /// Whether series() has not returned the whole series yet.
    bool is_working() const { return !is_taken_; }

  private:
    Figures series_{};
    bool is_taken_ = true;  ///< whether series_ is all that can be measured

    std::mutex mutex_;  ///< guards the members below
    Figures measured_{};
    bool is_over_ = true;

    std::jthread thread_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
