#include "fit/landmarks/landmark_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "hierarchy/rotation_fit.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

/// Right landmarks of four-legged animals agree with 0.9 and more; with nose and tail swapped, 0.5 to 0.7.
constexpr double good_cosine = 0.85;

/// Points of a body that lie nearly in one plane, such as hands, feet and head of a man, fit about as well mirrored, or
/// with their sides exchanged. So a swap must raise the agreement by this much, and leave less than this fraction of
/// the disagreement: swapped sides of four-legged animals leave 0.54 at most.
constexpr double swapped_margin = 0.02;
constexpr double swapped_rest = 0.6;

/// Three points and their mirror image can be turned into each other.
constexpr std::size_t fewest_chiral = 4;

/// Two neighbors lie the other way round if the cosine between the ways from one to the other is below this.
/// Right landmarks of four-legged animals turn less.
constexpr double reversed_cosine = -0.5;

/// Such neighbors are not swapped if the cosine between their ways in space is at least this.
constexpr double agreeing_cosine = 0.25;

/// A rotation that turns some directions best into others is determined if its margin is above this part of the
/// agreement.
constexpr double least_margin = 1e-3;

/// Landmarks farther apart than this, as a chord of the sphere, are no neighbors: swapped ones lower the agreement.
constexpr double farthest_neighbor = 1.2;

/// Three landmarks nearly in line, with a smaller sine than this, have no clear sense.
constexpr double clear_sine = 0.2;

/// Whether, seen from either of the two, at most two other points are nearer than the other one. Between two ears,
/// there may be a nose.
bool are_neighbors(std::span<const glm::dvec3> points, std::size_t i, std::size_t j) {
    const double apart = glm::distance(points[i], points[j]);
    if (apart > farthest_neighbor) return false;
    constexpr std::ptrdiff_t most_nearer = 2 + 1;  // and the point itself
    const auto is_near = [&](std::size_t to) {
        return std::ranges::count_if(points, [&](const glm::dvec3& point) {
                   return glm::distance(point, points[to]) < apart;
               }) <= most_nearer;
    };
    return is_near(i) || is_near(j);
}

/// The sine of the angle at point \p k from point \p i to point \p j, seen from outside.
double sine_at(std::span<const glm::dvec3> points, std::size_t k, std::size_t i, std::size_t j) {
    const glm::dvec3 to_i = points[i] - points[k];
    const glm::dvec3 to_j = points[j] - points[k];
    const double lengths = glm::length(to_i) * glm::length(to_j);
    return lengths > 0 ? glm::dot(points[k], glm::cross(to_i, to_j)) / lengths : 0;
}

/// Whether the two landmarks and the one nearest to both run around their triangle in the same sense as their targets.
/// Then that part of the body is turned, such as a lowered head. A swap would change the sense.
bool turn_together(std::span<const glm::dvec3> points, std::span<const glm::dvec3> targets, std::size_t i,
                   std::size_t j) {
    std::size_t nearest = i;
    double least = 2 * farthest_neighbor;
    for (std::size_t k = 0; k < targets.size(); ++k) {
        if (k == i || k == j) continue;
        const double apart = glm::distance(targets[k], targets[i]) + glm::distance(targets[k], targets[j]);
        if (apart >= least) continue;
        nearest = k;
        least = apart;
    }
    if (nearest == i) return false;
    const double sine = sine_at(points, nearest, i, j);
    const double wanted = sine_at(targets, nearest, i, j);
    return sine * wanted > 0 && std::min(std::abs(sine), std::abs(wanted)) > clear_sine;
}

/// Whether a way points about against another one.
bool is_reversed(const glm::dvec3& way, const glm::dvec3& wanted) {
    return glm::dot(way, wanted) < reversed_cosine * glm::length(way) * glm::length(wanted);
}

using Pairs = std::vector<std::array<std::size_t, 2>>;

/// Whether a pair of landmarks does not clearly lie as it should in space, once landmarks that are in none of
/// \p doubted are turned best to their counterparts; near ones count most, since a head may be turned. True if that is
/// not known. Only their maps to the sphere may turn narrow parts, such as necks, differently.
bool is_doubtful_in_space(const LandmarkPins& pins, const std::array<std::size_t, 2>& pair,
                          const Pairs& doubted) {
    const auto [i, j] = pair;
    const std::span<const glm::dvec3> places = pins.positions;
    const std::span<const glm::dvec3> counterparts = pins.counterparts;
    if (counterparts.empty()) return true;
    const glm::dvec3 across = places[i] - places[j];
    const glm::dvec3 wanted_across = counterparts[i] - counterparts[j];
    const glm::dvec3 middle = (places[i] + places[j]) / 2.0;
    const glm::dvec3 middle_there = (counterparts[i] + counterparts[j]) / 2.0;
    std::vector<glm::dvec3> from;
    std::vector<glm::dvec3> to;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto has_k = [&](const std::array<std::size_t, 2>& each) {
            return each[0] == k || each[1] == k;
        };
        if (std::ranges::any_of(doubted, has_k)) continue;
        const glm::dvec3 way = places[k] - middle;
        const glm::dvec3 wanted = counterparts[k] - middle_there;
        from.push_back(way / glm::dot(way, way));
        to.push_back(wanted / glm::dot(wanted, wanted));
    }
    const RotationFit fit = fit_rotation(from, to);
    if (!(fit.margin > least_margin * fit.agreement)) return true;
    return glm::dot(fit.rotation * across, wanted_across) <
           agreeing_cosine * glm::length(across) * glm::length(wanted_across);
}

/// Whether a mean cosine after a swap shows that the sides are swapped.
bool shows_swap(double swapped_cosine, double mean_cosine) {
    return swapped_cosine >= mean_cosine + swapped_margin &&
           1 - swapped_cosine < swapped_rest * (1 - mean_cosine);
}

std::string quoted(const LandmarkPins& pins, const std::array<std::size_t, 2>& pair) {
    return fmt::format("'{}' and '{}'", shown_text(pins.names[pair[0]]), shown_text(pins.names[pair[1]]));
}

}  // namespace

LandmarkAgreement agreement_of(std::span<const glm::dvec3> points, const LandmarkPins& pins) {
    LandmarkAgreement agreement;
    const auto count = double(points.size());
    const RotationFit fit = fit_rotation(points, pins.directions);
    agreement.mean_cosine = fit.agreement / count;
    agreement.mirrored_cosine = fit.mirrored / count;
    if (!pins.symmetric.empty()) {
        std::vector<glm::dvec3> exchanged(points.begin(), points.end());
        for (const auto& [left, right] : pins.symmetric) std::swap(exchanged[left], exchanged[right]);
        agreement.exchanged_cosine = fit_rotation(exchanged, pins.directions).agreement / count;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const glm::dvec3 way = fit.rotation * (points[i] - points[j]);
            const glm::dvec3 wanted = pins.directions[i] - pins.directions[j];
            if (is_reversed(way, wanted) && are_neighbors(pins.directions, i, j) &&
                are_neighbors(points, i, j) && !turn_together(points, pins.directions, i, j))
                agreement.reversed.push_back({j, i});
        }
    const Pairs doubted = agreement.reversed;
    std::erase_if(agreement.reversed, [&](const std::array<std::size_t, 2>& pair) {
        return !is_doubtful_in_space(pins, pair, doubted);
    });
    return agreement;
}

bool LandmarkAgreement::is_doubtful() const {
    return mean_cosine < good_cosine;
}

std::vector<std::string> faults_of(const LandmarkAgreement& agreement, const LandmarkPins& pins) {
    std::vector<std::string> faults;
    if (!pins.symmetric.empty() && shows_swap(agreement.exchanged_cosine, agreement.mean_cosine))
        faults.push_back(
            fmt::format("the landmarks fit better with left and right exchanged, such as {}: the sides "
                        "are probably swapped in one of the meshes",
                        quoted(pins, pins.symmetric.front())));
    else if (pins.names.size() >= fewest_chiral &&
             shows_swap(agreement.mirrored_cosine, agreement.mean_cosine))
        faults.emplace_back(
            "the landmarks fit better mirrored: left and right are probably swapped in one of the meshes");
    for (const std::array<std::size_t, 2>& pair : agreement.reversed)
        faults.push_back(
            fmt::format("the landmarks {} lie the other way round than on the first mesh: they are "
                        "probably swapped in one of the meshes",
                        quoted(pins, pair)));
    if (agreement.is_doubtful())
        faults.push_back(
            fmt::format("the landmarks lie differently than on the first mesh (agreement {:.2f}, expected at "
                        "least {}), most "
                        "of all '{}': it is probably swapped with another one or in the wrong place; check "
                        "it, or leave it out",
                        agreement.mean_cosine, good_cosine, shown_text(pins.names[agreement.farthest])));
    return faults;
}

std::string advice_on(const LandmarkAgreement& agreement, const LandmarkPins& pins) {
    std::string advice;
    for (const std::string& fault : faults_of(agreement, pins)) advice += "; " + fault;
    if (agreement.is_doubtful()) return advice;
    return advice + fmt::format("; the landmark '{}' is farthest from its place: check it, or leave it out",
                                shown_text(pins.names[agreement.farthest]));
}

}  // namespace interleaf
