#include "app/pictures/blend_painter.h"

#include <fmt/core.h>

#include "app/document/family_extent.h"
#include "app/document/shown_field.h"
#include "hierarchy/error.h"
#include "hierarchy/vertex_normals.h"
#include "render/straight_alpha.h"

namespace interleaf {
namespace {

constexpr int samples_per_pixel = 4;

}  // namespace

BlendPainter::BlendPainter(const Family& family, int width, int height, const Display& display)
    : family_(family),
      fields_(fields_of(family.keys)),
      display_(display),
      target_(width, height, samples_per_pixel) {
    interleaf::require_field(display_, fields_);
    adapt_display(display_, fields_);
    if (display_.ground) {
        ground_.emplace();
        box_ = extent(family).box;
    }
    if (display_.height > 0) warp_ = warp_of(display_, fields_, extent(family).box);
}

const FamilyField* BlendPainter::shown() const {
    return shown_field(display_, fields_);
}

void BlendPainter::require_field(const Weights& weights) const {
    const FamilyField* const field = shown();
    if (field == nullptr) return;
    if (const auto key = key_without(family_, weights, field->label))
        throw UsageError(
            fmt::format("--color: key '{}' has no field '{}'", family_.keys[*key].name, field->label.name));
}

void BlendPainter::unite_keys(const Weights& weights) {
    std::vector<std::size_t> keys = active_keys(weights);
    if (keys == keys_) return;
    require_field(weights);
    warped_.follow(family_, weights, {}, warp_);
    const UnionMesh mesh = unite(warped_.family(), warped_.weights());
    renderer_.upload(mesh, mesh.key_count() <= max_gpu_keys ? normal_form(mesh) : NormalForm{}, keys);
    if (const FamilyField* const field = shown()) {
        const UnionField united = united_field(warped_.family(), warped_.weights(), mesh, field->label);
        renderer_.set_field(&united);
    }
    keys_ = std::move(keys);
}

std::vector<std::uint8_t> BlendPainter::paint(const Weights& weights, const Camera& camera) {
    unite_keys(weights);
    renderer_.draw(target_, camera, weight_values(weights), display_);
    if (ground_) {
        ground_->cast_shadow(renderer_, weight_values(weights), box_);
        ground_->draw(target_, camera, display_.light_background);
    }
    occlusion_.darken(target_, camera, display_.occlusion_strength());
    std::vector<std::uint8_t> rgba = target_.read_rgba();
    if (display_.transparent) make_alpha_straight(rgba);
    return rgba;
}

}  // namespace interleaf
