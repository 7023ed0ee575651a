// A background job with its progress in front of the window, where the user can cancel it.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "app/work/background_job.h"
#include "ui/dialogs/progress_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

template <typename Result>
class ShownJob {
  public:
    /// Begins the work.
    /// \param title   of the progress
    /// \param now     seconds
    /// \param hidden  seconds without progress in front of the window: for short work, a dialog would only flicker
    ///
    /// Drops the result of work before, which it cancels.
    void start(std::string title, typename BackgroundJob<Result>::Work work, double now, double hidden = 0) {
        title_ = std::move(title);
        started_ = now;
        hidden_ = hidden;
        is_shown_ = hidden <= 0;
        is_closed_ = is_cancelled_ = false;
        job_ = std::make_unique<BackgroundJob<Result>>(std::move(work));
    }

    /// Whether there is work, or a result to take.
    bool is_working() const { return job_ != nullptr; }

    /// Whether the progress is in front of the window.
    bool is_shown() const { return job_ && is_shown_; }

    /// Shows the progress in the middle of \p area. Call it in every frame from the same place.
    void show(const Rect& area, double now) {
        if (!job_) return;
        const JobState state = job_->state();
        if (!state.is_done && now - started_ > hidden_) is_shown_ = true;
        if (!is_shown_) return;
        const bool cancels = progress_dialog({.title = title_,
                                              .stage = is_cancelled_ ? "cancelling" : state.stage,
                                              .part = state.part,
                                              .seconds = now - started_},
                                             area, state.is_done);
        if (cancels) cancel();
        is_closed_ = state.is_done;
    }

    /// Waits until the work is done.
    void wait() const {
        if (job_) job_->wait();
    }

    void cancel() {
        if (!job_) return;
        is_cancelled_ = true;
        job_->cancel();
    }

    /// Whether the work is done and no progress is in front of the window: take() is due.
    bool is_over() const { return job_ && is_shown_ == is_closed_ && job_->state().is_done; }

    /// Waits until the work is done, for \p longest at most, as long as no progress is in front of the window.
    /// \return whether take() is due
    bool is_over_within(std::chrono::milliseconds longest) {
        return job_ && !is_shown_ && job_->wait_for(longest);
    }

    /// The result. There is no work afterward, also if this throws.
    /// \pre is_over()
    /// \throw what the work has thrown; Cancelled after cancel(), unless the work has just ended
    Result take() {
        const std::unique_ptr<BackgroundJob<Result>> job = std::move(job_);
        return job->take();
    }

  private:
    std::unique_ptr<BackgroundJob<Result>> job_;
    std::string title_;
    double started_ = 0;
    double hidden_ = 0;
    bool is_shown_ = false;
    bool is_closed_ = false;  ///< the progress was shown for the last time
    bool is_cancelled_ = false;
};

}  // namespace interleaf
