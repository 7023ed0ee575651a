// The figures of the shown field at all keys of the timeline, measured on a separate thread.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "family/family.h"
#include "family/field_figures.h"
#include "ui/panels/field_curves.h"

namespace interleaf {

class FieldHistory {
  public:
    FieldHistory() = default;
    FieldHistory(const FieldHistory&) = delete;
    FieldHistory& operator=(const FieldHistory&) = delete;
    ~FieldHistory() = default;

    /// Begins to measure the scalar \p field of \p family, unless that is what it measures already.
    /// \param field  null for none
    void follow(const std::shared_ptr<const Family>& family, const std::string* field);

    /// The curves that are measured so far, from the first key on.
    const FieldCurves& curves();

    bool is_working() const { return !is_taken_; }

  private:
    void measure(const std::stop_token& stop, const Family& family, const std::string& field);
    void add(double time, const FieldFigures& figures);

    std::shared_ptr<const Family> family_;
    std::optional<std::string> field_;
    FieldCurves curves_;
    bool is_taken_ = true;  ///< whether curves_ are all that can be measured

    std::mutex mutex_;  ///< guards the members below
    FieldCurves measured_;
    bool is_over_ = true;

    std::jthread thread_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
