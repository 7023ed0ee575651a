// Whole frames of a union of many keys, with all its keys active and with two of them on the same mesh: how
// many are drawn per second at 1280x720. The weights change in every frame, as in playback. Prints one line of JSON.
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "json_line.h"
#include "keys.h"

#include "hierarchy/measure.h"
#include "render/context.h"
#include "render/renderer.h"
#include "text/parsed_number.h"

namespace {

using namespace interleaf;

constexpr std::size_t key_count = 30;

/// The weights of a frame: positive, with the sum 1.
std::vector<float> weights_of(std::size_t count, int frame) {
    std::vector<float> weights(count);
    float sum = 0;
    for (std::size_t key = 0; key < count; ++key) {
        const double phase = 0.1 * frame + static_cast<double>(key);
        weights[key] = static_cast<float>(1.5 + std::sin(phase));
        sum += weights[key];
    }
    for (float& weight : weights) weight /= sum;
    return weights;
}

/// \p mesh with its first two keys alone: the same leaves, though other keys have bisected some of them.
UnionMesh with_two_keys(UnionMesh mesh) {
    const KeySet both = key_bit(0) | key_bit(1);
    mesh.positions.resize(2);
    mesh.own_vertices.resize(2);
    for (KeySet& origin : mesh.origins) origin &= both;
    for (VertexOrigin& vertex : mesh.vertices) vertex.keys &= both;
    return mesh;
}

/// The frames per second of \p mesh.
double frame_rate(const UnionMesh& mesh, const OffscreenTarget& target) {
    constexpr int frames = 30;
    Renderer renderer;
    renderer.upload(mesh, mesh.key_count() <= max_gpu_keys ? normal_form(mesh) : NormalForm{});
    Camera camera;
    camera.view_all(extent_of(bounding_box(mesh.positions[0])), 16.0F / 9);
    const Display display;
    const auto draw = [&](int frame) {
        renderer.draw(target, camera, weights_of(mesh.key_count(), frame), display);
        target.finish();
    };
    draw(-1);
    const double seconds = bench::min_seconds_of(3, [&] {
        for (int frame = 0; frame < frames; ++frame) draw(frame);
    });
    return frames / seconds;
}

}  // namespace

int main(int argc, char** argv) {
    const Index leaves = argc == 2 ? parsed_number<Index>(argv[1]).value_or(0) : 0;
    if (leaves < 20 || leaves > 1'000'000) {
        std::fprintf(stderr, "usage: %s LEAVES (a key; 20 to 1000000)\n", argv[0]);
        return 2;
    }
    std::vector<Hierarchy> keys;
    keys.reserve(key_count);
    for (unsigned seed = 0; seed < key_count; ++seed) keys.push_back(bench::random_key(leaves, seed + 1));
    std::vector<const Hierarchy*> pointers;
    pointers.reserve(key_count);
    for (const Hierarchy& key : keys) pointers.push_back(&key);
    const UnionMesh all = unite(pointers);
    const UnionMesh two = with_two_keys(all);

    const EglContext context;
    const OffscreenTarget target(1280, 720, 1);
    const double of_two = frame_rate(two, target);
    bench::print_line({{"leaves", all.leaf_count()},
                       {"keys", all.key_count()},
                       {"frames_per_second_of_two", of_two},
                       {"frames_per_second", frame_rate(all, target)}});
    return 0;
}
