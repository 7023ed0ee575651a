// Keys generated from formulas: icosahedron, bone, cushion, star and sphere of the paper's figure 8, and the
// brezel of its appendix.
//
// Each shape maps a base surface, the unit sphere or the brezel, to a closed surface. The base's root
// triangles are bisected adaptively: a leaf's error is its distance from the surface plus a term for the turn
// of the normal, largest first.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "hierarchy/hierarchy.h"
#include "shapes/base_surface.h"
#include "shapes/surfaces.h"

namespace interleaf {

/// A shape that can be made by name.
struct Shape {
    std::string_view name;
    std::string_view description;  ///< one line, for people
    BaseSurface base;              ///< whose points the vertices are made from
    Surface surface;               ///< nullptr for the icosahedron, whose 20 roots are enough
};

/// All shapes, in the order they are listed to people.
std::span<const Shape> shapes();

/// The shape called \p name; nullptr when there is none.
const Shape* find_shape(std::string_view name);

struct ShapeBudget {
    std::optional<Index> leaves;  ///< at most this many, as near as closure allows; at least the roots
    std::optional<double>
        tolerance;  ///< largest distance from the surface, as a fraction of its box's diagonal; at
                    ///< least 1e-6, which is what the floats of a position can tell
};

/// The key of \p shape, bisected adaptively until the budget is reached; 20,000 leaves when it names neither.
/// \throw UsageError when both are named, or one is out of its range
Hierarchy make_key(const Shape& shape, const ShapeBudget& budget);

/// A key of the family in assets/families/five-keys: the shape's name is the key's.
struct ShippedKey {
    std::string_view shape;
    ShapeBudget budget;
};

/// The five keys as they are shipped, in the family's order. Each has the fewest leaves that look smooth in a
/// window.
std::span<const ShippedKey> five_keys();

}  // namespace interleaf
