#include "fit/clean_up.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/edge_pairing.h"
#include "fit/hole_filling.h"
#include "fit/surface_splitting.h"
#include "fit/triangle_soup.h"
#include "fit/unit_box.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

void check_numbers(const SurfaceMesh& mesh) {
    constexpr std::size_t most = std::size_t{1} << 30;  // half-edges and their sums are counted in 32 bits
    if (mesh.triangles.empty()) throw InputError("the mesh has no triangles");
    if (mesh.triangles.size() > most || mesh.positions.size() > most)
        throw InputError(
            fmt::format("the mesh has {} vertices and {} triangles, at most 2^30 of each are expected",
                        mesh.positions.size(), mesh.triangles.size()));
    if (!mesh.colors.empty() && mesh.colors.size() != mesh.positions.size())
        throw InputError(fmt::format("the mesh has {} colours for {} vertices", mesh.colors.size(),
                                     mesh.positions.size()));
    const auto is_good = [](double number) {  // not of a NaN either
        return std::abs(number) <= std::numeric_limits<float>::max();
    };
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p = mesh.positions[i];
        if (!is_good(p.x) || !is_good(p.y) || !is_good(p.z))
            throw InputError(fmt::format(
                "vertex {} is at ({}, {}, {}); numbers that fit a float are expected", i, p.x, p.y, p.z));
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const Index vertex : mesh.triangles[i])
            if (vertex >= mesh.positions.size())
                throw InputError(fmt::format("triangle {} names vertex {}, but there are {}", i, vertex,
                                             mesh.positions.size()));
}

std::vector<double> areas_of(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    std::vector<double> areas;
    areas.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles)
        areas.push_back(glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) /
                        2);
    return areas;
}

/// Keeps the component of the largest area, the first of equal ones.
void keep_largest(std::vector<Triangle>& triangles, std::vector<Index>& twin,
                  std::span<const glm::dvec3> positions, CleanUpReport& report, ProgressMeter& meter) {
    const std::vector<Index> component = components_of(twin, meter);
    const std::vector<double> areas = areas_of(triangles, positions);
    std::vector<double> area_of_component(1 + *std::max_element(component.begin(), component.end()));
    for (std::size_t i = 0; i < areas.size(); ++i) area_of_component[component[i]] += areas[i];
    const auto largest = static_cast<Index>(
        std::max_element(area_of_component.begin(), area_of_component.end()) - area_of_component.begin());

    std::vector<Index> number(triangles.size(), no_index);
    Index count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (component[i] == largest) number[i] = count++;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (number[i] == no_index) continue;
        triangles[number[i]] = triangles[i];
        for (Index k = 0; k < 3; ++k) {
            const Index partner = twin[3 * i + k];
            twin[3 * number[i] + k] = partner == no_index ? no_index : 3 * number[partner / 3] + partner % 3;
        }
    }
    report.dropped_components = area_of_component.size() - 1;
    report.dropped_triangles = triangles.size() - count;
    triangles.resize(count);
    twin.resize(3 * std::size_t(count));
}

/// Refuses holes as large as the surface.
void check_holes(const SurfaceMesh& mesh, const HoleFilling& filling) {
    constexpr double largest_part = 0.95;  // of the surface's own area; the lid of a shallow dish
    const std::vector<double> areas = areas_of(mesh.triangles, in_unit_box(mesh.positions));
    double own = 0;
    double filled = 0;
    for (std::size_t i = 0; i < areas.size(); ++i)
        (i < areas.size() - filling.triangles ? own : filled) += areas[i];
    if (filled >= largest_part * own)
        throw InputError(fmt::format(
            "the surface is an open sheet, not closed: to fill its {} would take {:.0f} % of its own area",
            filling.holes == 1 ? "hole" : fmt::format("{} holes", filling.holes), 100 * filled / own));
}

void check_genus(const SurfaceMesh& mesh) {
    const auto faces = std::ptrdiff_t(mesh.triangles.size());
    const std::ptrdiff_t euler = std::ptrdiff_t(mesh.positions.size()) - faces / 2;
    if (euler != 2)
        throw InputError(fmt::format(
            "the surface has {}, its Euler number is {}; a surface like a ball (genus 0, Euler number 2) is "
            "expected",
            euler == 0 ? "a handle, like a torus" : fmt::format("{} handles", (2 - euler) / 2), euler));
    if (mesh.positions.size() < 4)
        throw InputError("the surface is a single triangle; a closed surface is expected");
}

/// Turns the surface so that it encloses a positive volume; whether it did not already.
bool turn_outward(SurfaceMesh& mesh) {
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
    double volume = 0;
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 origin = positions.front();
        const glm::dvec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        volume += glm::dot(positions[a] - origin, normal) / 6;
        area += glm::length(normal) / 2;
    }
    constexpr double least = 1e-7;  // of a ball of the same area it is about 0.1
    if (!(std::abs(volume) > least * area * std::sqrt(area)))
        throw InputError("the surface encloses no volume: it is flat or folded onto itself");
    if (volume > 0) return false;
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return true;
}

}  // namespace

CleanMesh clean_up(SurfaceMesh mesh, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("cleaning up", 0);
    check_numbers(mesh);
    CleanUpReport report;

    const std::vector<Index> first = first_at_same_point(mesh.positions, meter);
    for (Index vertex = 0; vertex < first.size(); ++vertex) report.welded_vertices += first[vertex] != vertex;
    for (Triangle& triangle : mesh.triangles)
        for (Index& vertex : triangle) vertex = first[vertex];
    report.degenerate_triangles = remove_degenerate(mesh.triangles);
    if (mesh.triangles.empty()) throw InputError("each triangle of the mesh names some point twice");
    meter.set_part(0.2);
    report.duplicate_triangles = remove_duplicates(mesh.triangles, meter);

    meter.set_part(0.4);
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
    auto [twin, crowded_edges] = pair_edges(positions, mesh.triangles, meter);
    report.crowded_edges = crowded_edges;
    meter.set_part(0.6);
    keep_largest(mesh.triangles, twin, positions, report, meter);
    report.turned_triangles = make_agree(mesh.triangles, twin, meter);

    meter.set_part(0.7);
    std::vector<Index> source = split_vertices(mesh, twin, meter);
    std::vector<Index> distinct = source;
    report.split_vertices =
        source.size() - std::size_t(std::unique(distinct.begin(), distinct.end()) - distinct.begin());
    report.split_edges = split_double_edges(mesh, twin, meter);
    meter.set_part(0.9);
    const HoleFilling filling = fill_holes(mesh, twin, meter);
    report.holes = filling.holes;
    report.hole_triangles = filling.triangles;
    source.resize(mesh.positions.size(), no_index);

    check_holes(mesh, filling);
    check_genus(mesh);
    report.turned_outward = turn_outward(mesh);
    meter.enter("cleaning up", 1);
    return {std::move(mesh), report, std::move(source)};
}

std::vector<std::string> CleanUpReport::sentences() const {
    std::vector<std::string> said;
    const auto say = [&](std::size_t count, std::string_view one, std::string_view several) {
        if (count == 1)
            said.push_back(fmt::format("1 {}.", one));
        else if (count > 1)
            said.push_back(fmt::format("{} {}.", count, several));
    };
    say(welded_vertices, "vertex was welded to an equal one", "vertices were welded to equal ones");
    say(degenerate_triangles, "triangle named a point twice and was removed",
        "triangles named a point twice and were removed");
    say(duplicate_triangles, "triangle had the same points as another and was removed",
        "triangles had the same points as others and were removed");
    say(crowded_edges, "edge had more than two triangles, which were parted",
        "edges had more than two triangles, which were parted");
    if (dropped_components > 0)
        said.push_back(fmt::format(
            "{} smaller {} of {} {} dropped.", dropped_components,
            dropped_components == 1 ? "component" : "components",
            dropped_triangles == 1 ? "1 triangle" : fmt::format("{} triangles", dropped_triangles),
            dropped_components == 1 ? "was" : "were"));
    say(turned_triangles, "triangle was turned to agree with its neighbours",
        "triangles were turned to agree with their neighbours");
    say(split_vertices, "vertex was added where the surface touches itself",
        "vertices were added where the surface touches itself");
    say(split_edges, "edge that joined the same vertices as another got a midpoint",
        "edges that joined the same vertices as others got midpoints");
    if (holes > 0)
        said.push_back(
            fmt::format("{} filled with {}.", holes == 1 ? "1 hole was" : fmt::format("{} holes were", holes),
                        hole_triangles == 1 ? "1 triangle" : fmt::format("{} triangles", hole_triangles)));
    if (turned_outward) said.emplace_back("The surface looked inward and was turned over.");
    return said;
}

}  // namespace interleaf
