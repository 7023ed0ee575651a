#include "app/pictures/mismatch_pictures.h"

#include "hierarchy/error.h"
#include "render/image_texture.h"
#include "render/offscreen_target.h"

namespace interleaf {

void MismatchPictures::update(const std::shared_ptr<const MismatchedKeys>& keys, glm::ivec2 size) {
    if (keys == keys_) return;
    keys_ = keys;
    shown_.clear();
    textures_.clear();
    if (!keys) return;
    renderer_.emplace();
    try {
        draw(keys->key, place_in_key(keys->mismatch), size);
        draw(keys->reference, place_in_reference(keys->mismatch), size);
    } catch (const MachineError&) {  // too large: the message has the text
        shown_.clear();
    }
    renderer_.reset();
}

void MismatchPictures::draw(const Key& key, const RootPlace& place, glm::ivec2 size) {
    constexpr int samples = 4;
    constexpr std::array<float, 1> weight{1};
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const MismatchPicture picture = mismatch_picture(*key.hierarchy, place, aspect);
    renderer_->upload(picture.mesh, picture.form);
    renderer_->set_field(&picture.colors);
    Display display;
    display.coloring = Coloring::field;
    display.root_edges = true;
    OffscreenTarget target(size.x, size.y, samples);
    renderer_->draw(target, picture.camera, weight, display);
    textures_.push_back(image_texture(size.x, size.y, target.read_rgba()));
    shown_.push_back({textures_.back().name(), caption_of(key.name, place)});
}

}  // namespace interleaf
