#include "io/samples.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "hierarchy/adaptive_mesh.h"

namespace interleaf {

Hierarchy random_hierarchy(std::mt19937& random, bool open, int rounds) {
    std::vector<Triangle> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    if (open) triangles.pop_back();
    const std::vector<glm::vec3> positions{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                           {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    std::uniform_real_distribution<float> offset(-0.1f, 0.1f);
    std::vector<glm::vec3> all = positions;
    const auto midpoint = [&](Index a, Index b, Index) {
        all.push_back(0.5f * (all[a] + all[b]) + glm::vec3(offset(random), offset(random), offset(random)));
        return all.back();
    };
    AdaptiveMesh mesh(RootComplex(6, triangles), positions, midpoint);
    for (int round = 0; round < rounds; ++round) {
        const Index leaf = std::uniform_int_distribution<Index>(0, mesh.leaf_count() - 1)(random);
        mesh.refine({{leaf}});
    }
    return mesh.freeze();
}

Family sample_family(std::mt19937& random) {
    Family family;
    family.name = "A \"family\" \\ of Ü 三";
    family.keys.push_back({"Würfel", random_hierarchy(random, false, 10)});
    family.keys.push_back({"../a b", random_hierarchy(random, false, 20)});
    family.keys.push_back({"..-a-b", random_hierarchy(random, false, 0)});
    family.timeline = Timeline({{0.0, 0}, {0.1, 2}, {1.0 / 3, 1}, {1e9, 0}});
    family.domain = ParameterDomain({{{0, 0}, 0}, {{1, 0.1}, 1}, {{-1.0 / 3, 1}, 2}}, {{0, 1, 2}});
    return family;
}

Hierarchy with_fields(Hierarchy hierarchy, std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<float> part(0, 1);
    for (std::size_t n = 0; n < count; ++n) {
        const bool is_color = random() % 2 == 0;
        Field field{"Größe " + std::to_string(n), is_color ? FieldKind::color : FieldKind::scalar, {}};
        for (std::size_t v = 0; v < component_count(field.kind) * hierarchy.vertex_count(); ++v)
            field.values.push_back(is_color ? part(random) : -1e3f * part(random) * part(random) + 100);
        hierarchy.fields.push_back(std::move(field));
    }
    return hierarchy;
}

bool is_same(const Field& a, const Field& b) {
    return a.label() == b.label() && a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

bool is_same(const Hierarchy& a, const Hierarchy& b) {
    return a.roots == b.roots && a.bits == b.bits && a.midpoints == b.midpoints &&
           a.positions.size() == b.positions.size() &&
           std::memcmp(a.positions.data(), b.positions.data(), a.positions.size() * sizeof(glm::vec3)) == 0 &&
           std::ranges::equal(a.fields, b.fields,
                              [](const Field& f, const Field& g) { return is_same(f, g); });
}

bool is_same(const Family& a, const Family& b) {
    return a.name == b.name && a.timeline == b.timeline && a.domain == b.domain && a.origin == b.origin &&
           std::ranges::equal(a.keys, b.keys, [](const Key& key, const Key& other) {
               return key.name == other.name && is_same(*key.hierarchy, *other.hierarchy);
           });
}

}  // namespace interleaf
