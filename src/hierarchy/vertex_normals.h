// Vertex normals of a morph as a quadratic form in the weights.
//
// The normal of a triangle with edge vectors e(b) = sum b_i e_i and f(b) = sum b_j f_j is e(b) x f(b). So the
// weighted sum at a vertex is N(b) = sum over i <= j of b_i b_j N_ij. N_ij is the sum over the corners at the
// vertex of w (e_i x f_j + e_j x f_i), and half of that for i = j. The N_ij do not depend on the weights b:
// they are computed once per union, and a vertex shader that knows b has exact normals.
//
// Two rules make N independent of how finely the union is bisected.
//   1. The corner weights w follow the bisection. At a root's corner w is 1. At a bisection the split corner
//      keeps its weight in both parts, the weights at the ends of the refinement edge double, and the new
//      vertex starts with 2^level in each child, where level is the child's level. A flat triangle then gives
//      the same sums however it is bisected.
//   2. At a vertex where neither key i nor key j is bisected, N_ij is the mean of N_ij at the ends of its
//      edge, as for positions. So another key of weight 0 changes no normal.
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

/// Place of N_ij, i <= j: (0,0), (0,1), (1,1), (0,2), (1,2), (2,2), ... In this order a further key only
/// appends.
constexpr std::size_t product_index(std::size_t i, std::size_t j) {
    return j * (j + 1) / 2 + i;
}

/// The products N_ij for i <= j, not normalized; zero where the area vanishes. The products of one vertex are
/// adjacent, in the order of product_index(), because they are summed together and read together.
struct NormalForm {
    std::size_t product_count = 0;  ///< per vertex
    Buffer<glm::vec3> products;     ///< products[vertex * product_count + product_index(i, j)]
};

NormalForm normal_form(const UnionMesh& mesh);

/// As above, but reuses the memory of \p form.
void normal_form(const UnionMesh& mesh, NormalForm& form);

/// N(b), one vector per vertex, not normalized.
std::vector<glm::vec3> morph_normals(const NormalForm& form, std::span<const float> weights);

/// The vertex normals of a blended surface, for many keys, whose products would take too much memory. Rule 1
/// holds, and rule 2 for the keys of weight 0: a vertex that only they own takes the mean of its edge's ends.
/// \param weights    one per key of \p mesh
/// \param positions  the morph of \p mesh with these weights
/// \param normals    receives one vector per vertex, not normalized
void surface_normals(const UnionMesh& mesh, std::span<const float> weights,
                     std::span<const glm::vec3> positions, Buffer<glm::vec3>& normals);

}  // namespace interleaf
