#include "app/fitting/fit_files.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "family/origin.h"
#include "fit/mesh/stopwatch.h"
#include "hierarchy/error.h"
#include "io/series_files.h"

namespace interleaf {

namespace {

/// The part of the whole at which fitting ends and comparing begins.
constexpr double comparing_begins = 0.97;

}  // namespace

CleanMesh MeshFitter::clean_next(SurfaceFile surface, const Progress& progress) {
    if (!task_.ups.empty()) turn_up(surface.positions, task_.ups[next_]);
    if (!task_.origin) task_.origin = origin_for(surface.positions, surface.triangles);
    for (glm::dvec3& position : surface.positions) position -= *task_.origin;
    return clean_up({std::move(surface.positions), std::move(surface.triangles), std::move(surface.colors),
                     std::move(surface.scalars)},
                    progress);
}

/// Sets the landmarks of the next mesh in the options, and places the mesh by them.
void MeshFitter::aim_landmarks(CleanMesh& clean, FittedMesh& fitted) {
    task_.options.landmarks.clear();
    task_.options.counterparts.clear();
    if (task_.landmarks.empty() || task_.landmarks[next_].empty()) return;
    std::vector<Landmark> landmarks = std::move(task_.landmarks[next_]);
    std::vector<glm::dvec3> positions;
    positions.reserve(landmarks.size());
    for (const Landmark& landmark : landmarks) positions.push_back(landmark.position);
    if (!task_.ups.empty()) turn_up(positions, task_.ups[next_]);
    for (std::size_t k = 0; k < landmarks.size(); ++k) landmarks[k].position = positions[k] - origin();

    if (task_.targets.empty()) {
        const auto has_direction = [](const Landmark& landmark) { return landmark.direction.has_value(); };
        if (!std::ranges::all_of(landmarks, has_direction))
            for (Landmark& landmark : landmarks) landmark.direction.reset();
    } else {
        AimedLandmarks aimed = aim(landmarks, task_.targets);
        fitted.placement = placement_of(aimed, task_.landmark_placing);
        fitted.remarks.insert(fitted.remarks.end(), aimed.remarks.begin(), aimed.remarks.end());
        landmarks = std::move(aimed.landmarks);
        task_.options.counterparts = std::move(aimed.positions);
    }
    if (fitted.placement) {
        for (SurfaceMesh* part : {&clean.mesh, &clean.dropped})
            for (glm::dvec3& position : part->positions) position = (*fitted.placement)(position);
        for (Landmark& landmark : landmarks) landmark.position = (*fitted.placement)(landmark.position);
    }
    task_.options.landmarks = std::move(landmarks);
    task_.options.symmetric = task_.symmetric;
}

/// Compares the next key with the first one, or makes it the first one.
void MeshFitter::judge_landmarks(FittedMesh& fitted) {
    const FitReport& report = fitted.key.report;
    if (report.landmarks.empty()) return;
    fitted.landmark_warnings = report.landmark_faults;
    if (task_.targets.empty()) {
        task_.targets = targets_of(report.landmarks);
        task_.first_key = fitted.key.hierarchy;
        return;
    }
    std::vector<glm::dvec3> places;
    places.reserve(report.landmarks.size());
    for (const FittedLandmark& each : report.landmarks)
        places.push_back(std::ranges::find(task_.targets, each.name, &Landmark::name)->position);
    fitted.distortion = morph_distortion(*task_.first_key, fitted.key.hierarchy, places);
    const std::string fault =
        fault_of_distortion(*fitted.distortion, report.landmarks[fitted.distortion->worst].name);
    if (!fault.empty()) fitted.landmark_warnings.push_back(fault);
}

FittedMesh MeshFitter::fit_next(const Progress& progress) {
    constexpr double fitting_begins = 0.1;
    constexpr double fitting_ends = 0.97;
    const std::filesystem::path& file = task_.meshes[next_];
    SurfaceFile surface = read_mesh_to_fit(file);
    FittedMesh fitted;
    fitted.remarks = std::move(surface.remarks);
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    try {
        CleanMesh clean = clean_next(std::move(surface), [&](std::string_view stage, double part) {
            return !progress || progress(stage, fitting_begins * part);
        });
        stopwatch.lap("clean-up");
        aim_landmarks(clean, fitted);
        if (!task_.reference) task_.reference = extent_of(clean.mesh);
        if (!fitted.placement) place(clean, *task_.reference, task_.placing);
        fitted.warning = fault_of_placing(*task_.reference, extent_of(clean.mesh));
        // A body with targets is placed like the first one, and turned like it before the two are matched.
        if (!task_.rotations.empty())
            task_.options.rotation = task_.rotations[task_.targets.empty() ? next_ : 0];
        if (task_.matches && task_.first_key && !model_)
            model_first_key(
                [&](std::string_view stage, double) { return !progress || progress(stage, fitting_begins); });
        task_.options.model = model_.get();
        fitted.key = fit(std::move(clean), task_.options, [&](std::string_view stage, double part) {
            return !progress || progress(stage, fitting_begins + (fitting_ends - fitting_begins) * part);
        });
        keep_model(fitted.key, [&](std::string_view stage, double part) {
            return !progress || progress(stage, fitting_ends + (1 - fitting_ends) * part);
        });
        judge_landmarks(fitted);
    } catch (const InputError& error) {
        // The remarks on reading the file may explain the error.
        std::string text = fmt::format("{}: {}", file.string(), error.what());
        for (const std::string& remark : fitted.remarks) text += fmt::format(" ({})", remark);
        throw InputError(text);
    }
    std::vector<StageTime>& stages = fitted.key.report.times;
    stages.insert(stages.begin(), times.begin(), times.end());
    if (next_ == 0 && origin() != glm::dvec3(0)) fitted.remarks.push_back(origin_sentence(origin()));
    ++next_;
    return fitted;
}

/// Makes the first key of an existing family the model.
void MeshFitter::model_first_key(const Progress& progress) {
    std::vector<glm::dvec3> directions;
    directions.reserve(task_.targets.size());
    for (const Landmark& target : task_.targets) directions.push_back(*target.direction);
    model_ = model_of(surface_of(*task_.first_key), sphere_points_of(*task_.first_key, task_.options.roots),
                      glm::dmat3(1), directions, task_.options.matching, progress);
}

void MeshFitter::keep_model(FittedKey& key, const Progress& progress) {
    if (task_.matches && !model_ && next_ == 0 && task_.meshes.size() > 1) {
        std::vector<glm::dvec3> directions;
        directions.reserve(key.report.landmarks.size());
        for (const FittedLandmark& landmark : key.report.landmarks) directions.push_back(landmark.direction);
        model_ = model_of(key.mapped_mesh(), key.points, task_.options.rotation, directions,
                          task_.options.matching, progress);
    }
    key.fine_mesh = {};
    key.points = {};
}

std::vector<Key> keys_of(const Comparisons& fitted) {
    std::vector<Key> keys;
    keys.reserve(fitted.size());
    for (const auto& each : fitted)
        keys.push_back({std::filesystem::path(each->mesh_name).stem().string(), each->key});
    return keys;
}

BackgroundJob<FittedMeshes>::Work fit_work(FitTask task) {
    return [task = std::move(task)](const Progress& progress) {
        MeshFitter fitter(task);
        FittedMeshes all;
        const auto count = static_cast<double>(task.meshes.size());
        for (std::size_t i = 0; i < task.meshes.size(); ++i) {
            const std::string mesh = task.meshes[i].filename().string();
            const Progress part_of_all = [&](std::string_view stage, double part) {
                return progress(fmt::format("{}: {}", mesh, stage), (static_cast<double>(i) + part) / count);
            };
            FittedMesh fitted = fitter.fit_next([&](std::string_view stage, double part) {
                return part_of_all(stage, comparing_begins * part);
            });
            const std::optional<MatchReport>& match = fitted.key.report.match;
            if (match) all.stretched = std::max(all.stretched, match->after.stretched);
            all.comparisons.push_back(std::make_shared<const FitComparison>(
                compare(mesh, std::move(fitted.key), [&](std::string_view stage, double part) {
                    return part_of_all(stage, comparing_begins + (1 - comparing_begins) * part);
                })));
            for (const std::string& warning : fitted.landmark_warnings)
                all.warnings.push_back(fmt::format("{}: {}.", mesh, warning));
            if (!fitted.warning.empty()) all.warnings.push_back(fmt::format("{} {}.", mesh, fitted.warning));
        }
        all.origin = fitter.origin();
        for (const Landmark& target : fitter.targets())
            all.landmarks.push_back({target.name, *target.direction});
        return all;
    };
}

}  // namespace interleaf
