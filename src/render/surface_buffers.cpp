#include "render/surface_buffers.h"

#include <algorithm>

#include <fmt/core.h>
#include <glad/gl.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// Attribute of the first normal product, as in surface.vert.
constexpr std::size_t first_product = max_gpu_keys;

/// Makes attribute \p attribute of a vertex its vector number \p place, of the \p count vectors per vertex in
/// \p buffer.
void set_attribute(const GlBuffer& buffer, std::size_t attribute, std::size_t count, std::size_t place) {
    const auto number = static_cast<GLuint>(attribute);
    // The parameter, a pointer in OpenGL 1.1, is an offset into the buffer.
    const auto* const offset =
        reinterpret_cast<const void*>(place * sizeof(glm::vec3));  // NOLINT(performance-no-int-to-ptr)
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glVertexAttribPointer(number, 3, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(count * sizeof(glm::vec3)),
                          offset);
    glEnableVertexAttribArray(number);
}

/// A target that no vertex array keeps.
constexpr GLenum copy_target = GL_COPY_WRITE_BUFFER;

void fill_streamed(const GlBuffer& buffer, std::span<const glm::vec3> data) {
    glBindBuffer(copy_target, buffer.name());
    glBufferData(copy_target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
    glBindBuffer(copy_target, 0);
}

}  // namespace

void check_texel_count(std::size_t count, const char* what) {
    GLint max_texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &max_texels);
    if (count > static_cast<std::size_t>(max_texels))
        throw MachineError(fmt::format("cannot draw {} {}: at most {} here", count, what, max_texels));
}

SurfaceBuffers::SurfaceBuffers()
    : attributes_(GlVertexArray::create()),
      products_(GlBuffer::create()),
      corners_(GlBuffer::create()),
      leaf_data_(GlBuffer::create()),
      leaf_texture_(GlTexture::create()) {}

void SurfaceBuffers::begin(const UnionMesh& mesh, std::span<const LeafTexel> texels, const NormalForm& form) {
    const bool is_blended_here = is_blended_on_gpu(mesh);
    begin_leaves(mesh, texels, is_blended_here ? mesh.key_count() : 1);
    if (!is_blended_here) return;
    for (std::size_t key = 0; key < key_count_; ++key)
        add_piece(positions_[key], std::as_bytes(Stream(mesh.positions[key])));
    add_piece(products_, std::as_bytes(Stream(form.products)));
}

void SurfaceBuffers::begin_blend(const UnionMesh& mesh, std::span<const LeafTexel> texels, Stream positions,
                                 Stream normals) {
    begin_leaves(mesh, texels, 1);
    add_piece(positions_[0], std::as_bytes(positions));
    add_piece(products_, std::as_bytes(normals));
}

void SurfaceBuffers::begin_leaves(const UnionMesh& mesh, std::span<const LeafTexel> texels,
                                  std::size_t key_count) {
    check_texel_count(mesh.leaf_count(), "leaves");
    leaf_count_ = mesh.leaf_count();
    vertex_count_ = mesh.vertex_count();
    key_count_ = key_count;
    for (std::size_t key = 0; key < max_gpu_keys; ++key) {
        if (key >= key_count_)
            positions_[key] = {};
        else if (!positions_[key])
            positions_[key] = GlBuffer::create();
    }
    pieces_.clear();
    add_piece(leaf_data_, std::as_bytes(texels));
    add_piece(corners_, std::as_bytes(std::span(mesh.triangles.data(), mesh.triangles.size())));
}

void SurfaceBuffers::add_piece(const GlBuffer& buffer, std::span<const std::byte> data) {
    pieces_.push_back({&buffer, data.data(), data.size(), 0});
}

bool SurfaceBuffers::send(std::size_t max_bytes) {
    if (is_complete()) return true;
    while (max_bytes > 0 && !pieces_.empty()) {
        Piece& piece = pieces_.front();
        glBindBuffer(copy_target, piece.buffer->name());
        if (piece.sent == 0)
            glBufferData(copy_target, static_cast<GLsizeiptr>(piece.size), nullptr, GL_DYNAMIC_DRAW);
        const std::size_t part = std::min(max_bytes, piece.size - piece.sent);
        if (part > 0)
            glBufferSubData(copy_target, static_cast<GLintptr>(piece.sent), static_cast<GLsizeiptr>(part),
                            piece.data + piece.sent);
        piece.sent += part;
        max_bytes -= part;
        if (piece.sent == piece.size) pieces_.erase(pieces_.begin());
    }
    glBindBuffer(copy_target, 0);
    if (pieces_.empty()) set_attributes();
    return pieces_.empty();
}

void SurfaceBuffers::set_attributes() {
    glBindTexture(GL_TEXTURE_BUFFER, leaf_texture_.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32UI, leaf_data_.name());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    glBindVertexArray(attributes_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, corners_.name());
    const std::size_t normals = product_count(key_count_);
    for (std::size_t key = 0; key < key_count_; ++key) set_attribute(positions_[key], key, 1, 0);
    for (std::size_t n = 0; n < normals; ++n) set_attribute(products_, first_product + n, normals, n);
    for (std::size_t key = key_count_; key < max_gpu_keys; ++key)
        glDisableVertexAttribArray(static_cast<GLuint>(key));
    for (std::size_t n = normals; n < product_count(max_gpu_keys); ++n)
        glDisableVertexAttribArray(static_cast<GLuint>(first_product + n));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
}

void SurfaceBuffers::stream(Stream positions, Stream normals) {
    fill_streamed(positions_[0], positions);
    fill_streamed(products_, normals);
}

}  // namespace interleaf
