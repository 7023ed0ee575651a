#include "app/cli/mesh_figures.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "fit/clean_up/clean_up.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"
#include "io/read_files.h"

namespace interleaf {

namespace {

std::string counted(std::size_t count, std::string_view thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

}  // namespace

MeshFigures figures_of_mesh(const std::filesystem::path& file) {
    SurfaceFile surface = read_surface(file);
    MeshFigures figures;
    figures.file = std::filesystem::file_size(file);
    figures.remarks = std::move(surface.remarks);
    figures.has_colors = !surface.colors.empty();
    figures.box_min = glm::dvec3(std::numeric_limits<double>::infinity());
    figures.box_max = -figures.box_min;
    for (const Triangle& triangle : surface.triangles)
        for (const Index vertex : triangle) {
            figures.box_min = glm::min(figures.box_min, surface.positions[vertex]);
            figures.box_max = glm::max(figures.box_max, surface.positions[vertex]);
        }
    // Move the mesh to the origin, so that floats and products keep their digits.
    const glm::dvec3 center = figures.box_min / 2.0 + figures.box_max / 2.0;
    for (glm::dvec3& position : surface.positions) position -= center;
    const std::vector<glm::vec3> positions(surface.positions.begin(), surface.positions.end());
    figures.min_angle = measure(surface.triangles, positions).min_angle;
    figures.census = census_of({std::move(surface.positions), std::move(surface.triangles), {}});
    return figures;
}

std::vector<std::string> faults_of_mesh(const std::filesystem::path& file) {
    SurfaceFile surface = read_surface(file);
    try {
        const CleanMesh clean =
            clean_up({std::move(surface.positions), std::move(surface.triangles), {}}, {});
        return unwanted_changes(clean.report, false, false);
    } catch (const InputError& error) {
        return {error.what()};
    }
}

std::string in_words(const SurfaceCensus& census) {
    std::string text =
        fmt::format("{}, {}", census.parts,
                    census.openings == 0 ? "closed" : "with " + counted(census.openings, "opening"));
    if (!census.handles) return fmt::format("{}, one-sided", census.parts);
    if (*census.handles == 0) return text + ", without handles";
    return fmt::format("{}, {}", text, counted(*census.handles, "handle"));
}

}  // namespace interleaf
