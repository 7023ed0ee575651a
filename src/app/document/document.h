// The document: the open family with all its states, so that edits can be undone and redone. The document
// has no window and reads no files. It knows its folder, and whether it has changed since it was saved.
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
    /// \param folder  the folder that the family was read from; none for a family without a folder yet
    /// \pre           check(family) finds nothing
    explicit Document(Family family, std::optional<std::filesystem::path> folder = std::nullopt);

    const Family& family() const { return *states_[current_].family; }

    /// The present state, which a caller may keep: it never changes.
    std::shared_ptr<const Family> snapshot() const { return states_[current_].family; }

    const std::optional<std::filesystem::path>& folder() const { return folder_; }

    /// Makes \p family the present state, and drops all undone states.
    /// \param step  name of the edit, shown after "Undo"
    /// \pre         check(family) finds nothing
    void edit(std::string step, Family family);

    /// Replaces the present state within the same step. A drag calls edit() for its first movement and
    /// amend() for all others.
    /// \pre the last change was an edit() or an amend()
    void amend(Family family);

    /// Takes the present step back as if it had never been: redo() does not repeat it.
    /// \pre the last change was an edit() or an amend()
    void retract();

    /// The steps that undo() would take back and redo() would repeat; null if there is no such step.
    const std::string* undo_step() const;
    const std::string* redo_step() const;

    /// Both do nothing if there is no such step.
    void undo();
    void redo();

    /// Whether the present state differs from the state that was read or saved last.
    bool is_changed() const { return saved_ != current_; }

    /// Records that the state \p family is saved in \p folder.
    void mark_saved(const std::shared_ptr<const Family>& family, std::filesystem::path folder);

    /// Records that no file holds the present state.
    void mark_unsaved() { saved_.reset(); }

  private:
    struct State {
        std::string step;  ///< name of the edit that led to this state
        std::shared_ptr<const Family> family;
    };

    std::vector<State> states_;
    std::size_t current_ = 0;
    std::optional<std::size_t> saved_ = 0;
    std::optional<std::filesystem::path> folder_;
};

}  // namespace interleaf
