// Work on another thread, beside that of the thread which needs the result.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <string_view>
#include <utility>

#include "hierarchy/progress.h"

namespace interleaf {

/// The work ends soon if nobody wants its result any more.
template <typename Result>
class ParallelWork {
  public:
    using Work = std::function<Result(const Progress& progress)>;

    /// Begins the work, on another thread; where none can be had, wait() does it. What it uses must outlive this object.
    explicit ParallelWork(Work work)
        : work_(std::move(work)),
          result_(std::async(std::launch::async | std::launch::deferred, [this] { return work_(told_); })) {}

    /// Ends the work, and waits until it has ended.
    ~ParallelWork() { is_dropped_ = true; }
    ParallelWork(const ParallelWork&) = delete;
    ParallelWork& operator=(const ParallelWork&) = delete;

    bool is_done() const { return status_after(std::chrono::milliseconds(0)) == std::future_status::ready; }

    /// Waits for the result, and reports meanwhile how far the work is, as \p stage. To be called once.
    /// \throw Cancelled  if progress says so
    /// \throw ...        what the work throws
    Result wait(std::string_view stage, const Progress& progress) {
        constexpr std::chrono::milliseconds between_reports(20);
        std::future_status status = status_after(between_reports);
        if (status == std::future_status::deferred) return work_(progress);
        for (; status != std::future_status::ready; status = status_after(between_reports))
            if (progress && !progress(stage, part_)) throw Cancelled();
        return result_.get();
    }

  private:
    std::future_status status_after(std::chrono::milliseconds time) const { return result_.wait_for(time); }

    const Work work_;
    std::atomic<bool> is_dropped_ = false;
    std::atomic<double> part_ = 0;  ///< of the work that is done
    const Progress told_ = [this](std::string_view, double part) {
        part_ = part;
        return !is_dropped_;
    };
    std::future<Result> result_;  ///< last member: its destructor waits for work that uses the others
};

}  // namespace interleaf
