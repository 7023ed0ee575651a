#include "app/command_render.h"

#include <array>

#include "app/family_extent.h"
#include "app/open_family.h"
#include "hierarchy/vertex_normals.h"
#include "io/mesh_file.h"
#include "render/camera.h"
#include "render/context.h"
#include "render/offscreen_target.h"
#include "render/renderer.h"

namespace interleaf {
namespace {

constexpr std::array<std::string_view, 1> formats = {"png"};
constexpr int samples = 4;

Camera camera_on(const Family& family, const Viewpoint& viewpoint, float aspect) {
    Camera camera;
    camera.look_from(viewpoint.azimuth, viewpoint.elevation);
    camera.frame(extent(family), aspect);
    camera.zoom(viewpoint.zoom, {0, 0}, aspect);
    return camera;
}

}  // namespace

void run_render(const RenderOptions& options) {
    format_of(options.output, formats);
    const Family family = open_family(options.morph.family);
    const Weights weights = selected_weights(options.morph, family);
    const UnionMesh mesh = unite(family, weights);

    const EglContext context;
    Renderer renderer;
    renderer.upload(mesh, normal_form(mesh), active_keys(weights));
    const auto [width, height] = options.size;
    OffscreenTarget target(width, height, samples);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    renderer.draw(target, camera_on(family, options.viewpoint, aspect), weight_values(weights),
                  options.display);
    write_output(options.output, png_bytes(target.read_rgba(), width, height));
}

}  // namespace interleaf
