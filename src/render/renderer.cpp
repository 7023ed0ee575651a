// Uploads and draws. Every pass sets all the state it depends on.
#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

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

constexpr std::string_view background_files[] = {"background.vert", "background.frag"};

GLint uniform(const GlProgram& program, const char* name) {
    return glGetUniformLocation(program.name(), name);
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

/// The coloring as surface.frag numbers it.
GLint shader_number(Coloring coloring) {
    switch (coloring) {
        case Coloring::plain:
            return 0;
        case Coloring::level:
            return 1;
        case Coloring::origin:
        case Coloring::common:
            return 2;
        default:
            return 3;
    }
}

void bind_buffer_texture(GLuint unit, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture.name());
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
    : background_program_(link_program(background_files)),
      no_attributes_(GlVertexArray::create()),
      palette_data_(GlBuffer::create()),
      palette_texture_(GlTexture::create()),
      path_data_(GlBuffer::create()),
      path_texture_(GlTexture::create()),
      field_data_(GlBuffer::create()),
      field_texture_(GlTexture::create()) {}

GlProgram Renderer::make_surface_program(const SurfaceKind& kind) {
    constexpr std::string_view files[] = {"surface.vert", "surface.geom", "surface.frag"};
    constexpr std::string_view files_without_geometry[] = {"surface.vert", "surface.frag"};
    const std::string definitions = fmt::format(
        "#define KEY_COUNT {}\n#define FIELD {}\n#define VALUES {}\n#define CHECKER {:d}\n#define EDGES {:d}",
        kind.key_count, kind.field_components, kind.values, kind.checker, kind.edges);
    return kind.checker || kind.edges ? link_program(files, definitions)
                                      : link_program(files_without_geometry, definitions);
}

void Renderer::reload_shaders() {
    GlProgram background = link_program(background_files);
    SurfacePrograms surface;
    for (const auto& [kind, program] : surface_programs_) surface[kind] = make_surface_program(kind);
    marks_.reload_shaders();
    background_program_ = std::move(background);
    surface_programs_ = std::move(surface);
}

const GlProgram& Renderer::surface_program(const SurfaceKind& kind) {
    GlProgram& program = surface_programs_[kind];
    if (!program) program = make_surface_program(kind);
    return program;
}

void Renderer::upload(const UnionMesh& mesh, const NormalForm& form, std::span<const std::size_t> keys) {
    sending_.reset();
    begin_sending(mesh, surface_leaves(mesh), form);
    show_sent(keys);
}

void Renderer::begin_upload(std::shared_ptr<const PreparedSurface> surface) {
    sending_ = std::move(surface);
    begin_sending(sending_->mesh, sending_->leaves, sending_->form);
}

/// Begins to send a surface. Without sending_, all of it is sent, because the arguments may not last.
void Renderer::begin_sending(const UnionMesh& mesh, const SurfaceLeaves& leaves, const NormalForm& form) {
    assert(mesh.key_count() > 0);
    assert(!is_blended_on_gpu(mesh) || form.product_count == product_count(mesh.key_count()));
    next_.key_count = 0;
    next_.buffers.begin(mesh, leaves.texels, form);
    describe_next(mesh, leaves);
    if (!is_blended_on_gpu(mesh))
        next_.processor_blend =
            ProcessorBlend{.mesh = sending_ ? std::shared_ptr<const UnionMesh>(sending_, &sending_->mesh)
                                            : std::make_shared<const UnionMesh>(mesh)};
    if (!sending_) next_.buffers.send(std::numeric_limits<std::size_t>::max());
}

void Renderer::describe_next(const UnionMesh& mesh, const SurfaceLeaves& leaves) {
    next_.levels = leaves.levels;
    next_.origins = leaves.origins;
    next_.tags.assign(mesh.tags.begin(), mesh.tags.end());
    next_.processor_blend.reset();
    next_.key_count = mesh.key_count();
}

void Renderer::upload_blend(const UnionMesh& mesh, std::span<const glm::vec3> positions,
                            std::span<const glm::vec3> normals, std::span<const std::size_t> keys) {
    assert(positions.size() == mesh.vertex_count() && normals.size() == mesh.vertex_count());
    sending_.reset();
    const SurfaceLeaves leaves = surface_leaves(mesh);
    next_.key_count = 0;
    next_.buffers.begin_blend(mesh, leaves.texels, positions, normals);
    describe_next(mesh, leaves);
    next_.buffers.send(std::numeric_limits<std::size_t>::max());
    show_sent(keys);
    shown_.key_count = 1;
}

bool Renderer::send(std::size_t max_bytes) {
    const bool is_complete = next_.buffers.send(max_bytes);
    if (is_complete) sending_.reset();
    return is_complete;
}

void Renderer::show_sent(std::span<const std::size_t> keys) {
    assert(next_.key_count > 0 && next_.buffers.is_complete());
    std::swap(shown_, next_);
    next_.key_count = 0;
    next_.processor_blend.reset();
    std::vector<std::size_t> family_keys(keys.begin(), keys.end());
    if (family_keys.empty()) {
        family_keys.resize(shown_.key_count);
        std::iota(family_keys.begin(), family_keys.end(), std::size_t{0});
    }
    assert(family_keys.size() == shown_.key_count);
    origin_colors_.clear();
    origin_colors_.reserve(shown_.origins.size());
    for (const KeySet origin : shown_.origins)
        origin_colors_.push_back(linear_light(origin_color(origin, family_keys)));
    field_components_ = 0;
    values_.reset();
}

void Renderer::upload_paths() {
    if (shown_.tags.empty()) return;
    fill_buffer_texture<std::array<std::uint32_t, 2>>(path_data_, path_texture_, GL_RG32UI,
                                                      path_texels(shown_.tags));
    shown_.tags = {};
}

void Renderer::set_field(const UnionField* field) {
    field_components_ = 0;
    values_.reset();
    if (auto& blend = shown_.processor_blend) {
        blend->field.reset();
        if (field != nullptr) blend->field = *field;
        blend->weights.clear();  // so that the next picture blends anew
    } else if (field != nullptr) {
        upload_field(std::vector<std::span<const float>>(field->values.begin(), field->values.end()),
                     component_count(field->label.kind));
    }
    if (field != nullptr) field_components_ = component_count(field->label.kind);
}

void Renderer::set_values(const SurfaceValues& values) {
    set_field(nullptr);
    const std::span<const float> stream = values.values;
    upload_field({&stream, 1}, 1);
    field_components_ = 1;
    values_ = values.place;
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
    check_texel_count(together.size(), "values");
    fill_buffer_texture<float>(field_data_, field_texture_, GL_R32F, together);
}

void Renderer::blend_on_processor(ProcessorBlend& blend, std::span<const float> weights) {
    if (std::equal(weights.begin(), weights.end(), blend.weights.begin(), blend.weights.end())) return;
    morph(*blend.mesh, weights, blend.positions);
    surface_normals(*blend.mesh, weights, blend.positions, blend.normals);
    shown_.buffers.stream(blend.positions, blend.normals);
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
            for (unsigned level = 0; level <= shown_.levels.max; ++level)
                palette.emplace_back(linear_light(level_color(level, shown_.levels)), 1);
            break;
        case Coloring::origin:
            for (const glm::vec3 color : origin_colors_) palette.emplace_back(color, 1);
            break;
        case Coloring::common:
            for (const KeySet origin : shown_.origins)
                palette.emplace_back(linear_light(common_color(share_of(origin, shown_.key_count))), 1);
            break;
        case Coloring::checker:
            break;
        case Coloring::angle:
        case Coloring::curvature:
        case Coloring::moved:
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

    if (display.transparent) {
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
    } else {
        draw_background(display);
    }
    if (shown_.key_count > 0) draw_surface(target, camera, weights, display);

    // The values in the window are encoded already.
    glDisable(GL_FRAMEBUFFER_SRGB);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Renderer::draw_background(const Display& display) const {
    glDisable(GL_DEPTH_TEST);
    glUseProgram(background_program_.name());
    glUniform1i(uniform(background_program_, "is_light"), display.light_background ? 1 : 0);
    glBindVertexArray(no_attributes_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Blends on the processor if the GPU cannot.
/// \return the weights of the streams on the GPU
std::span<const float> Renderer::weights_on_gpu(std::span<const float> weights) {
    static constexpr float one = 1;
    assert(weights.size() == shown_.key_count);
    if (!shown_.processor_blend) return weights;
    blend_on_processor(*shown_.processor_blend, weights);
    return {&one, 1};
}

/// Draws all leaves with the program in use, whose uniforms are set.
void Renderer::draw_leaves() const {
    bind_buffer_texture(3, field_texture_);
    bind_buffer_texture(2, path_texture_);
    bind_buffer_texture(1, palette_texture_);
    bind_buffer_texture(0, shown_.buffers.leaf_texture());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glBindVertexArray(shown_.buffers.attributes().name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * shown_.buffers.leaf_count()), GL_UNSIGNED_INT,
                   nullptr);
}

void Renderer::draw_depths(std::span<const float> weights, const glm::mat4& projection) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
    if (shown_.key_count == 0) return;
    weights = weights_on_gpu(weights);
    const GlProgram& program = surface_program(
        {.key_count = shown_.buffers.key_count(), .field_components = 0, .checker = false, .edges = false});
    const glm::mat4 unmoved(1);
    glUseProgram(program.name());
    glUniformMatrix4fv(uniform(program, "view"), 1, GL_FALSE, glm::value_ptr(unmoved));
    glUniformMatrix4fv(uniform(program, "projection"), 1, GL_FALSE, glm::value_ptr(projection));
    glUniform1fv(uniform(program, "weights"), static_cast<GLsizei>(weights.size()), weights.data());
    glUniform1i(uniform(program, "leaf_data"), 0);
    glUniform1i(uniform(program, "palette"), 1);
    draw_leaves();
}

void Renderer::draw_surface(const OffscreenTarget& target, const Camera& camera,
                            std::span<const float> weights, const Display& display) {
    weights = weights_on_gpu(weights);
    const bool wants_field = display.coloring == Coloring::field || is_measured(display.coloring);
    const bool shows_field =
        wants_field && field_components_ > 0 && values_.has_value() == is_measured(display.coloring);
    const Coloring coloring = wants_field && !shows_field ? Coloring::plain : display.coloring;
    upload_palette(coloring, display.scale.map);
    if (coloring == Coloring::checker) upload_paths();

    const GlProgram& program =
        surface_program({.key_count = shown_.buffers.key_count(),
                         .field_components = shows_field ? field_components_ : 0,
                         .values = !shows_field || !values_         ? 0
                                   : *values_ == ValuePlace::vertex ? 1
                                                                    : 2,
                         .checker = coloring == Coloring::checker,
                         .edges = display.wireframe || display.refinement_edges || display.root_edges});
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    glUseProgram(program.name());
    glUniformMatrix4fv(uniform(program, "view"), 1, GL_FALSE, glm::value_ptr(camera.view()));
    glUniformMatrix4fv(uniform(program, "projection"), 1, GL_FALSE,
                       glm::value_ptr(camera.projection(aspect)));
    glUniform1fv(uniform(program, "weights"), static_cast<GLsizei>(weights.size()), weights.data());
    glUniform1i(uniform(program, "flat_shading"), display.shading == Shading::flat);
    glUniform1i(uniform(program, "coloring"), shader_number(coloring));
    const Material material = coloring == Coloring::plain ? display.material : Material::clay;
    glUniform1i(uniform(program, "material"), static_cast<GLint>(material));
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
    draw_leaves();
    marks_.draw(shown_.buffers, target, camera, weights, display);
}

}  // namespace interleaf
