#include "app/pictures/mismatch_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/pictures/tube.h"
#include "hierarchy/color.h"
#include "hierarchy/leaf_path.h"
#include "render/palette.h"
#include "render/pick.h"

namespace interleaf {

namespace {

/// The radius of tube and ball, as a part of their distance from the eye.
constexpr float tube_radius = 0.006F;
constexpr float ball_radius = 0.014F;

/// Part of the picture's half height that a root fills, from its middle to its corners.
constexpr float min_reach = 0.45F;
constexpr float max_reach = 0.75F;

/// The number of triangles examined to find a view: about one second of work.
constexpr std::size_t max_tests = 100'000'000;

std::vector<std::size_t> leaves_in(const UnionMesh& mesh, Index root) {
    const std::vector<LeafPath> paths = leaf_paths(mesh.tags);
    std::vector<std::size_t> leaves;
    for (std::size_t leaf = 0; leaf < paths.size(); ++leaf)
        if (paths[leaf].root == root) leaves.push_back(leaf);
    return leaves;
}

/// The vertices along the edge \p ends of a root with the leaves \p leaves, from end to end.
class EdgeWay {
  public:
    EdgeWay(const UnionMesh& mesh, std::span<const std::size_t> leaves, RootMismatch::Edge ends) {
        for (const std::size_t leaf : leaves)
            for (const Index vertex : mesh.triangles[leaf])
                if (const auto& edge = mesh.vertices[vertex].edge; edge[0] != no_index)
                    midpoints_[std::minmax(edge[0], edge[1])] = vertex;
        vertices_.push_back(ends[0]);
        go(ends[0], ends[1]);
    }
    std::vector<Index> vertices() && { return std::move(vertices_); }

  private:
    void go(Index from, Index to) {
        const auto middle = midpoints_.find(std::minmax(from, to));
        if (middle == midpoints_.end()) {
            vertices_.push_back(to);
        } else {
            go(from, middle->second);
            go(middle->second, to);
        }
    }

    std::map<std::pair<Index, Index>, Index> midpoints_;
    std::vector<Index> vertices_;
};

/// About \p most elements of \p all, evenly spread from the first to the last.
template <typename T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
    if (all.size() <= most) return all;
    std::vector<T> some;
    some.reserve(most);
    for (std::size_t n = 0; n < most; ++n) some.push_back(all[n * (all.size() - 1) / (most - 1)]);
    return some;
}

/// The part of a key that the picture must show.
struct Subject {
    std::vector<std::size_t> leaves;  ///< of the root
    std::vector<glm::vec3> line;      ///< the edge, or the vertex alone; may be empty
    std::vector<glm::vec3> points;    ///< some of the line and of the root
    glm::vec3 middle{0};              ///< of the line, or of the root
    glm::vec3 normal{0};              ///< of the root
    float reach = 0;                  ///< from the middle to the farthest point of the root
};

Subject subject_in(const UnionMesh& mesh, const RootPlace& place) {
    Subject subject;
    subject.leaves = leaves_in(mesh, place.root);
    const auto& positions = mesh.positions.front();
    if (place.vertex != no_index) subject.line = {positions[place.vertex]};
    if (place.edge[0] != no_index)
        for (const Index vertex : EdgeWay(mesh, subject.leaves, place.edge).vertices())
            subject.line.push_back(positions[vertex]);
    subject.points = some_of(subject.line, 5);
    std::vector<glm::vec3> centers;
    for (const std::size_t leaf : subject.leaves) {
        const auto& [a, b, c] = mesh.triangles[leaf];
        centers.push_back((positions[a] + positions[b] + positions[c]) / 3.0F);
        subject.normal += glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
    }
    const std::vector<glm::vec3> some_centers = some_of(centers, 5);
    subject.points.insert(subject.points.end(), some_centers.begin(), some_centers.end());
    subject.middle =
        subject.line.empty() ? centers[centers.size() / 2] : subject.line[subject.line.size() / 2];
    for (const std::size_t leaf : subject.leaves)
        for (const Index vertex : mesh.triangles[leaf])
            subject.reach = std::max(subject.reach, glm::distance(positions[vertex], subject.middle));
    return subject;
}

/// Viewing directions: along the normal, then ever more slanted around it, then from behind.
std::vector<glm::vec3> directions_about(glm::vec3 normal) {
    const glm::vec3 axis = normalized_or(normal, {0, 0, 1});
    const glm::vec3 across = any_perpendicular(axis);
    const glm::vec3 up = glm::cross(axis, across);
    std::vector<glm::vec3> directions{axis};
    for (const float slant : {30.0F, 60.0F})
        for (int n = 0; n < 8; ++n) {
            const float angle = static_cast<float>(n) * std::numbers::pi_v<float> / 4;
            const glm::vec3 aside = std::cos(angle) * across + std::sin(angle) * up;
            directions.push_back(std::cos(glm::radians(slant)) * axis +
                                 std::sin(glm::radians(slant)) * aside);
        }
    directions.push_back(-axis);
    return directions;
}

Camera looking_at(const Subject& subject, glm::vec3 from, const Extent& extent, float aspect) {
    Camera camera;
    camera.look_from(glm::degrees(std::atan2(from.x, from.z)),
                     glm::degrees(std::asin(std::clamp(from.y, -1.0F, 1.0F))));
    camera.view_all(extent, aspect);
    camera.center(subject.middle);
    const float seen = std::tan(glm::radians(vertical_field_degrees / 2)) *
                       glm::distance(camera.eye(), subject.middle) * std::min(aspect, 1.0F);
    if (!(subject.reach > 0)) return camera;
    const float nearer = seen / subject.reach;
    camera.approach(std::clamp(1.0F, min_reach * nearer, max_reach * nearer), subject.middle);
    return camera;
}

/// The number of the subject's points that nothing hides.
std::size_t seen_points(const UnionMesh& mesh, const Subject& subject, glm::vec3 eye, float slack) {
    const auto& positions = mesh.positions.front();
    return static_cast<std::size_t>(std::ranges::count_if(subject.points, [&](glm::vec3 point) {
        const auto hit = first_hit(mesh.triangles, positions, {eye, point});
        if (!hit) return true;
        const auto& [a, b, c] = mesh.triangles[hit->triangle];
        const glm::vec3 place = hit->barycentric.x * positions[a] + hit->barycentric.y * positions[b] +
                                hit->barycentric.z * positions[c];
        return glm::distance(place, point) <= slack;
    }));
}

Camera best_view(const UnionMesh& mesh, const Subject& subject, const Extent& extent, float aspect) {
    std::vector<glm::vec3> directions = directions_about(subject.normal);
    const std::size_t affordable = max_tests / (mesh.leaf_count() * subject.points.size());
    directions.resize(std::clamp<std::size_t>(affordable, 1, directions.size()));
    Camera best;
    std::size_t most = 0;
    for (const glm::vec3 from : directions) {
        const Camera camera = looking_at(subject, from, extent, aspect);
        const std::size_t seen = seen_points(mesh, subject, camera.eye(), 1e-4F * extent.radius);
        if (from == directions.front() || seen > most) {
            best = camera;
            most = seen;
        }
        if (most == subject.points.size()) break;
    }
    return best;
}

void append_color(Buffer<float>& values, glm::vec3 color) {
    const glm::vec3 light = linear_light(color);
    values.insert(values.end(), {light.r, light.g, light.b});
}

/// Gives the leaves of the root separate vertices in the root's color.
void fill_root(MismatchPicture& picture, std::span<const std::size_t> leaves) {
    UnionMesh& mesh = picture.mesh;
    std::map<Index, Index> own;
    for (const std::size_t leaf : leaves)
        for (Index& vertex : mesh.triangles[leaf]) {
            const auto [found, is_new] = own.emplace(vertex, static_cast<Index>(mesh.vertex_count()));
            if (is_new) {
                mesh.positions.front().push_back(glm::vec3(mesh.positions.front()[vertex]));
                mesh.vertices.push_back(VertexOrigin(mesh.vertices[vertex]));
                picture.form.products.push_back(glm::vec3(picture.form.products[vertex]));
                append_color(picture.colors.values.front(), mismatch_root_color);
            }
            vertex = found->second;
        }
}

void append_tube(MismatchPicture& picture, const Tube& tube) {
    UnionMesh& mesh = picture.mesh;
    const auto first = static_cast<Index>(mesh.vertex_count());
    for (std::size_t vertex = 0; vertex < tube.positions.size(); ++vertex) {
        mesh.positions.front().push_back(tube.positions[vertex]);
        mesh.vertices.push_back({{no_index, no_index}, key_bit(0)});
        picture.form.products.push_back(tube.normals[vertex]);
        append_color(picture.colors.values.front(), mismatch_edge_color);
    }
    for (const auto& [a, b, c] : tube.triangles) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.tags.push_back(LeafTag(0, 0, {0, 0, 0}));
        mesh.origins.push_back(key_bit(0));
    }
}

}  // namespace

RootPlace place_in_key(const RootMismatch& mismatch) {
    return {mismatch.root, mismatch.edge, mismatch.vertex};
}

RootPlace place_in_reference(const RootMismatch& mismatch) {
    return {mismatch.reference_root, mismatch.reference_edge, mismatch.reference_vertex};
}

std::string caption_of(const std::string& name, const RootPlace& place) {
    if (place.root == no_index) return name;
    std::string caption = fmt::format("{}: root {}", name, place.root);
    if (place.edge[0] != no_index) caption += fmt::format(", edge ({}, {})", place.edge[0], place.edge[1]);
    if (place.vertex != no_index) caption += fmt::format(", vertex {}", place.vertex);
    return caption;
}

MismatchPicture mismatch_picture(const Hierarchy& key, const RootPlace& place, float aspect) {
    const std::array<const Hierarchy*, 1> keys{&key};
    MismatchPicture picture{.mesh = unite(keys), .form = {}, .colors = {}, .leaf_count = 0, .camera = {}};
    picture.form = normal_form(picture.mesh);
    picture.leaf_count = picture.mesh.leaf_count();
    picture.colors.label = {"mismatch", FieldKind::color};
    picture.colors.values.emplace_back();
    for (std::size_t vertex = 0; vertex < picture.mesh.vertex_count(); ++vertex)
        append_color(picture.colors.values.front(), plain_color);

    const Extent extent = extent_of(key.positions);
    if (place.root == no_index) {
        picture.camera.look_from(30, 20);
        picture.camera.view_all(extent, aspect);
        return picture;
    }
    const Subject subject = subject_in(picture.mesh, place);
    picture.camera = best_view(picture.mesh, subject, extent, aspect);
    fill_root(picture, subject.leaves);
    if (!subject.line.empty()) {
        const float radius = subject.line.size() == 1 ? ball_radius : tube_radius;
        append_tube(picture,
                    tube_along(subject.line, radius * glm::distance(picture.camera.eye(), subject.middle)));
    }
    return picture;
}

}  // namespace interleaf
