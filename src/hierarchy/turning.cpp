#include "hierarchy/turning.h"

#include <cassert>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include "hierarchy/morph.h"
#include "hierarchy/turning_rotations.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {
namespace {

using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// The component of the roots to which each vertex belongs.
std::vector<Index> components_of(const UnionMesh& mesh) {
    std::vector<Index> of_triangle(mesh.roots.triangle_count(), no_index);
    std::vector<Index> components(mesh.vertex_count());
    std::vector<Index> reached;
    Index count = 0;
    for (Index start = 0; start < mesh.roots.triangle_count(); ++start) {
        if (of_triangle[start] != no_index) continue;
        of_triangle[start] = count;
        reached.assign(1, start);
        while (!reached.empty()) {
            const Index triangle = reached.back();
            reached.pop_back();
            for (const Index vertex : mesh.roots.triangles()[triangle]) components[vertex] = count;
            for (const Index neighbor : mesh.roots.neighbors()[triangle])
                if (neighbor != no_index && of_triangle[neighbor] == no_index) {
                    of_triangle[neighbor] = count;
                    reached.push_back(neighbor);
                }
        }
        ++count;
    }
    for (std::size_t v = mesh.roots.vertex_count(); v < mesh.vertex_count(); ++v)
        components[v] = components[mesh.vertices[v].edge[0]];
    return components;
}

/// The place of the pair (i, j), i < j: (0,1), (0,2), (1,2), (0,3), ...
constexpr std::size_t pair_index(std::size_t i, std::size_t j) {
    return j * (j - 1) / 2 + i;
}

}  // namespace

struct Turning::Parts {
    std::size_t first = 0;  ///< key that blends; pairs and weights count from it
    std::size_t pair_count = 0;
    /// rotations[vertex * pair_count + pair_index(i, j)] goes from key i to key j.
    std::vector<glm::quat> rotations;
    std::vector<StiffEdge> edges;
    std::vector<Index> components;  ///< of each vertex
    std::vector<double> shares;     ///< of each vertex
    SurfaceFactors factors;

    void turns(Index vertex, std::span<const float> weights, std::span<glm::dmat3> result) const;
};

Turning::Turning(const UnionMesh& mesh, std::size_t first) {
    assert(first < mesh.key_count());
    const std::size_t key_count = mesh.key_count() - first;
    assert(key_count <= max_keys);
    const auto parts = std::make_shared<Parts>();
    SurfaceMatrix stiffness = leaf_stiffness(mesh);
    parts->edges = stiff_edges(stiffness);
    parts->components = components_of(mesh);
    parts->shares = vertex_shares(mesh);
    parts->first = first;
    parts->pair_count = key_count * (key_count - 1) / 2;
    parts->rotations.resize(mesh.vertex_count() * parts->pair_count);
    TurningRotations rotations(mesh, stiffness, parts->shares);
    for (std::size_t j = 1; j < key_count; ++j)
        for (std::size_t i = 0; i < j; ++i) {
            const std::vector<glm::quat> between = rotations.between(first + i, first + j);
            for (std::size_t v = 0; v < between.size(); ++v)
                parts->rotations[v * parts->pair_count + pair_index(i, j)] = between[v];
        }

    // Edges leave the place of each component open; blend() settles it.
    std::vector<bool> is_held(mesh.roots.vertex_count(), false);  // of each component
    for (Index v = 0; v < mesh.roots.vertex_count(); ++v)
        if (!is_held[parts->components[v]]) {
            is_held[parts->components[v]] = true;
            stiffness.coeffRef(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(v)) += 1;
        }
    parts->factors.compute(stiffness);
    parts_ = parts;
}

/// The rotation from each key to the weighted mean of the keys, times the weight of the key.
void Turning::Parts::turns(Index vertex, std::span<const float> weights, std::span<glm::dmat3> result) const {
    const glm::quat* const between = rotations.data() + vertex * pair_count;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        if (weights[k] == 0) {
            result[k] = glm::dmat3(0);
            continue;
        }
        glm::dquat sum(weights[k], 0, 0, 0);
        for (std::size_t j = 0; j < k; ++j)
            sum += static_cast<double>(weights[j]) * glm::dquat(glm::conjugate(between[pair_index(j, k)]));
        for (std::size_t j = k + 1; j < weights.size(); ++j)
            sum += static_cast<double>(weights[j]) * glm::dquat(between[pair_index(k, j)]);
        result[k] = static_cast<double>(weights[k]) * glm::mat3_cast(glm::normalize(sum));
    }
}

void Turning::blend(const UnionMesh& mesh, std::span<const float> weights,
                    Buffer<glm::vec3>& positions) const {
    const Parts& parts = *parts_;
    const std::span<const float> blended = weights.subspan(parts.first);
    const std::size_t count = blended.size();
    std::vector<glm::dmat3> turns(mesh.vertex_count() * count);  // turns[vertex * count + k]
    for (Index v = 0; v < mesh.vertex_count(); ++v)
        parts.turns(v, blended, std::span(turns).subspan(v * count, count));

    Coordinates right = Coordinates::Zero(static_cast<Eigen::Index>(mesh.vertex_count()), 3);
    for (const StiffEdge& edge : parts.edges) {
        glm::dvec3 wanted(0);
        for (std::size_t k = 0; k < count; ++k) {
            if (blended[k] == 0) continue;
            const Buffer<glm::vec3>& key = mesh.positions[parts.first + k];
            wanted += (turns[edge.from * count + k] + turns[edge.to * count + k]) *
                      (glm::dvec3(key[edge.to]) - glm::dvec3(key[edge.from]));
        }
        wanted *= edge.stiffness / 2;
        for (int axis = 0; axis < 3; ++axis) {
            right(edge.from, axis) -= wanted[axis];
            right(edge.to, axis) += wanted[axis];
        }
    }
    const Coordinates solved = parts.factors.solve(right);

    weighted_sum(mesh.positions, weights, positions);
    std::vector<glm::dvec4> shifts;  // per component: sum of shares times shift, and of shares
    const auto place = [&](std::size_t v) {
        const auto row = static_cast<Eigen::Index>(v);
        return glm::dvec3(solved(row, 0), solved(row, 1), solved(row, 2));
    };
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (shifts.size() <= parts.components[v]) shifts.resize(parts.components[v] + 1, glm::dvec4(0));
        shifts[parts.components[v]] += parts.shares[v] * glm::dvec4(glm::dvec3(positions[v]) - place(v), 1);
    }
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const glm::dvec4& shift = shifts[parts.components[v]];
        positions[v] = glm::vec3(place(v) + glm::dvec3(shift) / shift.w);
    }
}

std::size_t Turning::byte_count() const {
    const Parts& parts = *parts_;
    const auto entries = static_cast<std::size_t>(parts.factors.matrixL().nestedExpression().nonZeros());
    return parts.rotations.size() * sizeof(glm::quat) + parts.edges.size() * sizeof(StiffEdge) +
           parts.components.size() * (sizeof(Index) + sizeof(double)) +
           entries * (sizeof(double) + sizeof(int));
}

}  // namespace interleaf
