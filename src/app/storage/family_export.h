// Exports the family or its blend on a separate thread, so that the window goes on. Long exports show their
// progress, and can be cancelled.
#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/document/message.h"
#include "family/family.h"
#include "family/weights.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class FamilyExport {
  public:
    /// Begins to write \p file. Waits for the export before.
    /// \param weights  of the present blend
    /// \param now      seconds
    /// \pre the format of \p file is exported (io/formats.h)
    void begin(std::shared_ptr<const Family> family, Weights weights, std::filesystem::path file, double now);

    bool is_working() const { return work_.has_value(); }

    /// Whether the progress is in front of the window.
    bool is_shown() const { return work_ && work_->is_shown; }

    /// Shows the progress in the middle of \p area, if the export takes long. Call it in every frame from the
    /// same place.
    void show(const Rect& area, double now);

    /// What to tell the user when an export has ended, once.
    /// \param now  seconds
    std::optional<Message> take_result(double now);

    /// Asks the export to end, which it does soon after.
    void cancel();

  private:
    /// What the two threads share.
    struct Report {
        std::mutex mutex;
        std::string stage;
        double part = 0;
        bool is_cancelled = false;
    };

    struct Work {
        std::filesystem::path file;
        std::shared_ptr<Report> report;
        std::future<std::vector<std::string>> written;  ///< remarks, one sentence each
        double started = 0;
        bool is_shown = false;
        bool is_closed = false;  ///< the progress was shown for the last time
    };

    std::optional<Work> work_;
};

}  // namespace interleaf
