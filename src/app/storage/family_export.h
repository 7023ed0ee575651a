// Exports the family or its blend on a separate thread, so that the window goes on. Long exports show their
// progress, and can be cancelled.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/message.h"
#include "app/work/shown_job.h"
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

    bool is_working() const { return job_.is_working(); }

    /// Whether the progress is in front of the window.
    bool is_shown() const { return job_.is_shown(); }

    /// Shows the progress in the middle of \p area, if the export takes long. Call it in every frame from the
    /// same place.
    void show(const Rect& area, double now) { job_.show(area, now); }

    /// What to tell the user when an export has ended, once.
    /// \param now  seconds
    std::optional<Message> take_result(double now);

    /// Asks the export to end, which it does soon after.
    void cancel() { job_.cancel(); }

  private:
    std::filesystem::path file_;
    ShownJob<std::vector<std::string>> job_;  ///< gives remarks, one sentence each
};

}  // namespace interleaf
