#include "app/cli/fit_command.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/error_message.h"
#include "app/cli/held_interrupts.h"
#include "app/cli/output.h"
#include "app/cli/progress_line.h"
#include "app/fitting/fit_files.h"
#include "app/fitting/fit_roots.h"
#include "family/new_family.h"
#include "fit/fit.h"
#include "hierarchy/error.h"
#include "io/family/family_file.h"
#include "io/formats.h"
#include "io/landmarks/landmark_file.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

using Json = nlohmann::ordered_json;

void check_landmark_options(const FitCommandOptions& options) {
    if (options.landmarks.empty()) {
        if (options.landmark_placing.value_or(LandmarkPlacing::keep) != LandmarkPlacing::keep)
            throw UsageError("fit: --place needs --landmarks, once per mesh");
        if (!options.onto.empty()) throw UsageError("fit: --onto needs --landmarks, once per mesh");
        return;
    }
    if (options.landmarks.size() != options.meshes.size())
        throw UsageError(fmt::format("fit: {} times --landmarks for {} meshes, expected it once per mesh",
                                     options.landmarks.size(), options.meshes.size()));
    if ((options.placing.same_size || options.placing.same_center) &&
        options.landmark_placing != LandmarkPlacing::keep)
        throw UsageError(
            "fit: landmarks give size and place, so --same-size and --same-center need --place keep");
    for (std::size_t i = options.onto.empty() ? 1 : 0; i < options.rotations.size(); ++i)
        if (options.rotations[i].degrees != 0)
            throw UsageError(
                "fit: landmarks turn all meshes after the first, expected --rotate x,0 for these");
}

void check_options(const FitCommandOptions& options) {
    if (options.json && options.output == "-")
        throw UsageError("fit: --report writes to standard output, expected a file for -o");
    if (!options.rotations.empty() && options.rotations.size() != options.meshes.size())
        throw UsageError(
            fmt::format("fit: {} times --rotate for {} meshes, expected it once per mesh (x,0 for no turn)",
                        options.rotations.size(), options.meshes.size()));
    if (!options.ups.empty() && options.ups.size() != options.meshes.size())
        throw UsageError(
            fmt::format("fit: {} times --up for {} meshes, expected it once per mesh (y for no turn)",
                        options.ups.size(), options.meshes.size()));
    check_landmark_options(options);
    if (options.meshes.size() == 1) {
        key_target_of(options.output);
    } else if (options.output == "-") {
        throw UsageError("fit: -o must name a folder for several meshes");
    }
}

SphereRoots roots_named(const std::string& name) {
    if (const NamedRoots* const named = find_roots(name)) return named->roots;
    const std::filesystem::path file = name;
    if (!is_called(file, &Format::holds_mesh_as_key))
        throw UsageError(
            fmt::format("--roots: expected cube, icosahedron, octahedron or an {} file, got '{}'",
                        extensions_in_words(&Format::holds_mesh_as_key), name));
    const auto read = find_format(file)->read_keys(std::span(&file, 1), std::nullopt);
    if (const auto* misfit = std::get_if<Misfit>(&read)) throw InputError(misfit->reason);
    try {
        return project_to_sphere(std::get<FileKeys>(read).keys.front());
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", name, error.what()));
    }
}

/// Gives \p task the landmarks, the roots, the origin and the first key of the family in \p path.
void aim_at(const std::string& path, FitTask& task) {
    const Family family = read_family(path);
    if (family.landmarks.empty())
        throw InputError(
            fmt::format("{}: has no landmarks, expected a family that fit has made with --landmarks", path));
    task.options.roots = roots_of(family).roots;
    task.first_key = *family.keys.front().hierarchy;
    for (const auto& [name, direction] : family.landmarks)
        task.targets.push_back(
            {name, point_in_direction(*task.first_key, task.options.roots, direction), direction});
    task.origin = family.origin;
    task.reference = extent_of(surface_of(*task.first_key));
}

/// Landmarks as a family keeps them. A family knows its sphere only if its roots have a name.
std::vector<LandmarkDirection> kept_landmarks(const FitCommandOptions& options, const FitReport& first) {
    std::vector<LandmarkDirection> landmarks;
    if (options.onto.empty() && find_roots(options.roots) == nullptr) return landmarks;
    for (const FittedLandmark& each : first.landmarks) landmarks.push_back({each.name, each.direction});
    return landmarks;
}

/// The fitted meshes of a command.
struct Fitted {
    std::vector<FittedMesh> meshes;
    glm::dvec3 origin{0};
};

/// Fits every mesh.
/// \throw Cancelled  when an interrupt is waiting
Fitted fit_files(const FitCommandOptions& options, const HeldInterrupts& interrupts) {
    FitTask task{.meshes = options.meshes,
                 .options = {.roots = roots_named(options.roots),
                             .leaves = options.leaves,
                             .tolerance = options.tolerance,
                             .keep_largest = options.keep_largest,
                             .fill_holes = options.fill_holes},
                 .rotations = {},
                 .ups = options.ups,
                 .placing = options.placing,
                 .matches = options.matches,
                 .landmark_placing = options.landmark_placing};
    for (const std::filesystem::path& file : options.landmarks) {
        LandmarkSet set = read_landmarks(file);
        task.landmarks.push_back(std::move(set.landmarks));
        for (auto& pair : set.symmetric)
            if (std::ranges::find(task.symmetric, pair) == task.symmetric.end())
                task.symmetric.push_back(std::move(pair));
    }
    for (const AxisTurn& rotation : options.rotations) task.rotations.push_back(matrix_of(rotation));
    if (!options.onto.empty()) aim_at(options.onto, task);
    MeshFitter fitter(std::move(task));
    Fitted fitted;
    ProgressLine line;
    for (std::size_t i = 0; i < options.meshes.size(); ++i) {
        const std::filesystem::path& mesh = options.meshes[i];
        fitted.meshes.push_back(fitter.fit_next([&](std::string_view stage, double part) {
            line.show(fmt::format("{}: {}", mesh.filename().string(), stage),
                      (double(i) + part) / double(options.meshes.size()));
            return !interrupts.is_waiting();
        }));
    }
    fitted.origin = fitter.origin();
    return fitted;
}

Family family_of(const FitCommandOptions& options, const Fitted& fitted) {
    std::vector<Key> keys;
    keys.reserve(fitted.meshes.size());
    for (std::size_t i = 0; i < fitted.meshes.size(); ++i)
        keys.push_back({options.meshes[i].stem().string(), fitted.meshes[i].key.hierarchy});
    Family family = family_of_keys(family_name_for(options.output), std::move(keys));
    family.origin = fitted.origin;
    family.landmarks = kept_landmarks(options, fitted.meshes.front().key.report);
    return family;
}

Json json_of(const FitQuality& quality) {
    return {{"hausdorff", quality.hausdorff},
            {"root_mean_square", quality.root_mean_square},
            {"least_angle", quality.min_angle},
            {"flipped_leaves", quality.flipped_leaves},
            {"euler", quality.euler}};
}

Json json_of(const MatchFigures& figures) {
    return {{"mean_cosine", figures.mean_cosine},
            {"distortion", figures.distortion},
            {"stretched_area", figures.stretched}};
}

/// Null for a mesh that was not to be matched.
Json json_of(const std::optional<MatchReport>& match) {
    if (!match) return nullptr;
    Json before = json_of(match->before);
    Json after = json_of(match->after);
    const bool is_measured = match->half_way_area_before > 0;
    before["half_way_area"] = is_measured ? Json(match->half_way_area_before) : Json();
    after["half_way_area"] = is_measured ? Json(match->half_way_area_after) : Json();
    return {{"is_matched", match->fault.empty()},
            {"fault", match->fault},
            {"passes", match->passes},
            {"before", std::move(before)},
            {"after", std::move(after)}};
}

Json vector_json(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

/// What the landmarks of a mesh did.
Json landmarks_json(const FittedMesh& mesh) {
    Json landmarks = Json::array();
    for (const FittedLandmark& each : mesh.key.report.landmarks)
        landmarks.push_back({{"name", each.name},
                             {"position", vector_json(each.position)},
                             {"direction", vector_json(each.direction)},
                             {"from_mesh", each.from_mesh},
                             {"off_in_key", each.off_in_key}});
    return landmarks;
}

Json json_of(const Similarity& placement) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row)
        rows.push_back({placement.rotation[0][row], placement.rotation[1][row], placement.rotation[2][row]});
    return {{"scale", placement.scale}, {"rotation", rows}, {"moved", vector_json(placement(glm::dvec3(0)))}};
}

Json json_of(const std::filesystem::path& file, const FittedMesh& mesh) {
    const FittedKey& key = mesh.key;
    const FitReport& report = key.report;
    Json seconds = Json::object();
    double whole = 0;
    for (const StageTime& time : report.times) {
        seconds[time.stage] = seconds.value(time.stage, 0.0) + time.seconds;
        whole += time.seconds;
    }
    seconds["whole"] = whole;
    Json json = {
        {"file", file.string()},
        {"mesh", {{"vertices", report.mesh_vertices}, {"triangles", report.mesh_triangles}}},
        {"remarks", mesh.remarks},
        {"warning", mesh.warning},
        {"clean_up", report.clean_up.sentences()},
        {"area", {{"dropped", report.clean_up.dropped_area}, {"made", report.clean_up.made_area}}},
        {"map", {{"method", name_of(report.map_method)}, {"keeps", name_of(report.map_keeps)}}},
        {"mean_cosine", report.mean_cosine},
        {"match", json_of(report.match)},
        {"key", {{"leaves", key.hierarchy.leaf_count()}, {"vertices", key.hierarchy.vertex_count()}}},
        {"quality", json_of(report.quality)},
        {"hausdorff_as_brought", report.hausdorff_as_brought},
        {"quality_at_20000_leaves", json_of(report.at_20000_leaves)},
        {"seconds", seconds}};
    if (report.landmarks.empty()) return json;
    json["landmarks"] = landmarks_json(mesh);
    json["landmark_warnings"] = mesh.landmark_warnings;
    json["placement"] = mesh.placement ? json_of(*mesh.placement) : Json();
    json["distortion_at_90_percent"] = mesh.distortion ? Json(mesh.distortion->at_90_percent) : Json();
    return json;
}

void print_landmarks(const FittedMesh& mesh) {
    for (const FittedLandmark& each : mesh.key.report.landmarks)
        fmt::print("  landmark {}: {:.2g} % of the box diagonal off in the key\n", shown_text(each.name),
                   100 * each.off_in_key);
    if (!mesh.placement) return;
    const Similarity& placement = *mesh.placement;
    const double trace = placement.rotation[0][0] + placement.rotation[1][1] + placement.rotation[2][2];
    const double degrees = std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
    fmt::print("  placed by its landmarks: scaled by {:.3g}, turned by {:.3g} degrees\n", placement.scale,
               degrees);
}

void print_match(const MatchReport& match) {
    if (!match.fault.empty()) {
        fmt::print("  not matched to the first mesh: {}\n", match.fault);
        return;
    }
    fmt::print(
        "  matched to the first mesh: normals agree by {:.3f} (before: {:.3f}), distortion {:.3g}, "
        "{:.2g} % of the area stretched over 8 times, area half way {:.3f} (before: {:.3f}), passes: {}\n",
        match.after.mean_cosine, match.before.mean_cosine, match.after.distortion,
        100 * match.after.stretched, match.half_way_area_after, match.half_way_area_before, match.passes);
}

void print_report(const std::filesystem::path& file, const FittedMesh& mesh) {
    const FittedKey& key = mesh.key;
    const FitReport& report = key.report;
    fmt::print("{}: {} vertices, {} triangles\n", file.string(), report.mesh_vertices, report.mesh_triangles);
    for (const std::string& remark : mesh.remarks) fmt::print("  read: {}\n", remark);
    for (const std::string& sentence : report.clean_up.sentences())
        fmt::print("  cleaned up: {}\n", sentence);
    double whole = 0;
    for (const StageTime& time : report.times) whole += time.seconds;
    fmt::print("  key: {} leaves, at most {:.3g} % of the box diagonal from the mesh, {:.3g} % in the mean\n",
               key.hierarchy.leaf_count(), 100 * report.quality.hausdorff,
               100 * report.quality.root_mean_square);
    if (report.hausdorff_as_brought != report.quality.hausdorff)
        fmt::print("  at most {:.3g} % of its box diagonal from the input mesh\n",
                   100 * report.hausdorff_as_brought);
    if (report.match) print_match(*report.match);
    fmt::print("  least angle {:.3g} degrees, flipped leaves: {}, {:.2g} s\n", report.quality.min_angle,
               report.quality.flipped_leaves, whole);
    print_landmarks(mesh);
}

void print_reports(const FitCommandOptions& options, const std::vector<FittedMesh>& fitted) {
    for (std::size_t i = 0; i < fitted.size(); ++i) {
        for (const std::string& warning : fitted[i].landmark_warnings)
            print_error(fmt::format("{}: warning: {}", options.meshes[i].string(), warning));
        if (!fitted[i].warning.empty())
            print_error(fmt::format("{}: warning: {}; --same-size and --same-center bring meshes together",
                                    options.meshes[i].string(), fitted[i].warning));
    }
    if (options.output == "-") return;
    Json meshes = Json::array();
    for (std::size_t i = 0; i < fitted.size(); ++i) {
        if (options.json)
            meshes.push_back(json_of(options.meshes[i], fitted[i]));
        else
            print_report(options.meshes[i], fitted[i]);
    }
    if (options.json)
        fmt::print("{}\n", Json{{"meshes", meshes}}.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

void run_fit(const FitCommandOptions& options) {
    check_options(options);
    const HeldInterrupts interrupts;
    Fitted fitted;
    try {
        fitted = fit_files(options, interrupts);
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
    if (fitted.meshes.size() == 1)
        write_output(key_target_of(options.output),
                     serialize_hierarchy(fitted.meshes[0].key.hierarchy, options.form));
    else
        write_family(family_of(options, fitted), options.output, options.form);
    print_reports(options, fitted.meshes);
}

}  // namespace interleaf
