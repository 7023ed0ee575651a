#include "fit/sphere_map/spherical_star.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "fit/mesh/space_triangle.h"

namespace interleaf {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A determinant below this fraction of the length of its edges is too close to 0: rounding a unit vector
/// moves it by 1e-16.
constexpr double min_height = 8e-16;

/// The exponents of MIPS and of the area's term.
struct Exponents {
    double mips;
    double area;
};

constexpr Exponents exponents_of(Keeps keeps) {
    return keeps == Keeps::areas ? Exponents{2, 1} : Exponents{3, 5.0 / 16};
}

/// Uses square roots, which are the same on every machine.
double to_5_16th(double value) {
    const double fourth_root = std::sqrt(std::sqrt(value));
    return fourth_root * std::sqrt(std::sqrt(fourth_root));
}

/// The stretch and the determinant of a triangle for one place of its first corner, and the two resulting
/// distortions.
struct Distortion {
    double mips;   ///< stretch / (2 determinant)
    double ratio;  ///< of the area to the target area

    Distortion(const StarTriangle& triangle, double stretch, double determinant)
        : mips(stretch / (2 * determinant)), ratio(determinant / (2 * triangle.area)) {}

    double energy(const StarTriangle& triangle, Keeps keeps) const {
        const double area_term = (ratio + 1 / ratio) / 2;
        return triangle.area * mips * mips *
               (keeps == Keeps::areas ? area_term : mips * to_5_16th(area_term));
    }
};

double stretch_of(const StarTriangle& triangle, double squared_to_a, double squared_to_b) {
    return triangle.fixed_stretch + triangle.cotangent_to_a * squared_to_a +
           triangle.cotangent_to_b * squared_to_b;
}

/// Raises the second derivatives until they form a bowl, if they do not.
glm::dvec2 newton_direction(const StarEnergy& here) {
    const double mean = (here.ss + here.tt) / 2;
    const double half = (here.ss - here.tt) / 2;
    const double spread =
        std::sqrt(half * half + here.st * here.st);  // hypot rounds differently on each system
    const double floor = 0.05 * (std::abs(mean) + spread);
    const double raise = std::max(0.0, floor - (mean - spread));
    const double ss = here.ss + raise;
    const double tt = here.tt + raise;
    const double determinant = ss * tt - here.st * here.st;
    return glm::dvec2(here.st * here.gradient.y - tt * here.gradient.x,
                      here.st * here.gradient.x - ss * here.gradient.y) /
           determinant;
}

}  // namespace

TangentFrame::TangentFrame(const glm::dvec3& unit_point) : center(unit_point) {
    // Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
    const double sign = std::copysign(1.0, center.z);
    const double a = -1 / (sign + center.z);
    const double b = center.x * center.y * a;
    s_axis = {1 + sign * center.x * center.x * a, sign * b, -sign * center.x};
    t_axis = {b, sign + center.y * center.y * a, -center.y};
}

glm::dvec3 TangentFrame::local(const glm::dvec3& point) const {
    const glm::dvec3 difference = point - center;
    return {glm::dot(difference, s_axis), glm::dot(difference, t_axis), -squared_length(difference) / 2};
}

glm::dvec3 TangentFrame::point_at(const glm::dvec2& place) const {
    return glm::normalize(center + place.x * s_axis + place.y * t_axis);
}

void SphericalStar::add(const glm::dvec3& a, const glm::dvec3& b, double cotangent_to_a,
                        double cotangent_to_b, double cotangent_across, double area) {
    const glm::dvec3 la = frame_.local(a);
    const glm::dvec3 lb = frame_.local(b);
    const glm::dvec3 normal = {la.y * (1 + lb.z) - (1 + la.z) * lb.y, (1 + la.z) * lb.x - la.x * (1 + lb.z),
                               la.x * lb.y - la.y * lb.x};
    triangles_.push_back(
        {la, lb, normal, cotangent_to_a, cotangent_to_b, cotangent_across * squared_length(b - a), area});
}

double SphericalStar::energy(const glm::dvec2& place) const {
    const double squared_tangent = glm::dot(place, place);
    const double secant = std::sqrt(1 + squared_tangent);
    const double height = 1 / secant;
    const glm::dvec3 moved = {place * height, -squared_tangent / (secant * (secant + 1))};  // from center
    double sum = 0;
    for (const StarTriangle& triangle : triangles_) {
        const double determinant =
            (place.x * triangle.normal.x + place.y * triangle.normal.y + triangle.normal.z) * height;
        const double to_a = squared_length(moved - triangle.a);
        const double to_b = squared_length(moved - triangle.b);
        if (!(determinant > 0) || determinant * determinant < min_height * min_height * (to_a + to_b))
            return infinity;
        sum += Distortion(triangle, stretch_of(triangle, to_a, to_b), determinant).energy(triangle, keeps_);
    }
    return sum < infinity ? sum : infinity;
}

StarEnergy SphericalStar::energy_at_center() const {
    const double mips_exponent = exponents_of(keeps_).mips;
    const double area_exponent = exponents_of(keeps_).area;
    StarEnergy energy;
    for (const StarTriangle& triangle : triangles_) {
        const glm::dvec3& a = triangle.a;
        const glm::dvec3& b = triangle.b;
        const double determinant = triangle.normal.z;
        const double stretch = stretch_of(triangle, squared_length(a), squared_length(b));
        const Distortion distortion(triangle, stretch, determinant);
        const double value = distortion.energy(triangle, keeps_);

        // The logarithm of the triangle's energy is, but for constants, p log(stretch) - p log(determinant) +
        // q log(r + 1/r), p and q the two exponents. On the sphere the stretch and the determinant are linear
        // in the point, so the second derivatives of each are the same in all directions.
        const glm::dvec2 stretch_rise =
            -2 / stretch *
            (triangle.cotangent_to_a * glm::dvec2(a) + triangle.cotangent_to_b * glm::dvec2(b));
        const double stretch_bend = (triangle.cotangent_to_a * (2 - squared_length(a)) +
                                     triangle.cotangent_to_b * (2 - squared_length(b))) /
                                    stretch;
        const glm::dvec2 determinant_rise = glm::dvec2(triangle.normal) / determinant;
        const double squared_ratio = distortion.ratio * distortion.ratio;
        const double area_slope =
            area_exponent * (squared_ratio - 1) / (squared_ratio + 1);  // of q log(r + 1/r) over log r
        const double area_bend =
            area_exponent * 4 * squared_ratio / ((squared_ratio + 1) * (squared_ratio + 1));

        const double determinant_slope = area_slope - mips_exponent;
        const glm::dvec2 rise = mips_exponent * stretch_rise + determinant_slope * determinant_rise;
        const double in_all_directions = mips_exponent * stretch_bend - determinant_slope;
        const auto second = [&](int i, int j) {
            return rise[i] * rise[j] - mips_exponent * stretch_rise[i] * stretch_rise[j] +
                   (area_bend - determinant_slope) * determinant_rise[i] * determinant_rise[j];
        };
        energy.value += value;
        energy.gradient += value * rise;
        energy.ss += value * (second(0, 0) + in_all_directions);
        energy.st += value * second(0, 1);
        energy.tt += value * (second(1, 1) + in_all_directions);
    }
    return energy;
}

double SphericalStar::squared_size() const {
    double size = 0;
    for (const StarTriangle& triangle : triangles_) size = std::max(size, squared_length(triangle.a));
    return size;
}

bool SphericalStar::has_center_in_kernel() const {
    return energy(glm::dvec2(0)) < infinity;
}

std::optional<glm::dvec2> SphericalStar::middle_of_kernel() const {
    const double size = squared_size();
    constexpr double farthest = 10;  // tangent of 84 degrees
    const double radius = size < 0.25 ? 4 * std::sqrt(size) : farthest;

    std::vector<glm::dvec2> polygon = {
        {-radius, -radius}, {radius, -radius}, {radius, radius}, {-radius, radius}};
    std::vector<glm::dvec2> clipped;
    for (const StarTriangle& triangle : triangles_) {
        const auto height = [&](const glm::dvec2& p) {
            return p.x * triangle.normal.x + p.y * triangle.normal.y + triangle.normal.z;
        };
        clipped.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec2 from = polygon[i];
            const glm::dvec2 to = polygon[i + 1 == polygon.size() ? 0 : i + 1];
            const double from_height = height(from);
            const double to_height = height(to);
            if (from_height > 0) clipped.push_back(from);
            if ((from_height > 0) != (to_height > 0))
                clipped.push_back(from + from_height / (from_height - to_height) * (to - from));
        }
        polygon.swap(clipped);
        if (polygon.size() < 3) return std::nullopt;
    }
    glm::dvec2 middle(0);
    for (const glm::dvec2& corner : polygon) middle += corner;
    middle /= double(polygon.size());
    if (energy(middle) == infinity) return std::nullopt;
    return middle;
}

NewtonStep SphericalStar::newton_step() const {
    const StarEnergy here = energy_at_center();
    const glm::dvec2 step = newton_direction(here);
    const double slope = glm::dot(step, here.gradient);
    if (!(slope < 0) || !(slope > -infinity)) return {};

    constexpr double max_fraction = 0.8;  // to the edge of the kernel
    double part = 1;
    for (const StarTriangle& triangle : triangles_) {
        const double fall = -glm::dot(step, glm::dvec2(triangle.normal));
        if (fall * part > max_fraction * triangle.normal.z) part = max_fraction * triangle.normal.z / fall;
    }
    constexpr int max_halvings = 12;
    constexpr double min_decrease = 1e-4;
    for (int halving = 0; halving < max_halvings; ++halving, part /= 2) {
        const double there = energy(part * step);
        if (there < here.value + min_decrease * part * slope) return {part * step, 1 - there / here.value};
    }
    return {};
}

}  // namespace interleaf
