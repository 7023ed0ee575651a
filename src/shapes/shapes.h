// The analytic keys of the paper's figure 8, generated from formulas: icosahedron, bone, cushion, star and sphere.
//
// Each maps the unit sphere to a closed surface. Over the icosahedron's 20 triangles the sphere is bisected adaptively: a leaf's error
// is its distance from the surface plus a term for the turn of the normal, largest first.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "hierarchy/greedy.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// A shape that can be made by name.
struct Shape {
    std::string_view name;
    std::string_view description;                    ///< one line, for people
    std::function<glm::dvec3(const glm::dvec3&)> surface;  ///< from the unit sphere to the surface
    bool bisected;                                   ///< false for the icosahedron, whose 20 roots are enough
};

/// All shapes, in the order they are listed to people.
std::span<const Shape> shapes();

/// The shape called \p name; nullptr when there is none.
const Shape* find_shape(std::string_view name);

/// The icosahedron's 20 triangles on the unit sphere, not bisected, compatibly marked.
Hierarchy icosahedron();

struct ShapeBudget {
    std::optional<Index> leaves;      ///< at most this many, as near as closure allows
    std::optional<double> tolerance;  ///< largest distance from the surface, as a fraction of the box diagonal
};

/// The key of \p shape, bisected adaptively until the budget is reached; 20,000 leaves when it names neither.
/// \throw UsageError when both are named
Hierarchy make_key(const Shape& shape, const ShapeBudget& budget);

}  // namespace interleaf
