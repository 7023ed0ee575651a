#include "io/gltf/target_normals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "hierarchy/vertex_normals.h"

namespace interleaf {

namespace {

constexpr double tilt = 0.002;
constexpr double flat_cosine = 0.999999;
constexpr double least_area = std::numeric_limits<float>::min();

/// \p v with length 1, or \p otherwise if \p v has none.
glm::dvec3 direction(const glm::vec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(glm::dvec3(v));
    return length > least_area ? glm::dvec3(v) / length : otherwise;
}

/// A unit vector perpendicular to the unit vector \p n.
glm::dvec3 perpendicular(const glm::dvec3& n) {
    glm::dvec3 axis(0);
    glm::length_t least = 0;
    for (glm::length_t c = 1; c < 3; ++c)
        if (std::abs(n[c]) < std::abs(n[least])) least = c;
    axis[least] = 1;
    return glm::normalize(glm::cross(n, axis));
}

/// The normals of the blend of all \p keys in equal parts. Their length is the area around the vertex.
Buffer<glm::vec3> area_normals(const UnionMesh& mesh, std::span<const std::size_t> keys) {
    std::vector<float> weights(mesh.key_count(), 0);
    for (const std::size_t key : keys) weights[key] = 1 / static_cast<float>(keys.size());
    Buffer<glm::vec3> positions;
    positions.resize(mesh.vertex_count());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        positions[v] = glm::vec3(0);
        for (const std::size_t key : keys) positions[v] += weights[key] * mesh.positions[key][v];
    }
    Buffer<glm::vec3> normals;
    surface_normals(mesh, weights, positions, normals);
    return normals;
}

/// The vertices of triangles whose corners all have the triangle's normal.
std::vector<bool> flat_vertices(const UnionMesh& mesh, std::size_t base,
                                std::span<const glm::dvec3> normals) {
    const Buffer<glm::vec3>& positions = mesh.positions[base];
    std::vector<bool> is_flat(normals.size(), false);
    for (const Triangle& triangle : mesh.triangles) {
        const glm::dvec3 a(positions[triangle[0]]);
        const glm::dvec3 face =
            glm::cross(glm::dvec3(positions[triangle[1]]) - a, glm::dvec3(positions[triangle[2]]) - a);
        const double least = flat_cosine * glm::length(face);
        if (!std::ranges::all_of(triangle, [&](Index v) { return glm::dot(normals[v], face) > least; }))
            continue;
        for (const Index vertex : triangle) is_flat[vertex] = true;
    }
    return is_flat;
}

/// The unit normals of the base, tilted where triangles are flat.
std::vector<glm::vec3> base_normals(const UnionMesh& mesh, std::size_t base,
                                    std::span<const glm::vec3> areas) {
    std::vector<glm::dvec3> normals;
    normals.reserve(areas.size());
    for (const glm::vec3& area : areas) normals.push_back(direction(area, glm::dvec3(0, 0, 1)));
    const std::vector<bool> is_flat = flat_vertices(mesh, base, normals);
    std::vector<glm::vec3> shown;
    shown.reserve(normals.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const glm::dvec3& n = normals[v];
        shown.emplace_back(is_flat[v] ? glm::normalize(n + tilt * perpendicular(n)) : n);
    }
    return shown;
}

/// The ratio of lengths that two normals of a vertex should have.
struct Ratio {
    double value = 1;       ///< length of the second normal by that of the first
    double confidence = 0;  ///< square of the sine of the angle between them; 0 if no ratio comes near
};

/// The ratio with which the sum of \p first and \p second, unit vectors, has the direction \p blend: the
/// least squares solution of a first + b second = blend.
Ratio ratio_of(const glm::dvec3& first, const glm::dvec3& second, const glm::dvec3& blend) {
    constexpr double max_ratio = 16;
    constexpr double least_confidence = 1e-6;
    const double cosine = glm::dot(first, second);
    const double confidence = 1 - cosine * cosine;
    const double a = glm::dot(blend, first) - cosine * glm::dot(blend, second);
    const double b = glm::dot(blend, second) - cosine * glm::dot(blend, first);
    if (!(confidence > least_confidence) || (a <= 0 && b <= 0)) return {};
    return {std::max(b, a / max_ratio) / std::max(a, b / max_ratio), confidence};
}

/// Where to begin, and where no pair tells more: the power 3/4 of the area came nearest.
double first_length(const glm::vec3& area, const glm::vec3& base_area) {
    constexpr double max_length = 256;
    const double root =
        std::sqrt(double{glm::length(area)} / std::max(double{glm::length(base_area)}, least_area));
    return std::clamp(root * std::sqrt(root), 1 / max_length, max_length);
}

/// Improves the lengths at one vertex: each becomes the mean of what the ratios to the other lengths ask for.
/// \param lengths  per key; that of the base stays
/// \param ratios   one per pair
void improve(std::vector<double>& lengths, std::size_t base, std::span<const KeyPair> pairs,
             std::span<const Ratio> ratios) {
    constexpr int sweeps = 4;
    constexpr double trust_in_start = 0.01;
    const std::vector<double> start = lengths;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t key = 0; key < lengths.size(); ++key) {
            if (key == base) continue;
            double sum = trust_in_start * start[key];
            double total = trust_in_start;
            for (std::size_t p = 0; p < pairs.size(); ++p) {
                const auto& [first, second] = pairs[p];
                if (key != first && key != second) continue;
                const auto& [ratio, confidence] = ratios[p];
                sum += confidence * (key == second ? lengths[first] * ratio : lengths[second] / ratio);
                total += confidence;
            }
            lengths[key] = sum / total;
        }
}

}  // namespace

TargetNormals target_normals(const UnionMesh& mesh, std::size_t base, std::span<const KeyPair> pairs,
                             const Progress& progress) {
    constexpr std::size_t vertices_per_report = 4096;
    const std::size_t key_count = mesh.key_count();
    const std::size_t steps = key_count + pairs.size() + mesh.vertex_count() / vertices_per_report + 1;
    std::size_t step = 0;
    const auto report = [&] {
        const double part = static_cast<double>(step++) / static_cast<double>(steps);
        if (progress && !progress("normals", part)) throw Cancelled();
    };
    std::vector<Buffer<glm::vec3>> areas;
    areas.reserve(key_count);
    for (std::size_t key = 0; key < key_count; ++key) {
        report();
        areas.push_back(area_normals(mesh, std::span(&key, 1)));
    }
    std::vector<Buffer<glm::vec3>> blends;
    blends.reserve(pairs.size());
    for (const KeyPair& pair : pairs) {
        report();
        blends.push_back(area_normals(mesh, pair));
    }

    TargetNormals normals{base_normals(mesh, base, areas[base]), {}};
    normals.deltas.resize(key_count);
    for (std::size_t key = 0; key < key_count; ++key)
        if (key != base) normals.deltas[key].resize(mesh.vertex_count());
    std::vector<glm::dvec3> units(key_count);
    std::vector<double> lengths(key_count);
    std::vector<Ratio> ratios(pairs.size());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (v % vertices_per_report == 0) report();
        const glm::dvec3 shown(normals.base[v]);
        for (std::size_t key = 0; key < key_count; ++key) {
            units[key] = direction(areas[key][v], shown);
            lengths[key] = key == base ? 1 : first_length(areas[key][v], areas[base][v]);
        }
        for (std::size_t p = 0; p < pairs.size(); ++p)
            ratios[p] =
                ratio_of(units[pairs[p][0]], units[pairs[p][1]], direction(blends[p][v], glm::dvec3(0)));
        improve(lengths, base, pairs, ratios);
        for (std::size_t key = 0; key < key_count; ++key)
            if (key != base) normals.deltas[key][v] = glm::vec3(lengths[key] * units[key] - shown);
    }
    return normals;
}

}  // namespace interleaf
