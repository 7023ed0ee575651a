// Imports a series on a separate thread, so that the window goes on.
#pragma once

#include <exception>
#include <filesystem>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/importing/series_import.h"

namespace interleaf {

/// All members must be called from the same thread.
class ImportJob {
  public:
    /// \param files  as series_files()
    ImportJob(std::vector<std::filesystem::path> files, ImportChoices choices);

    /// Cancels the remaining work.
    ~ImportJob() = default;
    ImportJob(const ImportJob&) = delete;
    ImportJob& operator=(const ImportJob&) = delete;

    struct State {
        std::string stage;
        double part = 0;  ///< finished part of the whole work, 0 to 1
        bool is_done = false;
    };
    State state() const;

    /// Asks the job to end, which it does soon after.
    void cancel() { thread_.request_stop(); }

    /// The result.
    /// \pre the job is done
    /// \throw the exceptions of series_files() and import_series(); Cancelled after cancel()
    ImportedSeries take();

  private:
    void work(const std::stop_token& stop);
    void report(std::string_view stage, double part);

    const std::vector<std::filesystem::path> files_;
    const ImportChoices choices_;

    mutable std::mutex mutex_;  ///< guards the members below
    State state_;
    ImportedSeries imported_;
    std::exception_ptr error_;

    std::jthread thread_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
