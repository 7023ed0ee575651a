// Normals of morph targets: how near their linear blend comes to the exact normals.
#include "io/gltf/target_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "family/family.h"
#include "hierarchy/vertex_normals.h"
#include "io/family/family_file.h"

namespace interleaf {

namespace {

struct FiveKeys {
    Family family = read_family(INTERLEAF_FIVE_KEYS);
    UnionMesh mesh = unite(family, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}});
    NormalForm form = normal_form(mesh);

    std::size_t key(std::string_view name) const { return find_key(family, name).value(); }

    /// The keys that follow each other in the timeline.
    std::vector<KeyPair> pairs() const {
        std::vector<KeyPair> pairs;
        const auto keys = family.timeline->keys();
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) pairs.push_back({keys[i].key, keys[i + 1].key});
        return pairs;
    }
};

/// The mean angle between the exact normals and the blend of the targets' normals, in degrees.
double mean_angle(const FiveKeys& five, const TargetNormals& normals, const std::vector<float>& weights) {
    const std::vector<glm::vec3> exact = morph_normals(five.form, weights);
    double sum = 0;
    for (std::size_t v = 0; v < exact.size(); ++v) {
        glm::vec3 shown = normals.base[v];
        for (std::size_t key = 0; key < weights.size(); ++key)
            if (!normals.deltas[key].empty()) shown += weights[key] * normals.deltas[key][v];
        const float cosine = glm::dot(glm::normalize(shown), glm::normalize(exact[v]));
        sum += std::acos(std::clamp(double{cosine}, -1.0, 1.0));
    }
    return sum / static_cast<double>(exact.size()) * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE("blended target normals come near the exact ones, at keys and half way between them") {
    const FiveKeys five;
    const TargetNormals normals = target_normals(five.mesh, five.key("star"), five.pairs());
    for (std::size_t key = 0; key < five.mesh.key_count(); ++key) {
        std::vector<float> weights(five.mesh.key_count(), 0);
        weights[key] = 1;
        CHECK(mean_angle(five, normals, weights) < 0.1);  // the tilt
    }
    struct Half {
        const char* first;
        const char* second;
        double angle;
    };
    for (const auto& [first, second, angle] :
         {Half{"star", "cushion", 0.85}, Half{"cushion", "bone", 2.1}, Half{"bone", "icosahedron", 6.8},
          Half{"icosahedron", "sphere", 5.2}, Half{"sphere", "star", 0.3}}) {
        std::vector<float> weights(five.mesh.key_count(), 0);
        weights[five.key(first)] = 0.5F;
        weights[five.key(second)] = 0.5F;
        CAPTURE(first);
        CHECK(mean_angle(five, normals, weights) < angle);
    }
}

TEST_CASE("normals of the base are unit vectors, and no triangle is flat by all its corners") {
    const FiveKeys five;
    const std::size_t base = five.key("icosahedron");
    const TargetNormals normals = target_normals(five.mesh, base, five.pairs());
    for (const glm::vec3& normal : normals.base) CHECK(std::abs(glm::length(normal) - 1) < 1e-6);
    const auto& positions = five.mesh.positions[base];
    for (const Triangle& triangle : five.mesh.triangles) {
        const glm::dvec3 a(positions[triangle[0]]);
        const glm::dvec3 face =
            glm::cross(glm::dvec3(positions[triangle[1]]) - a, glm::dvec3(positions[triangle[2]]) - a);
        CHECK(std::ranges::any_of(triangle, [&](Index v) {
            return glm::dot(glm::dvec3(normals.base[v]), face) < 0.9999995 * glm::length(face);
        }));
    }
}

TEST_CASE("a vertex without area has some unit normal, and finite deltas") {
    const RootComplex roots(3, {{0, 1, 2}});
    const Hierarchy flat = unrefined(roots, std::vector<glm::vec3>(3, glm::vec3(1)));
    const Hierarchy triangle = unrefined(roots, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const UnionMesh mesh = unite(std::vector{&flat, &triangle});
    const std::vector<KeyPair> pairs{{0, 1}};
    for (const std::size_t base : {std::size_t{0}, std::size_t{1}}) {
        const TargetNormals normals = target_normals(mesh, base, pairs);
        for (const glm::vec3& normal : normals.base) CHECK(std::abs(glm::length(normal) - 1) < 1e-6);
        for (const glm::vec3& delta : normals.deltas[1 - base]) CHECK(glm::length(delta) < 1000);
    }
}

}  // namespace interleaf
