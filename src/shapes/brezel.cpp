#include "shapes/brezel.h"

#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace interleaf {
namespace {

using Place = std::array<int, 3>;

/// Number of cubes along each axis.
constexpr Place plate_size = {6, 4, 1};

/// Width of the blur, in cube edges.
constexpr double blur = 0.4;

constexpr bool is_filled(const Place& cube) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (cube[axis] < 0 || cube[axis] >= plate_size[axis]) return false;
    }
    const bool is_hole = (cube[0] == 1 || cube[0] == 4) && (cube[1] == 1 || cube[1] == 2);
    return !is_hole;
}

constexpr Index corner_count = (plate_size[0] + 1) * (plate_size[1] + 1) * (plate_size[2] + 1);

constexpr Index corner_number(const Place& corner) {
    return static_cast<Index>((corner[2] * (plate_size[1] + 1) + corner[1]) * (plate_size[0] + 1) +
                              corner[0]);
}

glm::vec3 to_vector(const Place& place) {
    return {place[0], place[1], place[2]};
}

/// Calls \p visit with every place of the lattice box of \p size.
template <typename Visit>
void for_each_place(const Place& size, Visit visit) {
    for (int z = 0; z < size[2]; ++z)
        for (int y = 0; y < size[1]; ++y)
            for (int x = 0; x < size[0]; ++x) visit(Place{x, y, z});
}

/// Appends the two triangles of the square of \p cube whose normal is along \p axis, in its positive
/// direction if \p up.
///
/// The diagonal goes from the square's smallest corner to its largest. So the reflection of the plate at its
/// center keeps the roots, and 4 to 8 roots meet at each vertex. With diagonals that half turns keep, it
/// would be 3 to 9.
void add_square(const Place& cube, unsigned axis, bool up, std::vector<Triangle>& triangles) {
    const unsigned u = (axis + (up ? 1 : 2)) % 3;  // counter-clockwise from u to v seen from outside
    const unsigned v = (axis + (up ? 2 : 1)) % 3;
    const auto corner = [&](int along_u, int along_v) {
        Place place = cube;
        place[axis] += up ? 1 : 0;
        place[u] += along_u;
        place[v] += along_v;
        return corner_number(place);
    };
    triangles.push_back({corner(1, 0), corner(1, 1), corner(0, 0)});
    triangles.push_back({corner(0, 1), corner(0, 0), corner(1, 1)});
}

/// The blurred indicator function of an interval on an axis, and its derivative.
struct BlurredInterval {
    double value;
    double slope;

    BlurredInterval(double at, double from, double to)
        : value((std::erf((at - from) / blur) - std::erf((at - to) / blur)) / 2),
          slope((bell(at - from) - bell(at - to)) / (blur * std::sqrt(std::acos(-1.0)))) {}

    static double bell(double offset) { return std::exp(-(offset / blur) * (offset / blur)); }
};

}  // namespace

BrezelDensity brezel_density(const glm::dvec3& point) {
    // Adjacent blurred cubes add up to the blurred box that they fill. So the sum over the cubes is the
    // plate's box minus the two holes' boxes.
    const BlurredInterval width(point.x, -3, 3);
    const BlurredInterval height(point.y, -2, 2);
    const BlurredInterval depth(point.z, -0.5, 0.5);
    const BlurredInterval left(point.x, -2, -1);
    const BlurredInterval right(point.x, 1, 2);
    const BlurredInterval hole(point.y, -1, 1);

    const double value = width.value * height.value - (left.value + right.value) * hole.value;
    const double along_x = width.slope * height.value - (left.slope + right.slope) * hole.value;
    const double along_y = width.value * height.slope - (left.value + right.value) * hole.slope;
    return {value * depth.value, {along_x * depth.value, along_y * depth.value, value * depth.slope}};
}

Hierarchy brezel_plate() {
    std::vector<glm::vec3> positions(corner_count);
    for_each_place({plate_size[0] + 1, plate_size[1] + 1, plate_size[2] + 1}, [&](const Place& corner) {
        positions[corner_number(corner)] = to_vector(corner) - to_vector(plate_size) / 2.0F;
    });
    std::vector<Triangle> triangles;
    for_each_place(plate_size, [&](const Place& cube) {
        for (unsigned axis = 0; axis < 3 && is_filled(cube); ++axis) {
            for (const bool up : {false, true}) {
                Place next = cube;
                next[axis] += up ? 1 : -1;
                if (!is_filled(next)) add_square(cube, axis, up, triangles);
            }
        }
    });
    return unrefined(RootComplex(corner_count, std::move(triangles)), positions);
}

glm::dvec3 project_to_brezel(const glm::dvec3& point) {
    constexpr int max_steps = 20;
    constexpr double last_step = 1e-8;  // after such a step, the remaining error is its square
    glm::dvec3 on_surface = point;
    for (int step = 0; step < max_steps; ++step) {
        const auto [value, gradient] = brezel_density(on_surface);
        const glm::dvec3 move = (brezel_level - value) / glm::dot(gradient, gradient) * gradient;
        on_surface += move;
        if (glm::dot(move, move) <= last_step * last_step) return on_surface;
    }
    assert(false && "the point is too far from the brezel");
    return on_surface;
}

}  // namespace interleaf
