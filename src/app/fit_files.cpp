#include "app/fit_files.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/family_file.h"
#include "io/surface_file.h"

namespace interleaf {

namespace {

/// The part of the whole at which fitting ends and comparing begins.
constexpr double comparing_begins = 0.97;

}  // namespace

bool is_surface_file(const std::filesystem::path& file) {
    const std::string extension = lower_case_extension(file);
    return extension == ".ply" || extension == ".stl" || extension == ".off";
}

bool are_surfaces(std::span<const std::filesystem::path> files) {
    return std::ranges::any_of(files, is_surface_file) &&
           std::ranges::all_of(files, [](const std::filesystem::path& file) {
               return is_surface_file(file) || lower_case_extension(file) == ".obj";
           });
}

bool are_obj_files(std::span<const std::filesystem::path> files) {
    return std::ranges::all_of(
        files, [](const std::filesystem::path& file) { return lower_case_extension(file) == ".obj"; });
}

FittedKey fit_file(const std::filesystem::path& file, const FitOptions& options, const Progress& progress) {
    SurfaceFile surface = read_surface(file);
    try {
        return fit({std::move(surface.positions), std::move(surface.triangles), std::move(surface.colors)},
                   options, progress);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

std::vector<Key> keys_of(const Comparisons& fitted) {
    std::vector<Key> keys;
    keys.reserve(fitted.size());
    for (const auto& each : fitted)
        keys.push_back({std::filesystem::path(each->mesh_name).stem().string(), each->key});
    return keys;
}

FitJob::FitJob(std::vector<std::filesystem::path> meshes, FitOptions options,
               std::vector<glm::dmat3> rotations)
    : meshes_(std::move(meshes)),
      options_(std::move(options)),
      rotations_(std::move(rotations)),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

FitJob::State FitJob::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

Comparisons FitJob::take() {
    const std::scoped_lock lock(mutex_);
    if (error_) std::rethrow_exception(error_);
    return std::move(fitted_);
}

void FitJob::work(const std::stop_token& stop) {
    std::exception_ptr error;
    try {
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            const std::filesystem::path& mesh = meshes_[i];
            options_.rotation = rotations_[i];
            const auto part_of_all = [&](std::string_view stage, double part) {
                report(mesh, stage, (static_cast<double>(i) + part) / static_cast<double>(meshes_.size()));
                return !stop.stop_requested();
            };
            FittedKey key = fit_file(mesh, options_, [&](std::string_view stage, double part) {
                return part_of_all(stage, comparing_begins * part);
            });
            auto compared = std::make_shared<const FitComparison>(
                compare(mesh.filename().string(), std::move(key), [&](std::string_view stage, double part) {
                    return part_of_all(stage, comparing_begins + (1 - comparing_begins) * part);
                }));
            const std::scoped_lock lock(mutex_);
            fitted_.push_back(std::move(compared));
        }
    } catch (...) {
        error = std::current_exception();  // for take(), on the other thread
    }
    const std::scoped_lock lock(mutex_);
    error_ = error;
    state_.is_done = true;
}

void FitJob::report(const std::filesystem::path& mesh, std::string_view stage, double part) {
    const std::scoped_lock lock(mutex_);
    state_.stage = fmt::format("{}: {}", mesh.filename().string(), stage);
    state_.part = part;
}

}  // namespace interleaf
