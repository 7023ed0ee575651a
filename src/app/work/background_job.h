// Long work on a separate thread, so that the window goes on: its progress, its cancellation and its result.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "hierarchy/progress.h"

namespace interleaf {

/// How far a job is.
struct JobState {
    std::string stage;
    double part = 0;  ///< finished part of the whole work, 0 to 1
    bool is_done = false;
};

/// All members must be called from the same thread.
template <typename Result>
class BackgroundJob {
  public:
    /// The work. It reports its progress, and ends with Cancelled soon after a report returns false.
    using Work = std::function<Result(const Progress& progress)>;

    explicit BackgroundJob(Work work)
        : thread_([this, work = std::move(work)](const std::stop_token& stop) { run(work, stop); }) {}

    /// Cancels the remaining work, and waits for its end.
    ~BackgroundJob() = default;
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    JobState state() const {
        const std::scoped_lock lock(mutex_);
        return state_;
    }

    /// Waits until the job is done, for \p longest at most.
    /// \return whether it is done
    bool wait_for(std::chrono::milliseconds longest) const {
        std::unique_lock lock(mutex_);
        return done_.wait_for(lock, longest, [&] { return state_.is_done; });
    }

    void wait() const {
        std::unique_lock lock(mutex_);
        done_.wait(lock, [&] { return state_.is_done; });
    }

    /// Asks the job to end, which it does soon after.
    void cancel() { thread_.request_stop(); }

    /// The result.
    /// \pre the job is done
    /// \throw what the work has thrown
    Result take() {
        const std::scoped_lock lock(mutex_);
        if (error_) std::rethrow_exception(error_);
        return std::move(*result_);
    }

  private:
    void run(const Work& work, const std::stop_token& stop) {
        std::optional<Result> result;
        std::exception_ptr error;
        try {
            result = work([&](std::string_view stage, double part) {
                const std::scoped_lock lock(mutex_);
                state_.stage = stage;
                state_.part = part;
                return !stop.stop_requested();
            });
        } catch (...) {
            error = std::current_exception();  // for take(), on the other thread
        }
        const std::scoped_lock lock(mutex_);
        result_ = std::move(result);
        error_ = error;
        state_.is_done = true;
        done_.notify_all();
    }

    mutable std::mutex mutex_;  ///< guards the members below
    mutable std::condition_variable done_;
    JobState state_;
    std::optional<Result> result_;
    std::exception_ptr error_;

    std::jthread thread_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
