// The files of the document: opens and saves with the file browser, asks before changes are lost, keeps
// recent files, autosaves, offers recovery, and detects changes on disk by other programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/document/opening.h"
#include "app/document/viewer_state.h"
#include "app/fitting/mesh_fitting.h"
#include "app/storage/document_recovery.h"
#include "app/storage/family_export.h"
#include "app/storage/file_stamps.h"
#include "app/storage/series_importing.h"
#include "app/storage/settings.h"
#include "app/work/shown_job.h"
#include "ui/browser/file_browser.h"
#include "ui/dialogs/dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The folder in which to save a document that was read from \p sources; none unless \p sources are one
/// family.
std::optional<std::filesystem::path> family_folder(const std::vector<std::filesystem::path>& sources);

class DocumentFiles {
  public:
    /// \param sources        the files that the document in \p state was read from; empty for the built-in family
    /// \param is_unattended  whether the window runs without a user: then no settings and recoveries of the user are
    ///                       touched, and opening waits for the files
    DocumentFiles(ViewerState& state, std::vector<std::filesystem::path> sources, bool is_unattended);

    /// Carries out the request of a command.
    void grant(FileWish wish);

    /// Opens \p files as a new document; a series with the usual options.
    void open(std::vector<std::filesystem::path> files);

    /// Opens recent_files()[\p file]; a series with the options of its last import.
    void open_recent(std::size_t file);

    /// Adds the keys of \p files to the document.
    void add_keys(const std::vector<std::filesystem::path>& files, double now);

    /// The files of the document; empty for the built-in family.
    const std::vector<std::filesystem::path>& sources() const { return sources_; }

    const std::vector<std::filesystem::path>& recent_files() const { return settings_.recent_files; }

    const Settings& settings() const { return settings_; }

    /// Whether a dialog, the file browser or progress has the keyboard focus.
    bool is_asking() const {
        return browser_.is_open() || dialog_.is_open() || fitting_.is_open() || importing_.is_open() ||
               opening_.is_working() || exporting_.is_shown();
    }

    /// Whether work in progress needs new frames soon.
    bool is_working() const {
        return fitting_.is_working() || importing_.is_working() || opening_.is_working();
    }

    /// The fitting of meshes, with its dialog while that is open.
    const MeshFitting& fitting() const { return fitting_; }

    /// Whether the document is being saved in the background.
    bool is_saving() const { return saving_.has_value(); }

    /// Whether the family or a blend is being exported in the background.
    bool is_exporting() const { return exporting_.is_working(); }

    /// The path at the file browser's cursor; none while the browser is closed.
    std::optional<std::filesystem::path> browsed() const { return browser_.cursor_path(); }

    /// Shows dialogs, the file browser and the fit dialog in the middle of \p area. Call it in every frame.
    /// Answers are kept for act().
    void show(const Rect& area, double now);

    /// Acts on the answers, asks pending questions, and takes the results of finished work. Call it in every
    /// frame.
    /// \param density  framebuffer pixels per screen coordinate
    void act(float density, double now);

    /// Writes the autosave and looks for changes on disk, when either is due. Call it in every frame.
    void look_after(double now);

    /// Orders an autosave of unsaved changes at once, without waiting for the disk.
    void keep_unsaved();

    /// The size of the window when the program last ended, in screen coordinates.
    std::optional<glm::ivec2> window_size() const { return settings_.window_size; }

    /// How the window looked when the program last ended.
    const Appearance& appearance() const { return settings_.appearance; }

    /// Keeps the size and the look of the window and the choices of the camera for the next run.
    void remember_window(glm::ivec2 size, std::vector<std::string> closed_sections);

  private:
    using Action = std::function<void()>;  ///< null for no action

    /// The kinds of files that the file browser offers to open.
    static const std::vector<FileType>& openable_types();

    void offer_recovery();
    void recover();
    void ask(Question question, std::function<void(const Answer&)> answer);
    void leave_document(const Action& next);
    void quit();
    void save(const Action& next);
    void save_as(Action next);
    void write(const std::filesystem::path& folder, const Action& next);
    bool finish_saving();
    void browse(FileRequest request, std::function<void(const FileChoice&)> answer);
    void browse_to_open();
    void browse_to_add();
    void browse_to_import();
    void offer_import(const std::vector<std::filesystem::path>& files);
    void browse_to_export();
    void browse_to_save_picture();
    void export_as(const std::filesystem::path& file);
    void read(std::vector<std::filesystem::path> paths, std::function<void(Opening&)> receiver);
    void take_opened();
    void show_files(const std::vector<std::filesystem::path>& paths, const ImportChoices& choices);
    bool show_opened(Opening& found, const std::vector<std::filesystem::path>& paths,
                     const ImportChoices& choices);
    void add_opened(Opening& found);
    void reopen();
    void offer_to_open(const MeshesToFit& meshes);
    void offer_to_add(const MeshesToFit& meshes);
    void open_fitted(const std::vector<std::filesystem::path>& meshes, const FittedMeshes& fitted);
    void start_import(std::vector<std::filesystem::path> files, const ImportChoices& choices,
                      SeriesImporting::Receiver receiver);
    SeriesImporting::Receiver opener_of(std::vector<std::filesystem::path> files);
    ImportChoices remembered_choices(const std::filesystem::path& file) const;
    void add_fitted(const FittedMeshes& fitted);
    void set_landmarks();
    void tell_fit(const FittedMeshes& fitted);
    void tell_added(std::size_t first);
    void replace_document(Family family, std::vector<std::filesystem::path> sources);
    void set_sources(std::vector<std::filesystem::path> sources);
    void forget_unsaved();
    void remember(const std::filesystem::path& path);
    void change_settings(const std::function<void(Settings&)>& change);
    void complain(const std::string& text);
    void complain(const std::runtime_error& error);

    struct Saving {
        std::shared_ptr<const Family> family;
        std::filesystem::path folder;
        std::future<void> written;
    };

    ViewerState& state_;
    bool is_unattended_;
    std::vector<std::filesystem::path> sources_;
    ImportChoices imported_by_;  ///< if the sources are a series, the options of its import
    FileStamps stamps_;
    double looked_ = 0;  ///< time of the last comparison of stamps

    std::optional<std::filesystem::path> settings_file_;
    Settings settings_;

    FileBrowser browser_;
    std::optional<FileChoice> choice_;  ///< waits for act()
    std::function<void(const FileChoice&)> on_choice_;
    Dialog dialog_;
    std::optional<Answer> answer_;  ///< waits for act()
    std::function<void(const Answer&)> on_answer_;
    MeshFitting fitting_;
    SeriesImporting importing_;
    ShownJob<Opening> opening_;
    std::function<void(Opening&)> on_opened_;    ///< receives the result of opening_
    std::shared_ptr<const Family> last_fitted_;  ///< the document right after the last fit; null without one
    bool was_fit_added_ = false;                 ///< whether that fit added keys to the document
    std::optional<Saving> saving_;
    FamilyExport exporting_;
    double now_ = 0;

    std::optional<DocumentRecovery> recovery_;  ///< none if the user's recoveries must not be touched
};

}  // namespace interleaf
