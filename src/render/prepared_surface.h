// A union with everything that the GPU needs of it. It is made without OpenGL, on any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/palette.h"

namespace interleaf {

/// Four keys take 14 of the 16 vertex attributes that OpenGL 3.3 guarantees.
inline constexpr std::size_t max_gpu_keys = 4;

/// Whether the GPU blends the keys of \p mesh; otherwise the processor does.
inline bool is_blended_on_gpu(const UnionMesh& mesh) {
    return mesh.key_count() <= max_gpu_keys && !mesh.turning;
}

/// The data of a leaf that surface.frag reads.
struct LeafTexel {
    std::uint32_t tag;
    /// Bits 0-2: whether the corner lies on an edge of the roots; above: place in the palette.
    std::uint32_t origin_and_corners;
};

/// What belongs to the leaves of a surface.
struct SurfaceLeaves {
    std::vector<LeafTexel> texels;
    std::vector<KeySet> origins;  ///< that occur; a texel counts them in this order
    LevelRange levels{};
};

SurfaceLeaves surface_leaves(const UnionMesh& mesh);

struct PreparedSurface {
    UnionMesh mesh;
    NormalForm form;  ///< empty unless is_blended_on_gpu()
    SurfaceLeaves leaves;

    /// Memory of the large arrays, in bytes.
    std::size_t byte_count() const;
};

/// \p mesh with its normal products and the data of its leaves.
PreparedSurface prepared_surface(UnionMesh mesh);

}  // namespace interleaf
