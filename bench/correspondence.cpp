// How well automatic matching (fit/correspondence) makes two bodies correspond, for pairs of meshes, without and
// with matching. Pairs of meshes with landmark files beside them, NAME.json, are measured with landmarks, too: placed
// by these, and matched where the meshes are.
//
// Usage: bench_correspondence FOLDER... or bench_correspondence A B [A B ...]: a folder stands for the pairs
// NAME-1.obj, NAME-2.obj in it. Prints two lines of JSON per pair, or five. Lengths are percent of the box diagonal of
// the first mesh. half_area is the area half way over the mean of the keys' areas, half_area_of_one_size the same of
// keys that are scaled to one area.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "json_line.h"
#include <glm/geometric.hpp>

#include "fit/fit.h"
#include "fit/half_way.h"
#include "fit/landmarks/landmark_targets.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/error.h"
#include "hierarchy/union_mesh.h"
#include "io/landmarks/landmark_file.h"
#include "io/read_files.h"

namespace {

using namespace interleaf;
using Json = nlohmann::ordered_json;
using MeshPair = std::pair<std::filesystem::path, std::filesystem::path>;

std::vector<MeshPair> pairs_in(const std::filesystem::path& folder) {
    std::vector<MeshPair> pairs;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string stem = entry.path().stem().string();
        if (!stem.ends_with("-1")) continue;
        const std::filesystem::path second =
            folder / (stem.substr(0, stem.size() - 1) + "2" + entry.path().extension().string());
        if (std::filesystem::exists(second)) pairs.emplace_back(entry.path(), second);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::vector<MeshPair> pairs_of(std::span<char* const> names) {
    std::vector<MeshPair> pairs;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::filesystem::is_directory(names[i])) {
            const std::vector<MeshPair> more = pairs_in(names[i]);
            pairs.insert(pairs.end(), more.begin(), more.end());
        } else if (i + 1 < names.size()) {
            pairs.emplace_back(names[i], names[i + 1]);
            ++i;
        }
    }
    return pairs;
}

double area_of(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    double area = 0;
    for (const auto& [a, b, c] : triangles)
        area += glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) / 2;
    return area;
}

CleanMesh read_clean(const std::filesystem::path& file) {
    SurfaceFile surface = read_surface(file);
    return clean_up({std::move(surface.positions), std::move(surface.triangles), {}}, {});
}

/// The figures of two keys that correspond.
Json figures_of(const FittedKey& first, const FittedKey& second) {
    const std::vector<const Hierarchy*> keys = {&first.hierarchy, &second.hierarchy};
    const UnionMesh both = unite(keys);
    const std::vector<Triangle> triangles(both.triangles.begin(), both.triangles.end());
    const std::vector<glm::dvec3> a(both.positions[0].begin(), both.positions[0].end());
    const std::vector<glm::dvec3> b(both.positions[1].begin(), both.positions[1].end());
    std::vector<glm::dvec3> half;
    for (std::size_t v = 0; v < a.size(); ++v) half.push_back((a[v] + b[v]) / 2.0);

    const MeshView mesh{first.mesh.triangles, first.mesh.positions};
    const double percent = 100 / box_diagonal(first.mesh);
    const double area_a = area_of(triangles, a);
    const double area_b = area_of(triangles, b);
    double cosine = 0;
    double stretched = 0;
    double whole = 0;
    for (const auto& [i, j, k] : triangles) {
        const glm::dvec3 u = glm::cross(a[j] - a[i], a[k] - a[i]) / area_a;
        const glm::dvec3 v = glm::cross(b[j] - b[i], b[k] - b[i]) / area_b;
        const double length_u = glm::length(u);
        const double length_v = glm::length(v);
        const double weight = length_u + length_v;
        whole += weight;
        if (length_u > 0 && length_v > 0) cosine += weight * glm::dot(u, v) / length_u / length_v;
        if (length_u > 8 * length_v || length_v > 8 * length_u) stretched += weight;
    }
    return {{"half_way", percent * hausdorff_distance({triangles, half}, mesh, {})},
            {"keys", percent * hausdorff_distance({triangles, b}, mesh, {})},
            {"cosine", cosine / whole},
            {"half_area", 2 * area_of(triangles, half) / (area_a + area_b)},
            {"half_area_of_one_size", half_way_area(first.hierarchy, second.hierarchy, glm::dmat3(1))},
            {"stretched", 100 * stretched / whole}};
}

Json key_figures(const FittedKey& key) {
    double seconds = 0;
    for (const StageTime& time : key.report.times) seconds += time.seconds;
    return {{"hausdorff", 100 * key.report.quality.hausdorff},
            {"angle", key.report.quality.min_angle},
            {"flipped", key.report.quality.flipped_leaves},
            {"seconds", seconds}};
}

/// How long work takes on one core, and how long it takes with all cores.
class WorkClock {
  public:
    double processor_seconds() const {
        return static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC;
    }
    double elapsed_seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    std::clock_t processor_ = std::clock();
    Clock::time_point begin_ = Clock::now();
};

void print_figures(const std::string& name, const std::string& match, const FittedKey& first,
                   const FittedKey& second, const WorkClock& clock) {
    Json line = {{"pair", name}, {"match", match}};
    line.update(figures_of(first, second));
    line.update(key_figures(second));
    line["processor_seconds"] = clock.processor_seconds();
    line["elapsed_seconds"] = clock.elapsed_seconds();
    if (const auto& report = second.report.match)
        line.update({{"fault", report->fault},
                     {"passes", report->passes},
                     {"energy", {report->before.energy, report->after.energy}},
                     {"distortion", report->after.distortion},
                     {"half_way_area", {report->half_way_area_before, report->half_way_area_after}}});
    double match_seconds = 0;
    for (const StageTime& time : second.report.times)
        if (time.stage == "matching") match_seconds += time.seconds;
    line["match_seconds"] = match_seconds;
    bench::print_line(line);
    std::fflush(stdout);
}

/// Fits the second mesh of a pair to the first, with landmarks if both have some.
class Measurement {
  public:
    explicit Measurement(const MeshPair& pair)
        : name_(pair.first.stem().string() + " " + pair.second.stem().string()),
          second_(read_clean(pair.second)) {
        FitOptions options;
        const auto file_of = [](std::filesystem::path mesh) { return mesh.replace_extension(".json"); };
        const bool has_landmarks =
            std::filesystem::exists(file_of(pair.first)) && std::filesystem::exists(file_of(pair.second));
        if (has_landmarks) options.landmarks = read_landmarks(file_of(pair.first)).landmarks;
        first_ = fit(read_clean(pair.first), options);
        if (has_landmarks) landmarks_ = read_landmarks(file_of(pair.second)).landmarks;
    }

    void run() {
        measure("none", false, {});
        measure("auto", true, {});
        if (landmarks_.empty()) return;
        measure("landmarks", false, LandmarkPlacing::similarity);
        measure("landmarks and auto", true, LandmarkPlacing::similarity);
        measure("landmarks and auto, kept in place", true, LandmarkPlacing::keep);
    }

  private:
    /// \param placing  none for a fit without landmarks
    void measure(const std::string& match, bool is_matched, std::optional<LandmarkPlacing> placing) {
        FitOptions options;
        CleanMesh clean = second_;
        std::vector<glm::dvec3> directions;
        if (placing) {
            AimedLandmarks aimed = aim(landmarks_, targets_of(first_.report.landmarks));
            if (const auto placement = placement_of(aimed, placing)) {
                for (glm::dvec3& position : clean.mesh.positions) position = (*placement)(position);
                for (Landmark& landmark : aimed.landmarks)
                    landmark.position = (*placement)(landmark.position);
            }
            options.landmarks = std::move(aimed.landmarks);
            options.counterparts = std::move(aimed.positions);
            for (const FittedLandmark& each : first_.report.landmarks) directions.push_back(each.direction);
        }
        std::unique_ptr<const MatchedBody> model;
        if (is_matched)
            model = model_of(first_.mapped_mesh(), first_.points, glm::dmat3(1), directions, options.matching,
                             {});
        options.model = model.get();
        const WorkClock clock;
        const FittedKey key = fit(std::move(clean), options);
        print_figures(name_, match, first_, key, clock);
    }

    std::string name_;
    CleanMesh second_;
    FittedKey first_;
    std::vector<Landmark> landmarks_;  ///< of the second mesh; empty unless both have some
};

}  // namespace

int main(int argc, char** argv) {
    const std::vector<MeshPair> pairs = pairs_of(std::span(argv + 1, static_cast<std::size_t>(argc - 1)));
    if (pairs.empty()) {
        std::fprintf(stderr, "usage: %s FOLDER... | A B [A B ...]\n", argv[0]);
        return 2;
    }
    int failures = 0;
    for (const MeshPair& pair : pairs) {
        try {
            Measurement(pair).run();
        } catch (const InputError& error) {
            std::fprintf(stderr, "%s: %s\n", pair.first.string().c_str(), error.what());
            ++failures;
        }
    }
    return failures > 0 ? 1 : 0;
}
