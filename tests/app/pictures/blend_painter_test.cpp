// Tests of pictures that are written to files.
#include "app/pictures/blend_painter.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "app/document/viewpoint.h"
#include "app/pictures/picture_legend.h"
#include "render/context.h"
#include "shapes/shapes.h"

using namespace interleaf;

namespace {

/// A sphere with its heights as a field.
Family sphere_with_field() {
    Hierarchy sphere = make_key(*find_shape("sphere"), {.leaves = 500, .tolerance = {}});
    Field heights{.name = "height", .kind = FieldKind::scalar, .values = {}};
    for (const glm::vec3& position : sphere.positions) heights.values.push_back(position.y);
    sphere.fields.push_back(heights);
    Family family;
    family.keys.push_back({"sphere", SharedHierarchy(std::move(sphere))});
    return family;
}

Display legend_of_height() {
    Display display;
    display.coloring = Coloring::field;
    display.field = "height";
    display.transparent = true;
    display.legend = true;
    return display;
}

}  // namespace

TEST_CASE("the legend does not cover the surface, in pictures of any shape") {
    const EglContext context;
    const Family family = sphere_with_field();
    for (const glm::ivec2 size : {glm::ivec2(200, 320), glm::ivec2(240, 240), glm::ivec2(400, 240)}) {
        CAPTURE(size.x);
        const int width = size.x;
        const int height = size.y;
        const Camera camera = camera_on(family, {}, static_cast<float>(width) / static_cast<float>(height));
        BlendPainter painter(family, width, height, legend_of_height());
        const std::vector<std::uint8_t> rgba = painter.paint({{0, 1.0}}, camera);
        const auto alpha_at = [&](int x, int y) {
            return rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x)) +
                        3];
        };
        // The box of the legend is the only thing in its column that is seen, and partly transparent at its border.
        const PictureLegend legend{.title = "height", .colors = ColorScale{.range = {-1, 1}}};
        const int first =
            width - static_cast<int>(legend_part(width, height, legend) * static_cast<float>(width));
        std::size_t opaque_at_border = 0;
        for (int y = 0; y < height; ++y)
            if (alpha_at(first + 2, y) > 230) ++opaque_at_border;
        CHECK(opaque_at_border == 0);
        CHECK(alpha_at(first / 2, height / 2) == 255);  // the surface is in the middle of the rest
    }
}
