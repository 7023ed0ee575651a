// Uploading and drawing. Every pass sets all the state it depends on.
#include "render/renderer.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string_view>

#include <fmt/core.h>
#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "render/shader.h"

namespace interleaf {
namespace {

/// Attribute of the first normal product; as in surface.vert.
constexpr GLuint first_product = max_gpu_keys;

GlProgram make_background_program() {
    constexpr std::string_view files[] = {"background.vert", "background.frag"};
    return link_program(files);
}

GlProgram make_surface_program(std::size_t key_count, bool edges) {
    constexpr std::string_view files[] = {"surface.vert", "surface.geom", "surface.frag"};
    constexpr std::string_view files_without_edges[] = {"surface.vert", "surface.frag"};
    const std::string definitions =
        fmt::format("#define KEY_COUNT {}\n#define EDGES {}", key_count, edges ? 1 : 0);
    return edges ? link_program(files, definitions) : link_program(files_without_edges, definitions);
}

GLint uniform(const GlProgram& program, const char* name) {
    return glGetUniformLocation(program.name(), name);
}

GLsizeiptr byte_count(std::span<const glm::vec3> stream) {
    return static_cast<GLsizeiptr>(stream.size_bytes());
}

/// Makes \p data the content of \p buffer and \p texture a view of it as texels of \p format.
template <typename Texel>
void fill_buffer_texture(const GlBuffer& buffer, const GlTexture& texture, GLenum format,
                         std::span<const Texel> data) {
    glBindBuffer(GL_TEXTURE_BUFFER, buffer.name());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
    glBindTexture(GL_TEXTURE_BUFFER, texture.name());
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.name());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
}

/// Binds \p buffer, made when it is none yet, with \p data as its content.
void fill_vertex_buffer(GlBuffer& buffer, std::span<const glm::vec3> data, GLenum usage) {
    if (!buffer) buffer = GlBuffer::create();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, byte_count(data), data.data(), usage);
}

/// Attribute \p attribute of a vertex is vector \p place of the \p count it has in the bound buffer.
void set_attribute(std::size_t attribute, std::size_t count, std::size_t place) {
    const auto number = static_cast<GLuint>(attribute);
    // What was a pointer in OpenGL 1.1 is an offset into the buffer.
    const auto* const offset =
        reinterpret_cast<const void*>(place * sizeof(glm::vec3));  // NOLINT(performance-no-int-to-ptr)
    glVertexAttribPointer(number, 3, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(count * sizeof(glm::vec3)),
                          offset);
    glEnableVertexAttribArray(number);
}

void bind_buffer_texture(GLuint unit, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture.name());
}

void check_limit(std::size_t leaf_count) {
    GLint most_texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most_texels);
    if (leaf_count > static_cast<std::size_t>(most_texels))
        throw MachineError(fmt::format("cannot draw {} leaves: at most {} here", leaf_count, most_texels));
}

/// For each vertex whether it lies on an edge of the root complex.
std::vector<bool> vertices_on_root_edges(const UnionMesh& mesh) {
    std::vector<bool> on_edge(mesh.vertex_count(), false);
    for (std::size_t leaf = 0; leaf < mesh.leaf_count(); ++leaf)
        for (unsigned corner = 0; corner < 3; ++corner)
            if (mesh.tags[leaf].on_root_edge(corner))
                for (const unsigned end : {(corner + 1) % 3, (corner + 2) % 3})
                    on_edge[mesh.triangles[leaf][end]] = true;
    return on_edge;
}

/// What surface.frag reads about a leaf.
struct LeafTexel {
    std::uint32_t tag;
    std::uint32_t origin_and_corners;  ///< bits 0-2: the corner lies on an edge of the roots; above: place in
                                       ///< the palette
};

std::vector<LeafTexel> leaf_texels(const UnionMesh& mesh, std::span<const KeySet> origins) {
    const std::vector<bool> on_edge = vertices_on_root_edges(mesh);
    std::vector<LeafTexel> texels(mesh.leaf_count());
    for (std::size_t leaf = 0; leaf < texels.size(); ++leaf) {
        const auto place =
            std::lower_bound(origins.begin(), origins.end(), mesh.origins[leaf]) - origins.begin();
        std::uint32_t packed = static_cast<std::uint32_t>(place) << 3;
        for (unsigned corner = 0; corner < 3; ++corner)
            packed |= static_cast<std::uint32_t>(on_edge[mesh.triangles[leaf][corner]]) << corner;
        texels[leaf] = {mesh.tags[leaf].packed(), packed};
    }
    return texels;
}

}  // namespace

Renderer::Renderer()
    : background_program_(make_background_program()),
      no_attributes_(GlVertexArray::create()),
      attributes_(GlVertexArray::create()),
      corners_(GlBuffer::create()),
      leaf_data_(GlBuffer::create()),
      leaf_texture_(GlTexture::create()),
      palette_data_(GlBuffer::create()),
      palette_texture_(GlTexture::create()) {}

void Renderer::reload_shaders() {
    GlProgram background = make_background_program();
    SurfacePrograms surface;
    for (std::size_t keys = 0; keys < max_gpu_keys; ++keys)
        for (const bool edges : {false, true})
            if (surface_programs_[keys][edges]) surface[keys][edges] = make_surface_program(keys + 1, edges);
    background_program_ = std::move(background);
    surface_programs_ = std::move(surface);
}

const GlProgram& Renderer::surface_program(bool edges) {
    GlProgram& program = surface_programs_[gpu_key_count_ - 1][edges];
    if (!program) program = make_surface_program(gpu_key_count_, edges);
    return program;
}

void Renderer::upload(const UnionMesh& mesh, const NormalForm& form, std::span<const std::size_t> keys) {
    assert(mesh.key_count() > 0 && form.product_count == product_count(mesh.key_count()));
    check_limit(mesh.leaf_count());
    std::vector<std::size_t> family_keys(keys.begin(), keys.end());
    if (family_keys.empty()) {
        family_keys.resize(mesh.key_count());
        std::iota(family_keys.begin(), family_keys.end(), std::size_t{0});
    }
    assert(family_keys.size() == mesh.key_count());

    origins_ = origins_of(mesh);
    origin_colors_.clear();
    for (const KeySet origin : origins_)
        origin_colors_.push_back(linear_light(origin_color(origin, family_keys)));
    levels_ = level_range(mesh);
    upload_leaves(mesh);

    if (mesh.key_count() <= max_gpu_keys) {
        processor_blend_.reset();
        gpu_key_count_ = mesh.key_count();
        upload_streams(std::vector<Stream>(mesh.positions.begin(), mesh.positions.end()), form.products);
    } else {
        processor_blend_ = ProcessorBlend{mesh, form, {}};
        gpu_key_count_ = 1;
    }
}

void Renderer::upload_leaves(const UnionMesh& mesh) {
    fill_buffer_texture<LeafTexel>(leaf_data_, leaf_texture_, GL_RG32UI, leaf_texels(mesh, origins_));

    leaf_count_ = mesh.leaf_count();
    glBindVertexArray(attributes_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, corners_.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(leaf_count_ * sizeof(Triangle)),
                 mesh.triangles.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
}

void Renderer::upload_streams(std::span<const Stream> positions, Stream products) {
    const GLenum usage = processor_blend_ ? GL_STREAM_DRAW : GL_STATIC_DRAW;
    const std::size_t normals = product_count(positions.size());
    glBindVertexArray(attributes_.name());
    for (std::size_t key = 0; key < positions.size(); ++key) {
        fill_vertex_buffer(positions_[key], positions[key], usage);
        set_attribute(key, 1, 0);
    }
    fill_vertex_buffer(products_, products, usage);
    for (std::size_t n = 0; n < normals; ++n) set_attribute(first_product + n, normals, n);
    for (std::size_t key = positions.size(); key < max_gpu_keys; ++key) {
        positions_[key] = {};
        glDisableVertexAttribArray(static_cast<GLuint>(key));
    }
    for (std::size_t n = normals; n < product_count(max_gpu_keys); ++n)
        glDisableVertexAttribArray(static_cast<GLuint>(first_product + n));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
}

void Renderer::blend_on_processor(ProcessorBlend& blend, std::span<const float> weights) {
    if (std::equal(weights.begin(), weights.end(), blend.weights.begin(), blend.weights.end())) return;
    const std::vector<glm::vec3> positions = morph(blend.mesh, weights);
    const std::vector<glm::vec3> normals = morph_normals(blend.form, weights);
    const Stream position_stream = positions;
    upload_streams({&position_stream, 1}, normals);
    blend.weights.assign(weights.begin(), weights.end());
}

void Renderer::upload_palette(const Display& display) {
    std::vector<glm::vec4> palette;
    switch (display.coloring) {
        case Coloring::plain:
            palette.emplace_back(linear_light(plain_color), 1);
            break;
        case Coloring::level:
            for (unsigned level = 0; level <= levels_.max; ++level)
                palette.emplace_back(linear_light(level_color(level, levels_)), 1);
            break;
        case Coloring::origin:
            for (const glm::vec3 color : origin_colors_) palette.emplace_back(color, 1);
            break;
    }
    fill_buffer_texture<glm::vec4>(palette_data_, palette_texture_, GL_RGBA32F, palette);
}

void Renderer::draw(const OffscreenTarget& target, const Camera& camera, std::span<const float> weights,
                    const Display& display) {
    target.bind();
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_MULTISAMPLE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);

    draw_background();
    if (leaf_count_ > 0) draw_surface(target, camera, weights, display);

    // The values in the window are encoded already.
    glDisable(GL_FRAMEBUFFER_SRGB);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Renderer::draw_background() const {
    glDisable(GL_DEPTH_TEST);
    glUseProgram(background_program_.name());
    glBindVertexArray(no_attributes_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_surface(const OffscreenTarget& target, const Camera& camera,
                            std::span<const float> weights, const Display& display) {
    const float one = 1;
    if (processor_blend_) {
        assert(weights.size() == processor_blend_->mesh.key_count());
        blend_on_processor(*processor_blend_, weights);
        weights = {&one, 1};
    }
    assert(weights.size() == gpu_key_count_);
    upload_palette(display);

    const bool edges = display.wireframe || display.refinement_edges || display.root_edges;
    const GlProgram& program = surface_program(edges);
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    glUseProgram(program.name());
    glUniformMatrix4fv(uniform(program, "view"), 1, GL_FALSE, glm::value_ptr(camera.view()));
    glUniformMatrix4fv(uniform(program, "projection"), 1, GL_FALSE,
                       glm::value_ptr(camera.projection(aspect)));
    glUniform1fv(uniform(program, "weights"), static_cast<GLsizei>(weights.size()), weights.data());
    glUniform1i(uniform(program, "flat_shading"), display.shading == Shading::flat);
    glUniform1i(uniform(program, "coloring"), static_cast<GLint>(display.coloring));
    glUniform1i(uniform(program, "show_wireframe"), display.wireframe);
    glUniform1i(uniform(program, "show_refinement_edges"), display.refinement_edges);
    glUniform1i(uniform(program, "show_root_edges"), display.root_edges);
    glUniform1f(uniform(program, "line_width"), display.line_width);
    glUniform1i(uniform(program, "leaf_data"), 0);
    glUniform1i(uniform(program, "palette"), 1);
    bind_buffer_texture(1, palette_texture_);
    bind_buffer_texture(0, leaf_texture_);

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glBindVertexArray(attributes_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * leaf_count_), GL_UNSIGNED_INT, nullptr);
}

}  // namespace interleaf
