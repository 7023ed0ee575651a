#include "app/importing/import_job.h"

#include <utility>

#include "hierarchy/progress.h"
#include "io/series_files.h"

namespace interleaf {

ImportJob::ImportJob(std::vector<std::filesystem::path> files, ImportChoices choices)
    : files_(std::move(files)),
      choices_(std::move(choices)),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

ImportJob::State ImportJob::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

ImportedSeries ImportJob::take() {
    const std::scoped_lock lock(mutex_);
    if (error_) std::rethrow_exception(error_);
    return std::move(imported_);
}

void ImportJob::work(const std::stop_token& stop) {
    ImportedSeries imported;
    std::exception_ptr error;
    try {
        imported =
            import_series(every_step(series_files(files_), choices_.every), files_.front().stem().string(),
                          choices_, [&](std::string_view stage, double part) {
                              report(stage, part);
                              if (stop.stop_requested()) throw Cancelled();
                          });
    } catch (...) {
        error = std::current_exception();  // for take(), on the other thread
    }
    const std::scoped_lock lock(mutex_);
    imported_ = std::move(imported);
    error_ = error;
    state_.is_done = true;
}

void ImportJob::report(std::string_view stage, double part) {
    const std::scoped_lock lock(mutex_);
    state_.stage = stage;
    state_.part = part;
}

}  // namespace interleaf
