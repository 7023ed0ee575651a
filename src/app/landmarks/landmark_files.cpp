#include "app/landmarks/landmark_files.h"

#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/file/safe_write.h"
#include "io/landmarks/landmark_file.h"

namespace interleaf {

std::filesystem::path folder_of(const LandmarkFiles::Mesh& mesh, const std::filesystem::path& last) {
    if (mesh.file.empty()) return last;
    std::error_code error;
    const std::filesystem::path file = std::filesystem::absolute(mesh.file, error);
    return error ? last : file.parent_path();
}

void LandmarkFiles::ask(const Mesh& mesh, bool is_to_save) {
    mesh_ = mesh.index;
    is_to_save_ = is_to_save;
    FileRequest request;
    request.title = fmt::format("{} landmarks of {}", is_to_save ? "Save" : "Load", mesh.name);
    request.action = is_to_save ? "Save" : "Load";
    request.purpose = is_to_save ? FilePurpose::save : FilePurpose::open;
    request.types = {{"Landmarks", {".json"}}};
    request.folder = folder_of(mesh, last_folder_);
    if (is_to_save) request.name = (mesh.file.empty() ? "landmarks" : mesh.file.stem().string()) + ".json";
    browser_.open(std::move(request));
}

void LandmarkFiles::show(const Rect& area) {
    if (auto choice = browser_.show(area)) {
        last_folder_ = choice->folder;
        choice_ = std::move(choice);
    }
}

std::optional<LandmarkPoints> LandmarkFiles::update(const LandmarkPoints& points, std::size_t mesh_count) {
    const auto choice = std::exchange(choice_, std::nullopt);
    if (!choice) return std::nullopt;
    const std::filesystem::path& file = choice->files.front();
    try {
        if (is_to_save_) {
            write_file(file, landmarks_text({.landmarks = landmarks_on(points, mesh_)}));
            return std::nullopt;
        }
        LandmarkPoints changed = points;
        put_landmarks(changed, mesh_count, mesh_, read_landmarks(file).landmarks);
        if (changed.size() > max_landmarks)
            throw InputError(
                fmt::format("{}: more than {} landmarks together", file.string(), max_landmarks));
        return changed;
    } catch (const std::runtime_error& error) {
        fault_ = error.what();
        return std::nullopt;
    }
}

}  // namespace interleaf
