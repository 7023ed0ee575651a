// The display options of a picture, as plain data. The window's toggles and the command line's options set
// them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/color_map.h"

namespace interleaf {

enum class Shading { smooth, flat };

/// Unless a shading is chosen, keys of at most this number of leaves are shaded flat: their leaves are large.
inline constexpr std::size_t few_leaves = 100;

/// The shading of a key of \p leaves, unless another one is chosen.
constexpr Shading usual_shading(std::size_t leaves) {
    return leaves <= few_leaves ? Shading::flat : Shading::smooth;
}

/// "smooth": on the command line and in traces.
std::string_view name_of(Shading shading);
std::optional<Shading> shading_named(std::string_view name);

/// What a surface without coloring looks to be made of. With any other coloring it is of clay.
enum class Material { clay, porcelain, steel, jade, normals };

/// All materials, in the order in which they are offered.
std::vector<Material> materials();

/// The one that follows \p material in this order, around its end.
Material next_material(Material material);

/// "clay": on the command line and in traces.
std::string_view name_of(Material material);
std::optional<Material> material_named(std::string_view name);

/// "Clay": in the window.
const char* label_of(Material material);

/// The names and what they mean, for the help.
std::string materials_in_words();

enum class Coloring {
    plain,      ///< one color
    level,      ///< by the number of bisections above the leaf
    origin,     ///< by the set of active keys in which the leaf is a node
    common,     ///< by how many active keys have the leaf as a node: all, some or one
    checker,    ///< a checkerboard over the roots, carried along by level maps
    angle,      ///< by the smallest angle of each leaf
    curvature,  ///< by the mean curvature of the blend
    moved,      ///< by the distance of the blend from the first active key
    field,      ///< by a field of the keys
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

/// What the coloring shows, in a sentence.
const char* explanation_of(Coloring coloring);

/// "plain, level, ... or moved"; without Coloring::field.
std::string coloring_names_in_words();

/// The names, and what they mean, for the help; without Coloring::field.
std::string colorings_in_words();

struct Display {
    std::optional<Shading> shading{};  ///< none for the usual one; the renderer draws that smooth
    Coloring coloring = Coloring::plain;
    Material material = Material::clay;
    std::string field{};        ///< name of the field that Coloring::field shows
    bool range_locked = false;  ///< whether the range of the scale stays when the field changes
    ColorScale scale{};         ///< of a scalar field

    /// The least and the largest shown value of a range that the scale gets once its field is known. Until then they
    /// are doubles, as floats keep little of values with an offset. The renderer draws what it is given.
    std::optional<std::array<double, 2>> wanted_range{};

    /// The range that the scale of a coloring by values of the blend keeps. Without it the renderer's user chooses one
    /// for the active keys.
    struct KeptRange {
        Coloring coloring;
        ValueRange range;
        bool operator==(const KeptRange&) const = default;
    };
    std::optional<KeptRange> measured_range{};

    /// Of the present coloring.
    std::optional<ValueRange> kept_range() const {
        const bool is_kept = measured_range && measured_range->coloring == coloring;
        return is_kept ? std::optional(measured_range->range) : std::nullopt;
    }

    bool wireframe = false;  ///< the edges of the leaves

    /// The edge of each leaf that a bisection would split, in a color of its own.
    bool refinement_edges = false;

    bool root_edges = false;  ///< the edges of the root complex
    bool vertices = false;    ///< a dot at each vertex
    bool normals = false;     ///< a line along the normal at each vertex
    float line_width = 1.5F;  ///< in pixels

    bool transparent = false;  ///< draws no background: pixels have alpha where no surface is

    /// Whether the surface stands above a ground that it casts a soft shadow on (ground.h); the renderer draws none.
    bool ground = false;

    /// Whether hollows are darker, as less light of the sky reaches them.
    bool occlusion = true;

    bool light_background = false;  ///< of the picture; else it is dark

    /// Level of detail, from 0 for the roots alone to 1 for the whole keys; the renderer draws what it is given.
    float detail = 1;

    /// Height of the shown scalar's range over a flat surface, as a part of the surface's size; 0 shows it flat. The
    /// renderer draws what it is given.
    float height = 0;

    /// The scalar by which the surface is raised; the shown one if empty.
    std::string raised_by{};

    bool arrows = false;  ///< arrows of the vector whose component is shown; the renderer draws none

    /// The scalars that are the components of another vector for the arrows; the third may be empty. All are empty for
    /// the vector whose component is shown.
    std::array<std::string, 3> arrow_parts{};

    bool legend = false;  ///< of the shown scalar, in pictures that are written to files

    /// Whether the detail follows the camera instead, within a budget of leaves.
    bool follows_camera = false;

    /// How much hollows are darkened, 0 to 1: less where colors have a meaning.
    float occlusion_strength() const;

    bool operator==(const Display&) const = default;
};

}  // namespace interleaf
