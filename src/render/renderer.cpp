// Uploads and draws. Every pass sets all the state it depends on.
#include "render/renderer.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string_view>

#include <fmt/core.h>
#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>

#include "hierarchy/error.h"
#include "hierarchy/leaf_path.h"
#include "hierarchy/morph.h"
#include "render/shader.h"

namespace interleaf {
namespace {

/// Texels of a color map; linear light in between.
constexpr std::size_t scale_texels = 256;

/// Attribute of the first normal product, as in surface.vert.
constexpr GLuint first_product = max_gpu_keys;

GlProgram make_background_program() {
    constexpr std::string_view files[] = {"background.vert", "background.frag"};
    return link_program(files);
}

GLint uniform(const GlProgram& program, const char* name) {
    return glGetUniformLocation(program.name(), name);
}

GLsizeiptr byte_count(std::span<const glm::vec3> stream) {
    return static_cast<GLsizeiptr>(stream.size_bytes());
}

/// Makes \p data the content of \p buffer, and makes \p texture a view of it as texels of \p format.
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

/// Binds \p buffer, creates it if necessary, and fills it with \p data.
void fill_vertex_buffer(GlBuffer& buffer, std::span<const glm::vec3> data, GLenum usage) {
    if (!buffer) buffer = GlBuffer::create();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, byte_count(data), data.data(), usage);
}

/// Makes attribute \p attribute of a vertex its vector number \p place, of the \p count vectors per vertex in
/// the bound buffer.
void set_attribute(std::size_t attribute, std::size_t count, std::size_t place) {
    const auto number = static_cast<GLuint>(attribute);
    // The parameter, a pointer in OpenGL 1.1, is an offset into the buffer.
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

void check_limit(std::size_t count, std::string_view what) {
    GLint max_texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &max_texels);
    if (count > static_cast<std::size_t>(max_texels))
        throw MachineError(fmt::format("cannot draw {} {}: at most {} here", count, what, max_texels));
}

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

/// The data of a leaf that surface.frag reads.
struct LeafTexel {
    std::uint32_t tag;
    /// Bits 0-2: whether the corner lies on an edge of the roots; above: place in the palette.
    std::uint32_t origin_and_corners;
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

/// The path of each leaf as surface.geom reads it: bits 0-31, bits 32-63.
std::vector<std::array<std::uint32_t, 2>> path_texels(std::span<const LeafTag> tags) {
    std::vector<std::array<std::uint32_t, 2>> texels;
    texels.reserve(tags.size());
    for (const LeafPath& leaf : leaf_paths(tags))
        texels.push_back(
            {static_cast<std::uint32_t>(leaf.path), static_cast<std::uint32_t>(leaf.path >> 32)});
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
      palette_texture_(GlTexture::create()),
      path_data_(GlBuffer::create()),
      path_texture_(GlTexture::create()),
      field_data_(GlBuffer::create()),
      field_texture_(GlTexture::create()) {}

GlProgram Renderer::make_surface_program(const SurfaceKind& kind) {
    constexpr std::string_view files[] = {"surface.vert", "surface.geom", "surface.frag"};
    constexpr std::string_view files_without_geometry[] = {"surface.vert", "surface.frag"};
    const std::string definitions =
        fmt::format("#define KEY_COUNT {}\n#define FIELD {}\n#define CHECKER {:d}\n#define EDGES {:d}",
                    kind.key_count, kind.field_components, kind.checker, kind.edges);
    return kind.checker || kind.edges ? link_program(files, definitions)
                                      : link_program(files_without_geometry, definitions);
}

void Renderer::reload_shaders() {
    GlProgram background = make_background_program();
    SurfacePrograms surface;
    for (const auto& [kind, program] : surface_programs_) surface[kind] = make_surface_program(kind);
    background_program_ = std::move(background);
    surface_programs_ = std::move(surface);
}

const GlProgram& Renderer::surface_program(const SurfaceKind& kind) {
    GlProgram& program = surface_programs_[kind];
    if (!program) program = make_surface_program(kind);
    return program;
}

void Renderer::upload(const UnionMesh& mesh, const NormalForm& form, std::span<const std::size_t> keys) {
    assert(mesh.key_count() > 0);
    assert(mesh.key_count() > max_gpu_keys || form.product_count == product_count(mesh.key_count()));
    check_limit(mesh.leaf_count(), "leaves");
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
    field_components_ = 0;

    if (mesh.key_count() <= max_gpu_keys) {
        processor_blend_.reset();
        gpu_key_count_ = mesh.key_count();
        upload_streams(std::vector<Stream>(mesh.positions.begin(), mesh.positions.end()), form.products);
    } else {
        processor_blend_ = ProcessorBlend{.mesh = mesh};
        gpu_key_count_ = 1;
    }
}

void Renderer::upload_leaves(const UnionMesh& mesh) {
    fill_buffer_texture<LeafTexel>(leaf_data_, leaf_texture_, GL_RG32UI, leaf_texels(mesh, origins_));
    tags_.assign(mesh.tags.begin(), mesh.tags.end());

    leaf_count_ = mesh.leaf_count();
    glBindVertexArray(attributes_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, corners_.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(leaf_count_ * sizeof(Triangle)),
                 mesh.triangles.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
}

void Renderer::upload_paths() {
    if (tags_.empty()) return;
    fill_buffer_texture<std::array<std::uint32_t, 2>>(path_data_, path_texture_, GL_RG32UI,
                                                      path_texels(tags_));
    tags_ = {};
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

void Renderer::set_field(const UnionField* field) {
    field_components_ = 0;
    if (processor_blend_) {
        processor_blend_->field.reset();
        if (field != nullptr) processor_blend_->field = *field;
        processor_blend_->weights.clear();  // so that the next picture blends anew
    } else if (field != nullptr) {
        upload_field(std::vector<std::span<const float>>(field->values.begin(), field->values.end()),
                     component_count(field->label.kind));
    }
    if (field != nullptr) field_components_ = component_count(field->label.kind);
}

/// \param values  the values of each key, as in a UnionField; the components of a vertex are adjacent
void Renderer::upload_field(std::span<const std::span<const float>> values, std::size_t components) {
    std::vector<float> together;
    together.reserve(values.size() * values[0].size());
    for (std::size_t begin = 0; begin < values[0].size(); begin += components)
        for (const std::span<const float> stream : values) {
            const auto of_vertex = stream.subspan(begin, components);
            together.insert(together.end(), of_vertex.begin(), of_vertex.end());
        }
    check_limit(together.size(), "values");
    fill_buffer_texture<float>(field_data_, field_texture_, GL_R32F, together);
}

void Renderer::blend_on_processor(ProcessorBlend& blend, std::span<const float> weights) {
    if (std::equal(weights.begin(), weights.end(), blend.weights.begin(), blend.weights.end())) return;
    morph(blend.mesh, weights, blend.positions);
    surface_normals(blend.mesh, weights, blend.positions, blend.normals);
    const Stream position_stream = blend.positions;
    upload_streams({&position_stream, 1}, blend.normals);
    if (blend.field) {
        morph(*blend.field, weights, blend.values);
        const std::span<const float> stream = blend.values;
        upload_field({&stream, 1}, component_count(blend.field->label.kind));
    }
    blend.weights.assign(weights.begin(), weights.end());
}

void Renderer::upload_palette(Coloring coloring, ColorMap map) {
    std::vector<glm::vec4> palette;
    switch (coloring) {
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
        case Coloring::checker:
            break;
        case Coloring::field:
            for (std::size_t n = 0; n < scale_texels; ++n)
                palette.emplace_back(linear_light(color_at(map, static_cast<float>(n) / (scale_texels - 1))),
                                     1);
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
    const bool shows_field = display.coloring == Coloring::field && field_components_ > 0;
    const Coloring coloring =
        display.coloring == Coloring::field && !shows_field ? Coloring::plain : display.coloring;
    upload_palette(coloring, display.scale.map);
    if (coloring == Coloring::checker) upload_paths();

    const GlProgram& program =
        surface_program({.key_count = gpu_key_count_,
                         .field_components = shows_field ? field_components_ : 0,
                         .checker = coloring == Coloring::checker,
                         .edges = display.wireframe || display.refinement_edges || display.root_edges});
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    glUseProgram(program.name());
    glUniformMatrix4fv(uniform(program, "view"), 1, GL_FALSE, glm::value_ptr(camera.view()));
    glUniformMatrix4fv(uniform(program, "projection"), 1, GL_FALSE,
                       glm::value_ptr(camera.projection(aspect)));
    glUniform1fv(uniform(program, "weights"), static_cast<GLsizei>(weights.size()), weights.data());
    glUniform1i(uniform(program, "flat_shading"), display.shading == Shading::flat);
    glUniform1i(uniform(program, "coloring"), static_cast<GLint>(coloring));
    glUniform1i(uniform(program, "show_wireframe"), display.wireframe);
    glUniform1i(uniform(program, "show_refinement_edges"), display.refinement_edges);
    glUniform1i(uniform(program, "show_root_edges"), display.root_edges);
    glUniform1f(uniform(program, "line_width"), display.line_width);
    glUniform1i(uniform(program, "leaf_data"), 0);
    glUniform1i(uniform(program, "palette"), 1);
    glUniform1i(uniform(program, "leaf_paths"), 2);
    glUniform1i(uniform(program, "field_values"), 3);
    const auto [base, factor, offset] = display.scale.placing();
    glUniform2f(uniform(program, "value_range"), display.scale.range.min, display.scale.range.max);
    glUniform3f(uniform(program, "placing"), base, factor, offset);
    glUniform1i(uniform(program, "is_logarithmic"), display.scale.uses_logarithm() ? 1 : 0);
    bind_buffer_texture(3, field_texture_);
    bind_buffer_texture(2, path_texture_);
    bind_buffer_texture(1, palette_texture_);
    bind_buffer_texture(0, leaf_texture_);

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glBindVertexArray(attributes_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * leaf_count_), GL_UNSIGNED_INT, nullptr);
}

}  // namespace interleaf
