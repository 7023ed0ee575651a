#include "hierarchy/vertex_normals.h"

#include <bit>
#include <cstdint>

#include <glm/geometric.hpp>

#include "hierarchy/morph.h"

namespace interleaf {

namespace {

float power_of_two(unsigned exponent) {
    return std::bit_cast<float>((exponent + 127U) << 23);
}

/// Adds w (e_i x f_j + e_j x f_i), half of it for i = j, at every corner of every triangle.
void add_corners(const UnionMesh& mesh, std::size_t i, std::size_t j, Buffer<glm::vec3>& product) {
    const Buffer<glm::vec3>& p = mesh.positions[i];
    const Buffer<glm::vec3>& q = mesh.positions[j];
    for (std::size_t t = 0; t < mesh.leaf_count(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const glm::vec3 normal =
            i == j ? glm::cross(p[b] - p[a], p[c] - p[a])
                   : glm::cross(p[b] - p[a], q[c] - q[a]) + glm::cross(q[b] - q[a], p[c] - p[a]);
        for (unsigned corner = 0; corner < 3; ++corner)
            product[mesh.triangles[t][corner]] += power_of_two(mesh.tags[t].corner_exponent(corner)) * normal;
    }
}

/// Rule 2: the mean of the ends where neither key has a vertex of its own. Ends come before midpoints, so one
/// pass does it.
void interpolate_elsewhere(const UnionMesh& mesh, KeySet keys, Buffer<glm::vec3>& product) {
    for (std::size_t v = mesh.roots.vertex_count(); v < mesh.vertex_count(); ++v) {
        const auto& [edge, owners] = mesh.vertices[v];
        if ((owners & keys) == 0) product[v] = (product[edge[0]] + product[edge[1]]) * 0.5F;
    }
}

}  // namespace

NormalForm normal_form(const UnionMesh& mesh) {
    NormalForm form;
    normal_form(mesh, form);
    return form;
}

void normal_form(const UnionMesh& mesh, NormalForm& form) {
    form.products.resize(product_count(mesh.key_count()));
    for (std::size_t j = 0; j < mesh.key_count(); ++j)
        for (std::size_t i = 0; i <= j; ++i) {
            Buffer<glm::vec3>& product = form.products[product_index(i, j)];
            product.assign(mesh.vertex_count(), glm::vec3(0));
            add_corners(mesh, i, j, product);
            interpolate_elsewhere(mesh, key_bit(i) | key_bit(j), product);
        }
}

std::vector<glm::vec3> morph_normals(const NormalForm& form, std::span<const float> weights) {
    std::vector<float> factors(form.products.size());
    for (std::size_t j = 0; j < weights.size(); ++j)
        for (std::size_t i = 0; i <= j; ++i) factors[product_index(i, j)] = weights[i] * weights[j];
    std::vector<glm::vec3> normals;
    weighted_sum(form.products, factors, normals);
    return normals;
}

}  // namespace interleaf
