#include "app/pictures/key_portraits.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "app/document/family_extent.h"
#include "family/warp.h"
#include "hierarchy/detail/level_cut.h"
#include "hierarchy/union_fields.h"
#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/lone_picture.h"

namespace interleaf {

namespace {

/// A picture of more leaves takes long, and is too small to show them.
constexpr std::size_t max_drawn_leaves = 60'000;

/// The end of the axis \p axis, 0 to 2.
glm::vec3 end_of(unsigned axis) {
    glm::vec3 end(0);
    end[static_cast<int>(axis)] = 1;
    return end;
}

KeyPortrait portrait_of(const SharedHierarchy& hierarchy) {
    const std::vector<Leaf> leaves = leaves_of(*hierarchy);
    return {.hierarchy = hierarchy,
            .leaves = leaves.size(),
            .deepest = std::ranges::max_element(leaves, {}, &Leaf::level)->level,
            .extent = extent_of(bounding_box(hierarchy->positions)),
            .picture = {},
            .is_old = false};
}

}  // namespace

void KeyPortraits::update(const Family& family) {
    std::vector<KeyPortrait> portraits;
    bool is_changed = family.keys.size() != portraits_.size();
    for (const Key& key : family.keys) {
        const auto known = std::ranges::find_if(portraits_, [&](const KeyPortrait& portrait) {
            return portrait.hierarchy.is_same(key.hierarchy);
        });
        if (known == portraits_.end()) {
            is_changed = true;
            portraits.push_back(portrait_of(key.hierarchy));
        } else {
            KeyPortrait portrait{known->hierarchy, known->leaves, known->deepest, known->extent, {},
                                 known->is_old};
            portrait.picture = std::exchange(known->picture, {});
            portraits.push_back(std::move(portrait));
        }
    }
    if (portraits.size() == portraits_.size()) keep_old_pictures(portraits);
    portraits_ = std::move(portraits);
    if (is_changed) extent_ = interleaf::extent(family);
}

void KeyPortraits::set_look(const PortraitLook& look) {
    if (look == look_) return;
    const bool changes_all = look.is_light != look_.is_light || look.up != look_.up;
    look_ = look;
    for (KeyPortrait& portrait : portraits_)
        if (changes_all || flat_axis(portrait.extent.box)) portrait.is_old = true;
}

/// Gives \p portraits, which replace those of an edited family, the pictures that nothing else has taken.
void KeyPortraits::keep_old_pictures(std::vector<KeyPortrait>& portraits) {
    for (std::size_t key = 0; key < portraits.size(); ++key) {
        if (portraits[key].picture || !portraits_[key].picture) continue;
        portraits[key].picture = std::exchange(portraits_[key].picture, {});
        portraits[key].is_old = true;
    }
}

bool KeyPortraits::draw_next(std::size_t begin, std::size_t end, int side) {
    end = std::min(end, portraits_.size());
    const auto missing =
        std::find_if(portraits_.begin() + static_cast<std::ptrdiff_t>(std::min(begin, end)),
                     portraits_.begin() + static_cast<std::ptrdiff_t>(end),
                     [](const KeyPortrait& portrait) { return !portrait.picture || portrait.is_old; });
    if (missing == portraits_.begin() + static_cast<std::ptrdiff_t>(end)) return false;

    const Hierarchy& whole = *missing->hierarchy;
    std::optional<Hierarchy> coarse;
    if (whole.leaf_count() > max_drawn_leaves)
        coarse = cut_at_level(whole, level_with_at_most(whole, max_drawn_leaves));
    const std::array<const Hierarchy*, 1> key{coarse ? &*coarse : &whole};
    const UnionMesh mesh = unite(key);
    const auto axis = flat_axis(missing->extent.box);
    std::optional<UnionField> field;
    LonePicture picture{.size = {side, side}, .camera = {}, .display = {}};
    picture.display.light_background = look_.is_light;
    picture.display.shading = usual_shading(missing->leaves);
    picture.camera.set_up(look_.up);
    if (axis) {
        picture.camera.look_from_end(end_of(*axis));
        if (look_.field && std::ranges::count(common_fields(key), *look_.field) > 0) {
            field = united_field(key, mesh, *look_.field);
            picture.field = &*field;
            picture.display.coloring = Coloring::field;
            picture.display.scale = look_.scale;
        }
    } else {
        picture.camera.look_from(30, 20);
    }
    picture.camera.view_all(missing->extent, 1);
    missing->is_old = false;
    missing->picture = texture_alone(renderer_, mesh, normal_form(mesh), picture);
    return true;
}

}  // namespace interleaf
