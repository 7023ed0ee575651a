// Vertex normals of a morph as a quadratic form in the weights.
//
// The normal of a triangle with edge vectors e(b) = sum b_i e_i and f(b) = sum b_j f_j is e(b) x f(b), so the
// weighted sum at a vertex is N(b) = sum over i <= j of b_i b_j N_ij, with N_ij the sum over the corners at
// the vertex of w (e_i x f_j + e_j x f_i), half of it for i = j. The N_ij do not depend on the weights: they
// are made once for a union, and a vertex shader that knows b has exact normals.
//
// Two rules make N independent of how finely the union is bisected. (1) The corner weights w follow the
// bisection: 1 at a root's corner; at bisection the split corner keeps its weight in both parts, the ends of
// the refinement edge double theirs, and the new vertex starts with 2^level in each child, level being the
// child's. A flat triangle then gives the same sums however it is bisected. (2) At a vertex where neither key
// i nor key j is bisected, N_ij is the mean of N_ij at the ends of its edge, as positions are. So one more
// key of weight 0 changes no normal.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/union_mesh.h"

namespace interleaf {

/// Number of products for \p key_count keys: n (n + 1) / 2.
constexpr std::size_t product_count(std::size_t key_count) {
    return key_count * (key_count + 1) / 2;
}

/// Place of N_ij, i <= j: (0,0), (0,1), (1,1), (0,2), (1,2), (2,2), ... so that a further key only appends.
constexpr std::size_t product_index(std::size_t i, std::size_t j) {
    return j * (j + 1) / 2 + i;
}

/// The products N_ij for i <= j, not normalised; zero where the area vanishes. Those of one vertex follow
/// each other, in the order of product_index(): they are summed up together, and read together.
struct NormalForm {
    std::size_t product_count = 0;  ///< a vertex
    Buffer<glm::vec3> products;     ///< products[vertex * product_count + product_index(i, j)]
};

NormalForm normal_form(const UnionMesh& mesh);

/// The same into the buffers of \p form, whose memory is used again.
void normal_form(const UnionMesh& mesh, NormalForm& form);

/// N(b), one vector a vertex, not normalised.
std::vector<glm::vec3> morph_normals(const NormalForm& form, std::span<const float> weights);

}  // namespace interleaf
