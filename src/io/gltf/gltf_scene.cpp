#include "io/gltf/gltf_scene.h"

#include <array>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

namespace {

template <std::size_t count>
std::array<double, count> numbers_at(const JsonPlace& place) {
    if (place.size() != count) place.fail_expecting("an array of " + std::to_string(count) + " numbers");
    std::array<double, count> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers[i] = place.element(i).number();
    return numbers;
}

/// The matrix of a node: given, or from translation, rotation and scale.
glm::dmat4 matrix_of(const JsonPlace& node) {
    glm::dmat4 matrix(1);
    if (const auto given = node.optional_member("matrix")) {
        const auto numbers = numbers_at<16>(*given);
        for (glm::length_t column = 0; column < 4; ++column)
            for (glm::length_t row = 0; row < 4; ++row)
                matrix[column][row] =
                    numbers[4 * static_cast<std::size_t>(column) + static_cast<std::size_t>(row)];
        return matrix;
    }
    if (const auto given = node.optional_member("translation")) {
        const auto [x, y, z] = numbers_at<3>(*given);
        matrix = glm::translate(matrix, glm::dvec3(x, y, z));
    }
    if (const auto given = node.optional_member("rotation")) {
        const auto [x, y, z, w] = numbers_at<4>(*given);
        matrix *= glm::dmat4(glm::mat3_cast(glm::dquat(w, x, y, z)));
    }
    if (const auto given = node.optional_member("scale")) {
        const auto [x, y, z] = numbers_at<3>(*given);
        matrix = glm::scale(matrix, glm::dvec3(x, y, z));
    }
    return matrix;
}

/// A node that waits, with the matrix of its parent.
struct Waiting {
    std::size_t node;
    glm::dmat4 parent;
};

/// Puts the nodes of the array \p member of \p place on the stack, the first on top.
void push_nodes(const JsonPlace& place, std::string_view member, const glm::dmat4& parent,
                std::size_t node_count, std::vector<Waiting>& stack) {
    const auto nodes = place.optional_member(member);
    for (std::size_t i = nodes ? nodes->size() : 0; i-- > 0;)
        stack.push_back({nodes->element(i).index_below(node_count), parent});
}

/// The nodes where the walk begins.
std::vector<Waiting> first_nodes(const GltfFile& file, std::size_t node_count) {
    std::vector<Waiting> stack;
    if (const std::size_t scenes = file.count("scenes"); scenes > 0) {
        const auto shown = file.root().optional_member("scene");
        push_nodes(file.element("scenes", shown ? shown->index_below(scenes) : 0), "nodes", glm::dmat4(1),
                   node_count, stack);
        return stack;
    }
    std::vector<bool> is_child(node_count, false);
    std::vector<Waiting> children;
    for (std::size_t n = 0; n < node_count; ++n)
        push_nodes(file.element("nodes", n), "children", glm::dmat4(1), node_count, children);
    for (const Waiting& child : children) is_child[child.node] = true;
    for (std::size_t n = node_count; n-- > 0;)
        if (!is_child[n]) stack.push_back({n, glm::dmat4(1)});
    return stack;
}

}  // namespace

std::vector<MeshInstance> mesh_instances(const GltfFile& file) {
    const std::size_t node_count = file.count("nodes");
    const std::size_t mesh_count = file.count("meshes");
    std::vector<MeshInstance> instances;
    if (node_count == 0) {
        for (std::size_t mesh = 0; mesh < mesh_count; ++mesh) instances.push_back({mesh, glm::dmat4(1)});
        return instances;
    }
    std::vector<bool> is_visited(node_count, false);
    std::vector<Waiting> stack = first_nodes(file, node_count);
    while (!stack.empty()) {
        const auto [number, parent] = stack.back();
        stack.pop_back();
        const JsonPlace node = file.element("nodes", number);
        if (is_visited[number]) node.fail("has two parents, or is its own");
        is_visited[number] = true;
        const glm::dmat4 matrix = parent * matrix_of(node);
        if (const auto mesh = node.optional_member("mesh"))
            instances.push_back({mesh->index_below(mesh_count), matrix});
        push_nodes(node, "children", matrix, node_count, stack);
    }
    return instances;
}

}  // namespace interleaf
