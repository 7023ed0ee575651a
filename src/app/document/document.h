// The document: the family that is open, with every state it has been in, so that edits can be undone and
// done again. No window, no files: it knows where it was saved, and whether it has changed since.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "family/family.h"

namespace interleaf {

class Document {
  public:
    /// \param folder  of the family, where it was read from one; none for what has no place of its own yet
    /// \pre  check(family) finds nothing
    explicit Document(Family family, std::optional<std::filesystem::path> folder = std::nullopt);

    const Family& family() const { return *states_[current_].family; }

    /// The present state, for keeping: it never changes.
    std::shared_ptr<const Family> snapshot() const { return states_[current_].family; }

    const std::optional<std::filesystem::path>& folder() const { return folder_; }

    /// Makes \p family the present state; what had been undone is forgotten.
    /// \param step  names the edit, to be read after "Undo"
    /// \pre  check(family) finds nothing
    void edit(std::string step, Family family);

    /// Replaces the present state, as part of the same step: for all but the first movement of a drag.
    /// \pre  the last change was an edit() or an amend()
    void amend(Family family);

    /// The step that undo() takes back, redo() does again; null when there is none.
    const std::string* undo_step() const;
    const std::string* redo_step() const;

    /// Both do nothing when there is no such step.
    void undo();
    void redo();

    /// Whether the present state is another than the one that was read or saved last.
    bool is_changed() const { return saved_ != current_; }

    /// The state \p family, now in \p folder, is the saved one.
    void mark_saved(const std::shared_ptr<const Family>& family, std::filesystem::path folder);

    /// The present state is nowhere on disk as it is.
    void mark_unsaved() { saved_.reset(); }

  private:
    struct State {
        std::string step;  ///< that led to it
        std::shared_ptr<const Family> family;
    };

    std::vector<State> states_;
    std::size_t current_ = 0;
    std::optional<std::size_t> saved_ = 0;
    std::optional<std::filesystem::path> folder_;
};

}  // namespace interleaf
