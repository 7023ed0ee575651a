#include "fit/correspondence/match.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/correspondence/direction_insertion.h"
#include "fit/correspondence/even_mesh.h"
#include "fit/correspondence/pull_back.h"
#include "fit/correspondence/sphere_mesh.h"
#include "fit/landmarks/similarity.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// The fractions of the whole work at which its parts begin.
constexpr double moving_begins = 0.1;
constexpr double finishing_begins = 0.9;

/// The meshes from which the first passes start, in vertices. Which one gives the best match differs.
constexpr std::array<std::size_t, 3> start_sizes = {100, 400, 200};

/// To these numbers of vertices, the best match so far is coarsened in the passes after the first ones.
constexpr std::array<std::size_t, 5> pass_sizes = {500, 300, 1000, 700, 400};

struct Movement {
    MovingMesh::Places places;
    MatchFigures figures;
    int passes = 0;
};

/// Moves the model's mesh over the other body in several passes, and keeps the best.
/// \return nothing if no pass ends with all vertices on the other body
std::optional<Movement> move_over(MovingMesh& mesh, const MatchOptions& options, ProgressMeter& meter) {
    constexpr int sweeps_of_coarse = 300;
    constexpr int sweeps_per_growth = 60;
    constexpr double stiffer = 3;
    constexpr int last_sweeps = 100;
    const std::size_t all = mesh.count();
    Movement best;
    best.figures.energy = std::numeric_limits<double>::infinity();
    bool is_found = false;
    for (int pass = 0; pass < options.max_passes; ++pass) {
        meter.enter("matching", double(pass) / (options.max_passes + 1));
        const auto number = static_cast<std::size_t>(pass);
        if (number < start_sizes.size() || !is_found) {
            mesh.put_at_own_points();
            mesh.coarsen_to(start_sizes[number % start_sizes.size()],
                            number < start_sizes.size() ? 0 : static_cast<std::uint32_t>(pass), false);
        } else {
            mesh.set_places(best.places);
            mesh.coarsen_to(pass_sizes[number % pass_sizes.size()], static_cast<std::uint32_t>(pass), true);
        }
        mesh.set_weights(weights_at(double(mesh.count())));
        mesh.relax(sweeps_of_coarse);
        if (!mesh.refine(sweeps_per_growth)) continue;
        const MatchFigures figures = mesh.figures();
        best.passes = pass + 1;
        if (!(figures.energy < best.figures.energy)) continue;
        is_found = true;
        best.places = mesh.places();
        best.figures = figures;
        if (figures.distortion < options.enough) break;
    }
    if (!is_found) return std::nullopt;
    meter.enter("matching", double(options.max_passes) / (options.max_passes + 1));
    MatchWeights weights = weights_at(double(all));
    mesh.set_places(best.places);
    weights.distortion *= stiffer;
    mesh.set_weights(weights);
    mesh.relax(last_sweeps);
    weights.distortion /= stiffer;
    mesh.set_weights(weights);
    best.places = mesh.places();
    best.figures = mesh.figures();
    return best;
}

/// Relaxes a match once more, with distortion weighted by \p factor: less strained places are pulled back with fewer
/// triangles turned over.
void stiffen(MovingMesh& mesh, const MovingMesh::Places& places, double factor) {
    constexpr int sweeps = 100;
    MatchWeights weights = weights_at(double(mesh.count()));
    mesh.set_places(places);
    weights.distortion *= factor;
    mesh.set_weights(weights);
    mesh.relax(sweeps);
    weights.distortion /= factor;
    mesh.set_weights(weights);
}

/// Vertices of the even mesh of a body with \p count vertices. Over twice as many would only cost time.
std::size_t even_vertices(const MatchOptions& options, std::size_t count) {
    constexpr std::size_t least = 1500;
    return std::min(options.vertices, std::max(least, 2 * count));
}

std::vector<std::array<Index, 2>> split(SphereMesh& body, std::size_t vertices, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("making an even mesh", 0);
    return split_long_edges(body, vertices, meter);
}

/// \p mesh with the middles of the halved edges.
SurfaceMesh with_middles(const SurfaceMesh& mesh, std::span<const std::array<Index, 2>> halved,
                         const std::vector<Triangle>& triangles) {
    SurfaceMesh fine{.positions = mesh.positions, .triangles = triangles, .colors = {}};
    fine.positions.reserve(mesh.positions.size() + halved.size());
    for (const auto& [a, b] : halved)
        fine.positions.push_back(fine.positions[a] / 2.0 + fine.positions[b] / 2.0);
    return fine;
}

/// Where the map \p points of the split body puts the model's vertices on the other body.
MovingMesh::Places places_by_map(const SphereMesh& body, std::span<const glm::dvec3> points,
                                 const MatchedBody& model, const MatchedBody& other) {
    const SphereLocation in_map(body.triangles, points);
    MovingMesh::Places places;
    Index guess = no_index;
    Index guess_on_other = no_index;
    for (const glm::dvec3& point : model.points()) {
        const MeshPoint on_body = in_map.locate(point, guess);
        guess = on_body.triangle;
        const glm::dvec3 direction =
            glm::normalize(on_body.of(std::span(body.triangles), std::span(body.points)));
        const MeshPoint place = other.locate(direction, guess_on_other);
        guess_on_other = place.triangle;
        places.on_mesh.push_back(place);
        places.in_space.push_back(other.position(place));
        places.on_sphere.push_back(direction);
    }
    return places;
}

/// Turns \p body so that its landmarks come nearest to those of \p model, if they determine a rotation.
void turn_to_landmarks(SphereMesh& body, const MatchedBody& model) {
    constexpr std::size_t fewest = 3;
    std::vector<glm::dvec3> from;
    std::vector<glm::dvec3> to;
    for (const SphereLandmark& own : body.landmarks) {
        const auto there = std::ranges::find(model.landmarks(), own.direction, &SphereLandmark::direction);
        if (there == model.landmarks().end()) continue;
        from.push_back(body.positions[own.vertex]);
        to.push_back(model.positions()[there->vertex]);
    }
    if (from.size() < fewest) return;
    try {
        const glm::dmat3 rotation = fit_similarity(from, to, false).rotation;
        for (glm::dvec3& position : body.positions) position = rotation * position;
    } catch (const InputError&) {
        return;  // they lie on one line
    }
}

MatchedMap unmatched(MatchReport report, std::string fault) {
    report.after = report.before;
    report.fault = std::move(fault);
    return {{}, {}, std::move(report)};
}

}  // namespace

std::unique_ptr<const MatchedBody> model_of(const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                                            const glm::dmat3& turn, std::span<const glm::dvec3> landmarks,
                                            const MatchOptions& options, const Progress& progress) {
    SphereMesh body = normalized(mesh, points, turn);
    insert_directions(body, landmarks);
    return std::make_unique<const MatchedBody>(std::move(body), even_vertices(options, points.size()),
                                               progress);
}

MatchedMap match(const MatchedBody& model, const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                 const glm::dmat3& turn, std::span<const Index> held, const MatchOptions& options,
                 const Progress& progress) {
    const Progress begin = part_of(progress, 0, moving_begins);
    const Progress middle = part_of(progress, moving_begins, 1);
    SphereMesh body = normalized(mesh, points, turn);
    for (const Index vertex : held) body.landmarks.push_back({vertex, points[vertex]});
    turn_to_landmarks(body, model);
    const std::size_t vertices = even_vertices(options, points.size());
    const std::vector<std::array<Index, 2>> halved = split(body, vertices, begin);
    const MatchedBody other(body, vertices, begin);

    MatchReport report;
    ProgressMeter meter(middle);
    meter.enter("matching", 0);
    MovingMesh moving(model, other, meter);
    moving.set_weights(weights_at(double(moving.count())));
    report.before = moving.figures();
    if (report.before.distortion < options.enough)
        return unmatched(std::move(report), "the maps agree already");
    const std::optional<Movement> movement = move_over(moving, options, meter);
    if (!movement) return unmatched(std::move(report), "there is no room for a vertex of the first mesh");
    report.passes = movement->passes;
    meter.enter("matching", finishing_begins);
    MatchedMap matched{.mesh = with_middles(mesh, halved, body.triangles), .points = {}, .report = {}};
    std::string fault;
    for (const double stiffness : {1.0, 10.0, 40.0}) {
        if (stiffness > 1) stiffen(moving, movement->places, stiffness);
        const std::span<const glm::dvec3> on_sphere =
            stiffness > 1 ? moving.places().on_sphere : movement->places.on_sphere;
        matched.points = pull_back(body, model, on_sphere, meter);
        fault = fault_of_map(matched.mesh, matched.points);
        // Another attempt takes as long again, and pays where landmarks tell what belongs together.
        if (fault.empty() || body.landmarks.empty()) break;
    }
    if (!fault.empty()) return unmatched(std::move(report), "the matched map is not one to one: " + fault);
    moving.set_places(places_by_map(body, matched.points, model, other));
    report.after = moving.figures();
    if (!(report.after.energy < report.before.energy))
        return unmatched(std::move(report), "the matched map agrees no better");
    matched.report = std::move(report);
    return matched;
}

}  // namespace interleaf
