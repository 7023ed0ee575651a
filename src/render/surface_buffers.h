// The vertex and texture buffers of one surface on the GPU, which are filled in slices, so that no frame has to
// wait until a large surface has been sent.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/gl_object.h"
#include "render/prepared_surface.h"

namespace interleaf {

class SurfaceBuffers {
  public:
    using Stream = std::span<const glm::vec3>;  ///< one vector per vertex

    /// \pre a context is current
    SurfaceBuffers();

    /// Begins to send a surface, instead of the present one.
    /// \param texels  one per leaf
    /// \param form    ignored unless is_blended_on_gpu(); streams come by stream() then
    /// \pre the arguments outlive the sending
    /// \throw MachineError if there are more leaves than a buffer texture holds here; the old surface stays
    void begin(const UnionMesh& mesh, std::span<const LeafTexel> texels, const NormalForm& form);

    /// The same for a surface that the caller has blended, with one stream of each.
    void begin_blend(const UnionMesh& mesh, std::span<const LeafTexel> texels, Stream positions,
                     Stream normals);

    /// Sends at most about \p max_bytes more.
    /// \return whether everything has been sent
    bool send(std::size_t max_bytes);

    bool is_complete() const { return pieces_.empty(); }

    /// Replaces the streams by one blended stream, which changes in every frame.
    void stream(Stream positions, Stream normals);

    const GlVertexArray& attributes() const { return attributes_; }
    const GlTexture& leaf_texture() const { return leaf_texture_; }
    std::size_t leaf_count() const { return leaf_count_; }
    std::size_t vertex_count() const { return vertex_count_; }

    /// Number of position streams on the GPU.
    std::size_t key_count() const { return key_count_; }

  private:
    /// Data for a buffer, of which a part has been sent.
    struct Piece {
        const GlBuffer* buffer;
        const std::byte* data;
        std::size_t size;
        std::size_t sent;
    };
    void begin_leaves(const UnionMesh& mesh, std::span<const LeafTexel> texels, std::size_t key_count);
    void add_piece(const GlBuffer& buffer, std::span<const std::byte> data);
    void set_attributes();

    GlVertexArray attributes_;
    std::array<GlBuffer, max_gpu_keys> positions_;  ///< of each key
    GlBuffer products_;                             ///< the normal products; those of a vertex are adjacent
    GlBuffer corners_;                              ///< vertex indices of the leaves
    GlBuffer leaf_data_;                            ///< LeafTexels
    GlTexture leaf_texture_;                        ///< leaf_data_ as a buffer texture
    std::size_t leaf_count_ = 0;
    std::size_t vertex_count_ = 0;
    std::size_t key_count_ = 0;
    std::vector<Piece> pieces_;  ///< still to be sent
};

/// \throw MachineError if a buffer texture here does not hold \p count texels
/// \param what  names them in the message
void check_texel_count(std::size_t count, const char* what);

}  // namespace interleaf
