#include "app/cli/option_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "app/document/expected_text.h"
#include "app/document/typed_count.h"
#include "family/field_scale.h"
#include "hierarchy/error.h"
#include "io/text/joined_text.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

constexpr int max_side = 16384;

/// The finite numbers in \p text, separated by commas; none if a part of \p text is not a finite number.
std::optional<std::vector<double>> numbers(std::string_view text) {
    std::vector<double> values;
    for (const std::string_view part : split_at(text, ',')) {
        const std::optional<double> value = parsed_number<double>(part);
        if (!value || !std::isfinite(*value)) return {};
        values.push_back(*value);
    }
    return values;
}

struct ShownEdges {
    std::string_view name;
    bool Display::*shown;
};

constexpr ShownEdges shown_edges[] = {{"wireframe", &Display::wireframe},
                                      {"refinement-edges", &Display::refinement_edges},
                                      {"root-edges", &Display::root_edges},
                                      {"vertices", &Display::vertices},
                                      {"normals", &Display::normals}};

}  // namespace

double parse_number(std::string_view text) {
    const auto values = numbers(text);
    if (!values || values->size() != 1) fail_expecting("a number", text);
    return values->front();
}

Index parse_count(std::string_view text) {
    const std::optional<Index> count = typed_count(text);
    if (!count) fail_expecting("a whole number", text);
    return *count;
}

unsigned parse_corner(std::string_view text) {
    constexpr std::string_view corners[] = {"first", "second", "last"};
    const auto* const found = std::ranges::find(corners, text);
    if (found == std::end(corners)) fail_expecting("first, second or last", text);
    return static_cast<unsigned>(found - corners);
}

float parse_line_width(std::string_view text) {
    constexpr double max_width = 100;
    const auto width = parsed_number<double>(text);
    if (!width || !(*width > 0 && *width <= max_width))
        fail_expecting(fmt::format("a width above 0, at most {}", max_width), text);
    return static_cast<float>(*width);
}

ChosenWarp parse_warp(std::string_view text) {
    ChosenWarp warp{std::string(text)};
    // A comma belongs to the name of the field unless a number follows.
    if (const std::size_t comma = text.rfind(','); comma != std::string_view::npos)
        if (const auto factor = numbers(text.substr(comma + 1)); factor && factor->size() == 1)
            warp = {std::string(text.substr(0, comma)), factor->front()};
    if (warp.field.empty()) fail_expecting("FIELD or FIELD,FACTOR", text);
    return warp;
}

void parse_height(std::string_view text, Display& display) {
    constexpr double usual_part = 0.25;
    const ChosenWarp chosen = parse_warp(text);
    const double part = chosen.field == text ? usual_part : chosen.factor;
    if (!(part > 0 && part <= 1)) fail_expecting("FIELD or FIELD,PART with a part above 0 and up to 1", text);
    display.raised_by = chosen.field;
    display.height = static_cast<float>(part);
}

void parse_arrows(std::string_view text, Display& display) {
    std::vector<std::string> parts(1);
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool is_escape =
            text[at] == '\\' && at + 1 < text.size() && (text[at + 1] == ',' || text[at + 1] == '\\');
        if (is_escape)
            parts.back() += text[++at];
        else if (text[at] == ',')
            parts.emplace_back();
        else
            parts.back() += text[at];
    }
    if (parts.size() < 2 || parts.size() > 3 || std::ranges::any_of(parts, &std::string::empty))
        fail_expecting("two or three scalars, X,Y or X,Y,Z", text);
    display.arrows = true;
    display.arrow_parts = {};
    std::ranges::move(parts, display.arrow_parts.begin());
}

NamedUnit parse_unit(std::string_view text) {
    const std::size_t sign = text.rfind('=');
    if (sign == 0 || sign == std::string_view::npos || !is_unit(text.substr(sign + 1)))
        throw UsageError(fmt::format("--unit: expected FIELD=TEXT, such as T=K, got '{}'", text));
    return {std::string(text.substr(0, sign)), std::string(text.substr(sign + 1))};
}

unsigned parse_bits(std::string_view text) {
    const unsigned bits = parsed_number<unsigned>(text).value_or(0);
    if (bits < 8 || bits > 24) fail_expecting("a whole number from 8 to 24", text);
    return bits;
}

glm::dvec2 parse_point(std::string_view text) {
    const auto values = numbers(text);
    if (!values || values->size() != 2) fail_expecting("U,V", text);
    return {(*values)[0], (*values)[1]};
}

std::vector<NamedWeight> parse_weights(std::string_view text) {
    std::vector<NamedWeight> weights;
    std::string name;  // a comma without a number before it belongs to the name
    for (const std::string_view part : split_at(text, ',')) {
        const std::size_t equals = part.rfind('=');
        name += part.substr(0, equals);
        if (equals == std::string_view::npos) {
            name += ',';
            continue;
        }
        const std::optional<double> value = parsed_number<double>(part.substr(equals + 1));
        if (!value || !std::isfinite(*value)) fail_expecting("NAME=WEIGHT,...", text);
        weights.push_back({std::exchange(name, {}), *value});
    }
    if (!name.empty()) fail_expecting("NAME=WEIGHT,...", text);
    return weights;
}

PictureSize parse_size(std::string_view text) {
    const std::vector<std::string_view> sides = split_at(text, 'x');
    const auto side = [&](std::size_t i) {
        return i < sides.size() ? parsed_number<int>(sides[i]).value_or(0) : 0;
    };
    const auto is_allowed = [](int length) { return length >= 1 && length <= max_side; };
    if (sides.size() != 2 || !is_allowed(side(0)) || !is_allowed(side(1))) {
        fail_expecting(fmt::format("WIDTHxHEIGHT with sides from 1 to {}", max_side), text);
    }
    return {side(0), side(1)};
}

FrameRange parse_frames(std::string_view text) {
    const std::vector<std::string_view> ends = split_at(text, ':');
    const auto first = parsed_number<std::size_t>(ends.front());
    const auto last = parsed_number<std::size_t>(ends.back());
    if (ends.size() != 2 || !first || !last || *last < *first)
        fail_expecting("A:B, the numbers of the first and the last frame", text);
    return {*first, *last};
}

ConstantRange parse_constant_range(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::size_t colon = text.find(':');
    if (equals != std::string_view::npos && colon != std::string_view::npos && equals < colon) {
        const auto low = numbers(text.substr(equals + 1, colon - equals - 1));
        const auto high = numbers(text.substr(colon + 1));
        if (low && high && low->size() == 1 && high->size() == 1)
            return {std::string(text.substr(0, equals)), low->front(), high->front()};
    }
    fail_expecting("NAME=A:B", text);
}

AxisTurn parse_axis_turn(std::string_view text) {
    constexpr std::string_view axes = "xyz";
    const std::vector<std::string_view> parts = split_at(text, ',');
    const std::size_t axis = parts[0].size() == 1 ? axes.find(parts[0]) : std::string_view::npos;
    const std::optional<double> degrees = parts.size() == 2 ? parsed_number<double>(parts[1]) : std::nullopt;
    if (axis == std::string_view::npos || !degrees || !(std::abs(*degrees) <= 360))
        fail_expecting("AXIS,DEGREES with the axis x, y or z, from -360 to 360 degrees", text);
    return {static_cast<int>(axis), *degrees};
}

UpAxis parse_up(std::string_view text) {
    if (const std::optional<UpAxis> up = up_axis_named(text)) return *up;
    fail_expecting("X, Y or Z", text);
}

LandmarkPlacing parse_placing(std::string_view text) {
    if (text == "similarity") return LandmarkPlacing::similarity;
    if (text == "rigid") return LandmarkPlacing::rigid;
    if (text == "keep") return LandmarkPlacing::keep;
    fail_expecting("similarity, rigid or keep", text);
}

Shading parse_shading(std::string_view text) {
    const std::optional<Shading> shading = shading_named(text);
    if (!shading) fail_expecting("smooth or flat", text);
    return *shading;
}

Material parse_material(std::string_view text) {
    const std::optional<Material> material = material_named(text);
    if (!material) fail_expecting("clay, porcelain, steel, jade or normals", text);
    return *material;
}

Theme parse_theme(std::string_view text) {
    const std::optional<Theme> theme = theme_named(text);
    if (!theme) fail_expecting("dark or light", text);
    return *theme;
}

void parse_coloring(std::string_view text, Display& display) {
    const std::optional<Coloring> coloring = coloring_named(text);
    if (coloring && *coloring != Coloring::field) {
        display.coloring = *coloring;
        return;
    }
    constexpr std::string_view prefix = "field:";
    display.coloring = Coloring::field;
    display.field = text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

Basis parse_basis(std::string_view text) {
    if (const std::optional<Basis> basis = basis_named(text)) return *basis;
    fail_expecting(bases_in_words(), text);
}

BlendKind parse_blend_kind(std::string_view text) {
    if (const std::optional<BlendKind> kind = blend_kind_named(text)) return *kind;
    fail_expecting("straight or turning", text);
}

TimeSource parse_time_source(std::string_view text) {
    if (const std::optional<TimeSource> source = time_source_named(text)) return *source;
    fail_expecting("keys or path", text);
}

std::string bases_in_words() {
    std::vector<std::string> names;
    for (const Basis basis : bases()) names.emplace_back(name_of(basis));
    return either_of(names);
}

ColorMap parse_color_map(std::string_view text) {
    if (const std::optional<ColorMap> map = color_map_named(text)) return *map;
    fail_expecting(color_maps_in_words(), text);
}

std::string color_maps_in_words() {
    std::vector<std::string> names;
    for (const ColorMap map : color_maps()) names.emplace_back(name_of(map));
    return either_of(names);
}

std::array<double, 2> parse_range(std::string_view text) {
    const auto values = numbers(text);
    if (!values || values->size() != 2) fail_expecting("MIN,MAX", text);
    const std::array<double, 2> range = {(*values)[0], (*values)[1]};
    if (range[0] >= range[1]) fail_expecting("MIN,MAX, ascending", text);
    return range;
}

void parse_shown_edges(std::string_view text, Display& display) {
    for (const std::string_view name : split_at(text, ',')) {
        const auto found = std::ranges::find(shown_edges, name, &ShownEdges::name);
        if (found == std::end(shown_edges)) fail_expecting(shown_edges_in_words(), name);
        display.*found->shown = true;
    }
}

std::string shown_edges_in_words() {
    std::vector<std::string> names;
    for (const ShownEdges& edges : shown_edges) names.emplace_back(edges.name);
    return either_of(names);
}

}  // namespace interleaf
