// The program's own work per frame: Renderer::draw() with the calls that draw and clear replaced by no-ops,
// because without a graphics card these calls are the rendering. Counts the uploaded bytes. Prints one line
// of JSON.
#include <utility>
#include <vector>

#include "json_line.h"
#include "keys.h"
#include <glad/gl.h>

#include "hierarchy/measure.h"
#include "render/context.h"
#include "render/renderer.h"
#include "text/parsed_number.h"

namespace {

using namespace interleaf;

std::size_t uploaded = 0;
PFNGLBUFFERDATAPROC buffer_data = nullptr;

void GLAD_API_PTR draw_nothing(GLenum, GLsizei, GLenum, const void*) {}
void GLAD_API_PTR draw_no_arrays(GLenum, GLint, GLsizei) {}
void GLAD_API_PTR clear_nothing(GLbitfield) {}
void GLAD_API_PTR count_upload(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    uploaded += static_cast<std::size_t>(size);
    buffer_data(target, size, data, usage);
}

}  // namespace

int main(int argc, char** argv) {
    const Index leaves = argc == 2 ? parsed_number<Index>(argv[1]).value_or(0) : 0;
    if (leaves < 20 || leaves > 5'000'000) {
        std::fprintf(stderr, "usage: %s LEAVES (a key; 20 to 5000000)\n", argv[0]);
        return 2;
    }
    std::vector<Hierarchy> keys;
    for (const unsigned seed : {1U, 2U, 3U}) keys.push_back(bench::random_key(leaves, seed));
    const std::vector<const Hierarchy*> pointers = {&keys[0], &keys[1], &keys[2]};
    const UnionMesh mesh = unite(pointers);

    const EglContext context;
    const OffscreenTarget target(256, 256, 1);
    Renderer renderer;
    renderer.upload(mesh, normal_form(mesh));
    Camera camera;
    camera.view_all(extent_of(bounding_box(mesh.positions[0])), 1);
    const std::vector<float> weights = {0.2F, 0.3F, 0.5F};
    const Display display;
    renderer.draw(target, camera, weights, display);
    target.finish();

    glad_glDrawElements = draw_nothing;
    glad_glDrawArrays = draw_no_arrays;
    glad_glClear = clear_nothing;
    buffer_data = std::exchange(glad_glBufferData, count_upload);
    constexpr int frames = 1000;
    const double seconds = bench::min_seconds_of(5, [&] {
        uploaded = 0;
        for (int frame = 0; frame < frames; ++frame) renderer.draw(target, camera, weights, display);
    });
    bench::print_line({{"leaves", mesh.leaf_count()},
                       {"microseconds_per_frame", seconds / frames * 1e6},
                       {"bytes_uploaded_per_frame", uploaded / frames}});
    return 0;
}
