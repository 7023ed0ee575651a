// What DocumentFiles does to open files and to add keys from them, fitted first where they are no keys.
#include <ranges>
#include <utility>

#include <fmt/format.h>

#include "app/document/edit_commands.h"
#include "app/document/open_family.h"
#include "app/fitting/fit_roots.h"
#include "app/storage/document_files.h"
#include "family/new_family.h"
#include "hierarchy/error.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

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
        {"Families, keys and meshes", {".json", ".ilh", ".obj", ".ply", ".stl", ".off"}},
        {"Families and keys", {".json", ".ilh"}},
        {"Meshes", {".obj", ".ply", ".stl", ".off"}}};
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

/// Gives \p receiver the family that \p paths stand for; meshes that are no keys as they are go to \p fit,
/// with the reason where it is not their kind.
void DocumentFiles::read_or_fit(const std::vector<fs::path>& paths,
                                const std::function<void(Family)>& receiver, const Fit& fit) {
    std::vector<fs::path> files;
    try {
        files = files_of(paths);
        if (are_surfaces(files)) return fit(files, "");
        receiver(open_family(files));
    } catch (const InputError& error) {
        if (files.size() > 1 && are_obj_files(files)) return fit(files, error.what());
        complain(error);
    } catch (const std::runtime_error& error) {
        complain(error);
    }
}

void DocumentFiles::open(std::vector<fs::path> files) {
    leave_document([this, files = std::move(files)] {
        read_or_fit(
            files,
            [&](Family family) {
                replace_document(std::move(family), files);
                remember(files.front());
            },
            [&](const std::vector<fs::path>& meshes, const std::string& reason) {
                fitting_.offer({meshes, reason, {}},
                               [this, meshes](const FittedMeshes& fitted) { open_fitted(meshes, fitted); });
            });
    });
}

void DocumentFiles::reopen() {
    leave_document([this] {
        try {
            Family family = open_family(sources_);
            replace_document(std::move(family), sources_);
        } catch (const std::runtime_error& error) {
            complain(error);
        }
    });
}

/// An .obj is a key as it is, but one over the family's roots only once it has been fitted.
void DocumentFiles::add_keys(const std::vector<fs::path>& files, double now) {
    read_or_fit(
        files,
        [&](Family family) {
            const auto before = state_.document.snapshot();
            interleaf::add_keys(state_, std::move(family.keys), family.origin, now);
            if (state_.document.snapshot() != before) return;
            const std::vector<fs::path> read = files_of(files);
            if (are_obj_files(read)) offer_to_add(read, std::exchange(state_.message, {}).text);
        },
        [this](const std::vector<fs::path>& meshes, const std::string& reason) {
            offer_to_add(meshes, reason);
        });
}

/// Keys for the document are fitted over its roots.
void DocumentFiles::offer_to_add(const std::vector<fs::path>& meshes, const std::string& reason) {
    try {
        const Family& family = state_.document.family();
        fitting_.offer({meshes, reason, roots_of(family), family.origin,
                        extent_of(surface_of(*family.keys.front().hierarchy))},
                       [this](const FittedMeshes& fitted) {
                           interleaf::add_keys(state_, keys_of(fitted.comparisons), fitted.origin, now_);
                           tell_fit(fitted);
                       });
    } catch (const InputError& error) {
        complain(error);
    }
}

/// The fitted keys as a new document, which is nowhere on disk yet; several are played once, from the first
/// to the last.
void DocumentFiles::open_fitted(const std::vector<fs::path>& meshes, const FittedMeshes& fitted) {
    std::vector<Key> keys = keys_of(fitted.comparisons);
    const std::string name = keys.size() == 1 ? keys.front().name : "Fitted meshes";
    Family family = family_of_keys(name, std::move(keys));
    family.origin = fitted.origin;
    replace_document(std::move(family), {});
    state_.document.mark_unsaved();
    for (const fs::path& mesh : meshes) remember(mesh);
    state_.session.toggle_loop(now_);
    state_.session.toggle_playing(now_);
    tell_fit(fitted);
}

/// Says how near to their meshes the keys are that have come into the document. No question: what has been
/// fitted is to be seen, and to be played with, at once.
void DocumentFiles::tell_fit(const FittedMeshes& fitted) {
    const auto compared = compared_keys(state_.document.family(), fitted.comparisons);
    if (compared.empty()) return;
    state_.comparisons.insert(state_.comparisons.end(), fitted.comparisons.begin(), fitted.comparisons.end());
    state_.compared = compared.front().comparison;
    constexpr std::size_t max_lines = 6;
    std::string text =
        compared.size() == 1
            ? "A key has been fitted. M compares it with its mesh."
            : fmt::format("{} keys have been fitted. M compares them with their meshes.", compared.size());
    for (const ComparedKey& each : compared | std::views::take(max_lines))
        text += fmt::format("\n{}: {}.", state_.document.family().keys[each.key].name,
                            in_words(each.comparison->quality));
    if (compared.size() > max_lines) text += fmt::format("\nAnd {} more.", compared.size() - max_lines);
    for (const std::string& warning : fitted.warnings) text += "\n" + warning;
    state_.message = {.text = std::move(text), .kind = MessageKind::notice, .seen = now_};
}

}  // namespace interleaf
