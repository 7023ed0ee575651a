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

    /// The present state as files hold it: with its own time source, not with that of drive_in_this_run().
    std::shared_ptr<const Family> family_to_save() const;

    /// Lets \p source drive the present state in place of its own choice, which files keep. That is no edit: the
    /// state does not count as changed. States that edits make of it inherit both sources.
    /// \pre has_source(family(), source)
    void drive_in_this_run(TimeSource source);

    /// Makes the time source that drives the present state its own.
    void keep_time_source() { states_[current_].source_to_save.reset(); }

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
        std::optional<TimeSource> source_to_save;  ///< while another source drives in this run alone
    };

    std::vector<State> states_;
    std::size_t current_ = 0;
    std::optional<std::size_t> saved_ = 0;
    std::optional<std::filesystem::path> folder_;
};

}  // namespace interleaf
