// What the picture shows, as plain data; the window's toggles and the command line's options set it.
#pragma once

#include <string>

#include "render/color_map.h"

namespace interleaf {

enum class Shading { smooth, flat };

enum class Coloring {
    plain,    ///< one colour
    level,    ///< bisections above the leaf
    origin,   ///< which of the active keys bisect this far
    checker,  ///< a checker over the roots, carried along by level maps
    field,    ///< a field of the keys
};

struct Display {
    Shading shading = Shading::smooth;
    Coloring coloring = Coloring::plain;
    std::string field;          ///< the name of the one that Coloring::field shows
    bool range_locked = false;  ///< whether the range of the scale stays when the field is another
    ColorScale scale;           ///< of a scalar field
    bool wireframe = false;     ///< the edges of the leaves
    bool refinement_edges =
        false;                ///< the edge of each leaf that bisection would split, in a colour of its own
    bool root_edges = false;  ///< the edges of the root complex
    float line_width = 1.5F;  ///< pixels
    bool operator==(const Display&) const = default;
};

}  // namespace interleaf
