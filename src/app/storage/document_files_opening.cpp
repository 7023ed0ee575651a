// DocumentFiles: opens files and adds keys from them. Meshes that are not keys are fitted first.
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "app/document/edit_commands.h"
#include "app/document/opening.h"
#include "app/document/shown_field.h"
#include "app/fitting/fit_roots.h"
#include "app/storage/document_files.h"
#include "family/family_fields.h"
#include "family/new_family.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "io/file/file_pattern.h"
#include "io/formats.h"
#include "text/shown_text.h"
#include "ui/widgets/command_keys.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// Reading that takes less shows no progress: a dialog would only flicker. The window waits for it a moment.
constexpr double hidden_opening = 0.3;  // seconds
constexpr std::chrono::milliseconds awaited_opening{150};

FileRequest request_to_open(std::string title, std::string action, std::vector<FileType> types) {
    FileRequest request;
    request.title = std::move(title);
    request.action = std::move(action);
    request.several = true;
    request.types = std::move(types);
    request.opens_folder = [](const fs::path& folder) {
        return is_family_folder(folder) || !files_in_folder(folder).empty();
    };
    return request;
}

}  // namespace

const std::vector<FileType>& DocumentFiles::openable_types() {
    static const std::vector<FileType> types{
        {"Families, keys, meshes and series", extensions_of(&Format::is_openable)},
        {"Families, keys and series", extensions_of(&Format::opens_unfitted)},
        {"Meshes", extensions_of(&Format::holds_mesh)}};
    return types;
}

void DocumentFiles::browse_to_open() {
    browse(request_to_open("Open", "Open", openable_types()),
           [this](const FileChoice& choice) { open(choice.files); });
}

void DocumentFiles::browse_to_add() {
    browse(request_to_open("Add keys", "Add", openable_types()),
           [this](const FileChoice& choice) { add_keys(choice.files, now_); });
}

void DocumentFiles::browse_to_import() {
    browse(request_to_open("Import series", "Choose",
                           {{"Steps of series", extensions_of(&Format::holds_series)}}),
           [this](const FileChoice& choice) {
               leave_document([this, files = choice.files] { offer_import(files); });
           });
}

/// The options of the last import of \p file, if it is a recent series; else the usual ones.
ImportChoices DocumentFiles::remembered_choices(const fs::path& file) const {
    const auto found = settings_.imports.find(file);
    return found != settings_.imports.end() ? found->second : ImportChoices{};
}

/// Shows the options of an import, which replaces the document. They begin as those of the last import of the files.
void DocumentFiles::offer_import(const std::vector<fs::path>& files) {
    try {
        const std::vector<fs::path> steps = files_of(files);
        importing_.offer(steps, remembered_choices(path_of_all(steps)), opener_of(steps));
    } catch (const std::runtime_error& error) {
        complain(error);
    }
}

/// Reads \p paths on a worker, and hands their content to \p receiver. The document stays as it is meanwhile. Small
/// files are there within this call; otherwise the progress is shown, and can be cancelled.
void DocumentFiles::read(std::vector<fs::path> paths, std::function<void(Opening&)> receiver) {
    if (is_asking()) return;
    const std::string title = paths.empty()
                                  ? "Opening the built-in family"
                                  : fmt::format("Opening {}", shown_name(paths.front().filename().string()));
    on_opened_ = std::move(receiver);
    opening_.start(
        title,
        [paths = std::move(paths)](const Progress& progress) {
            progress("reading", 0);
            Opening opened = open_files(paths, progress);
            if (!progress("reading", 1)) throw Cancelled();  // not every reader asks
            return opened;
        },
        now_, hidden_opening);
    if (is_unattended_) opening_.wait();
    if (opening_.is_over_within(awaited_opening)) take_opened();
}

/// Hands the content of the files on, or says why they cannot be opened.
/// \pre opening_.is_over()
void DocumentFiles::take_opened() {
    const auto receiver = std::exchange(on_opened_, nullptr);
    std::optional<Opening> found;
    try {
        found = opening_.take();
    } catch (const Cancelled&) {
        return;
    } catch (const std::runtime_error& error) {
        return complain(error);
    }
    receiver(*found);
}

void DocumentFiles::open(std::vector<fs::path> files) {
    leave_document([this, files = std::move(files)] { show_files(files, {}); });
}

void DocumentFiles::open_recent(std::size_t file) {
    leave_document([this, path = recent_files()[file]] { show_files({path}, remembered_choices(path)); });
}

void DocumentFiles::reopen() {
    leave_document([this] { show_files(sources_, ImportChoices(imported_by_)); });
}

/// Reads \p paths, and replaces the document, unless it has been changed meanwhile and the user keeps it.
/// \param choices  by which a series is imported
void DocumentFiles::show_files(const std::vector<fs::path>& paths, const ImportChoices& choices) {
    const auto present = state_.document.snapshot();
    read(paths, [this, paths, choices, present](Opening& found) {
        const Action show = [this, paths, choices, content = std::make_shared<Opening>(std::move(found))] {
            if (show_opened(*content, paths, choices) && !paths.empty()) remember(paths.front());
        };
        if (state_.document.snapshot() == present)
            show();
        else
            leave_document(show);
    });
}

/// Replaces the document by the family that was found in \p paths, or offers to fit their meshes.
/// \return whether the document was replaced
bool DocumentFiles::show_opened(Opening& found, const std::vector<fs::path>& paths,
                                const ImportChoices& choices) {
    return std::visit(Cases{[&](OpenedFamily& family) {
                                replace_document(std::move(family.family), paths);
                                return true;
                            },
                            [&](OpenedKeys& keys) {
                                replace_document(std::move(keys.family), paths);
                                return true;
                            },
                            [&](const MeshesToFit& meshes) {
                                offer_to_open(meshes);
                                return false;
                            },
                            [&](SeriesToImport& series) {
                                start_import(series.files, choices, opener_of(series.files));
                                return false;
                            }},
                      found);
}

void DocumentFiles::offer_to_open(const MeshesToFit& meshes) {
    fitting_.offer({.meshes = meshes.files, .reason = meshes.reason, .roots = {}},
                   [this, files = meshes.files](const FittedMeshes& fitted) { open_fitted(files, fitted); });
}

void DocumentFiles::add_keys(const std::vector<fs::path>& files, double now) {
    now_ = now;
    read(files, [this](Opening& found) { add_opened(found); });
}

void DocumentFiles::add_opened(Opening& found) {
    const auto add = [this](Family& family) {
        const auto before = state_.document.snapshot();
        family.landmarks.clear();
        interleaf::add_keys(state_, family, now_);
        if (state_.document.snapshot() == before) return false;
        tell_added(before->keys.size());
        return true;
    };
    const auto add_family = [&](OpenedFamily& opened) { add(opened.family); };
    const auto add_or_fit = [&](OpenedKeys& keys) {
        if (add(keys.family) || !keys.can_be_fitted()) return;
        // Only the fit puts a mesh over the family's roots.
        offer_to_add({keys.files, std::exchange(state_.message, {}).text});
    };
    const auto offer_fit = [&](const MeshesToFit& meshes) { offer_to_add(meshes); };
    const auto import_and_add = [&](SeriesToImport& series) {
        start_import(std::move(series.files), {},
                     [add](ImportedSeries imported, const ImportChoices&) { add(imported.family); });
    };
    std::visit(Cases{add_family, add_or_fit, offer_fit, import_and_add}, found);
}

/// Imports a series on a worker, and shows the progress.
void DocumentFiles::start_import(std::vector<fs::path> files, const ImportChoices& choices,
                                 SeriesImporting::Receiver receiver) {
    if (!is_asking()) importing_.start(std::move(files), choices, std::move(receiver), now_);
}

/// Opens the imported series of \p files as a new document, colored by its field.
SeriesImporting::Receiver DocumentFiles::opener_of(std::vector<fs::path> files) {
    return [this, files = std::move(files)](ImportedSeries imported, const ImportChoices& choices) {
        replace_document(std::move(imported.family), files);
        imported_by_ = choices;
        color_by_field(state_.session.display, fields_of(state_.document.family()));
        change_settings([&](Settings& settings) { remember_series(settings, path_of_all(files), choices); });
        state_.message = {.text = sentences_of(imported.report), .kind = MessageKind::notice, .seen = now_};
    };
}

/// Offers to fit keys for the document over its roots.
void DocumentFiles::offer_to_add(const MeshesToFit& meshes) {
    try {
        const Family& family = state_.document.family();
        const SharedHierarchy first = family.keys.front().hierarchy;
        fitting_.offer({.meshes = meshes.files,
                        .reason = meshes.reason,
                        .roots = roots_of(family),
                        .origin = family.origin,
                        .reference = extent_of(surface_of(*first)),
                        .key_name = family.keys.front().name,
                        .first_key = first,
                        .landmarks = family.landmarks},
                       [this](const FittedMeshes& fitted) { add_fitted(fitted); });
    } catch (const InputError& error) {
        complain(error);
    }
}

/// Shows the keys from \p first on, which have been added, and says where they are.
void DocumentFiles::tell_added(std::size_t first) {
    const Family& family = state_.document.family();
    const std::size_t count = family.keys.size() - first;
    select_key(state_, first, now_);
    const std::string what = count == 1
                                 ? fmt::format("{} has been added as the last key", family.keys[first].name)
                                 : fmt::format("{} keys have been added to the end of the list", count);
    state_.message = {
        .text = fmt::format("{}. Drag {} to the timeline{}, or use the Key menu.", what,
                            count == 1 ? "it" : "them", family.domain ? " or into the domain" : ""),
        .kind = MessageKind::notice,
        .offer = count == 1 ? MessageOffer::timeline : MessageOffer::none,
        .seen = now_};
}

/// Adds fitted keys, and the landmarks that the family lacks, to the document.
void DocumentFiles::add_fitted(const FittedMeshes& fitted) {
    // A family knows its sphere only if its roots have a name.
    const bool keeps_landmarks = find_roots(roots_of(state_.document.family()).name) != nullptr;
    Family added{.name = {}, .keys = keys_of(fitted.comparisons), .timeline = {}, .domain = {}};
    added.origin = fitted.origin;
    if (keeps_landmarks) added.landmarks = fitted.landmarks;
    const std::size_t first = state_.document.family().keys.size();
    interleaf::add_keys(state_, added, now_);
    tell_fit(fitted);
    was_fit_added_ = true;
    if (state_.document.family().keys.size() != first + 1) return;
    select_key(state_, first, now_);  // what was added is shown, and has a place offered
    if (!state_.message.empty() && state_.message.offer == MessageOffer::none)
        state_.message.offer = MessageOffer::timeline;
}

/// Offers the last fit once more, with landmarks. Its keys are replaced.
void DocumentFiles::set_landmarks() {
    if (!fitting_.can_offer_again()) return;
    const bool is_untouched = state_.document.snapshot() == last_fitted_;
    if (was_fit_added_) {
        fitting_.offer_again([this, is_untouched](const FittedMeshes& fitted) {
            if (is_untouched && state_.document.snapshot() == last_fitted_) undo(state_, now_);
            add_fitted(fitted);
        });
        return;
    }
    const auto offer = [this] {
        fitting_.offer_again([this, files = fitting_.last_meshes()](const FittedMeshes& fitted) {
            open_fitted(files, fitted);
        });
    };
    if (is_untouched)
        offer();
    else
        leave_document(offer);
}

/// Opens the fitted keys as a new, unsaved document. Several keys are played once, from the first to the
/// last.
void DocumentFiles::open_fitted(const std::vector<fs::path>& meshes, const FittedMeshes& fitted) {
    std::vector<Key> keys = keys_of(fitted.comparisons);
    const std::string name = keys.size() == 1 ? keys.front().name : "Fitted meshes";
    Family family = family_of_keys(name, std::move(keys));
    family.origin = fitted.origin;
    family.landmarks = fitted.landmarks;
    replace_document(std::move(family), {});
    state_.document.mark_unsaved();
    for (const fs::path& mesh : meshes) remember(mesh);
    state_.session.set_repeat(Repeat::once, now_);
    state_.session.toggle_playing(now_);
    tell_fit(fitted);
}

/// Reports the distances between the keys added to the document and their meshes. It does not ask, so that
/// the user can see and play the result at once.
void DocumentFiles::tell_fit(const FittedMeshes& fitted) {
    const auto compared = compared_keys(state_.document.family(), fitted.comparisons);
    if (compared.empty()) return;
    state_.comparisons.insert(state_.comparisons.end(), fitted.comparisons.begin(), fitted.comparisons.end());
    state_.compared = compared.front().comparison;
    constexpr std::size_t max_lines = 6;
    std::string text =
        compared.size() == 1
            ? with_keys("A key has been fitted. Compare it with its mesh", {"Compare with mesh"}) + "."
            : with_keys(
                  fmt::format("{} keys have been fitted. Compare them with their meshes", compared.size()),
                  {"Compare with mesh"}) +
                  ".";
    for (const ComparedKey& each : compared | std::views::take(max_lines))
        text += fmt::format("\n{}: {}.", state_.document.family().keys[each.key].name,
                            in_words(each.comparison->quality));
    if (compared.size() > max_lines) text += fmt::format("\nAnd {} more.", compared.size() - max_lines);
    for (const std::string& warning : fitted.warnings) text += "\n" + warning;
    constexpr double much_stretched = 0.05;
    const bool offers_landmarks =
        fitted.stretched > much_stretched && fitted.landmarks.empty() && fitting_.can_offer_again();
    if (offers_landmarks)
        text += fmt::format("\n{:.2g} % of a body is stretched more than 8 times. Landmarks may help.",
                            100 * fitted.stretched);
    state_.message = {.text = std::move(text),
                      .kind = MessageKind::notice,
                      .offer = offers_landmarks ? MessageOffer::landmarks : MessageOffer::none,
                      .seen = now_};
    last_fitted_ = state_.document.snapshot();
    was_fit_added_ = false;
    state_.can_set_landmarks = fitting_.can_offer_again();
}

}  // namespace interleaf
