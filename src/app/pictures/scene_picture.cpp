#include "app/pictures/scene_picture.h"

#include <chrono>

namespace interleaf {
namespace {

constexpr int all_samples = 4;
constexpr double slow_from = 25;  // milliseconds

}  // namespace

bool ScenePicture::update(Renderer& renderer, const Scene& scene) {
    const bool moves = drawn_ != scene;
    if (moves) {
        draw(renderer, scene, drawn_ && is_slow_ ? 1 : all_samples);
    } else if (samples_ != all_samples) {
        draw(renderer, scene, all_samples);
    }
    return samples_ == all_samples;
}

void ScenePicture::draw(Renderer& renderer, const Scene& scene, int samples) {
    if (!target_ || samples != samples_ || target_->width() != scene.width ||
        target_->height() != scene.height) {
        target_.reset();  // two targets at a time may exceed the memory
        target_ = std::make_unique<OffscreenTarget>(scene.width, scene.height, samples);
    }
    const auto start = std::chrono::steady_clock::now();
    renderer.draw(*target_, scene.camera, scene.weights, scene.display);
    target_->finish();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    milliseconds_ = taken.count();
    if (samples == all_samples) is_slow_ = milliseconds_ > slow_from;
    samples_ = samples;
    drawn_ = scene;
}

}  // namespace interleaf
