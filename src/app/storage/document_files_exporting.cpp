// The files of the document: exports, pictures and films.
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/storage/document_files.h"
#include "app/storage/save_folder.h"
#include "io/file/file_pattern.h"
#include "io/film/film_encoder.h"
#include "io/formats.h"
#include "io/text/joined_text.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> film_extensions() {
    std::vector<std::string> extensions;
    for (const FilmFormat& format : film_formats()) extensions.emplace_back(format.extension);
    return extensions;
}

/// The kinds of files that the file browser offers to export to: all, then each.
std::vector<FileType> exported_types() {
    std::vector<FileType> types = {{"Everything that is exported", extensions_of(&Format::is_exported)}};
    const auto add = [&](std::string_view title, std::string_view extension) {
        types.push_back({std::string(title), {std::string(extension)}});
    };
    for (const Format& format : formats())
        if (format.is_exported()) add(format.title, format.extension);
    add("PNG picture", ".png");
    for (const FilmFormat& format : film_formats()) add(format.title, format.extension);
    types.front().extensions.emplace_back(".png");
    for (const std::string& extension : film_extensions()) types.front().extensions.push_back(extension);
    return types;
}

}  // namespace

void DocumentFiles::browse_to_export() {
    FileRequest request;
    request.title = "Export";
    request.action = "Export";
    request.purpose = FilePurpose::save;
    request.types = exported_types();
    request.name = folder_name(state_.document.family().name) + ".obj";
    browse(std::move(request), [this](const FileChoice& choice) { export_as(choice.files.front()); });
}

void DocumentFiles::browse_to_save_picture() {
    FileRequest request;
    request.title = "Save picture";
    request.action = "Save picture";
    request.purpose = FilePurpose::save;
    request.types = {{"PNG picture", {".png"}}};
    request.name = folder_name(state_.document.family().name) + ".png";
    browse(std::move(request), [this](const FileChoice& choice) { export_as(choice.files.front()); });
}

void DocumentFiles::export_as(const fs::path& file) {
    const std::string extension = lower_case_extension(file);
    if (extension == ".png" || film_format_with_extension(extension) != nullptr)
        state_.film_wish = file;
    else if (is_called(file, &Format::is_exported))
        exporting_.begin(state_.document.snapshot(), state_.session.weights(), file, now_);
    else
        complain(fmt::format("{}: expected the name of an {} file, a picture .png, or a film {}",
                             file.filename().string(), extensions_in_words(&Format::is_exported),
                             either_of(film_extensions())));
}

}  // namespace interleaf
