// The star of a vertex: its derivatives, its kernel, and steps that stay inside.
#include "fit/sphere_map/spherical_star.h"

#include <cmath>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/sphere_map/orientation.h"

using namespace interleaf;

namespace {

struct RandomStar {
    glm::dvec3 center;
    std::vector<glm::dvec3> ring;
    SphericalStar star;
};

/// A star of \p size around a random point, with random shapes and target areas.
RandomStar random_star(unsigned seed, double size) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const glm::dvec3 center = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
    const TangentFrame frame(center);
    RandomStar made{center, {}, SphericalStar(center)};
    const int count = 3 + int(random() % 6);
    for (int i = 0; i < count; ++i) {
        const double angle = 6.283185307 * (i + 0.2 * number(random)) / count;
        const double radius = size * (1 + 0.7 * number(random));
        made.ring.push_back(frame.point_at({radius * std::cos(angle), radius * std::sin(angle)}));
    }
    for (std::size_t i = 0; i < made.ring.size(); ++i) {
        const double area = size * size * (0.5 + 0.4 * number(random));
        made.star.add(made.ring[i], made.ring[(i + 1) % made.ring.size()], 0.6 + 0.5 * number(random),
                      0.6 + 0.5 * number(random), 0.6 + 0.5 * number(random), area);
    }
    return made;
}

bool is_in_kernel(const RandomStar& made, const glm::dvec3& point) {
    for (std::size_t i = 0; i < made.ring.size(); ++i)
        if (orientation(point, made.ring[i], made.ring[(i + 1) % made.ring.size()]) <= 0) return false;
    return true;
}

}  // namespace

TEST_CASE("a frame is orthonormal, right-handed, and its coordinates are those of the point") {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        const glm::dvec3 p = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        const glm::dvec3 q = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        const TangentFrame frame(p);
        CHECK(glm::length(glm::cross(frame.s_axis, frame.t_axis) - p) < 1e-14);
        const glm::dvec3 local = frame.local(q);
        CHECK(glm::length(p + local.x * frame.s_axis + local.y * frame.t_axis + local.z * p - q) < 1e-14);
    }
}

TEST_CASE("the derivatives are the limits of differences, for large stars and for small ones") {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        const double size = seed % 3 == 0 ? 0.7 : seed % 3 == 1 ? 1e-2 : 1e-7;
        const RandomStar made = random_star(seed, size);
        const StarEnergy energy = made.star.energy_at_center();
        const auto at = [&](double s, double t) { return made.star.energy({s, t}); };
        CHECK(at(0, 0) == doctest::Approx(energy.value).epsilon(1e-12));
        const double h = 1e-4 * size;
        const double scale = std::abs(energy.ss) + std::abs(energy.tt) + std::abs(energy.st);
        CHECK(std::abs((at(h, 0) - at(-h, 0)) / (2 * h) - energy.gradient.x) < 1e-4 * scale * size);
        CHECK(std::abs((at(0, h) - at(0, -h)) / (2 * h) - energy.gradient.y) < 1e-4 * scale * size);
        CHECK(std::abs((at(h, 0) - 2 * at(0, 0) + at(-h, 0)) / (h * h) - energy.ss) < 1e-3 * scale);
        CHECK(std::abs((at(0, h) - 2 * at(0, 0) + at(0, -h)) / (h * h) - energy.tt) < 1e-3 * scale);
        CHECK(std::abs((at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h) - energy.st) <
              1e-3 * scale);
    }
}

TEST_CASE(
    "a step lowers the energy by what it says and stays in the kernel; steps come to rest at a minimum") {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        const RandomStar made = random_star(seed, seed % 2 == 0 ? 0.5 : 1e-9);
        const NewtonStep step = made.star.newton_step();
        if (step.gain == 0) continue;
        CHECK(made.star.energy(step.place) ==
              doctest::Approx((1 - step.gain) * made.star.energy(glm::dvec2(0))).epsilon(1e-9));
        CHECK(is_in_kernel(made, made.star.frame().point_at(step.place)));
    }
}

TEST_CASE("the middle of the kernel is in it, seen from any point of it; a star without a kernel has none") {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        const RandomStar made = random_star(seed, seed % 2 == 0 ? 0.5 : 1e-9);
        const auto middle = made.star.middle_of_kernel();
        REQUIRE(middle);
        CHECK(is_in_kernel(made, made.star.frame().point_at(*middle)));
    }
    // A ring of eight vertices, twisted: every other vertex lies behind the middle of its edge. A pinwheel.
    const glm::dvec3 center(0, 0, 1);
    const TangentFrame frame(center);
    SphericalStar pinwheel(center);
    std::vector<glm::dvec3> ring;
    for (int i = 0; i < 8; ++i) {
        const double angle = 0.785398163 * (i + (i % 2 == 0 ? 0.0 : 2.5));
        const double radius = i % 2 == 0 ? 0.5 : 0.1;
        ring.push_back(frame.point_at({radius * std::cos(angle), radius * std::sin(angle)}));
    }
    for (std::size_t i = 0; i < 8; ++i) pinwheel.add(ring[i], ring[(i + 1) % 8], 0.6, 0.6, 0.6, 0.1);
    CHECK_FALSE(pinwheel.middle_of_kernel());
    CHECK_FALSE(pinwheel.has_center_in_kernel());
}

TEST_CASE("the orientation has the sign of exact arithmetic where doubles alone cannot tell") {
    const glm::dvec3 a(1, 0x1p-30, 0x1p-60);
    const glm::dvec3 b(1, 0x1p-29, 0x1p-59);
    CHECK(orientation(a, b, {1, 0, 0}) == 0);  // all three on one great circle
    // det(a, b, (1, 0, z)) = z 2^-30 exactly: smaller than the rounding of any of its terms.
    CHECK(orientation(a, b, {1, 0, 0x1p-200}) == 1);
    CHECK(orientation(a, b, {1, 0, -0x1p-200}) == -1);
    CHECK(orientation(b, a, {1, 0, 0x1p-200}) == -1);
    CHECK(orientation({1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == 1);
    CHECK(orientation({0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == -1);
    CHECK(orientation(a, a, b) == 0);
}
