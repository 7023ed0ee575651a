#include "app/storage/document_files.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "app/document/builtin_family.h"
#include "app/document/opening.h"
#include "app/storage/save_folder.h"
#include "app/storage/user_folders.h"
#include "hierarchy/error.h"
#include "io/family/family_file.h"
#include "io/file/file_pattern.h"
#include "io/formats.h"
#include "ui/browser/typed_path.h"
#include "ui/widgets/command_keys.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// Whether \p sources are steps of a series, which the command line has imported with the usual choices.
bool are_steps(const std::vector<fs::path>& sources) {
    return !sources.empty() && std::ranges::all_of(sources, [](const fs::path& source) {
        return is_called(source, &Format::holds_series);
    });
}

/// The interval between checks of the files on disk; seconds.
constexpr double look_interval = 2;

std::vector<fs::path> watched_files(const std::vector<fs::path>& sources) {
    std::vector<fs::path> files;
    for (const fs::path& source : sources) {
        if (const auto inside = files_in_folder(source); !inside.empty()) {
            files.insert(files.end(), inside.begin(), inside.end());
            continue;
        }
        std::error_code ignored;
        files.push_back(fs::is_directory(source, ignored) ? source / "family.json" : source);
        try {
            const auto keys = key_files(source);
            files.insert(files.end(), keys.begin(), keys.end());
        } catch (const std::runtime_error&) {
            continue;  // the file itself is watched
        }
    }
    return files;
}

}  // namespace

std::optional<fs::path> family_folder(const std::vector<fs::path>& sources) {
    if (sources.size() != 1) return std::nullopt;
    std::error_code error;
    const fs::path source = fs::absolute(sources.front(), error).lexically_normal();
    if (error) return std::nullopt;  // relative to a deleted folder
    if (is_family_folder(source)) return source.has_filename() ? source : source.parent_path();
    if (source.filename() == "family.json" && !fs::is_directory(source, error)) return source.parent_path();
    return std::nullopt;
}

DocumentFiles::DocumentFiles(ViewerState& state, std::vector<fs::path> sources, bool is_unattended)
    : state_(state), is_unattended_(is_unattended) {
    if (!is_unattended) {
        settings_file_ = settings_file();
        if (settings_file_) {
            LoadedSettings loaded = load_settings(*settings_file_);
            settings_ = std::move(loaded.settings);
            if (settings_.trackball) state_.camera.orbit = OrbitStyle::trackball;
            state_.camera.shows_axes = settings_.axes;
            state_.camera.up = state_.camera.chosen_up = settings_.up;
            if (!loaded.message.empty()) complain(loaded.message);
        }
        if (const auto folder = state_folder()) recovery_.emplace(*folder, state_.document);
    }
    if (are_steps(sources))
        change_settings([&](Settings& settings) { remember_series(settings, path_of_all(sources), {}); });
    else if (!sources.empty())
        remember(sources.front());
    set_sources(std::move(sources));
    offer_recovery();
}

void DocumentFiles::grant(FileWish wish) {
    switch (wish) {
        case FileWish::none:
            break;
        case FileWish::open:
            browse_to_open();
            break;
        case FileWish::reopen:
            reopen();
            break;
        case FileWish::save:
            save({});
            break;
        case FileWish::save_as:
            save_as({});
            break;
        case FileWish::save_picture:
            browse_to_save_picture();
            break;
        case FileWish::export_as:
            browse_to_export();
            break;
        case FileWish::add_keys:
            browse_to_add();
            break;
        case FileWish::import_series:
            browse_to_import();
            break;
        case FileWish::set_landmarks:
            set_landmarks();
            break;
        case FileWish::quit:
            quit();
            break;
    }
}

void DocumentFiles::show(const Rect& area, double now) {
    if (auto choice = browser_.show(area)) choice_ = std::move(choice);
    if (auto answer = dialog_.show(area)) answer_ = std::move(answer);
    fitting_.show(area, now);
    // The progress of what goes on beside waits until the user has answered: there is room for one dialog.
    const bool asks = browser_.is_open() || dialog_.is_open() || fitting_.is_open();
    if (!asks) opening_.show(area, now);
    if (!asks && !opening_.is_shown()) importing_.show(area, now);
    if (!asks && !opening_.is_shown() && !importing_.is_open()) exporting_.show(area, now);
}

void DocumentFiles::act(float density, double now) {
    now_ = now;
    if (const auto choice = std::exchange(choice_, std::nullopt)) {
        change_settings([&](Settings& settings) {
            settings.last_folder = choice->folder;
            interleaf::remember(settings.recent_folders, choice->folder);
        });
        std::exchange(on_choice_, nullptr)(*choice);
    }
    if (const auto answer = std::exchange(answer_, std::nullopt)) std::exchange(on_answer_, nullptr)(*answer);
    if (state_.question && !is_asking()) {
        TextQuestion question = *std::exchange(state_.question, std::nullopt);
        ask({.text = question.text,
             .detail = {},
             .buttons = {question.button, "Cancel"},
             .entry = question.entry,
             .fault = question.fault},
            [this, answer = question.answer](const Answer& given) {
                if (given.button == 0) answer(state_, given.entry, now_);
            });
    }
    if (opening_.is_over() && !dialog_.is_open()) take_opened();
    if (const auto error = fitting_.update(density, now)) complain(*error);
    if (const auto error = importing_.update(now)) complain(*error);
}

void DocumentFiles::look_after(double now) {
    if (saving_ && saving_->written.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        finish_saving();
    if (auto result = exporting_.take_result(now)) state_.message = *std::move(result);
    if (recovery_) {
        recovery_->look_after(state_.document, state_.is_dragging, now);
        if (const auto error = recovery_->take_error()) complain(*error);
    }
    // A shown fault is not replaced: the change is reported when the user has dismissed the fault. Saving
    // changes files itself.
    if (now - looked_ < look_interval || state_.message.is_fault() || saving_) return;
    looked_ = now;
    if (const auto file = stamps_.take_changed())
        complain(with_keys(fmt::format("{} has changed on disk: Reopen reads it again", file->string()),
                           {"Reopen"}));
}

void DocumentFiles::keep_unsaved() {
    if (recovery_) recovery_->keep(state_.document);
}

void DocumentFiles::remember_window(glm::ivec2 size, std::vector<std::string> closed_sections) {
    state_.appearance.closed_sections = std::move(closed_sections);
    Settings now = settings_;
    const auto take = [&](Settings& settings) {
        settings.window_size = size;
        const Theme last = settings.appearance.theme;
        settings.appearance = state_.appearance;
        if (state_.has_theme_of_run) settings.appearance.theme = last;
        settings.trackball = state_.camera.orbit == OrbitStyle::trackball;
        settings.axes = state_.camera.shows_axes;
        settings.up = state_.camera.chosen_up;
    };
    take(now);
    if (now == settings_) return;
    change_settings([&](Settings& settings) { take(settings); });
}

// ---- questions ----

void DocumentFiles::ask(Question question, std::function<void(const Answer&)> answer) {
    if (dialog_.is_open()) return;
    on_answer_ = std::move(answer);
    dialog_.ask(std::move(question));
}

void DocumentFiles::browse(FileRequest request, std::function<void(const FileChoice&)> answer) {
    if (browser_.is_open()) return;
    request.places.push_back({"Built-in families", builtin_family_folder().parent_path()});
    request.recent_folders = settings_.recent_folders;
    if (request.folder.empty()) request.folder = settings_.last_folder;
    on_choice_ = std::move(answer);
    browser_.open(std::move(request));
}

/// Runs \p next when no changes can be lost: there are none, or they have been saved or discarded.
void DocumentFiles::leave_document(const Action& next) {
    finish_saving();
    if (!state_.document.is_changed()) {
        next();
        return;
    }
    ask({.text = fmt::format("Save the changes to {}?", state_.document.family().name),
         .detail = "They are lost otherwise.",
         .buttons = {"Save", "Don't save", "Cancel"},
         .entry = {},
         .fault = {}},
        [this, next](const Answer& answer) {
            if (answer.button == 0) save(next);
            if (answer.button == 1) next();
        });
}

/// Quits when nothing can be lost: neither changes nor a film or picture in the making.
void DocumentFiles::quit() {
    opening_.cancel();
    const auto leave = [this] {
        leave_document([this] {
            forget_unsaved();
            exporting_.cancel();
            state_.quit_wanted = true;
        });
    };
    if (!state_.makes_film) return leave();
    ask({.text = "Stop making the film or picture, and quit?",
         .detail = "What is made of it is lost.",
         .buttons = {"Quit", "Cancel"},
         .entry = {},
         .fault = {}},
        [leave](const Answer& answer) {
            if (answer.button == 0) leave();
        });
}

// ---- the document ----

void DocumentFiles::replace_document(Family family, std::vector<fs::path> sources) {
    const bool is_saved = finish_saving();  // what goes on belongs to the document that leaves
    forget_unsaved();
    ViewerState opened(std::move(family), family_folder(sources));
    opened.session.display = state_.session.display;
    opened.help_shown = state_.help_shown;
    opened.plots_blend = state_.plots_blend;
    opened.camera = state_.camera;
    opened.appearance = state_.appearance;
    opened.has_theme_of_run = state_.has_theme_of_run;
    if (!is_saved) opened.message = std::move(state_.message);
    state_ = std::move(opened);
    set_sources(std::move(sources));
}

void DocumentFiles::set_sources(std::vector<fs::path> sources) {
    stamps_ = FileStamps(watched_files(sources));
    sources_ = std::move(sources);
    imported_by_ = {};
}

// ---- saving ----

void DocumentFiles::save(const Action& next) {
    if (state_.document.folder()) {
        write(*state_.document.folder(), next);
    } else {
        save_as(next);
    }
}

void DocumentFiles::save_as(Action next) {
    FileRequest request;
    request.title = "Save the family in a folder of its own";
    request.action = "Save";
    request.purpose = FilePurpose::save_folder;
    request.types = openable_types();
    request.name = folder_name(state_.document.family().name);
    std::error_code ignored;
    const fs::path folder = folder_to_save_in({.document = state_.document.folder(),
                                               .last = settings_.last_folder,
                                               .current = fs::current_path(ignored),
                                               .builtin = builtin_family_folder().parent_path()});
    request.folder = folder.empty() ? home_folder() : folder;
    browse(std::move(request),
           [this, next = std::move(next)](const FileChoice& choice) { write(choice.files.front(), next); });
}

/// Writes on a separate thread, so that a family of hundreds of megabytes does not block the window. If \p
/// next follows, it may replace the document, so the function waits for the end of the write.
void DocumentFiles::write(const fs::path& folder, const Action& next) {
    finish_saving();
    const auto family = state_.document.snapshot();
    auto written = std::async(std::launch::async, [saved = state_.document.family_to_save(), folder] {
        write_family(*saved, folder);
    });
    saving_.emplace(Saving{family, fs::absolute(folder), std::move(written)});
    if (next && finish_saving()) next();
}

/// Waits until the save in progress is on the disk.
/// \return whether it succeeded
bool DocumentFiles::finish_saving() {
    if (!saving_) return true;
    Saving saved = *std::exchange(saving_, std::nullopt);
    try {
        saved.written.get();
    } catch (const std::runtime_error& error) {
        complain(error);
        return false;
    }
    state_.document.mark_saved(saved.family, saved.folder);
    if (!state_.document.is_changed()) forget_unsaved();  // otherwise there were edits meanwhile
    remember(saved.folder);
    set_sources({saved.folder});
    return true;
}

// ---- protection of unsaved work ----

/// Removes the recovery of the document.
void DocumentFiles::forget_unsaved() {
    if (recovery_) recovery_->forget(state_.document);
}

void DocumentFiles::offer_recovery() {
    if (!recovery_ || recovery_->offered() == nullptr) return;
    ask(question_about(recovery_->offered()->note), [this](const Answer& answer) {
        if (answer.button == 0) recover();
        if (answer.button != 1) return;
        try {
            recovery_->discard_offered();
        } catch (const MachineError& error) {
            complain(error);
        }
        offer_recovery();
    });
}

void DocumentFiles::recover() {
    auto claimed = recovery_->claim_offered();
    if (!claimed) return complain("the recovery has gone: another window has taken it");
    const Message message = state_.message;  // the message of the start, behind the question
    try {
        Family family = read_family(claimed->family());
        std::vector<fs::path> sources;
        if (!claimed->note.document_folder.empty()) sources.push_back(claimed->note.document_folder);
        replace_document(std::move(family), std::move(sources));
        state_.document.mark_unsaved();
        state_.message = message;
        recovery_->adopt(*std::move(claimed));
    } catch (const std::runtime_error& error) {
        complain(fmt::format("{}; it is kept", error.what()));
    }
}

void DocumentFiles::remember(const fs::path& path) {
    change_settings([&](Settings& settings) { remember_document(settings.recent_files, path); });
}

void DocumentFiles::change_settings(const std::function<void(Settings&)>& change) {
    change(settings_);
    if (!settings_file_) return;
    try {
        interleaf::change_settings(*settings_file_, change);
    } catch (const std::runtime_error& error) {
        complain(error);
    }
}

void DocumentFiles::complain(const std::string& text) {
    state_.message = {text};
}

void DocumentFiles::complain(const std::runtime_error& error) {
    state_.message = message_of(error);
}

}  // namespace interleaf
