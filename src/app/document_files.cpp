#include "app/document_files.h"

#include <algorithm>
#include <ctime>
#include <ranges>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "app/builtin_family.h"
#include "app/edit_commands.h"
#include "app/fit_roots.h"
#include "app/open_family.h"
#include "app/user_folders.h"
#include "family/new_family.h"
#include "hierarchy/error.h"
#include "io/family_file.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// How long a changed document rests before it is autosaved, and how often files are looked at; seconds.
constexpr double autosave_rest = 1;
constexpr double look_interval = 2;

const std::vector<FileType>& openable_types() {
    static const std::vector<FileType> types{
        {"Families, keys and meshes", {".json", ".ilh", ".obj", ".ply", ".stl", ".off"}},
        {"Families and keys", {".json", ".ilh"}},
        {"Meshes", {".obj", ".ply", ".stl", ".off"}}};
    return types;
}

std::vector<fs::path> watched_files(const std::vector<fs::path>& sources) {
    std::vector<fs::path> files;
    for (const fs::path& source : sources) {
        std::error_code ignored;
        files.push_back(fs::is_directory(source, ignored) ? source / "family.json" : source);
        try {
            const auto keys = key_files(source);
            files.insert(files.end(), keys.begin(), keys.end());
        } catch (const std::runtime_error&) {
            continue;  // it is watched itself
        }
    }
    return files;
}

FileRequest request_to_open(std::string title, std::string action) {
    FileRequest request;
    request.title = std::move(title);
    request.action = std::move(action);
    request.several = true;
    request.types = openable_types();
    return request;
}

std::string folder_name(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '\0'; }, '-');
    return name.empty() ? "family" : name;
}

}  // namespace

std::optional<fs::path> family_folder(const std::vector<fs::path>& sources) {
    if (sources.size() != 1) return std::nullopt;
    std::error_code ignored;
    if (fs::is_directory(sources.front(), ignored)) return fs::absolute(sources.front());
    if (sources.front().filename() == "family.json") return fs::absolute(sources.front()).parent_path();
    return std::nullopt;
}

DocumentFiles::DocumentFiles(ViewerState& state, std::vector<fs::path> sources, bool is_alone)
    : state_(state) {
    if (!is_alone) {
        settings_file_ = settings_file();
        if (settings_file_) {
            LoadedSettings loaded = load_settings(*settings_file_);
            settings_ = std::move(loaded.settings);
            if (!loaded.message.empty()) complain(loaded.message);
        }
        if (const auto folder = state_folder()) {
            abandoned_ = abandoned_recoveries(*folder);
            autosave_.emplace(*folder);
        }
    }
    seen_ = state_.document.snapshot();
    if (!sources.empty()) remember(sources.front());
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
            save([] {});
            break;
        case FileWish::save_as:
            save_as([] {});
            break;
        case FileWish::add_keys:
            browse_to_add();
            break;
        case FileWish::quit:
            leave_document([this] {
                forget_unsaved();
                state_.quit_wanted = true;
            });
            break;
    }
}

void DocumentFiles::show(const Rect& area, float density, double now) {
    now_ = now;
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
    if (const auto choice = browser_.show(area)) {
        change_settings([&](Settings& settings) {
            settings.last_folder = choice->folder;
            interleaf::remember(settings.recent_folders, choice->folder);
        });
        std::exchange(on_choice_, nullptr)(*choice);
    }
    if (const auto answer = dialog_.show(area)) std::exchange(on_answer_, nullptr)(*answer);
    if (const auto error = fitting_.show(area, density, now)) complain(*error);
}

void DocumentFiles::look_after(double now) {
    const auto present = state_.document.snapshot();
    if (present != seen_) {
        seen_ = present;
        seen_since_ = now;
    }
    if (autosave_) {
        const bool rests = now - seen_since_ >= autosave_rest;
        if (present != autosaved_ && rests && !state_.is_dragging) {
            autosaved_ = present;
            if (state_.document.is_changed()) {
                autosave_->write(present, state_.document.folder().value_or(fs::path()));
            } else {
                autosave_->clear();  // undone to what is saved
            }
        }
        if (const auto error = autosave_->take_error()) complain(*error);
    }
    // A message that is there is not replaced: the change is told once it has been read.
    if (now - looked_ < look_interval || !state_.message.empty()) return;
    looked_ = now;
    if (const auto file = stamps_.take_changed())
        complain(fmt::format("{} has changed on disk: Ctrl+R reads it again", file->string()));
}

void DocumentFiles::remember_window(glm::ivec2 size) {
    if (settings_.window_size != size)
        change_settings([size](Settings& settings) { settings.window_size = size; });
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
    request.folder = settings_.last_folder;
    on_choice_ = std::move(answer);
    browser_.open(std::move(request));
}

/// Does \p next once no changes can be lost: there are none, they have been saved, or they are not wanted.
void DocumentFiles::leave_document(const Action& next) {
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

// ---- opening ----

void DocumentFiles::browse_to_open() {
    browse(request_to_open("Open", "Open"), [this](const FileChoice& choice) { open(choice.files); });
}

void DocumentFiles::browse_to_add() {
    browse(request_to_open("Add keys", "Add"),
           [this](const FileChoice& choice) { add_keys(choice.files, now_); });
}

/// Gives \p receiver the family that \p files hold; meshes that are no keys as they are go to \p fit, with
/// the reason where it is not their kind.
void DocumentFiles::read_or_fit(const std::vector<fs::path>& files,
                                const std::function<void(Family)>& receiver,
                                const std::function<void(const std::string&)>& fit) {
    if (are_surfaces(files)) return fit("");
    try {
        receiver(open_family(files));
    } catch (const InputError& error) {
        if (files.size() > 1 && are_obj_files(files)) return fit(error.what());
        complain(error.what());
    } catch (const std::runtime_error& error) {
        complain(error.what());
    }
}

void DocumentFiles::open(std::vector<fs::path> files) {
    leave_document([this, files = std::move(files)] {
        read_or_fit(
            files,
            [&](Family family) {
                remember(files.front());
                replace_document(std::move(family), files);
            },
            [&](const std::string& reason) {
                fitting_.offer({files, reason, {}},
                               [this, files](const Comparisons& fitted) { open_fitted(files, fitted); });
            });
    });
}

void DocumentFiles::reopen() {
    leave_document([this] {
        try {
            Family family = open_family(sources_);
            replace_document(std::move(family), sources_);
        } catch (const std::runtime_error& error) {
            complain(error.what());
        }
    });
}

/// An .obj is a key as it is, but one over the family's roots only once it has been fitted.
void DocumentFiles::add_keys(const std::vector<fs::path>& files, double now) {
    const auto offer = [&](const std::string& reason) { offer_to_add(files, reason); };
    read_or_fit(
        files,
        [&](Family family) {
            const auto before = state_.document.snapshot();
            interleaf::add_keys(state_, std::move(family.keys), now);
            if (state_.document.snapshot() == before && are_obj_files(files))
                offer(std::exchange(state_.message, ""));
        },
        offer);
}

/// Keys for the document are fitted over its roots.
void DocumentFiles::offer_to_add(const std::vector<fs::path>& meshes, const std::string& reason) {
    try {
        fitting_.offer({meshes, reason, roots_of(state_.document.family())},
                       [this](const Comparisons& fitted) {
                           interleaf::add_keys(state_, keys_of(fitted), now_);
                           offer_comparison(fitted);
                       });
    } catch (const InputError& error) {
        complain(error.what());
    }
}

/// The fitted keys as a new document, which is nowhere on disk yet.
void DocumentFiles::open_fitted(const std::vector<fs::path>& meshes, const Comparisons& fitted) {
    std::vector<Key> keys = keys_of(fitted);
    const std::string name = keys.size() == 1 ? keys.front().name : "Fitted meshes";
    for (const fs::path& mesh : meshes) remember(mesh);
    replace_document(family_of_keys(name, std::move(keys)), {});
    state_.document.mark_unsaved();
    offer_comparison(fitted);
}

/// Says how near to their meshes the keys are that have come into the document, and offers to show it.
void DocumentFiles::offer_comparison(const Comparisons& fitted) {
    const auto compared = compared_keys(state_.document.family(), fitted);
    if (compared.empty()) return;
    state_.comparisons.insert(state_.comparisons.end(), fitted.begin(), fitted.end());
    constexpr std::size_t most_lines = 6;
    std::string detail;
    for (const ComparedKey& each : compared | std::views::take(most_lines))
        detail +=
            fmt::format("{}{}: {}.", detail.empty() ? "" : "\n", state_.document.family().keys[each.key].name,
                        in_words(each.comparison->quality));
    if (compared.size() > most_lines) detail += fmt::format("\nAnd {} more.", compared.size() - most_lines);
    ask({.text =
             compared.size() == 1
                 ? "A key has been fitted. Compare it with its mesh?"
                 : fmt::format("{} keys have been fitted. Compare them with their meshes?", compared.size()),
         .detail = std::move(detail),
         .buttons = {"Compare", "Done"},
         .entry = {},
         .fault = {}},
        [this, first = compared.front().comparison](const Answer& answer) {
            if (answer.button != 0) return;
            state_.compared = first;
            state_.is_comparing = true;
        });
}

void DocumentFiles::replace_document(Family family, std::vector<fs::path> sources) {
    forget_unsaved();
    ViewerState opened(std::move(family), family_folder(sources));
    opened.session.display = state_.session.display;
    opened.help_shown = state_.help_shown;
    state_ = std::move(opened);
    set_sources(std::move(sources));
}

void DocumentFiles::set_sources(std::vector<fs::path> sources) {
    stamps_ = FileStamps(watched_files(sources));
    sources_ = std::move(sources);
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
    browse(std::move(request),
           [this, next = std::move(next)](const FileChoice& choice) { write(choice.files.front(), next); });
}

void DocumentFiles::write(const fs::path& folder, const Action& next) {
    const auto family = state_.document.snapshot();
    try {
        write_family(*family, folder);
    } catch (const std::runtime_error& error) {
        complain(error.what());
        return;
    }
    state_.document.mark_saved(family, fs::absolute(folder));
    forget_unsaved();
    remember(folder);
    set_sources({fs::absolute(folder)});
    next();
}

// ---- what the user is not to lose ----

/// Nothing unsaved is worth recovering any more.
void DocumentFiles::forget_unsaved() {
    autosaved_ = state_.document.snapshot();
    if (autosave_) autosave_->clear();
    if (!recovered_) return;
    try {
        discard_recovery(*recovered_);
    } catch (const MachineError& error) {
        complain(error.what());
    }
    recovered_.reset();
}

void DocumentFiles::offer_recovery() {
    if (abandoned_.empty()) return;
    const RecoveryNote& note = abandoned_.front().note;
    const std::string when =
        note.time == 0
            ? ""
            : fmt::format(", as of {:%Y-%m-%d %H:%M}", fmt::localtime(static_cast<std::time_t>(note.time)));
    ask({.text = fmt::format("Recover {}?", note.name),
         .detail = fmt::format("Interleaf ended while it had changes that were not saved{}.", when),
         .buttons = {"Recover", "Discard", "Later"},
         .entry = {},
         .fault = {}},
        [this](const Answer& answer) {
            if (answer.button == 0) recover();
            if (answer.button != 1) return;
            try {
                if (const auto claimed = claim_recovery(abandoned_.front())) discard_recovery(*claimed);
            } catch (const MachineError& error) {
                complain(error.what());
            }
            abandoned_.erase(abandoned_.begin());
            offer_recovery();
        });
}

void DocumentFiles::recover() {
    auto claimed = claim_recovery(abandoned_.front());
    abandoned_.clear();
    if (!claimed) return complain("the recovery has gone: another window has taken it");
    try {
        Family family = read_family(claimed->family());
        std::vector<fs::path> sources;
        if (!claimed->note.document_folder.empty()) sources.push_back(claimed->note.document_folder);
        replace_document(std::move(family), std::move(sources));
        state_.document.mark_unsaved();
        recovered_ = std::move(claimed);
    } catch (const std::runtime_error& error) {
        complain(fmt::format("{}; it is kept", error.what()));
    }
}

void DocumentFiles::remember(const fs::path& path) {
    change_settings([&](Settings& settings) { interleaf::remember(settings.recent_files, path); });
}

void DocumentFiles::change_settings(const std::function<void(Settings&)>& change) {
    change(settings_);
    if (!settings_file_) return;
    try {
        interleaf::change_settings(*settings_file_, change);
    } catch (const std::runtime_error& error) {
        complain(error.what());
    }
}

void DocumentFiles::complain(const std::string& text) {
    state_.message = text;
}

}  // namespace interleaf
