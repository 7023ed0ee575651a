#include "app/pictures/mismatch_pictures.h"

#include "hierarchy/error.h"
#include "render/lone_picture.h"

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
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const MismatchPicture picture = mismatch_picture(*key.hierarchy, place, aspect);
    LonePicture drawn{.size = size, .camera = picture.camera, .display = {}, .field = &picture.colors};
    drawn.display.coloring = Coloring::field;
    drawn.display.root_edges = true;
    textures_.push_back(texture_alone(*renderer_, picture.mesh, picture.form, drawn));
    shown_.push_back({textures_.back().name(), caption_of(key.name, place)});
}

}  // namespace interleaf
