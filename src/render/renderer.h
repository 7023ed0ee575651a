// The renderer: draws the morph of a union mesh. The same renderer serves the window and EGL.
//
// upload() sends the data that stay constant while the active keys stay the same: leaves, tags, position
// streams, normal products. begin_upload(), send() and show_sent() do the same in slices, while the surface
// before is still drawn. draw() sends weights, camera and display as uniforms and draws once; the vertex
// shader blends positions and exact normals. With more than max_gpu_keys active keys, or where they turn, the
// processor blends positions into a streamed buffer and takes the normals of the blended surface.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/camera.h"
#include "render/display.h"
#include "render/offscreen_target.h"
#include "render/palette.h"
#include "render/prepared_surface.h"
#include "render/surface_buffers.h"
#include "render/surface_values.h"
#include "render/vertex_marks.h"

namespace interleaf {

class Renderer {
  public:
    /// \pre  a context is current
    Renderer();

    /// Replaces the surface.
    /// \param form  the normal products of \p mesh; not needed, and may be empty, unless
    ///     is_blended_on_gpu()
    /// \param keys  index in the family of each key of \p mesh, for the colors by origin; 0, 1, 2, ... if
    ///     empty
    /// \throw MachineError if there are more leaves than a buffer texture holds here; the old surface stays
    void upload(const UnionMesh& mesh, const NormalForm& form, std::span<const std::size_t> keys = {});

    /// Begins to send \p surface beside the present one; what was begun before is dropped.
    /// \throw MachineError as upload()
    void begin_upload(std::shared_ptr<const PreparedSurface> surface);

    /// Sends at most about \p max_bytes more of it.
    /// \return whether all of it has been sent
    bool send(std::size_t max_bytes);

    /// Replaces the surface by the one that was sent.
    /// \param keys  as for upload()
    /// \pre send() has returned true since begin_upload()
    void show_sent(std::span<const std::size_t> keys = {});

    /// Replaces the surface by a blend that the caller has made. The only weight in draw() is then 1, and a
    /// field in set_field() has one stream, its blend.
    /// \param mesh       gives the leaves and their data, but no positions
    /// \param positions  of the blend, one per vertex
    /// \param normals    of the blend, one per vertex, not normalized
    /// \param keys       as in upload()
    /// \throw MachineError as upload() does
    void upload_blend(const UnionMesh& mesh, std::span<const glm::vec3> positions,
                      std::span<const glm::vec3> normals, std::span<const std::size_t> keys);

    /// Makes Coloring::field show \p field, a field of the uploaded mesh; null for none. Without a field it
    /// looks like Coloring::plain.
    /// \throw MachineError if the field has more values than a buffer texture holds here
    void set_field(const UnionField* field);

    /// Makes the colorings of is_measured() show \p values, instead of a field. Without values they look like
    /// Coloring::plain.
    /// \throw MachineError as set_field()
    void set_values(const SurfaceValues& values);

    /// Draws the background and the surface into \p target.
    /// \param weights  one per key of the uploaded mesh
    void draw(const OffscreenTarget& target, const Camera& camera, std::span<const float> weights,
              const Display& display);

    /// Draws the depths of the surface alone into the bound framebuffer, which has no colors, after clearing it.
    /// \param weights     as in draw()
    /// \param projection  from the surface's coordinates to those of the device
    void draw_depths(std::span<const float> weights, const glm::mat4& projection);

    /// The levels, and the sets of keys, that occur on the surface; the legend explains these.
    LevelRange levels() const { return shown_.levels; }
    std::span<const KeySet> origins() const { return shown_.origins; }

    /// Reads the shader files again and compiles them; keeps the old ones if that fails.
    /// \throw InputError with the compiler's message
    void reload_shaders();

  private:
    /// What distinguishes the programs for the surface.
    struct SurfaceKind {
        std::size_t key_count;         ///< on the GPU
        std::size_t field_components;  ///< components of the shown field; 0 for none
        int values = 0;  ///< 0: the field has a stream per key; 1: one value per vertex; 2: one per leaf
        bool checker;
        bool edges;
        auto operator<=>(const SurfaceKind&) const = default;
    };
    /// Programs, made when first needed.
    using SurfacePrograms = std::map<SurfaceKind, GlProgram>;

    /// A mesh that the processor blends.
    struct ProcessorBlend {
        std::shared_ptr<const UnionMesh> mesh;
        std::optional<UnionField> field{};
        std::vector<float> weights{};  ///< the weights that the streams were blended with
        Buffer<glm::vec3> positions{};
        Buffer<glm::vec3> normals{};
        Buffer<float> values{};  ///< of the field
    };

    /// A surface on the GPU, or on its way there.
    struct Surface {
        SurfaceBuffers buffers{};
        LevelRange levels{};
        std::vector<KeySet> origins{};
        std::vector<LeafTag> tags{};  ///< of the leaves, until path_data_ is filled from them
        std::optional<ProcessorBlend> processor_blend{};
        std::size_t key_count = 0;  ///< 0 for none
    };

    static GlProgram make_surface_program(const SurfaceKind& kind);
    const GlProgram& surface_program(const SurfaceKind& kind);
    void upload_paths();
    void begin_sending(const UnionMesh& mesh, const SurfaceLeaves& leaves, const NormalForm& form);
    void describe_next(const UnionMesh& mesh, const SurfaceLeaves& leaves);
    void upload_field(std::span<const std::span<const float>> values, std::size_t components);
    std::span<const float> weights_on_gpu(std::span<const float> weights);
    void draw_leaves() const;
    void blend_on_processor(ProcessorBlend& blend, std::span<const float> weights);
    void upload_palette(Coloring coloring, ColorMap map);
    void draw_background(const Display& display) const;
    void draw_surface(const OffscreenTarget& target, const Camera& camera, std::span<const float> weights,
                      const Display& display);

    GlProgram background_program_;
    SurfacePrograms surface_programs_;
    GlVertexArray no_attributes_;
    GlBuffer palette_data_;
    GlTexture palette_texture_;
    GlBuffer path_data_;  ///< the path from the root to each leaf; filled when a checkerboard is first drawn
    GlTexture path_texture_;
    GlBuffer field_data_;
    GlTexture field_texture_;

    Surface shown_;
    Surface next_;                                    ///< what is sent
    std::shared_ptr<const PreparedSurface> sending_;  ///< its data, until they are sent
    VertexMarks marks_;
    std::optional<ValuePlace> values_;      ///< of the uploaded values; none for a field
    std::size_t field_components_ = 0;      ///< of the uploaded field; 0 for none
    std::vector<glm::vec3> origin_colors_;  ///< of the origins that occur, in linear light
};

}  // namespace interleaf
