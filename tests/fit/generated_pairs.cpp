#include "fit/generated_pairs.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "fit/closed_meshes.h"
#include "fit/correspondence/match.h"
#include "fit/fit_quality.h"
#include "fit/sampling/mapped_surface.h"
#include "fit/sphere_map/alignment.h"
#include "fit/sphere_map/spherical_map.h"

namespace interleaf::testing {
namespace {

/// Random numbers that are the same with every compiler and standard library: no expression draws twice, since C++
/// leaves open which of two arguments is drawn first.
class Draw {
  public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
    }
    glm::dvec3 direction() {
        for (;;) {
            const double z = between(-1, 1);
            const double y = between(-1, 1);
            const double x = between(-1, 1);
            const glm::dvec3 v(x, y, z);
            const double squared = glm::dot(v, v);
            if (squared > 0.01 && squared < 1) return v / std::sqrt(squared);
        }
    }
    /// About a random axis, by a sine of at most \p largest.
    glm::dmat3 turn(double largest) {
        const glm::dvec3 axis = direction();
        const double sine = between(-largest, largest);
        const double cosine = std::sqrt(1 - sine * sine);
        const auto turned = [&](const glm::dvec3& v) {
            return cosine * v + sine * glm::cross(axis, v) + (1 - cosine) * glm::dot(axis, v) * axis;
        };
        return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
    }

  private:
    std::mt19937_64 engine_;
};

struct Bump {
    glm::dvec3 at;
    double height;
    double width;
};

std::vector<Bump> drawn_bumps(Draw& draw) {
    constexpr std::size_t count = 6;
    std::vector<Bump> bumps;
    bumps.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 at = draw.direction();
        const double height = draw.between(0.2, 0.8);
        bumps.push_back({at, height, draw.between(0.2, 0.4)});
    }
    return bumps;
}

double radius_at(std::span<const Bump> bumps, const glm::dvec3& u) {
    double radius = 1;
    for (const Bump& bump : bumps) {
        const glm::dvec3 away = u - bump.at;
        radius += bump.height / (1 + glm::dot(away, away) / (bump.width * bump.width));
    }
    return radius;
}

/// A mesh of the body that is turned against it at random, denser towards one side.
MappedMesh drawn_mesh(Draw& draw, std::span<const Bump> bumps, unsigned divisions) {
    MappedMesh body{icosphere(divisions), {}};
    const glm::dmat3 mesh_turn = draw.turn(1);
    const glm::dvec3 pull_direction = draw.direction();
    const glm::dvec3 pull = draw.between(0, 0.35) * pull_direction;
    for (glm::dvec3& position : body.mesh.positions) {
        body.points.push_back(glm::normalize(mesh_turn * position + pull));
        position = radius_at(bumps, body.points.back()) * body.points.back();
    }
    return body;
}

std::vector<glm::dvec3> aligned_map_of(const SurfaceMesh& mesh) {
    std::vector<glm::dvec3> points = map_to_sphere(mesh, {}, Keeps::shapes).points;
    center_map(mesh, points);
    rotate(points, rotation_to_surface(mesh, points));
    return points;
}

/// The mean distance between the places of \p places, per vertex, and the places on the first mesh that are mapped to
/// \p points.
double mean_distance(const GeneratedPair& pair, std::span<const glm::dvec3> map_of_first,
                     std::span<const glm::dvec3> points) {
    const MappedSurface first(pair.first.mesh, map_of_first);
    double sum = 0;
    for (std::size_t v = 0; v < pair.places.size(); ++v) {
        const MeshPoint place = first.location.locate(points[v], no_index);
        sum +=
            glm::distance(pair.places[v], place.of(std::span<const Triangle>(pair.first.mesh.triangles),
                                                   std::span<const glm::dvec3>(pair.first.mesh.positions)));
    }
    return sum / double(pair.places.size()) / box_diagonal(pair.first.mesh);
}

}  // namespace

GeneratedPair generated_pair(std::uint64_t seed, unsigned divisions) {
    constexpr double sine_of_20_degrees = 0.342;
    constexpr double noise = 0.005;
    Draw draw(seed);
    const std::vector<Bump> bumps = drawn_bumps(draw);
    const bool is_first_finer = draw.between(0, 1) < 0.5;
    GeneratedPair pair;
    pair.first = drawn_mesh(draw, bumps, divisions - (is_first_finer ? 0U : 1U));
    pair.second = drawn_mesh(draw, bumps, divisions - (is_first_finer ? 1U : 0U));
    pair.places = pair.second.mesh.positions;
    const glm::dmat3 turn = draw.turn(sine_of_20_degrees);
    const glm::dmat3 pose = draw.between(0.5, 2) * turn;
    for (glm::dvec3& position : pair.second.mesh.positions)
        position = pose * (draw.between(1 - noise, 1 + noise) * position);
    return pair;
}

PairFigures figures_of(const GeneratedPair& pair) {
    const std::vector<glm::dvec3> first = aligned_map_of(pair.first.mesh);
    const std::vector<glm::dvec3> second = aligned_map_of(pair.second.mesh);
    const auto model = model_of(pair.first.mesh, first, glm::dmat3(1), {}, {}, {});
    const MatchedMap matched = match(*model, pair.second.mesh, second, glm::dmat3(1), {}, {}, {});
    PairFigures figures;
    figures.unmatched = mean_distance(pair, first, second);
    figures.is_matched = matched.report.fault.empty();
    figures.mean_error = figures.is_matched ? mean_distance(pair, first, matched.points) : figures.unmatched;
    figures.is_one_to_one = figures.is_matched ? fault_of_map(matched.mesh, matched.points).empty()
                                               : fault_of_map(pair.second.mesh, second).empty();
    return figures;
}

}  // namespace interleaf::testing
