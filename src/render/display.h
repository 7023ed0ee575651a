// What the picture shows, as plain data; the window's toggles and the command line's options set it.
#pragma once

#include <glm/vec3.hpp>

namespace interleaf {

enum class Shading { smooth, flat };

enum class Coloring {
    plain,   ///< one colour
    level,   ///< bisections above the leaf
    origin,  ///< which of the active keys bisect this far
};

struct Display {
    Shading shading = Shading::smooth;
    Coloring coloring = Coloring::plain;
    bool wireframe = false;  ///< the edges of the leaves
    bool refinement_edges =
        false;                ///< the edge of each leaf that bisection would split, in a colour of its own
    bool root_edges = false;  ///< the edges of the root complex
    float line_width = 1.5F;  ///< pixels
    bool operator==(const Display&) const = default;
};

}  // namespace interleaf
