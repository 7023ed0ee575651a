#include "app/cli/render_command.h"

#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/document/family_extent.h"
#include "app/document/opening.h"
#include "app/document/shown_field.h"
#include "hierarchy/error.h"
#include "hierarchy/vertex_normals.h"
#include "io/mesh/mesh_file.h"
#include "render/camera.h"
#include "render/context.h"
#include "render/offscreen_target.h"
#include "render/renderer.h"

namespace interleaf {
namespace {

const std::vector<std::string> render_formats = {"png"};
constexpr int samples = 4;

Camera camera_on(const Family& family, const Viewpoint& viewpoint, float aspect) {
    Camera camera;
    camera.look_from(viewpoint.azimuth, viewpoint.elevation);
    camera.view_all(extent(family), aspect);
    camera.zoom(viewpoint.zoom, {0, 0}, aspect);
    return camera;
}

/// \throw UsageError if an active key lacks the field that \p display shows
std::optional<UnionField> united_shown_field(const Display& display, std::span<const FamilyField> fields,
                                             const Family& family, const Weights& weights,
                                             const UnionMesh& mesh) {
    const FamilyField* const shown = shown_field(display, fields);
    if (shown == nullptr) return std::nullopt;
    if (const auto key = key_without(family, weights, shown->label))
        throw UsageError(
            fmt::format("--color: key '{}' has no field '{}'", family.keys[*key].name, shown->label.name));
    return united_field(family, weights, mesh, shown->label);
}

}  // namespace

void run_render(const RenderOptions& options) {
    format_of(options.output, render_formats);
    const Family family = open_family(options.morph.family);
    const Weights weights = selected_weights(options.morph, family);
    const UnionMesh mesh = unite(family, weights);
    const std::vector<FamilyField> fields = fields_of(family.keys);
    require_field(options.display, fields);
    Display display = options.display;
    adapt_display(display, fields);
    const std::optional<UnionField> field = united_shown_field(display, fields, family, weights, mesh);

    const EglContext context;
    Renderer renderer;
    renderer.upload(mesh, mesh.key_count() <= max_gpu_keys ? normal_form(mesh) : NormalForm{},
                    active_keys(weights));
    if (field) renderer.set_field(&*field);
    const auto [width, height] = options.size;
    OffscreenTarget target(width, height, samples);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    renderer.draw(target, camera_on(family, options.viewpoint, aspect), weight_values(weights), display);
    write_output(target_of(options.output), png_bytes(target.read_rgba(), width, height));
}

}  // namespace interleaf
