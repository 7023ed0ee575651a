// Imports series in the window: runs the import on a separate thread, shows its progress in front of the window, asks
// for a tolerance where the series needs one, and hands on the keys.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/importing/series_import.h"
#include "app/work/shown_job.h"
#include "ui/dialogs/dialog.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// How the keys of a series were found, and what had to be decided: sentences for a notice, one per line.
std::string sentences_of(const SeriesReport& report);

class SeriesImporting {
  public:
    /// Receives the result of an import, and the choices by which the series was imported in the end.
    using Receiver = std::function<void(ImportedSeries, const ImportChoices&)>;

    /// Begins to import \p files by \p choices. \p receiver receives the result.
    /// \param now  seconds
    /// \pre is_open() is false
    void start(std::vector<std::filesystem::path> files, ImportChoices choices, Receiver receiver,
               double now);

    /// Shows the options of an import of \p files, at first \p choices. The import begins when the user says so.
    /// \param receiver  receives the result
    /// \throw InputError, MachineError  if the first step cannot be read
    /// \pre is_open() is false
    void offer(std::vector<std::filesystem::path> files, const ImportChoices& choices, Receiver receiver);

    /// Whether the options, the progress or the question for a tolerance is in front of the window.
    bool is_open() const { return job_.is_working() || dialog_.is_open() || options_.is_open(); }

    /// Whether work in progress needs new frames soon, even without input.
    bool is_working() const { return job_.is_working(); }

    /// Shows the options, the progress or the question, if open, in the middle of \p area. Call it in every frame from
    /// the same place.
    void show(const Rect& area, double now);

    /// Acts on the user's answer, and hands on the keys when the work is done. Call it in every frame.
    /// \return an error, reported once
    std::optional<std::string> update(double now);

  private:
    std::optional<std::string> hand_on_keys();
    void begin(double now);
    void ask_for_tolerance(const std::string& reason);

    std::vector<std::filesystem::path> files_;
    Receiver receiver_;
    ImportChoices choices_;  ///< of the last import
    ImportDialog options_;
    ImportDialogShown offered_;      ///< what options_ shows
    std::optional<bool> is_wanted_;  ///< the user's answer to the options, kept for update()
    Dialog dialog_;
    std::optional<Answer> answer_;  ///< kept for update()
    ShownJob<ImportedSeries> job_;
};

}  // namespace interleaf
