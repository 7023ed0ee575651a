// Protects unsaved work: autosaves the open document, and offers the documents that earlier runs of the
// program have left in their autosaves.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/storage/autosave_writer.h"
#include "app/storage/recovery.h"
#include "ui/dialogs/dialog.h"

namespace interleaf {

class DocumentRecovery {
  public:
    /// \param state_folder  the user's state folder (user_folders.h)
    DocumentRecovery(const std::filesystem::path& state_folder, const Document& document);

    /// The latest abandoned recovery without an answer yet; null if there is none.
    const Recovery* offered() const { return abandoned_.empty() ? nullptr : &abandoned_.front(); }

    /// Claims the offered recovery for this process, and ends the offers.
    /// \return the claimed recovery; none if another process was faster
    /// \pre    a recovery is offered
    std::optional<Recovery> claim_offered();

    /// Removes the offered recovery from the disk, and offers the next one.
    /// \pre   a recovery is offered
    /// \throw MachineError if it cannot be removed
    void discard_offered();

    /// Continues with \p claimed, the recovery that the present, unsaved document was read from. The autosave
    /// writes there from now on, so that the document has a single recovery, and forget() removes it.
    void adopt(Recovery claimed);

    /// Autosaves \p document when it has not changed for a second. Call it in every frame. take_error()
    /// reports errors.
    /// \param is_dragging  whether a drag is about to replace the present state
    void look_after(const Document& document, bool is_dragging, double now);

    /// Autosaves \p document at once if it has unsaved changes, because something has gone wrong.
    void keep(const Document& document);

    /// Removes the recovery: \p document has been saved, or its changes have been discarded.
    void forget(const Document& document);

    /// The error of writing or removing the autosave, reported once.
    std::optional<std::string> take_error() { return autosave_.take_error(); }

  private:
    AutosaveWriter autosave_;
    std::shared_ptr<const Family> autosaved_;  ///< the state handled by the autosave last
    std::shared_ptr<const Family> seen_;       ///< the document's state in the last frame
    double seen_since_ = 0;                    ///< when seen_ became the document's state
    std::vector<Recovery> abandoned_;
};

/// The question whether to recover, discard or decide later.
Question question_about(const RecoveryNote& note);

}  // namespace interleaf
