// Parses the values of command line options.
//
// Every parse function throws UsageError, which names what was expected.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "app/cli/adapt_command.h"
#include "app/cli/fit_command.h"
#include "app/cli/morph_selection.h"
#include "app/cli/render_command.h"
#include "app/importing/series_import.h"
#include "family/blend_kind.h"
#include "family/field_units.h"
#include "family/interpolation.h"
#include "hierarchy/triangle.h"
#include "render/display.h"
#include "ui/widgets/appearance.h"

namespace interleaf {

/// One finite number, "-0.5".
double parse_number(std::string_view text);

/// A count, "20000" or "2e4".
Index parse_count(std::string_view text);

/// The corner of a triangle, 0 to 2: "first", "second" or "last".
unsigned parse_corner(std::string_view text);

/// The width of lines in pixels, above 0 and at most 100.
float parse_line_width(std::string_view text);

/// A warp, "FIELD" or "FIELD,FACTOR".
ChosenWarp parse_warp(std::string_view text);

/// The unit of a field, "FIELD=TEXT".
NamedUnit parse_unit(std::string_view text);

/// The number of bits of a rounded coordinate, 8 to 24.
unsigned parse_bits(std::string_view text);

/// A point "U,V".
glm::dvec2 parse_point(std::string_view text);

/// Named weights "star=0.5,sphere=-1".
std::vector<NamedWeight> parse_weights(std::string_view text);

/// The size of a picture, "WxH" in pixels, each side from 1 to 16384.
PictureSize parse_size(std::string_view text);

/// A range of frames, "A:B", two whole numbers, the second at least the first.
FrameRange parse_frames(std::string_view text);

/// The range of a constant, "NAME=A:B".
ConstantRange parse_constant_range(std::string_view text);

/// A turn "AXIS,DEGREES" about the axis x, y or z.
AxisTurn parse_axis_turn(std::string_view text);

/// The axis that points up: "X", "Y" or "Z", in either case.
UpAxis parse_up(std::string_view text);

/// How landmarks place a mesh: "similarity", "rigid" or "keep".
LandmarkPlacing parse_placing(std::string_view text);

Shading parse_shading(std::string_view text);

Material parse_material(std::string_view text);

Theme parse_theme(std::string_view text);

/// A coloring: one of coloring_names_in_words(), or the name of a field. "field:NAME" means a field, also one that is
/// called like a coloring.
void parse_coloring(std::string_view text, Display& display);

/// The name of a color map.
ColorMap parse_color_map(std::string_view text);

/// The names of all color maps: "viridis, magma or coolwarm".
std::string color_maps_in_words();

/// The name of an interpolation basis.
Basis parse_basis(std::string_view text);
BlendKind parse_blend_kind(std::string_view text);

/// What drives the blend over time: "keys" or "path".
TimeSource parse_time_source(std::string_view text);

/// The names of all interpolation bases: "linear, hold, ... or spline".
std::string bases_in_words();

/// A range "MIN,MAX", ascending.
std::array<double, 2> parse_range(std::string_view text);

/// Shows the edges that \p text names, such as "wireframe,root-edges".
void parse_shown_edges(std::string_view text, Display& display);

/// Raises flat keys by a scalar: "FIELD", or "FIELD,PART" with the height of its range as a part of the size of the
/// surface, above 0 and up to 1.
void parse_height(std::string_view text, Display& display);

/// Shows the arrows of a vector of scalars: "X,Y" or "X,Y,Z". In a name, "\," stands for a comma and "\\" for a
/// backslash.
void parse_arrows(std::string_view text, Display& display);

/// The names of all lines and points that can be shown: "wireframe, ... or normals".
std::string shown_edges_in_words();

}  // namespace interleaf
