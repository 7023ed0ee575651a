#include "render/lone_picture.h"

#include <array>

#include "render/image_texture.h"

namespace interleaf {

OffscreenTarget draw_alone(Renderer& renderer, const UnionMesh& mesh, const NormalForm& form,
                           const LonePicture& picture) {
    constexpr std::array<float, 1> weight{1};
    renderer.upload(mesh, form);
    renderer.set_field(picture.field);
    OffscreenTarget target(picture.size.x, picture.size.y, picture.samples);
    renderer.draw(target, picture.camera, weight, picture.display);
    return target;
}

GlTexture texture_alone(Renderer& renderer, const UnionMesh& mesh, const NormalForm& form,
                        const LonePicture& picture) {
    OffscreenTarget target = draw_alone(renderer, mesh, form, picture);
    return image_texture(picture.size.x, picture.size.y, target.read_rgba());
}

}  // namespace interleaf
