// What the picture shows, as plain data; the window's toggles and the command line's options set it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/color_map.h"

namespace interleaf {

enum class Shading { smooth, flat };

/// "smooth": on the command line and in traces.
std::string_view name_of(Shading shading);
std::optional<Shading> shading_named(std::string_view name);

enum class Coloring {
    plain,    ///< one colour
    level,    ///< bisections above the leaf
    origin,   ///< which of the active keys bisect this far
    checker,  ///< a checker over the roots, carried along by level maps
    field,    ///< a field of the keys
};

/// All colorings, in the order in which they are offered; Coloring::field only where there are fields.
std::vector<Coloring> colorings(bool has_fields);

/// The one that follows \p coloring in this order, around its end.
Coloring next_coloring(Coloring coloring, bool has_fields);

/// "plain": on the command line and in traces.
std::string_view name_of(Coloring coloring);
std::optional<Coloring> coloring_named(std::string_view name);

/// "Plain": on a button.
const char* label_of(Coloring coloring);

/// The names, and what they mean, for the help; without Coloring::field.
std::string colorings_in_words();

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
