#include "app/pictures/blend_painter.h"

#include <fmt/core.h>

#include "app/document/family_extent.h"
#include "app/document/shown_field.h"
#include "app/document/shown_shading.h"
#include "app/pictures/picture_arrows.h"
#include "app/pictures/picture_legend.h"
#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "hierarchy/vertex_normals.h"
#include "render/straight_alpha.h"
#include "render/surface_values.h"

namespace interleaf {
namespace {

constexpr int samples_per_pixel = 4;

}  // namespace

BlendPainter::BlendPainter(const Family& family, int width, int height, const Display& display)
    : family_(family),
      fields_(fields_of(family)),
      display_(display),
      target_(width, height, samples_per_pixel) {
    interleaf::require_field(display_, fields_);
    adapt_display(display_, fields_);
    if (display_.ground) {
        ground_.emplace();
        box_ = extent(family).box;
    }
    if (display_.height > 0) warp_ = warp_of(display_, fields_, extent(family).box);
    if (!display_.raised_by.empty() && display_.height > 0 && !warp_)
        throw UsageError(
            fmt::format("--height: the keys are not in a plane x, y or z = constant, or {} is constant",
                        display_.raised_by));
    if (const FamilyField* const field = warp_ ? find_field(fields_, warp_->field) : nullptr)
        box_.max[static_cast<int>(warp_->axis)] += warp_->factor * (field->max - field->min);
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
    mesh_ = unite(warped_.family(), warped_.weights());
    set_blend(mesh_, family_.blend);
    renderer_.upload(mesh_, is_blended_on_gpu(mesh_) ? normal_form(mesh_) : NormalForm{}, keys);
    arrows_.follow(warped_.family(), warped_.weights(), mesh_, ++unions_, shown_vector(display_, fields_));
    if (const FamilyField* const field = shown()) {
        const UnionField united = united_field(warped_.family(), warped_.weights(), mesh_, field->label);
        renderer_.set_field(&united);
    }
    if (is_measured(display_.coloring)) {
        display_.scale = measured_scale(display_.coloring, mesh_);
        if (const auto range = display_.kept_range()) display_.scale.range = *range;
    }
    keys_ = std::move(keys);
    legend_ = legend_of_union();
}

void BlendPainter::draw_surface(const Weights& weights, const Camera& camera) {
    if (is_measured(display_.coloring))
        renderer_.set_values(surface_values(display_.coloring, mesh_, morph(mesh_, weight_values(weights))));
    Display drawn = display_;
    drawn.shading = shown_shading(display_, family_, weights);
    renderer_.draw(target_, camera, weight_values(weights), drawn);
    if (ground_) {
        ground_->cast_shadow(renderer_, weight_values(weights), box_, camera.up());
        ground_->draw(target_, camera, display_.light_background);
    }
    occlusion_.darken(target_, camera, display_.occlusion_strength());
}

/// The legend of the union, if the display asks for one and has one.
std::optional<PictureLegend> BlendPainter::legend_of_union() const {
    if (!display_.legend || !has_picture_legend(display_, fields_)) return std::nullopt;
    std::vector<std::string> names;
    names.reserve(family_.keys.size());
    for (const Key& key : family_.keys) names.push_back(key.name);
    return picture_legend(display_, fields_, names, keys_, mesh_);
}

std::vector<std::uint8_t> BlendPainter::paint(const Weights& weights, const Camera& camera) {
    unite_keys(weights);
    const int width = target_.width();
    const int height = target_.height();
    Camera beside_legend = camera;
    if (legend_) beside_legend.show_in_left(1 - legend_part(width, height, *legend_));
    draw_surface(weights, beside_legend);
    std::vector<std::uint8_t> rgba = target_.read_rgba();
    if (display_.transparent) make_alpha_straight(rgba);
    if (arrows_.are_shown()) {
        const std::vector<float> depths = target_.read_depths();
        Weights united = warped_.weights();
        for (std::size_t n = 0; n < united.size(); ++n) united[n].value = weights[n].value;
        draw_arrows(rgba, width, height,
                    arrows_.arrows(mesh_, united, beside_legend, {width, height, depths},
                                   arrow_cell_of(width, height)));
    }
    if (legend_) draw_legend(rgba, width, height, *legend_);
    return rgba;
}

}  // namespace interleaf
