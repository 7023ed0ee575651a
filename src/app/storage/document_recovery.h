// What the user is not to lose: the autosave of the document that is open, and the documents that programs
// before have left in theirs.
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
    /// \param state_folder  of the user (user_folders.h)
    DocumentRecovery(const std::filesystem::path& state_folder, const Document& document);

    /// The latest that is left and has not been answered; null for none.
    const Recovery* offered() const { return abandoned_.empty() ? nullptr : &abandoned_.front(); }

    /// Makes the offered one this process's, and offers no other. \return it; none when another window was
    /// faster
    /// \pre one is offered
    std::optional<Recovery> claim_offered();

    /// Removes the offered one from the disk; the next one is offered then.
    /// \pre one is offered \throw MachineError when it cannot be removed
    void discard_offered();

    /// \p claimed is what the document, which is unsaved, was read from: from now on the autosave writes
    /// there, so that there is one of the document, and forget() removes it.
    void adopt(Recovery claimed);

    /// Autosaves \p document once it has rested for a second; call it in every frame. What comes of it: see
    /// take_error(). \param is_dragging  whether its present state is about to be replaced
    void look_after(const Document& document, bool is_dragging, double now);

    /// Autosaves \p document at once, if it is not saved: something has gone wrong.
    void keep(const Document& document);

    /// Nothing in \p document is worth recovering any more: it has been saved, or its changes are not wanted.
    void forget(const Document& document);

    /// What went wrong with writing or removing the autosave, once.
    std::optional<std::string> take_error() { return autosave_.take_error(); }

  private:
    AutosaveWriter autosave_;
    std::shared_ptr<const Family> autosaved_;  ///< the state that the autosave has taken care of
    std::shared_ptr<const Family> seen_;       ///< the document's state of the last frame,
    double seen_since_ = 0;                    ///< and since when
    std::vector<Recovery> abandoned_;
};

/// Recover, discard, or decide later?
Question question_about(const RecoveryNote& note);

}  // namespace interleaf
