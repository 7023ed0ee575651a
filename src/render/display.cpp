#include "render/display.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

namespace interleaf {

namespace {

struct ShadingRow {
    Shading shading;
    std::string_view name;
};

constexpr std::array<ShadingRow, 2> shading_rows{{{Shading::smooth, "smooth"}, {Shading::flat, "flat"}}};

struct ColoringRow {
    Coloring coloring;
    std::string_view name;
    const char* label;
    std::string_view meaning;  ///< for the help; none where the name says it
    const char* explanation;
};

/// In the order of the enumerators, which is that of the buttons.
constexpr std::array<ColoringRow, 9> coloring_rows{{
    {Coloring::plain, "plain", "Plain", "", "One color."},
    {Coloring::level, "level", "Level", "of each leaf", "The number of bisections above each leaf."},
    {Coloring::origin, "origin", "Origin", "which keys bisect this far",
     "The active keys that bisect as far as each leaf."},
    {Coloring::common, "common", "Common", "whether all, some or one of the keys bisect this far",
     "The complex that all active keys have in common, and what some or one of them add."},
    {Coloring::checker, "checker", "Checker", "over the roots",
     "A pattern over the roots: it shows which part of one key becomes which part of another."},
    {Coloring::angle, "angle", "Angle", "smallest of each leaf", "The smallest angle of each leaf."},
    {Coloring::curvature, "curvature", "Curvature", "mean curvature", "The mean curvature of the blend."},
    {Coloring::moved, "moved", "Moved", "distance from the first active key",
     "The distance of the blend from the first active key."},
    {Coloring::field, "field", "Field", "", "A field of the keys."},
}};

struct MaterialRow {
    Material material;
    std::string_view name;
    const char* label;
    std::string_view meaning;
};

/// In the order of the enumerators.
constexpr std::array<MaterialRow, 5> material_rows{{
    {Material::clay, "clay", "Clay", "under three soft lights"},
    {Material::porcelain, "porcelain", "Porcelain", "glazed"},
    {Material::steel, "steel", "Steel", "which mirrors a horizon and shows how smooth the surface is"},
    {Material::jade, "jade", "Jade", "which light shines through"},
    {Material::normals, "normals", "Normals", "the direction of the surface as a color"},
}};

const ColoringRow& row_of(Coloring coloring) {
    return coloring_rows.at(static_cast<std::size_t>(coloring));
}

}  // namespace

std::string_view name_of(Shading shading) {
    return std::ranges::find(shading_rows, shading, &ShadingRow::shading)->name;
}

std::optional<Shading> shading_named(std::string_view name) {
    const auto* const found = std::ranges::find(shading_rows, name, &ShadingRow::name);
    return found == shading_rows.end() ? std::nullopt : std::optional(found->shading);
}

std::vector<Coloring> colorings(bool has_fields) {
    std::vector<Coloring> offered;
    for (const ColoringRow& row : coloring_rows)
        if (has_fields || row.coloring != Coloring::field) offered.push_back(row.coloring);
    return offered;
}

Coloring next_coloring(Coloring coloring, bool has_fields) {
    const std::vector<Coloring> offered = colorings(has_fields);
    const auto found = std::ranges::find(offered, coloring);
    return found == offered.end() || found + 1 == offered.end() ? offered.front() : *(found + 1);
}

std::string_view name_of(Coloring coloring) {
    return row_of(coloring).name;
}

const char* label_of(Coloring coloring) {
    return row_of(coloring).label;
}

const char* explanation_of(Coloring coloring) {
    return row_of(coloring).explanation;
}

std::string coloring_names_in_words() {
    const std::vector<Coloring> offered = colorings(false);
    std::string words;
    for (const Coloring coloring : offered) {
        if (!words.empty()) words += coloring == offered.back() ? " or " : ", ";
        words += name_of(coloring);
    }
    return words;
}

std::optional<Coloring> coloring_named(std::string_view name) {
    const auto* const found = std::ranges::find(coloring_rows, name, &ColoringRow::name);
    return found == coloring_rows.end() ? std::nullopt : std::optional(found->coloring);
}

std::string colorings_in_words() {
    std::string words;
    for (const Coloring coloring : colorings(false)) {
        if (!words.empty()) words += ", ";
        words += name_of(coloring);
        if (const auto meaning = row_of(coloring).meaning; !meaning.empty())
            words += fmt::format(" ({})", meaning);
    }
    return words;
}

std::vector<Material> materials() {
    std::vector<Material> all;
    all.reserve(material_rows.size());
    for (const MaterialRow& row : material_rows) all.push_back(row.material);
    return all;
}

Material next_material(Material material) {
    return material_rows.at((static_cast<std::size_t>(material) + 1) % material_rows.size()).material;
}

std::string_view name_of(Material material) {
    return material_rows.at(static_cast<std::size_t>(material)).name;
}

const char* label_of(Material material) {
    return material_rows.at(static_cast<std::size_t>(material)).label;
}

std::optional<Material> material_named(std::string_view name) {
    const auto* const found = std::ranges::find(material_rows, name, &MaterialRow::name);
    return found == material_rows.end() ? std::nullopt : std::optional(found->material);
}

std::string materials_in_words() {
    std::string words;
    for (const MaterialRow& row : material_rows)
        words += fmt::format("{}{} ({})", words.empty() ? "" : ", ", row.name, row.meaning);
    return words;
}

float Display::occlusion_strength() const {
    if (!occlusion) return 0;
    if (coloring != Coloring::plain) return 0.5F;
    return material == Material::normals ? 0.0F : 1.0F;
}

}  // namespace interleaf
