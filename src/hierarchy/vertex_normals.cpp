#include "hierarchy/vertex_normals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include <glm/geometric.hpp>

#include "hierarchy/lanes.h"

namespace interleaf {

namespace {

float power_of_two(unsigned exponent) {
    return std::bit_cast<float>((exponent + 127U) << 23);
}

/// The normals e_i x f_j + e_j x f_i of a leaf, or e_i x f_i for i = j, 3 floats each. Also overwrites one
/// float behind the last.
/// \param edges  scratch memory for e and f of every key
template <typename Count>
void leaf_products(const UnionMesh& mesh, const Triangle& leaf, Count key_count, std::array<Lanes, 2>* edges,
                   float* products) {
    const auto& [a, b, c] = leaf;
    for (std::size_t j = 0; j < key_count; ++j) {
        const glm::vec3* p = mesh.positions[j].data();
        const Lanes at_a = load(p[a]);
        edges[j] = {load(p[b]) - at_a, load(p[c]) - at_a};
        for (std::size_t i = 0; i < j; ++i, products += 3)
            store(products,
                  yzx(turned_cross(edges[i][0], edges[j][1]) + turned_cross(edges[j][0], edges[i][1])));
        store(products, yzx(turned_cross(edges[j][0], edges[j][1])));
        products += 3;
    }
}

/// Adds the weighted products of every leaf to its corners.
template <typename Count>
void add_leaves(const UnionMesh& mesh, Count key_count, NormalForm& form) {
    // The writes and the reads of a product have different widths. With batches, the writes have finished
    // before the reads begin.
    constexpr std::size_t batch = 32;
    const std::size_t float_count = 3 * product_count(key_count);
    std::vector<float> products(batch * float_count + 1);
    std::vector<std::array<Lanes, 2>> edges(key_count);
    float* const sums = &form.products[0].x;
    for (std::size_t begin = 0; begin < mesh.leaf_count(); begin += batch) {
        const std::size_t end = std::min(begin + batch, mesh.leaf_count());
        for (std::size_t t = begin; t < end; ++t)
            leaf_products(mesh, mesh.triangles[t], key_count, edges.data(),
                          &products[(t - begin) * float_count]);
        for (std::size_t t = begin; t < end; ++t) {
            const float* const normal = &products[(t - begin) * float_count];
            for (unsigned corner = 0; corner < 3; ++corner) {
                const float weight = power_of_two(mesh.tags[t].corner_exponent(corner));
                float* const __restrict sum = sums + mesh.triangles[t][corner] * float_count;
                for (std::size_t n = 0; n < float_count; ++n) sum[n] += weight * normal[n];
            }
        }
    }
}

/// Rule 2: takes the mean of the edge's ends at vertices that neither key owns. Ends come before midpoints,
/// so one pass suffices.
void interpolate_elsewhere(const UnionMesh& mesh, NormalForm& form) {
    const std::size_t count = form.product_count;
    KeySet all = 0;
    for (std::size_t key = 0; key < mesh.key_count(); ++key) all |= key_bit(key);
    for (std::size_t v = mesh.roots.vertex_count(); v < mesh.vertex_count(); ++v) {
        const auto& [edge, owners] = mesh.vertices[v];
        if (owners == all) continue;
        glm::vec3* const products = &form.products[v * count];
        const glm::vec3* const from = &form.products[edge[0] * count];
        const glm::vec3* const to = &form.products[edge[1] * count];
        for (std::size_t j = 0; j < mesh.key_count(); ++j) {
            if ((owners & key_bit(j)) != 0) continue;
            for (std::size_t i = 0; i <= j; ++i) {
                const std::size_t n = product_index(i, j);
                if ((owners & key_bit(i)) == 0) products[n] = (from[n] + to[n]) * 0.5F;
            }
        }
    }
}

}  // namespace

NormalForm normal_form(const UnionMesh& mesh) {
    NormalForm form;
    normal_form(mesh, form);
    return form;
}

void normal_form(const UnionMesh& mesh, NormalForm& form) {
    form.product_count = product_count(mesh.key_count());
    form.products.assign(mesh.vertex_count() * form.product_count, glm::vec3(0));
    // The loops over keys are unrolled for the usual numbers of active keys.
    switch (mesh.key_count()) {
        case 1:
            add_leaves(mesh, std::integral_constant<std::size_t, 1>(), form);
            break;
        case 2:
            add_leaves(mesh, std::integral_constant<std::size_t, 2>(), form);
            break;
        case 3:
            add_leaves(mesh, std::integral_constant<std::size_t, 3>(), form);
            break;
        case 4:
            add_leaves(mesh, std::integral_constant<std::size_t, 4>(), form);
            break;
        default:
            add_leaves(mesh, mesh.key_count(), form);
    }
    interpolate_elsewhere(mesh, form);
}

std::vector<glm::vec3> morph_normals(const NormalForm& form, std::span<const float> weights) {
    std::vector<float> factors(form.product_count);
    for (std::size_t j = 0; j < weights.size(); ++j)
        for (std::size_t i = 0; i <= j; ++i) factors[product_index(i, j)] = weights[i] * weights[j];
    std::vector<glm::vec3> normals(form.products.size() / form.product_count, glm::vec3(0));
    for (std::size_t v = 0; v < normals.size(); ++v)
        for (std::size_t n = 0; n < form.product_count; ++n)
            normals[v] += factors[n] * form.products[v * form.product_count + n];
    return normals;
}

void surface_normals(const UnionMesh& mesh, std::span<const float> weights,
                     std::span<const glm::vec3> positions, Buffer<glm::vec3>& normals) {
    normals.assign(mesh.vertex_count(), glm::vec3(0));
    for (std::size_t t = 0; t < mesh.leaf_count(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const glm::vec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        for (unsigned corner = 0; corner < 3; ++corner)
            normals[mesh.triangles[t][corner]] += power_of_two(mesh.tags[t].corner_exponent(corner)) * normal;
    }
    KeySet blended = 0;
    for (std::size_t key = 0; key < weights.size(); ++key)
        if (weights[key] != 0) blended |= key_bit(key);
    for (std::size_t v = mesh.roots.vertex_count(); v < mesh.vertex_count(); ++v) {
        const auto& [edge, owners] = mesh.vertices[v];
        if ((owners & blended) == 0) normals[v] = (normals[edge[0]] + normals[edge[1]]) * 0.5F;
    }
}

}  // namespace interleaf
