#include "fit/correspondence/moving_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "fit/correspondence/coarsening.h"
#include "fit/sphere_map/orientation.h"
#include "fit/sphere_map/rest_shape.h"
#include "fit/sphere_map/spherical_star.h"

namespace interleaf {
namespace {

/// Rest shapes are blended by this towards equilateral.
constexpr double shape_blend = 0.05;

/// A vertex rests when a step lowers its energy by less than this fraction.
constexpr double still_gain = 1e-4;

/// The factor by which the mesh grows from one relaxation to the next.
constexpr double level_growth = 1.25;

double squared_norm(const glm::dvec3& v) {
    return glm::dot(v, v);
}

double doubled_area_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::length(glm::cross(b - a, c - a));
}

double value_at(const MatchedBody& body, const MeshPoint& place) {
    const auto& [a, b, c] = body.triangles()[place.triangle];
    const std::vector<double>& values = body.outwardness();
    return values[a] * place.barycentric.x + values[b] * place.barycentric.y +
           values[c] * place.barycentric.z;
}

}  // namespace

MatchWeights weights_at(double vertices) {
    constexpr double coarsest = 100;
    constexpr int steps_per_level = 4;
    // From 100 to 8,000 vertices, in 20 steps, positions fall to a third, normals to a half, outwardness to a
    // quarter.
    constexpr double position_factor = 0.946;
    constexpr double normal_factor = 0.966;
    constexpr double outwardness_factor = 0.933;
    constexpr int max_steps = 20;
    MatchWeights weights;
    int steps = 0;
    for (double count = coarsest; steps < max_steps && count * level_growth <= vertices;
         count *= level_growth, ++steps) {
        weights.position *= position_factor;
        weights.normal *= normal_factor;
        weights.outwardness *= outwardness_factor;
    }
    weights.level = std::min(std::size_t(steps / steps_per_level), smoothing_levels - 1);
    return weights;
}

MovingMesh::MovingMesh(const MatchedBody& moving, const MatchedBody& onto, ProgressMeter& meter)
    : moving_(moving),
      onto_(onto),
      meter_(meter),
      mesh_(static_cast<Index>(moving.positions().size()), moving.triangles()),
      count_(moving.positions().size()),
      cotangent_(3 * moving.triangles().size()),
      rest_area_(moving.triangles().size()),
      mass_(count_),
      is_active_(count_) {
    places_.on_mesh.resize(count_);
    places_.in_space.resize(count_);
    places_.on_sphere.resize(count_);
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t) update_shape(t);
    put_at_own_points();
}

void MovingMesh::put_at_own_points() {
    Index guess = no_index;
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v) {
        const MeshPoint place = onto_.locate(moving_.points()[v], guess);
        guess = place.triangle;
        places_.on_mesh[v] = place;
        places_.in_space[v] = onto_.position(place);
        places_.on_sphere[v] = moving_.points()[v];
    }
    linear_ = glm::dmat3(1);
    offset_ = glm::dvec3(0);
}

void MovingMesh::set_places(const Places& places) {
    places_ = places;
}

void MovingMesh::set_weights(const MatchWeights& weights) {
    weights_ = weights;
}

void MovingMesh::update_shape(Index triangle) {
    const glm::dvec3& a = moving_.positions()[mesh_.origin(3 * triangle)];
    const glm::dvec3& b = moving_.positions()[mesh_.origin(3 * triangle + 1)];
    const glm::dvec3& c = moving_.positions()[mesh_.origin(3 * triangle + 2)];
    const auto opposite_sides = rest_cotangents(a, b, c, shape_blend);
    for (std::size_t k = 0; k < 3; ++k)
        cotangent_[std::size_t{3} * triangle + k] = opposite_sides[(k + 1) % 3];
    const double mean = (squared_norm(b - a) + squared_norm(c - b) + squared_norm(a - c)) / 3;
    const auto blended = [&](const glm::dvec3& side) {
        return (1 - shape_blend) * squared_norm(side) + shape_blend * mean;
    };
    const double u = blended(b - a);
    const double v = blended(c - b);
    const double w = blended(a - c);
    constexpr double least = 1e-12;
    const double squared = 2 * (u * v + v * w + w * u) - (u * u + v * v + w * w);  // 16 area^2
    rest_area_[triangle] = std::max(std::sqrt(std::max(squared, 0.0)) / 4, least);
}

void MovingMesh::update_shapes_at(Index vertex) {
    for_star(vertex, [&](Index spoke) { update_shape(spoke / 3); });
}

void MovingMesh::gather(Index vertex) {
    star_.clear();
    for_star(vertex, [&](Index spoke) {
        const Index at_a = HalfEdgeMesh::next(spoke);
        const Index at_b = HalfEdgeMesh::previous(spoke);
        const Index a = mesh_.origin(at_a);
        const Index b = mesh_.origin(at_b);
        star_.push_back({{places_.in_space[a], places_.in_space[b], cotangent_[spoke], cotangent_[at_a],
                          cotangent_[at_b], rest_area_[spoke / 3]},
                         places_.on_sphere[a],
                         places_.on_sphere[b],
                         spoke / 3});
    });
}

void MovingMesh::update_masses() {
    std::fill(mass_.begin(), mass_.end(), 0.0);
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t) {
        if (!mesh_.has_triangle(t)) continue;
        const std::array<Index, 3> corners = {mesh_.origin(3 * t), mesh_.origin(3 * t + 1),
                                              mesh_.origin(3 * t + 2)};
        const double there = doubled_area_of(places_.in_space[corners[0]], places_.in_space[corners[1]],
                                             places_.in_space[corners[2]]) /
                             2;
        for (const Index vertex : corners) mass_[vertex] += (rest_area_[t] + there) / 6;
    }
}

/// Fits the affine map from positions to places, drawn towards no linear change.
void MovingMesh::fit_affine() {
    constexpr double ridge = 0.3;
    double whole = 0;
    glm::dvec3 center(0);
    glm::dvec3 center_there(0);
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v) {
        if (!mesh_.has_vertex(v)) continue;
        whole += mass_[v];
        center += mass_[v] * moving_.positions()[v];
        center_there += mass_[v] * places_.in_space[v];
    }
    center /= whole;
    center_there /= whole;
    glm::dmat3 own(0.0);
    glm::dmat3 across(0.0);
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v) {
        if (!mesh_.has_vertex(v)) continue;
        const glm::dvec3 from = moving_.positions()[v] - center;
        own += mass_[v] / whole * glm::outerProduct(from, from);
        across += mass_[v] / whole * glm::outerProduct(places_.in_space[v] - center_there, from);
    }
    const glm::dmat3 drawn(ridge * (own[0][0] + own[1][1] + own[2][2]) / 3);
    linear_ = (across + drawn) * glm::inverse(own + drawn);
    offset_ = center_there - linear_ * center;
}

double MovingMesh::data_energy(Index vertex, const MeshPoint& place, const glm::dvec3& position) const {
    const std::vector<glm::dvec3>& normals_there = onto_.normals(weights_.level);
    const glm::dvec3 normal = place.of(onto_.triangles(), std::span(normals_there));
    const double outward = value_at(onto_, place) - moving_.outwardness()[vertex];
    return mass_[vertex] * (weights_.position * squared_norm(position - affine_place(vertex)) +
                            weights_.normal * squared_norm(normal - moving_.normals(weights_.level)[vertex]) +
                            weights_.outwardness * outward * outward);
}

double MovingMesh::star_energy(Index vertex, const MeshPoint& place, const glm::dvec3& position) const {
    double sum = 0;
    for (const StarSide& side : star_) sum += distortion_of(side.triangle, position);
    return weights_.distortion * sum + data_energy(vertex, place, position);
}

bool MovingMesh::is_positive_at(const glm::dvec3& point) const {
    return std::ranges::all_of(
        star_, [&](const StarSide& side) { return orientation(point, side.point_a, side.point_b) > 0; });
}

void MovingMesh::put(Index vertex, const MeshPoint& place) {
    places_.on_mesh[vertex] = place;
    places_.in_space[vertex] = onto_.position(place);
    places_.on_sphere[vertex] = onto_.point(place);
}

/// Moves the vertex of the gathered star, if that lowers its energy and its triangles stay positive.
/// \return the new energy
std::optional<double> MovingMesh::try_place(Index vertex, const MeshPoint& place, double energy) {
    const double there = star_energy(vertex, place, onto_.position(place));
    if (!(there < energy) || !is_positive_at(onto_.point(place))) return std::nullopt;
    put(vertex, place);
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
        place.of(onto_.triangles(), std::span(normals)) - moving_.normals(weights_.level)[vertex];
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
    for (const StarSide& side : star_) {
        add_distortion_derivatives(side.triangle, position, frame.s_axis, frame.t_axis, weights_.distortion,
                                   derivatives);
        squared_size = std::max(squared_size, squared_norm(side.triangle.a - position));
        area += side.triangle.rest_area;
    }
    const double energy = star_energy(vertex, place, position);
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
    int moved = 0;
    update_masses();
    fit_affine();
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v) {
        if (!mesh_.has_vertex(v) || !std::exchange(is_active_[v], char{0})) continue;
        if (!(relax_vertex(v) > still_gain)) continue;
        ++moved;
        is_active_[v] = 1;
        for_star(v, [&](Index spoke) { is_active_[mesh_.target(spoke)] = 1; });
    }
    return moved;
}

void MovingMesh::relax(int sweeps) {
    std::fill(is_active_.begin(), is_active_.end(), char{1});
    for (int i = 0; i < sweeps && sweep() > 0; ++i) meter_.step();
}

/// 1 per vertex whose triangles are stretched so much that it had better move as part of a coarser mesh.
std::vector<char> MovingMesh::strained_vertices() const {
    constexpr double strained = 6;  // distortion per rest area
    std::vector<double> energy(mesh_.vertex_capacity(), 0.0);
    std::vector<double> area(mesh_.vertex_capacity(), 0.0);
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t) {
        if (!mesh_.has_triangle(t)) continue;
        const std::array<Index, 3> corners = {mesh_.origin(3 * t), mesh_.origin(3 * t + 1),
                                              mesh_.origin(3 * t + 2)};
        const double here = distortion_of(
            {places_.in_space[corners[1]], places_.in_space[corners[2]], cotangent_[std::size_t{3} * t],
             cotangent_[3 * t + 1], cotangent_[3 * t + 2], rest_area_[t]},
            places_.in_space[corners[0]]);
        for (const Index vertex : corners) {
            energy[vertex] += here;
            area[vertex] += rest_area_[t];
        }
    }
    std::vector<char> are_strained(mesh_.vertex_capacity(), 0);
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v)
        are_strained[v] = energy[v] > strained * area[v] ? 1 : 0;
    return are_strained;
}

void MovingMesh::coarsen_to(std::size_t vertices, std::uint32_t variation, bool heeds_places) {
    CoarseningView view{.positions = moving_.positions(), .points = places_.on_sphere};
    view.variation = variation;
    std::vector<char> strained;
    if (heeds_places) {
        strained = strained_vertices();
        view.images = places_.in_space;
        view.are_first = strained;
    }
    const std::vector<Index> collapses = coarsen(mesh_, vertices, view, meter_);
    collapses_.insert(collapses_.end(), collapses.begin(), collapses.end());
    count_ -= collapses.size();
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t)
        if (mesh_.has_triangle(t)) update_shape(t);
}

bool MovingMesh::refine(int sweeps) {
    double next = level_growth * double(count_);
    while (!collapses_.empty()) {
        const Index half_edge = collapses_.back();
        if (!restore(half_edge)) {
            for (; !collapses_.empty(); collapses_.pop_back(), ++count_)
                mesh_.undo_collapse(collapses_.back());
            for (Index t = 0; t < mesh_.triangle_capacity(); ++t) update_shape(t);
            return false;
        }
        collapses_.pop_back();
        if (double(count_) < next && !collapses_.empty()) continue;
        set_weights(weights_at(double(count_)));
        relax(sweeps);
        next = level_growth * double(count_);
    }
    return true;
}

/// Undoes the collapse and places the vertex. Where there is no room, makes room and tries again.
/// \return false if there is still no room; then the collapse stands
bool MovingMesh::restore(Index half_edge) {
    constexpr int max_tries = 5;
    constexpr int sweeps_for_room = 10;
    for (int tries = 0; tries < max_tries; ++tries) {
        const Index vertex = mesh_.origin(half_edge);
        const Index kept = mesh_.origin(mesh_.twin(half_edge));
        mesh_.undo_collapse(half_edge);
        ++count_;
        update_shapes_at(vertex);
        if (place_in_kernel(vertex, kept)) return true;
        mesh_.collapse(half_edge);
        --count_;
        update_shapes_at(kept);
        if (tries == 0) relax(sweeps_for_room);
        make_room_around(kept, tries + 1);
    }
    return false;
}

bool MovingMesh::place_in_kernel(Index vertex, Index kept) {
    gather(vertex);
    mass_[vertex] = 0;
    for (const StarSide& side : star_) mass_[vertex] += side.triangle.rest_area / 3;
    const glm::dvec3 from = places_.on_sphere[kept];
    const Index guess = places_.on_mesh[kept].triangle;
    double energy = std::numeric_limits<double>::infinity();
    const auto attempt = [&](const glm::dvec3& point) {
        if (const auto less = try_place(vertex, onto_.locate(glm::normalize(point), guess), energy))
            energy = *less;
    };
    if (const auto middle = kernel_middle(from))
        for (const double part : {1.0, 0.5, 0.25}) attempt(from + part * (*middle - from));
    glm::dvec3 sum(0);
    for (const StarSide& side : star_) sum += side.point_a;
    attempt(sum);
    for (const StarSide& side : star_) attempt(from + side.point_a);
    if (energy == std::numeric_limits<double>::infinity()) return false;

    for (int i = 0; i < 3; ++i) relax_vertex(vertex);
    for_star(vertex, [&](Index spoke) { relax_vertex(mesh_.target(spoke)); });
    relax_vertex(vertex);
    return true;
}

/// Moves the vertices within \p rings rings of edges about \p vertex to the middles of their kernels.
void MovingMesh::make_room_around(Index vertex, int rings) {
    constexpr int rounds = 10;
    std::vector<Index> near = {vertex};
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<Index> inner = near;
        for (const Index v : inner) for_star(v, [&](Index spoke) { near.push_back(mesh_.target(spoke)); });
        std::ranges::sort(near);
        near.erase(std::unique(near.begin(), near.end()), near.end());
    }
    for (int round = 0; round < rounds; ++round)
        for (const Index v : near) move_to_middle(v);
}

void MovingMesh::move_to_middle(Index vertex) {
    gather(vertex);
    const auto middle = kernel_middle(places_.on_sphere[vertex]);
    if (!middle) return;
    const MeshPoint place = onto_.locate(*middle, places_.on_mesh[vertex].triangle);
    if (is_positive_at(onto_.point(place))) put(vertex, place);
}

MatchFigures MovingMesh::figures() {
    constexpr double largest_distortion = 20;  // per area
    constexpr double much = 8;
    update_masses();
    fit_affine();
    MatchFigures figures;
    double whole = 0;
    for (Index v = 0; v < mesh_.vertex_capacity(); ++v)
        if (mesh_.has_vertex(v)) figures.energy += data_energy(v, places_.on_mesh[v], places_.in_space[v]);
    for (Index t = 0; t < mesh_.triangle_capacity(); ++t) {
        if (!mesh_.has_triangle(t)) continue;
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
