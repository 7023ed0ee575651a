#include "io/polygon_divider.h"

#include <iterator>
#include <string>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

constexpr std::size_t corners_at_a_time = 10'000;

std::vector<Index> triangle_corners(const std::string& obj, std::string_view name) {
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig options;
    options.vertex_color = false;
    if (!reader.ParseFromString(obj, "", options))
        throw InputError(fmt::format("{}: faces: {}", name, reader.Error()));
    std::vector<Index> corners;
    for (const tinyobj::shape_t& shape : reader.GetShapes())
        for (const tinyobj::index_t& index : shape.mesh.indices)
            corners.push_back(static_cast<Index>(index.vertex_index));
    return corners;
}

}  // namespace

void PolygonDivider::divide(std::size_t face, std::span<const Index> corners, std::span<Triangle> target) {
    const std::size_t begin = vertices_.size();
    std::string line = "f";
    for (const Index vertex : corners) {
        Index& local = local_[vertex];
        if (local < begin || local >= vertices_.size() || vertices_[local] != vertex) {
            local = static_cast<Index>(vertices_.size());
            vertices_.push_back(vertex);
            const glm::vec3& p = positions_[vertex];
            fmt::format_to(std::back_inserter(obj_), "v {} {} {}\n", p.x, p.y, p.z);
        }
        fmt::format_to(std::back_inserter(line), " {}", local + 1);
    }
    obj_.append(line).append("\n");
    polygons_.push_back({face, begin, vertices_.size(), target});
    corner_count_ += corners.size();
    if (corner_count_ >= corners_at_a_time) finish();
}

void PolygonDivider::finish() {
    if (polygons_.empty()) return;
    const std::vector<Index> corners = triangle_corners(obj_, name_);
    auto corner = corners.begin();
    for (const Polygon& polygon : polygons_)
        for (Triangle& triangle : polygon.target)
            for (Index& vertex : triangle) {
                // What cannot be divided is left out, so the next polygon's vertices come too early.
                if (corner == corners.end() || *corner < polygon.begin || *corner >= polygon.end)
                    throw InputError(fmt::format(
                        "{}: face {} (counted from 1): a polygon that cannot be divided into triangles",
                        name_, polygon.face + 1));
                vertex = vertices_[*corner++];
            }
    polygons_.clear();
    vertices_.clear();
    corner_count_ = 0;
    obj_.clear();
}

}  // namespace interleaf
