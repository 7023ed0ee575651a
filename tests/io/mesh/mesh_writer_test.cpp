#include "io/mesh/mesh_writer.h"

#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

namespace interleaf {

TEST_CASE("a PLY has its header and its bytes") {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0.5f, 0}, {0, 1, -2}};
    const std::vector<Triangle> triangles{{2, 0, 1}};
    const std::string ply = ply_bytes(triangles, positions);
    const std::string_view header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    REQUIRE(ply.starts_with(header));
    REQUIRE(ply.size() == header.size() + 36 + 13);
    CHECK(ply.substr(header.size(), 36) == std::string(reinterpret_cast<const char*>(positions.data()), 36));
    CHECK(ply[header.size() + 36] == 3);
    CHECK(std::memcmp(ply.data() + header.size() + 37, triangles.data(), 12) == 0);
}

TEST_CASE("a PLY has the fields as properties with different names") {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Triangle> triangles{{0, 1, 2}};
    const Buffer<float> scalar{1.5F, -2, 3};
    const Buffer<float> color{0, 0.5F, 1, 0.25F, 0.001F, 0.999F, 1, 1, 1};
    const std::vector<Field> fields{{"x", FieldKind::scalar, scalar},
                                    {"a b", FieldKind::scalar, scalar},
                                    {"a_b", FieldKind::scalar, scalar},
                                    {"tint", FieldKind::color, color},
                                    {"color", FieldKind::color, color}};
    const std::string ply = ply_bytes(triangles, positions, fields);
    const std::string_view header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float x_2\nproperty float a_b\nproperty float a_b_2\n"
        "property uchar tint_red\nproperty uchar tint_green\nproperty uchar tint_blue\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    REQUIRE(ply.starts_with(header));
    constexpr std::size_t row = 12 + 12 + 6;
    REQUIRE(ply.size() == header.size() + 3 * row + 13);
    for (std::size_t v = 0; v < 3; ++v) {
        const char* const at = ply.data() + header.size() + v * row;
        CHECK(std::memcmp(at, &positions[v], 12) == 0);
        for (std::size_t f = 0; f < 3; ++f) CHECK(std::memcmp(at + 12 + 4 * f, &scalar[v], 4) == 0);
        for (std::size_t c = 0; c < 6; ++c)
            CHECK(static_cast<unsigned char>(at[24 + c]) == std::lround(255 * color[3 * v + c % 3]));
    }
}

}  // namespace interleaf
