// Exports the family or its blend on a separate thread, so that the window goes on.
#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/message.h"
#include "family/family.h"
#include "family/weights.h"

namespace interleaf {

class FamilyExport {
  public:
    /// Begins to write \p file. Waits for the export before.
    /// \param weights  of the present blend
    /// \pre the format of \p file is exported (io/formats.h)
    void begin(std::shared_ptr<const Family> family, Weights weights, std::filesystem::path file);

    bool is_working() const { return work_.has_value(); }

    /// What to tell the user when an export has ended, once.
    /// \param now  seconds
    std::optional<Message> take_result(double now);

  private:
    struct Work {
        std::filesystem::path file;
        std::future<std::vector<std::string>> written;  ///< remarks, one sentence each
    };
    std::optional<Work> work_;
};

}  // namespace interleaf
