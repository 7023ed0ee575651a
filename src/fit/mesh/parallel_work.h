// Work on another thread, beside that of the thread which needs the result.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <string_view>
#include <utility>

#include "hierarchy/progress.h"

namespace interleaf {

/// The work ends soon if nobody wants its result any more.
template <typename Result>
class ParallelWork {
  public:
    /// \param work  called as work(const Progress&), on another thread, or by wait() if there is none. What it uses must
    ///              outlive this object
    template <typename Work>
    explicit ParallelWork(Work work)
        : result_(std::async(std::launch::async | std::launch::deferred,
                             [this, work = std::move(work)]() mutable { return work(progress_); })) {}

    /// Ends the work, and waits until it has ended.
    ~ParallelWork() { is_dropped_ = true; }
    ParallelWork(const ParallelWork&) = delete;
    ParallelWork& operator=(const ParallelWork&) = delete;

    bool is_done() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

    /// Waits for the result, and reports meanwhile how far the work is, as \p stage. To be called once.
    /// \throw Cancelled  if progress says so
    /// \throw ...        what the work throws
    Result wait(std::string_view stage, const Progress& progress) {
        constexpr std::chrono::milliseconds between_reports(20);
        while (result_.wait_for(between_reports) == std::future_status::timeout)
            if (progress && !progress(stage, part_)) throw Cancelled();
        return result_.get();
    }

  private:
    std::atomic<bool> is_dropped_ = false;
    std::atomic<double> part_ = 0;  ///< of the work that is done
    const Progress progress_ = [this](std::string_view, double part) {
        part_ = part;
        return !is_dropped_;
    };
    std::future<Result> result_;  ///< last member: its destructor waits for work that uses the others
};

}  // namespace interleaf
