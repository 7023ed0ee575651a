// The surfaces of the analytic keys (paper, figure 8): each maps a point of the unit sphere to a point of a
// closed surface.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

#include <glm/vec3.hpp>

namespace interleaf {

/// A map from a base surface to a surface, one to one, keeping the orientation. The base is the unit sphere
/// unless stated otherwise.
using Surface = std::function<glm::dvec3(const glm::dvec3& u)>;

/// The same, as a plain function.
using PlainSurface = glm::dvec3 (*)(const glm::dvec3& u);

/// A family of surfaces, one per set of constants.
/// \param constants  one per constant that the family names
using ParametricSurface = glm::dvec3 (*)(const glm::dvec3& u, std::span<const double> constants);

/// A constant of a parametric surface.
struct SurfaceConstant {
    std::string_view name;
    double value;  ///< of the shape as it is known
    double low;    ///< the range in which the surface is sound
    double high;
};

/// The unit sphere itself.
glm::dvec3 sphere_surface(const glm::dvec3& u);

/// Z^2 = height^2 (1 - (X / length)^2)(1 - Y^2), intersected with the ray through \p u.
inline constexpr std::array cushion_constants = {SurfaceConstant{"height", 0.55, 0.1, 1},
                                                 SurfaceConstant{"length", 1, 0.5, 2}};
glm::dvec3 cushion_surface(const glm::dvec3& u, std::span<const double> constants);

/// An arm towards each of the icosahedron's 12 vertices d: radius core + arm * sum over d of exp(sharpness (u.d -
/// 1)).
inline constexpr std::array star_constants = {SurfaceConstant{"core", 0.62, 0.2, 2},
                                              SurfaceConstant{"arm", 0.95, 0, 3},
                                              SurfaceConstant{"sharpness", 22, 8, 60}};
glm::dvec3 star_surface(const glm::dvec3& u, std::span<const double> constants);

/// A bone along the x axis, with two knobs at each end, at +y and -y. Half its length along the axis, the radius
/// of the shaft, and how much thicker the ends are.
inline constexpr std::array bone_constants = {SurfaceConstant{"length", 1.25, 0.5, 3},
                                              SurfaceConstant{"shaft", 0.17, 0.05, 0.5},
                                              SurfaceConstant{"knob", 0.17, 0, 0.5}};
glm::dvec3 bone_surface(const glm::dvec3& u, std::span<const double> constants);

/// The values of \p constants as the shapes are known.
template <std::size_t count>
constexpr std::array<double, count> values_of(const std::array<SurfaceConstant, count>& constants) {
    std::array<double, count> values{};
    for (std::size_t i = 0; i < count; ++i) values[i] = constants[i].value;
    return values;
}

/// The surfaces of the five keys: those with the values of their constants.
/// @{
inline glm::dvec3 cushion_surface(const glm::dvec3& u) {
    return cushion_surface(u, values_of(cushion_constants));
}
inline glm::dvec3 star_surface(const glm::dvec3& u) {
    return star_surface(u, values_of(star_constants));
}
inline glm::dvec3 bone_surface(const glm::dvec3& u) {
    return bone_surface(u, values_of(bone_constants));
}
/// @}

}  // namespace interleaf
