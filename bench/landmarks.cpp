// How well landmarks make bodies correspond. Takes a folder of closed meshes, NAME.off, each with a file
// NAME.vts that has one landmark per line; the first column is a vertex. Lines with one number are landmarks of
// one name. Fits each mesh, without and with matching, with some of the landmarks onto each of the first few, and
// measures where the others arrive; or fits it with all landmarks. Prints one line of JSON per fit, and one of all
// pairs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json_line.h"

#include "fit/fit.h"
#include "fit/landmarks/landmark_insertion.h"
#include "fit/landmarks/pinned_map.h"
#include "fit/mesh/surface_distance.h"
#include "fit/mesh/surface_graph.h"
#include "fit/placement.h"
#include "hierarchy/error.h"
#include "io/mesh/surface_file.h"
#include "text/parsed_number.h"

namespace {

using namespace interleaf;

/// The lines whose landmarks are given to the fit, unless all are: nose, the tips of the ears or horns, feet, and so
/// on. The ears come last.
constexpr std::array<std::size_t, 8> few_lines = {0, 5, 7, 9, 11, 13, 15, 16};

/// The lines whose landmarks are given, and the others.
struct Lines {
    std::vector<std::size_t> given;
    std::vector<std::size_t> held_out;
};

Lines lines_of(std::size_t count, bool all_given) {
    Lines lines;
    for (std::size_t line = 0; line < count; ++line) {
        const bool is_given = all_given || std::ranges::find(few_lines, line) != few_lines.end();
        (is_given ? lines.given : lines.held_out).push_back(line);
    }
    return lines;
}

struct Body {
    std::string name;
    CleanMesh clean;
    std::vector<Landmark> landmarks;  ///< one per line
};

Body read_body(const std::filesystem::path& mesh) {
    Body body{.name = mesh.stem().string(), .clean = {}, .landmarks = {}};
    SurfaceFile surface = parse_file(mesh, parse_off);
    std::ifstream file(std::filesystem::path(mesh).replace_extension(".vts"));
    for (std::string line; std::getline(file, line);) {
        std::size_t vertex = surface.positions.size();
        std::istringstream(line) >> vertex;
        if (vertex >= surface.positions.size()) throw InputError(body.name + ".vts: expected vertices");
        body.landmarks.push_back({std::to_string(body.landmarks.size()), surface.positions[vertex]});
    }
    body.clean = clean_up({std::move(surface.positions), std::move(surface.triangles), {}}, {});
    return body;
}

/// Processor seconds that \p work takes.
template <typename Work>
double processor_seconds_of(Work&& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The distance of \p place from \p vertex along the surface, for a place on it.
double distance_along(const SurfaceMesh& mesh, const SurfaceGraph& graph, Index vertex,
                      const glm::dvec3& place) {
    const std::vector<double> distances = graph.distances_from(vertex);
    Index nearest = no_index;
    SurfaceDistance(mesh.triangles, mesh.positions)(place, nearest);
    double least = std::numeric_limits<double>::infinity();
    for (const Index corner : mesh.triangles[nearest])
        least = std::min(least, distances[corner] + glm::distance(place, mesh.positions[corner]));
    return least;
}

struct Totals {
    int pairs = 0;
    int failed = 0;
    int inexact = 0;  ///< maps that do not bring a landmark to its target to the last bit
    int warned = 0;
    int swaps_named = 0;  ///< of the last two given landmarks, the ears
    double held_out = 0;
    double held_out_matched = 0;  ///< with matching after the pins
    double match_seconds = 0;
    double off_in_key = 0;
    double most_off_in_key = 0;
    double map_seconds = 0;
    double fit_seconds = 0;
    double largest_hausdorff = 0;
    std::size_t most_flipped = 0;
};

/// The mean distance, in square roots of the area, at which the landmarks of \p lines arrive in \p key.
double held_out_of(const Body& body, const FittedKey& first, const FittedKey& key,
                   std::span<const std::size_t> lines) {
    const SphereRoots roots = FitOptions().roots;
    const double unit = extent_of(body.clean.mesh).size;
    const SurfaceGraph graph(body.clean.mesh.triangles, body.clean.mesh.positions);
    double sum = 0;
    for (const std::size_t line : lines) {
        const std::vector<glm::dvec3>& positions = body.clean.mesh.positions;
        const auto vertex = static_cast<Index>(std::ranges::find(positions, body.landmarks[line].position) -
                                               positions.begin());
        const glm::dvec3 place =
            point_in_direction(key.hierarchy, roots, first.report.landmarks[line].direction);
        sum += distance_along(body.clean.mesh, graph, vertex, place) / unit;
    }
    return sum / double(lines.size());
}

/// Whether the last two landmarks are named if they are swapped.
bool names_swap(const SurfaceMesh& mesh, LandmarkPins pins) {
    const std::size_t count = pins.directions.size();
    std::swap(pins.directions[count - 2], pins.directions[count - 1]);
    std::swap(pins.counterparts[count - 2], pins.counterparts[count - 1]);
    std::string text;
    try {
        for (const std::string& fault : faults_of(map_to_pins(mesh, pins, {}, {}).agreement, pins))
            text += fault;
    } catch (const InputError& error) {
        text = error.what();
    }
    return text.find(pins.names[count - 2]) != std::string::npos ||
           text.find("left and right") != std::string::npos;
}

/// Measures where the landmarks that were not given arrive in \p key, and in the key with matching after the pins.
void measure_held_out(const Body& body, const std::string& first_name, const FittedKey& first,
                      const FittedKey& key, const FitOptions& options, const Lines& lines, Totals& totals) {
    std::vector<glm::dvec3> directions;
    directions.reserve(options.landmarks.size());
    for (const Landmark& landmark : options.landmarks) directions.push_back(*landmark.direction);
    const double held_out = held_out_of(body, first, key, lines.held_out);
    const auto model = model_of(first.mapped_mesh(), first.points, glm::dmat3(1), directions, {}, {});
    FitOptions with_model = options;
    with_model.model = model.get();
    FittedKey matched;
    const double seconds = processor_seconds_of([&] { matched = fit(CleanMesh(body.clean), with_model); });
    const double held_out_matched = held_out_of(body, first, matched, lines.held_out);
    totals.held_out += held_out;
    totals.held_out_matched += held_out_matched;
    totals.match_seconds += seconds;
    bench::print_line({{"first", first_name},
                       {"matched", body.name},
                       {"held_out", held_out},
                       {"held_out_matched", held_out_matched},
                       {"match_fault", matched.report.match->fault},
                       {"fit_seconds_matched", seconds}});
}

/// Fits \p body so that its given landmarks are at the directions in \p first.
void measure_pair(const Body& body, const std::string& first_name, const FittedKey& first, const Lines& lines,
                  Totals& totals) {
    std::vector<Landmark> given;
    std::vector<glm::dvec3> first_places;
    for (const std::size_t line : lines.given) {
        given.push_back(body.landmarks[line]);
        given.back().direction = first.report.landmarks[line].direction;
        first_places.push_back(first.report.landmarks[line].position);
    }
    ++totals.pairs;
    try {
        const MeshWithLandmarks inserted = insert_landmarks(body.clean.mesh, given);
        LandmarkPins pins;
        pins.vertices = inserted.vertices;
        pins.counterparts = first_places;
        for (const Landmark& landmark : given) {
            pins.names.push_back(landmark.name);
            pins.directions.push_back(*landmark.direction);
            pins.positions.push_back(landmark.position);
        }
        PinnedMap map;
        totals.map_seconds += processor_seconds_of([&] { map = map_to_pins(inserted.mesh, pins, {}, {}); });
        for (std::size_t k = 0; k < given.size(); ++k)
            totals.inexact += map.points[pins.vertices[k]] != pins.directions[k];

        FittedKey key;
        const FitOptions options{.landmarks = given, .counterparts = first_places};
        const double seconds = processor_seconds_of([&] { key = fit(CleanMesh(body.clean), options); });
        totals.fit_seconds += seconds;

        totals.swaps_named += names_swap(inserted.mesh, pins);
        double off = 0;
        double most_off = 0;
        for (const FittedLandmark& landmark : key.report.landmarks) {
            off += landmark.off_in_key / double(given.size());
            most_off = std::max(most_off, landmark.off_in_key);
        }
        const MorphDistortion distortion = morph_distortion(first.hierarchy, key.hierarchy, first_places);
        totals.off_in_key += off;
        totals.most_off_in_key = std::max(totals.most_off_in_key, most_off);
        totals.largest_hausdorff = std::max(totals.largest_hausdorff, key.report.quality.hausdorff);
        totals.most_flipped = std::max(totals.most_flipped, key.report.quality.flipped_leaves);
        totals.warned += !key.report.landmark_faults.empty() || distortion.at_90_percent > 3;
        bench::print_line({{"first", first_name},
                           {"other", body.name},
                           {"agreement", map.agreement.mean_cosine},
                           {"mirrored", map.agreement.mirrored_cosine},
                           {"distortion_at_90_percent", distortion.at_90_percent},
                           {"off_in_key", off},
                           {"most_off_in_key", most_off},
                           {"hausdorff", key.report.quality.hausdorff},
                           {"flipped_leaves", key.report.quality.flipped_leaves},
                           {"fit_seconds", seconds}});
        if (!lines.held_out.empty()) measure_held_out(body, first_name, first, key, options, lines, totals);
    } catch (const InputError& error) {
        ++totals.failed;
        bench::print_line({{"first", first_name}, {"other", body.name}, {"error", error.what()}});
    }
}

}  // namespace

int main(int argc, char** argv) {
    const bool all_given = argc == 4 && std::string_view(argv[3]) == "all";
    const auto firsts = argc == 3 || all_given ? parsed_number<std::size_t>(argv[2]).value_or(0) : 0;
    if (firsts == 0) {
        std::fprintf(
            stderr,
            "usage: %s FOLDER FIRSTS [all] (each of the first FIRSTS meshes to all others, with some or all "
            "landmarks)\n",
            argv[0]);
        return 2;
    }
    try {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
            if (entry.path().extension() == ".off") files.push_back(entry.path());
        std::ranges::sort(files);
        std::vector<Body> bodies;
        bodies.reserve(files.size());
        for (const std::filesystem::path& file : files) bodies.push_back(read_body(file));

        Totals totals;
        for (std::size_t first = 0; first < std::min(firsts, bodies.size()); ++first) {
            const FittedKey key = fit(CleanMesh(bodies[first].clean), {.landmarks = bodies[first].landmarks});
            const Lines lines = lines_of(bodies[first].landmarks.size(), all_given);
            for (const Body& body : bodies)
                if (body.name != bodies[first].name)
                    measure_pair(body, bodies[first].name, key, lines, totals);
        }
        const double fitted = std::max(1, totals.pairs - totals.failed);
        bench::print_line({{"pairs", totals.pairs},
                           {"failed", totals.failed},
                           {"inexact_landmarks", totals.inexact},
                           {"warned", totals.warned},
                           {"held_out", totals.held_out / fitted},
                           {"held_out_matched", totals.held_out_matched / fitted},
                           {"fit_seconds_matched", totals.match_seconds / fitted},
                           {"swapped_ears_named", totals.swaps_named},
                           {"off_in_key", totals.off_in_key / fitted},
                           {"most_off_in_key", totals.most_off_in_key},
                           {"largest_hausdorff", totals.largest_hausdorff},
                           {"most_flipped_leaves", totals.most_flipped},
                           {"map_seconds", totals.map_seconds / fitted},
                           {"fit_seconds", totals.fit_seconds / fitted}});
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
