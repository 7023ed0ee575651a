// MovingMesh: the energy, and the steps that lower it.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "fit/correspondence/moving_mesh.h"
#include "fit/sphere_map/orientation.h"
#include "fit/sphere_map/spherical_star.h"
#include "hierarchy/rotation_fit.h"

namespace interleaf {
namespace {

/// A vertex rests when a step lowers its energy by less than this fraction.
constexpr double still_gain = 1e-4;

double squared_norm(const glm::dvec3& v) {
    return glm::dot(v, v);
}

double value_at(const MatchedBody& body, const MeshPoint& place) {
    const auto& [a, b, c] = body.triangles()[place.triangle];
    const std::vector<double>& values = body.outwardness();
    return values[a] * place.barycentric.x + values[b] * place.barycentric.y +
           values[c] * place.barycentric.z;
}

/// The rotation that turns positions best into places, unless it is large: bodies stand about alike. Between 32 and 37
/// degrees a part of it is taken, because sweeps would go back and forth over a sudden limit forever.
glm::dmat3 trusted_rotation(const glm::dmat3& across) {
    constexpr double trusted_cosine = 0.85;
    constexpr double distrusted_cosine = 0.8;
    const std::array<glm::dvec3, 3> axes = {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
    const std::array<glm::dvec3, 3> turned = {across[0], across[1], across[2]};
    const RotationFit best = fit_rotation(axes, turned);
    const double cosine = (best.rotation[0][0] + best.rotation[1][1] + best.rotation[2][2] - 1) / 2;
    if (cosine >= trusted_cosine) return best.rotation;
    const double trust = std::max(0.0, (cosine - distrusted_cosine) / (trusted_cosine - distrusted_cosine));
    const glm::dquat q = best.quaternion.w < 0 ? -best.quaternion : best.quaternion;
    return glm::mat3_cast(
        glm::normalize(glm::dquat(1 - trust + trust * q.w, trust * q.x, trust * q.y, trust * q.z)));
}

}  // namespace

/// Fits the affine map from positions to places, drawn towards the best rotation.
void MovingMesh::fit_affine() {
    constexpr double ridge = 0.3;
    double whole = 0;
    glm::dvec3 center(0);
    glm::dvec3 center_there(0);
    for (const Index v : vertices_) {
        whole += mass_[v];
        center += mass_[v] * moving_.positions()[v];
        center_there += mass_[v] * places_.in_space[v];
    }
    center /= whole;
    center_there /= whole;
    glm::dmat3 own(0.0);
    glm::dmat3 across(0.0);
    for (const Index v : vertices_) {
        const glm::dvec3 from = moving_.positions()[v] - center;
        own += mass_[v] / whole * glm::outerProduct(from, from);
        across += mass_[v] / whole * glm::outerProduct(places_.in_space[v] - center_there, from);
    }
    const glm::dmat3 drawn(ridge * (own[0][0] + own[1][1] + own[2][2]) / 3);
    rotation_ = trusted_rotation(across);
    linear_ = (across + drawn * rotation_) * glm::inverse(own + drawn);
    offset_ = center_there - linear_ * center;
}

double MovingMesh::data_energy(Index vertex, const MeshPoint& place, const glm::dvec3& position) const {
    const std::vector<glm::dvec3>& normals_there = onto_.normals(weights_.level);
    const glm::dvec3 normal = place.of(onto_.triangles(), std::span(normals_there));
    const double outward = value_at(onto_, place) - moving_.outwardness()[vertex];
    return mass_[vertex] *
           (weights_.position * squared_norm(position - affine_place(vertex)) +
            weights_.normal * squared_norm(normal - rotation_ * moving_.normals(weights_.level)[vertex]) +
            weights_.outwardness * outward * outward);
}

/// The energy of the gathered star with the vertex at \p place; none if it is not less than \p limit.
std::optional<double> MovingMesh::energy_below(double limit, Index vertex, const MeshPoint& place,
                                               const glm::dvec3& position) const {
    double sum = 0;
    for (const StarSide& side : star_) {
        sum += distortion_of(side.triangle, position);
        if (!(weights_.distortion * sum < limit)) return std::nullopt;
    }
    const double energy = weights_.distortion * sum + data_energy(vertex, place, position);
    if (!(energy < limit)) return std::nullopt;
    return energy;
}

bool MovingMesh::is_positive_at(const glm::dvec3& point) const {
    return std::ranges::all_of(
        star_, [&](const StarSide& side) { return orientation(point, side.point_a, side.point_b) > 0; });
}

/// Whether the triangles of the gathered star are no needles on the sphere with the vertex at \p point. Nothing relaxes
/// a triangle any more that is positive by a hair.
bool MovingMesh::is_roomy_at(const glm::dvec3& point) const {
    constexpr double least_height = 1e-3;  // of a triangle, per length
    return std::ranges::all_of(star_, [&](const StarSide& side) {
        const glm::dvec3 to_a = side.point_a - point;
        const glm::dvec3 to_b = side.point_b - point;
        const glm::dvec3 across = side.point_b - side.point_a;
        const double longest = std::max({squared_norm(to_a), squared_norm(to_b), squared_norm(across)});
        return glm::dot(point, glm::cross(to_a, to_b)) > least_height * longest;
    });
}

void MovingMesh::put(Index vertex, const MeshPoint& place) {
    places_.on_mesh[vertex] = place;
    places_.in_space[vertex] = onto_.position(place);
    places_.on_sphere[vertex] = onto_.point(place);
}

/// Moves the vertex of the gathered star, if that lowers its energy and its triangles stay positive.
/// \return the new energy
std::optional<double> MovingMesh::try_place(Index vertex, const MeshPoint& place, double energy) {
    const glm::dvec3 position = onto_.position(place);
    const std::optional<double> there = energy_below(energy, vertex, place, position);
    if (!there) return std::nullopt;
    const glm::dvec3 point = onto_.point(place);
    if (!is_positive_at(point) || (avoids_needles_ && !is_roomy_at(point))) return std::nullopt;
    places_.on_mesh[vertex] = place;
    places_.in_space[vertex] = position;
    places_.on_sphere[vertex] = point;
    return there;
}

void MovingMesh::add_data_derivatives(Index vertex, const glm::dvec3& s, const glm::dvec3& t,
                                      TangentDerivatives& sum) const {
    constexpr double no_area = 1e-26;  // square of twice the area
    const MeshPoint& place = places_.on_mesh[vertex];
    const auto& [i, j, k] = onto_.triangles()[place.triangle];
    const double mass = 2 * mass_[vertex];
    const glm::dvec3 away = places_.in_space[vertex] - affine_place(vertex);
    sum.gradient += mass * weights_.position * glm::dvec2(glm::dot(away, s), glm::dot(away, t));
    sum.second += glm::dmat2(mass * weights_.position);

    const glm::dvec3& a = onto_.positions()[i];
    const glm::dvec3& b = onto_.positions()[j];
    const glm::dvec3& c = onto_.positions()[k];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double squared = squared_norm(normal);
    if (!(squared > no_area)) return;
    const auto rate = [&](const glm::dvec3& d) {
        return glm::dvec3(glm::dot(normal, glm::cross(c - b, d)), glm::dot(normal, glm::cross(a - c, d)),
                          glm::dot(normal, glm::cross(b - a, d))) /
               squared;
    };
    const glm::dvec3 rate_s = rate(s);
    const glm::dvec3 rate_t = rate(t);
    const std::vector<glm::dvec3>& normals = onto_.normals(weights_.level);
    const glm::dvec3 normal_s = rate_s.x * normals[i] + rate_s.y * normals[j] + rate_s.z * normals[k];
    const glm::dvec3 normal_t = rate_t.x * normals[i] + rate_t.y * normals[j] + rate_t.z * normals[k];
    const glm::dvec3 turned =
        place.of(onto_.triangles(), std::span(normals)) - rotation_ * moving_.normals(weights_.level)[vertex];
    sum.gradient +=
        mass * weights_.normal * glm::dvec2(glm::dot(turned, normal_s), glm::dot(turned, normal_t));
    const double mixed = glm::dot(normal_s, normal_t);
    sum.second +=
        mass * weights_.normal * glm::dmat2(squared_norm(normal_s), mixed, mixed, squared_norm(normal_t));

    const std::vector<double>& outward = onto_.outwardness();
    const glm::dvec2 slope(rate_s.x * outward[i] + rate_s.y * outward[j] + rate_s.z * outward[k],
                           rate_t.x * outward[i] + rate_t.y * outward[j] + rate_t.z * outward[k]);
    const double difference = value_at(onto_, place) - moving_.outwardness()[vertex];
    sum.gradient += mass * weights_.outwardness * difference * slope;
    sum.second += mass * weights_.outwardness * glm::outerProduct(slope, slope);
}

/// One step of Newton's method in the tangent plane, walked along the surface.
/// \return the relative decrease of the energy of the vertex's star
double MovingMesh::relax_vertex(Index vertex) {
    constexpr int max_tries = 6;
    constexpr double shorter = 0.4;
    constexpr double strained = 4;  // energy per rest area
    if (is_held_[vertex]) return 0;
    meter_.step(60);
    const MeshPoint place = places_.on_mesh[vertex];
    const glm::dvec3 position = places_.in_space[vertex];
    const glm::dvec3& normal = onto_.triangle_normals()[place.triangle];
    if (!(squared_norm(normal) > 0.5)) return 0;
    const TangentFrame frame(normal);
    gather(vertex);

    TangentDerivatives derivatives;
    add_data_derivatives(vertex, frame.s_axis, frame.t_axis, derivatives);
    double squared_size = 0;
    double area = 0;
    double distortion = 0;
    for (const StarSide& side : star_) {
        distortion += add_distortion_derivatives(side.triangle, position, frame.s_axis, frame.t_axis,
                                                 weights_.distortion, derivatives);
        squared_size = std::max(squared_size, squared_norm(side.triangle.a - position));
        area += side.triangle.rest_area;
    }
    const double energy = weights_.distortion * distortion + data_energy(vertex, place, position);
    glm::dmat2& second = derivatives.second;
    second += glm::dmat2(1e-6 * (second[0][0] + second[1][1]));
    const double determinant = second[0][0] * second[1][1] - second[0][1] * second[1][0];
    if (!(determinant > 0)) return 0;
    const glm::dvec2& slope = derivatives.gradient;
    const glm::dvec2 newton = glm::dvec2(second[0][1] * slope.y - second[1][1] * slope.x,
                                         second[0][1] * slope.x - second[0][0] * slope.y) /
                              determinant;
    glm::dvec3 step = newton.x * frame.s_axis + newton.y * frame.t_axis;
    const double squared_step = squared_norm(step);
    if (!(squared_step > 0) || !(squared_step < std::numeric_limits<double>::infinity())) return 0;
    if (squared_step > squared_size) step *= std::sqrt(squared_size / squared_step);
    for (int tries = 0; tries < max_tries; ++tries, step *= shorter)
        if (const auto less = try_place(vertex, walk(onto_, place, step), energy)) return 1 - *less / energy;
    return energy > strained * weights_.distortion * area ? relax_to_middle(vertex, energy) : 0;
}

/// Tries places on the way to the middle of the kernel of the gathered star. A star that is thin on the sphere
/// blocks the steps of Newton's method.
double MovingMesh::relax_to_middle(Index vertex, double energy) {
    const glm::dvec3 here = places_.on_sphere[vertex];
    const std::optional<glm::dvec3> middle = kernel_middle(here);
    if (!middle) return 0;
    for (const double part : {1.0, 0.5, 0.2, 0.05}) {
        const glm::dvec3 point = glm::normalize(here + part * (*middle - here));
        const MeshPoint place = onto_.locate(point, places_.on_mesh[vertex].triangle);
        if (const auto less = try_place(vertex, place, energy)) return 1 - *less / energy;
    }
    return 0;
}

/// The middle of the kernel of the gathered star.
std::optional<glm::dvec3> MovingMesh::kernel_middle(const glm::dvec3& seed) const {
    SphericalStar star(seed);
    for (const StarSide& side : star_) star.add(side.point_a, side.point_b, 1, 1, 1, 1);
    const std::optional<glm::dvec2> middle = star.middle_of_kernel();
    if (!middle) return std::nullopt;
    return star.frame().point_at(*middle);
}

int MovingMesh::sweep() {
    update_masses();
    fit_affine();
    return move_active();
}

int MovingMesh::move_active() {
    int moved = 0;
    for (const Index v : vertices_) {
        if (!std::exchange(is_active_[v], char{0})) continue;
        if (!(relax_vertex(v) > still_gain)) continue;
        ++moved;
        is_active_[v] = 1;
        mesh_.for_spokes(v, [&](Index spoke) { is_active_[mesh_.target(spoke)] = 1; });
    }
    return moved;
}

void MovingMesh::relax(int sweeps) {
    relaxed_count_ = count_;
    list_present();
    std::fill(is_active_.begin(), is_active_.end(), char{1});
    for (int i = 0; i < sweeps && sweep() > 0; ++i) meter_.step();
}

/// Relaxes from the vertices within \p rings rings of edges about \p vertex on.
void MovingMesh::relax_around(Index vertex, int rings, int sweeps) {
    list_present();
    std::fill(is_active_.begin(), is_active_.end(), char{0});
    for (const Index v : vertices_around(vertex, rings)) is_active_[v] = 1;
    for (int i = 0; i < sweeps && move_active() > 0; ++i) meter_.step();
}

void MovingMesh::relax_stiffly(double factor) {
    constexpr int sweeps = 100;
    const MatchWeights weights = weights_;
    weights_.distortion *= factor;
    relax(sweeps);
    weights_ = weights;
}

MatchFigures MovingMesh::figures() {
    constexpr double largest_distortion = 20;  // per area
    constexpr double much = 8;
    list_present();
    update_masses();
    fit_affine();
    MatchFigures figures;
    double whole = 0;
    for (const Index v : vertices_) figures.energy += data_energy(v, places_.on_mesh[v], places_.in_space[v]);
    for (const Index t : triangles_) {
        const std::array<Index, 3> corners = {mesh_.origin(3 * t), mesh_.origin(3 * t + 1),
                                              mesh_.origin(3 * t + 2)};
        std::array<glm::dvec3, 3> own{};
        std::array<glm::dvec3, 3> there{};
        for (std::size_t k = 0; k < 3; ++k) {
            own[k] = moving_.positions()[corners[k]];
            there[k] = places_.in_space[corners[k]];
        }
        const glm::dvec3 normal = glm::cross(own[1] - own[0], own[2] - own[0]);
        const glm::dvec3 normal_there = glm::cross(there[1] - there[0], there[2] - there[0]);
        const double doubled = glm::length(normal);
        const double doubled_there = glm::length(normal_there);
        const double area = (doubled + doubled_there) / 4;
        const double distortion =
            std::min(distortion_of({there[1], there[2], cotangent_[std::size_t{3} * t], cotangent_[3 * t + 1],
                                    cotangent_[3 * t + 2], rest_area_[t]},
                                   there[0]),
                     largest_distortion * 2 * area);
        figures.distortion += distortion;
        whole += area;
        if (doubled > 0 && doubled_there > 0)
            figures.mean_cosine += area * glm::dot(normal, normal_there) / doubled / doubled_there;
        if (doubled_there > much * doubled || doubled > much * doubled_there) figures.stretched += area;
    }
    figures.energy += weights_.distortion * figures.distortion;
    figures.mean_cosine /= whole;
    figures.stretched /= whole;
    return figures;
}

}  // namespace interleaf
