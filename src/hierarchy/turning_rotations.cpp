#include "hierarchy/turning_rotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <span>
#include <utility>

#include <Eigen/Geometry>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "hierarchy/measure.h"
#include "hierarchy/rotation_fit.h"

namespace interleaf {
namespace {

/// Length of the diffusion, in parts of the square root of the area.
constexpr double diffusion_length = 0.03;

/// The part by which the roots count beside the area of the keys, so that keys of no area do no harm, and by which
/// no rotation is preferred, so that it wins where the leaves say nothing.
constexpr double small_part = 1e-6;

Eigen::Vector3d edge_vector(std::span<const glm::vec3> positions, Index from, Index to) {
    const glm::dvec3 e = glm::dvec3(positions[to]) - glm::dvec3(positions[from]);
    return {e.x, e.y, e.z};
}

}  // namespace

SurfaceMatrix leaf_stiffness(const UnionMesh& mesh) {
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(8 * mesh.leaf_count());
    const auto add = [&](Index a, Index b) {
        const int row = static_cast<int>(a);
        const int column = static_cast<int>(b);
        entries.emplace_back(row, row, 0.5);
        entries.emplace_back(column, column, 0.5);
        entries.emplace_back(row, column, -0.5);
        entries.emplace_back(column, row, -0.5);
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        add(a, b);
        add(a, c);
    }
    const auto count = static_cast<Eigen::Index>(mesh.vertex_count());
    SurfaceMatrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

std::vector<StiffEdge> stiff_edges(const SurfaceMatrix& stiffness) {
    std::vector<StiffEdge> edges;
    edges.reserve(static_cast<std::size_t>(stiffness.nonZeros()) / 2);
    for (Eigen::Index column = 0; column < stiffness.cols(); ++column)
        for (SurfaceMatrix::InnerIterator entry(stiffness, column); entry; ++entry)
            if (entry.row() > column)
                edges.push_back(
                    {static_cast<Index>(column), static_cast<Index>(entry.row()), -entry.value()});
    return edges;
}

std::vector<double> vertex_shares(const UnionMesh& mesh) {
    std::vector<double> shares(mesh.vertex_count(), 0);
    for (std::size_t t = 0; t < mesh.leaf_count(); ++t)
        for (const Index vertex : mesh.triangles[t])
            shares[vertex] +=
                std::ldexp(1.0 / 3, -static_cast<int>(mesh.tags[t].level())) / mesh.roots.triangle_count();
    return shares;
}

TurningRotations::TurningRotations(const UnionMesh& mesh, const SurfaceMatrix& stiffness,
                                   const std::vector<double>& shares)
    : mesh_(mesh), stiffness_(stiffness), shares_(shares) {
    for (const Buffer<glm::vec3>& positions : mesh.positions)
        key_areas_.push_back(measure(mesh.triangles, positions).area);
    diffusion_.analyzePattern(stiffness);
}

/// The area that each vertex stands for in the mean of both keys, each of area 1.
std::vector<double> TurningRotations::vertex_areas(std::size_t from, std::size_t to) const {
    std::vector<double> areas(mesh_.vertex_count());
    for (std::size_t v = 0; v < areas.size(); ++v) areas[v] = small_part * shares_[v];
    for (const std::size_t key : {from, to}) {
        if (!(key_areas_[key] > 0)) continue;
        const Buffer<glm::vec3>& positions = mesh_.positions[key];
        for (const auto& [a, b, c] : mesh_.triangles) {
            const double area = edge_vector(positions, a, b).cross(edge_vector(positions, a, c)).norm() / 2;
            for (const Index vertex : {a, b, c}) areas[vertex] += area / key_areas_[key] / 6;
        }
    }
    return areas;
}

/// For each vertex, the sum of (from)(to)^T over the legs and the normals of its leaves, column by column.
Eigen::Matrix<double, Eigen::Dynamic, 9> TurningRotations::agreements(std::size_t from,
                                                                      std::size_t to) const {
    Eigen::Matrix<double, Eigen::Dynamic, 9> sums(mesh_.vertex_count(), 9);
    sums.setZero();
    const double scale = std::sqrt(key_areas_[from] * key_areas_[to]);
    if (!(scale > 0)) return sums;
    for (const Triangle& leaf : mesh_.triangles) {
        std::array<Eigen::Vector3d, 2> leg_from;
        std::array<Eigen::Vector3d, 2> leg_to;
        for (std::size_t n = 0; n < 2; ++n) {
            leg_from[n] = edge_vector(mesh_.positions[from], leaf[0], leaf[n + 1]);
            leg_to[n] = edge_vector(mesh_.positions[to], leaf[0], leaf[n + 1]);
        }
        Eigen::Matrix3d sum = leg_from[0] * leg_to[0].transpose() + leg_from[1] * leg_to[1].transpose();
        const Eigen::Vector3d normal_from = leg_from[0].cross(leg_from[1]);
        const Eigen::Vector3d normal_to = leg_to[0].cross(leg_to[1]);
        const double length = std::sqrt(normal_from.norm() * normal_to.norm());
        if (length > 0) sum += normal_from / length * normal_to.transpose();
        sum /= 6 * scale;
        for (const Index vertex : leaf)
            sums.row(vertex) += Eigen::Map<const Eigen::Matrix<double, 1, 9>>(sum.data());
    }
    return sums;
}

std::vector<glm::quat> TurningRotations::between(std::size_t from, std::size_t to) {
    const std::vector<double> areas = vertex_areas(from, to);
    Eigen::Matrix<double, Eigen::Dynamic, 9> sums = agreements(from, to);
    SurfaceMatrix matrix = diffusion_length * diffusion_length * stiffness_;
    for (std::size_t v = 0; v < areas.size(); ++v) {
        const auto row = static_cast<Eigen::Index>(v);
        matrix.coeffRef(row, row) += areas[v];
        for (const int diagonal : {0, 4, 8}) sums(row, diagonal) += small_part * areas[v];
    }
    diffusion_.factorize(matrix);
    sums = diffusion_.solve(sums).eval();

    std::vector<glm::dquat> rotations;
    rotations.reserve(areas.size());
    for (std::size_t v = 0; v < areas.size(); ++v) {
        const Eigen::Matrix<double, 9, 1> sum = sums.row(static_cast<Eigen::Index>(v));
        rotations.push_back(fit_rotation(glm::make_mat3(sum.data())).quaternion);
    }
    choose_signs(rotations, areas);
    return {rotations.begin(), rotations.end()};
}

/// A rotation by an angle, and the one by 360 degrees less, are the quaternions q and -q. Goes over the surface from
/// a vertex to the neighbor that is most like it, so that the two differ only across the sharpest turns.
void TurningRotations::choose_signs(std::vector<glm::dquat>& rotations,
                                    const std::vector<double>& areas) const {
    struct Step {
        double likeness;
        Index from;
        Index to;
        bool operator<(const Step& other) const { return likeness < other.likeness; }
    };
    std::vector<bool> is_known(rotations.size(), false);
    std::priority_queue<Step> steps;
    std::vector<Index> component;
    const auto reach = [&](Index vertex) {
        is_known[vertex] = true;
        component.push_back(vertex);
        for (SurfaceMatrix::InnerIterator entry(stiffness_, static_cast<Eigen::Index>(vertex)); entry;
             ++entry) {
            const auto neighbor = static_cast<Index>(entry.row());
            if (!is_known[neighbor])
                steps.push({std::abs(glm::dot(rotations[vertex], rotations[neighbor])), vertex, neighbor});
        }
    };
    for (Index start = 0; start < mesh_.roots.vertex_count(); ++start) {
        if (is_known[start]) continue;
        component.clear();
        reach(start);
        while (!steps.empty()) {
            const Step step = steps.top();
            steps.pop();
            if (is_known[step.to]) continue;
            if (glm::dot(rotations[step.from], rotations[step.to]) < 0) rotations[step.to] *= -1.0;
            reach(step.to);
        }
        double sum = 0;
        for (const Index vertex : component) sum += areas[vertex] * rotations[vertex].w;
        if (sum < 0)
            for (const Index vertex : component) rotations[vertex] *= -1.0;
    }
}

}  // namespace interleaf
