#include "app/pictures/scene_picture.h"

namespace interleaf {
namespace {

constexpr int all_samples = 4;
constexpr std::chrono::milliseconds slow_from{25};

/// Where shading is slow it waits this long, so that it does not delay the next movement.
constexpr std::chrono::milliseconds rest_before_shading{150};

}  // namespace

bool ScenePicture::update(Renderer& renderer, const Scene& scene) {
    if (drawn_ != scene) {
        changed_ = Clock::now();
        draw(renderer, scene, drawn_ ? quality_while_moving() : Quality::shaded);
    } else if (quality_ == Quality::coarse) {
        draw(renderer, scene, Quality::smooth);
    } else if (quality_ == Quality::smooth && Clock::now() - changed_ > rest_before_shading) {
        draw(renderer, scene, Quality::shaded);
    }
    return quality_ == Quality::shaded;
}

void ScenePicture::reload_shaders() {
    occlusion_.reset();
    ground_.reset();
    drawn_.reset();
}

ScenePicture::Quality ScenePicture::quality_while_moving() const {
    if (shaded_time_ <= slow_from) return Quality::shaded;
    return smooth_time_ <= slow_from ? Quality::smooth : Quality::coarse;
}

void ScenePicture::draw(Renderer& renderer, const Scene& scene, Quality quality) {
    const int samples = quality == Quality::coarse ? 1 : all_samples;
    if (!target_ || samples != samples_ || target_->width() != scene.width ||
        target_->height() != scene.height) {
        drawn_.reset();   // there is no picture if there is no memory for the target
        target_.reset();  // two targets at a time may exceed the memory
        target_ = std::make_unique<OffscreenTarget>(scene.width, scene.height, samples);
        samples_ = samples;
    }
    ++drawings_;
    const Clock::time_point start = Clock::now();
    renderer.draw(*target_, scene.camera, scene.weights, scene.display);
    if (scene.display.ground) draw_ground(renderer, scene, quality);
    target_->finish();
    const Clock::duration taken = Clock::now() - start;
    milliseconds_ = std::chrono::duration<double, std::milli>(taken).count();
    if (quality != Quality::coarse) smooth_time_ = taken;
    if (quality == Quality::shaded) {
        if (scene.display.occlusion) {
            if (!occlusion_) occlusion_.emplace();
            occlusion_->darken(*target_, scene.camera, scene.display.occlusion_strength());
            target_->finish();
        }
        shaded_time_ = Clock::now() - start;
    }
    quality_ = quality;
    drawn_ = scene;
}

/// While a slow surface moves, the ground keeps its last shadow.
void ScenePicture::draw_ground(Renderer& renderer, const Scene& scene, Quality quality) {
    const auto has_same_surface = [&](const Scene& other) {
        return other.weights == scene.weights && other.surface == scene.surface && other.view == scene.view &&
               other.box == scene.box;
    };
    const bool is_new = !ground_ || (shadow_of_ && shadow_of_->camera.up() != scene.camera.up());
    if (!ground_) ground_.emplace();
    const bool has_shadow = shadow_of_ && has_same_surface(*shadow_of_);
    if (is_new || (!has_shadow && quality != Quality::coarse)) {
        ground_->cast_shadow(renderer, scene.weights, scene.box, scene.camera.up());
        shadow_of_ = scene;
    }
    ground_->draw(*target_, scene.camera, scene.display.light_background);
}

}  // namespace interleaf
