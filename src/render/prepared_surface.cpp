#include "render/prepared_surface.h"

#include <algorithm>
#include <utility>

#include <glm/vec3.hpp>

namespace interleaf {

namespace {

/// For each vertex, whether it lies on an edge of the root complex.
std::vector<bool> vertices_on_root_edges(const UnionMesh& mesh) {
    std::vector<bool> on_edge(mesh.vertex_count(), false);
    for (std::size_t leaf = 0; leaf < mesh.leaf_count(); ++leaf)
        for (unsigned corner = 0; corner < 3; ++corner)
            if (mesh.tags[leaf].on_root_edge(corner))
                for (const unsigned end : {(corner + 1) % 3, (corner + 2) % 3})
                    on_edge[mesh.triangles[leaf][end]] = true;
    return on_edge;
}

}  // namespace

SurfaceLeaves surface_leaves(const UnionMesh& mesh) {
    SurfaceLeaves leaves{.texels = {}, .origins = origins_of(mesh), .levels = level_range(mesh)};
    const std::vector<bool> on_edge = vertices_on_root_edges(mesh);
    leaves.texels.resize(mesh.leaf_count());
    for (std::size_t leaf = 0; leaf < leaves.texels.size(); ++leaf) {
        const auto place =
            std::ranges::lower_bound(leaves.origins, mesh.origins[leaf]) - leaves.origins.begin();
        std::uint32_t packed = static_cast<std::uint32_t>(place) << 3;
        for (unsigned corner = 0; corner < 3; ++corner)
            packed |= static_cast<std::uint32_t>(on_edge[mesh.triangles[leaf][corner]]) << corner;
        leaves.texels[leaf] = {mesh.tags[leaf].packed(), packed};
    }
    return leaves;
}

std::size_t PreparedSurface::byte_count() const {
    std::size_t per_vertex = sizeof(VertexOrigin) + form.product_count * sizeof(glm::vec3);
    per_vertex += mesh.key_count() * sizeof(glm::vec3);
    const std::size_t per_leaf = sizeof(Triangle) + sizeof(LeafTag) + sizeof(KeySet) + sizeof(LeafTexel);
    std::size_t bytes = mesh.vertex_count() * per_vertex + mesh.leaf_count() * per_leaf;
    if (mesh.turning) bytes += mesh.turning->byte_count();
    for (const Buffer<Index>& own : mesh.own_vertices) bytes += own.size() * sizeof(Index);
    return bytes;
}

PreparedSurface prepared_surface(UnionMesh mesh) {
    PreparedSurface surface;
    surface.mesh = std::move(mesh);
    if (is_blended_on_gpu(surface.mesh)) normal_form(surface.mesh, surface.form);
    surface.leaves = surface_leaves(surface.mesh);
    return surface;
}

}  // namespace interleaf
