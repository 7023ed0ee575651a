// Keys generated from formulas: icosahedron, bone, cushion, star and sphere of the paper's figure 8, and the
// brezel of its appendix.
//
// Each shape maps a base surface, the unit sphere or the brezel, to a closed surface. The base's root
// triangles are bisected adaptively, the leaf with the largest error first. A leaf's error is its distance
// from the surface plus a term for the turn of the normal.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "shapes/base_surface.h"
#include "shapes/surfaces.h"

namespace interleaf {

/// A shape that can be made by name.
struct Shape {
    std::string_view name;
    std::string_view description;  ///< one line, for users
    BaseSurface base;              ///< the surface whose points the vertices stand for
    Surface surface;               ///< nullptr for the icosahedron, which needs only its 20 roots
    std::span<const SurfaceConstant> constants{};  ///< with their values, they give `surface`
    ParametricSurface parametric = nullptr;        ///< null for a shape without constants
};

/// \p shape with other values of its constants.
/// \param values  one per constant
/// \throw UsageError if a value is out of its range
Shape with_constants(const Shape& shape, std::vector<double> values);

/// All shapes, in the order in which they are listed.
std::span<const Shape> shapes();

/// The shape called \p name; nullptr if there is none.
const Shape* find_shape(std::string_view name);

struct ShapeBudget {
    /// Maximum number of leaves; refinement comes as close to it as closure allows. At least the number of
    /// roots.
    std::optional<Index> leaves;

    /// Maximum distance from the surface, as a fraction of the diagonal of its box. At least 1e-6, which is
    /// the resolution of float positions.
    std::optional<double> tolerance;
};

/// The key of \p shape, bisected adaptively until the budget is reached; 20,000 leaves if the budget sets
/// neither limit.
/// \throw UsageError if the budget sets both limits, or one that is out of range
Hierarchy make_key(const Shape& shape, const ShapeBudget& budget);

/// A key of the family in assets/families/five-keys: the shape's name is the key's name.
struct ShippedKey {
    std::string_view shape;
    ShapeBudget budget;
};

/// The five shipped keys, in the family's order. Each has the minimum number of leaves that look smooth in a
/// window.
std::span<const ShippedKey> five_keys();

}  // namespace interleaf
