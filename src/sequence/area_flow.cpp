#include "sequence/area_flow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"

namespace interleaf {
namespace {

using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// What a triangle adds to the Laplacian and to the areas of its corners.
struct CornerTerms {
    std::array<double, 3> cotangents;  ///< of the angles; half of one weighs the edge opposite its corner
    std::array<double, 3> voronoi;     ///< the corners' Voronoi areas; negative beyond an obtuse angle
    std::array<double, 3> mixed;       ///< as voronoi, but halves and quarters of an obtuse triangle
};

CornerTerms corner_terms(const Triangle& triangle, std::span<const glm::dvec3> positions) {
    CornerTerms terms{};
    std::array<double, 3> cosines{};  // times the lengths of both sides
    std::array<double, 3> opposite{};
    const glm::dvec3 origin = positions[triangle[0]];
    const double twice_area =
        glm::length(glm::cross(positions[triangle[1]] - origin, positions[triangle[2]] - origin));
    if (!(twice_area > 0)) return terms;
    for (unsigned k = 0; k < 3; ++k) {
        const glm::dvec3 side = positions[triangle[(k + 1) % 3]] - positions[triangle[k]];
        const glm::dvec3 other = positions[triangle[(k + 2) % 3]] - positions[triangle[k]];
        cosines[k] = glm::dot(side, other);
        opposite[k] = glm::dot(other - side, other - side);
        terms.cotangents[k] = cosines[k] / twice_area;
    }
    const bool is_obtuse = *std::min_element(cosines.begin(), cosines.end()) < 0;
    for (unsigned k = 0; k < 3; ++k) {
        const unsigned next = (k + 1) % 3;
        const unsigned last = (k + 2) % 3;
        terms.voronoi[k] =
            (opposite[next] * terms.cotangents[next] + opposite[last] * terms.cotangents[last]) / 8;
        terms.mixed[k] = is_obtuse ? twice_area / (cosines[k] < 0 ? 4 : 8) : terms.voronoi[k];
    }
    return terms;
}

/// The area that each vertex stands for.
std::vector<double> vertex_areas(std::span<const Triangle> triangles, std::span<const CornerTerms> terms,
                                 std::size_t vertex_count) {
    std::vector<double> voronoi(vertex_count);
    std::vector<double> mixed(vertex_count);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (unsigned k = 0; k < 3; ++k) {
            voronoi[triangles[t][k]] += terms[t].voronoi[k];
            mixed[triangles[t][k]] += terms[t].mixed[k];
        }
    }
    std::vector<double> areas(vertex_count);
    std::transform(voronoi.begin(), voronoi.end(), mixed.begin(), areas.begin(),
                   [](double area, double positive_area) { return std::max(area, positive_area / 2); });
    return areas;
}

std::vector<CornerTerms> all_corner_terms(std::span<const Triangle> triangles,
                                          std::span<const glm::dvec3> positions) {
    std::vector<CornerTerms> terms;
    terms.reserve(triangles.size());
    for (const Triangle& triangle : triangles) terms.push_back(corner_terms(triangle, positions));
    return terms;
}

/// The unknowns of a step: the vertices that triangles use and that are not pinned.
struct Unknowns {
    std::vector<int> number;      ///< by vertex; -1 for the other vertices
    std::vector<Index> vertices;  ///< by number
};

Unknowns unknowns_of(std::span<const Triangle> triangles, const Pinned& is_pinned) {
    Unknowns unknowns{std::vector<int>(is_pinned.size(), -1), {}};
    for (const Triangle& triangle : triangles) {
        for (const Index vertex : triangle) {
            if (is_pinned[vertex] || unknowns.number[vertex] >= 0) continue;
            unknowns.number[vertex] = static_cast<int>(unknowns.vertices.size());
            unknowns.vertices.push_back(vertex);
        }
    }
    return unknowns;
}

}  // namespace

void step_to_smaller_area(std::span<const Triangle> triangles, const Pinned& is_pinned, double length,
                          std::span<glm::dvec3> positions) {
    const Unknowns unknowns = unknowns_of(triangles, is_pinned);
    const auto count = static_cast<Eigen::Index>(unknowns.vertices.size());
    if (count == 0) return;

    // (areas + length * Laplacian) x = areas * positions now
    const std::vector<CornerTerms> terms = all_corner_terms(triangles, positions);
    const std::vector<double> areas = vertex_areas(triangles, terms, positions.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * triangles.size());
    Coordinates right = Coordinates::Zero(count, 3);
    const auto add_to_right = [&](int row, double factor, const glm::dvec3& position) {
        for (int axis = 0; axis < 3; ++axis) right(row, axis) += factor * position[axis];
    };
    for (int row = 0; row < count; ++row) {
        const Index vertex = unknowns.vertices[static_cast<std::size_t>(row)];
        entries.emplace_back(row, row, areas[vertex]);
        add_to_right(row, areas[vertex], positions[vertex]);
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& triangle = triangles[t];
        for (unsigned k = 0; k < 3; ++k) {
            const int row = unknowns.number[triangle[k]];
            if (row < 0) continue;
            for (const unsigned step : {1U, 2U}) {
                const Index neighbor = triangle[(k + step) % 3];
                const double weight = length * terms[t].cotangents[(k + 3 - step) % 3] / 2;
                entries.emplace_back(row, row, weight);
                if (const int column = unknowns.number[neighbor]; column >= 0)
                    entries.emplace_back(row, column, -weight);
                else
                    add_to_right(row, weight, positions[neighbor]);
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    const Coordinates moved = factors.solve(right);
    if (factors.info() != Eigen::Success || !moved.allFinite())
        throw InputError("the triangles of the surface degenerate, so it cannot flow on");
    for (Eigen::Index row = 0; row < count; ++row)
        positions[unknowns.vertices[static_cast<std::size_t>(row)]] = {moved(row, 0), moved(row, 1),
                                                                       moved(row, 2)};
}

std::vector<glm::dvec3> area_weighted_normals(std::span<const Triangle> triangles,
                                              std::span<const glm::dvec3> positions) {
    std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0));
    for (const auto& [a, b, c] : triangles) {
        const glm::dvec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        for (const Index corner : {a, b, c}) normals[corner] += normal;
    }
    for (glm::dvec3& normal : normals) {
        const double length = glm::length(normal);
        if (length > 0) normal /= length;
    }
    return normals;
}

std::vector<float> mean_curvatures(std::span<const Triangle> triangles, const Pinned& is_pinned,
                                   std::span<const glm::dvec3> positions) {
    const std::vector<glm::dvec3> normals = area_weighted_normals(triangles, positions);
    std::vector<glm::dvec3> gradients(positions.size(), glm::dvec3(0));  // of the area
    const std::vector<CornerTerms> terms = all_corner_terms(triangles, positions);
    const std::vector<double> areas = vertex_areas(triangles, terms, positions.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& triangle = triangles[t];
        for (unsigned k = 0; k < 3; ++k) {
            for (const unsigned step : {1U, 2U}) {
                const double weight = terms[t].cotangents[(k + 3 - step) % 3] / 2;
                gradients[triangle[k]] +=
                    weight * (positions[triangle[k]] - positions[triangle[(k + step) % 3]]);
            }
        }
    }
    std::vector<double> curvatures(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v)
        if (areas[v] > 0) curvatures[v] = glm::dot(gradients[v], normals[v]) / (2 * areas[v]);

    std::vector<double> sums(positions.size());
    std::vector<unsigned> counts(positions.size());
    for (const Triangle& triangle : triangles) {
        for (const Index vertex : triangle) {
            for (const Index neighbor : triangle) {
                if (!is_pinned[vertex] || is_pinned[neighbor]) continue;
                sums[vertex] += curvatures[neighbor];
                ++counts[vertex];
            }
        }
    }
    std::vector<float> result(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const double of_neighbors = counts[v] > 0 ? sums[v] / counts[v] : 0;
        result[v] = static_cast<float>(is_pinned[v] ? of_neighbors : curvatures[v]);
    }
    return result;
}

}  // namespace interleaf
