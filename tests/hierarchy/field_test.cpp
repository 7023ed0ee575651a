// Tests that fields follow the vertices: a field that holds a coordinate still holds it after every operation
// on a key.
#include "hierarchy/field.h"

#include <algorithm>
#include <limits>
#include <string>

#include "messages.h"
#include "not_utf8.h"
#include <doctest/doctest.h>
#include <glm/common.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/color.h"
#include "hierarchy/morph.h"
#include "hierarchy/random_families.h"
#include "hierarchy/union_fields.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};

/// One scalar field per coordinate.
std::vector<Field> coordinates(std::span<const glm::vec3> positions) {
    std::vector<Field> fields;
    for (int axis = 0; axis < 3; ++axis) {
        Field field{axis_names[static_cast<std::size_t>(axis)], FieldKind::scalar, {}};
        for (const glm::vec3& p : positions) field.values.push_back(p[axis]);
        fields.push_back(std::move(field));
    }
    return fields;
}

bool are_coordinates(std::span<const Field> fields, std::span<const glm::vec3> positions) {
    const std::vector<Field> expected = coordinates(positions);
    return std::ranges::equal(fields, expected, [](const Field& a, const Field& b) {
        return a.label() == b.label() && a.values == b.values;
    });
}

/// A family whose keys have their coordinates as fields.
RandomFamily with_coordinates(RandomFamily family) {
    for (Hierarchy& key : family.keys) key.fields = coordinates(key.positions);
    return family;
}

Field random_field(FieldKind kind, std::size_t vertex_count, Random& random) {
    Field field{kind == FieldKind::color ? "color" : "scalar", kind, {}};
    for (std::size_t n = 0; n < component_count(kind) * vertex_count; ++n)
        field.values.push_back(static_cast<float>(random.unit()));
    return field;
}

glm::vec3 vector_at(std::span<const float> values, std::size_t vertex) {
    return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
}

std::vector<float> random_weights(std::size_t count, Random& random) {
    std::vector<float> weights;
    for (std::size_t n = 0; n < count; ++n) weights.push_back(static_cast<float>(4 * random.unit() - 2));
    return weights;
}

}  // namespace

TEST_CASE("fields that hold the coordinates equal the coordinates of every union and morph, bit for bit") {
    for (const std::size_t key_count : {1u, 2u, 3u, 6u})
        for_random_families(2000, key_count, [&](const RandomFamily& plain) {
            CAPTURE(plain.seed);
            const RandomFamily family = with_coordinates(plain);
            UnionMesh mesh = unite(family.key_pointers());
            unite_fields(family.key_pointers(), mesh);
            REQUIRE(mesh.fields.size() == 3);
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (std::size_t key = 0; key < key_count; ++key)
                    REQUIRE(mesh.fields[axis].values[key] == coordinates(mesh.positions[key])[axis].values);

            Random random(family.seed);
            const std::vector<float> weights = random_weights(key_count, random);
            const Buffer<glm::vec3> positions = morph(mesh, weights);
            for (std::size_t axis = 0; axis < 3; ++axis)
                REQUIRE(morphed_field(mesh.fields[axis], weights).values ==
                        coordinates(positions)[axis].values);
            const Hierarchy key = morphed_hierarchy(mesh, weights);
            REQUIRE(check(key) == std::vector<std::string>{});
            REQUIRE(are_coordinates(key.fields, key.positions));
        });
}

TEST_CASE("fields that hold the coordinates equal the coordinates of a frozen mesh, even after coarsening") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_roots(random);
        std::vector<glm::vec3> points = random_points(random, roots.vertex_count());
        std::vector<Field> fields = coordinates(points);
        AdaptiveMesh mesh(roots, std::move(points), [&](Index, Index, Index midpoint) {
            const glm::vec3 point = random.point();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                fields[axis].values.resize(std::max<std::size_t>(fields[axis].values.size(), midpoint + 1));
                fields[axis].values[midpoint] = point[static_cast<int>(axis)];
            }
            return point;
        });
        refine_at_random(mesh, random, 4, 100);
        std::vector<Index> marked;
        for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf)
            if (random.chance(0.6)) marked.push_back(leaf);
        mesh.coarsen(marked);
        const Hierarchy key = mesh.freeze(fields);
        REQUIRE(check(key) == std::vector<std::string>{});
        REQUIRE(are_coordinates(key.fields, key.positions));
        REQUIRE(mesh.freeze().fields.empty());
    }
}

TEST_CASE("values that are independent of positions follow the rule of the union literally") {
    for_random_families(3000, 3, [](const RandomFamily& plain) {
        CAPTURE(plain.seed);
        RandomFamily family = plain;
        Random random(family.seed);
        for (Hierarchy& key : family.keys)
            for (const FieldKind kind : {FieldKind::scalar, FieldKind::color})
                key.fields.push_back(random_field(kind, key.vertex_count(), random));
        UnionMesh mesh = unite(family.key_pointers());
        unite_fields(family.key_pointers(), mesh);
        REQUIRE(mesh.fields.size() == 2);
        for (std::size_t key = 0; key < 3; ++key) {
            const Buffer<float>& scalars = mesh.fields[0].values[key];
            const Buffer<float>& colors = mesh.fields[1].values[key];
            REQUIRE(scalars.size() == mesh.vertex_count());
            REQUIRE(colors.size() == 3 * mesh.vertex_count());
            for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
                if ((mesh.vertices[v].keys & key_bit(key)) != 0) continue;
                const auto [a, b] = mesh.vertices[v].edge;
                REQUIRE(scalars[v] == (scalars[a] + scalars[b]) * 0.5F);
                REQUIRE(vector_at(colors, v) == (vector_at(colors, a) + vector_at(colors, b)) * 0.5F);
            }
            const std::vector<Field>& own = family.keys[key].fields;
            for (std::size_t v = 0; v < family.keys[key].vertex_count(); ++v) {
                const Index at = mesh.own_vertices[key][v];
                REQUIRE(scalars[at] == own[0].values[v]);
                REQUIRE(vector_at(colors, at) == linear_light(vector_at(own[1].values, v)));
            }
        }
    });
}

TEST_CASE("colors are mixed as light and clamped to 0 to 1") {
    for_random_families(1500, 3, [](const RandomFamily& plain) {
        CAPTURE(plain.seed);
        RandomFamily family = plain;
        Random random(family.seed);
        for (Hierarchy& key : family.keys)
            key.fields.push_back(random_field(FieldKind::color, key.vertex_count(), random));
        UnionMesh mesh = unite(family.key_pointers());
        unite_fields(family.key_pointers(), mesh);
        const std::vector<float> weights = random_weights(3, random);
        const Field morphed = morphed_field(mesh.fields[0], weights);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            glm::vec3 light(0);
            for (std::size_t key = 0; key < 3; ++key)
                light += weights[key] * vector_at(mesh.fields[0].values[key], v);
            const glm::vec3 expected = glm::clamp(light, 0.0F, 1.0F);
            const glm::vec3 found = linear_light(vector_at(morphed.values, v));
            REQUIRE(glm::all(glm::lessThan(glm::abs(found - expected), glm::vec3(1e-5F))));
        }
        REQUIRE(check(morphed_hierarchy(mesh, weights)) == std::vector<std::string>{});
    });
}

TEST_CASE("encoding and its inverse agree, and half the light is encoded as 188 of 255") {
    CHECK(encoded(glm::vec3(0.5F)).r * 255 == doctest::Approx(187.516));
    for (int n = 0; n <= 255; ++n) {
        const float part = static_cast<float>(n) / 255;
        CHECK(encoded(linear_light(glm::vec3(part))).g == doctest::Approx(part).epsilon(1e-5));
    }
}

TEST_CASE("the union has exactly the fields that all keys have with the same name and kind") {
    RandomFamily family = random_family(7, 3);
    Random random(7);
    const auto field = [&](std::string name, FieldKind kind, const Hierarchy& key) {
        Field made = random_field(kind, key.vertex_count(), random);
        made.name = std::move(name);
        return made;
    };
    for (Hierarchy& key : family.keys) {
        key.fields.push_back(field("shared", FieldKind::scalar, key));
        key.fields.push_back(field("all", FieldKind::color, key));
    }
    std::swap(family.keys[1].fields[0], family.keys[1].fields[1]);
    family.keys[0].fields.insert(family.keys[0].fields.begin(),
                                 field("first", FieldKind::scalar, family.keys[0]));
    for (std::size_t key = 0; key < 3; ++key)
        family.keys[key].fields.push_back(
            field("kinds", key == 1 ? FieldKind::color : FieldKind::scalar, family.keys[key]));
    const auto pointers = family.key_pointers();
    const std::vector<FieldName> expected = {{"shared", FieldKind::scalar}, {"all", FieldKind::color}};
    CHECK(common_fields(pointers) == expected);
    UnionMesh mesh = unite(pointers);
    CHECK(mesh.fields.empty());
    unite_fields(pointers, mesh);
    REQUIRE(mesh.fields.size() == 2);
    CHECK(mesh.fields[1].label == expected[1]);
    unite(pointers, mesh);  // reuses the memory
    CHECK(mesh.fields.empty());
}

TEST_CASE("fields of more keys than a key set has bits are united as well") {
    Random random(5);
    RandomFamily family{5, Marking::random, octahedron(), {}};
    for (unsigned n = 0; n < 80; ++n) family.keys.push_back(random_key(family.roots, random));
    family = with_coordinates(family);
    UnionMesh mesh = unite(family.key_pointers());
    unite_fields(family.key_pointers(), mesh);
    for (std::size_t key = 0; key < family.keys.size(); ++key)
        REQUIRE(mesh.fields[1].values[key] == coordinates(mesh.positions[key])[1].values);
}

TEST_CASE("a field's name is printable UTF-8 of 1 to 255 bytes") {
    for (const std::string name :
         {"T", "height", "Höhe über NN", "三", "a b", "\xf0\x9f\x8c\x8d", "\xc2\xa0"}) {
        CAPTURE(name);
        CHECK(is_field_name(name));
    }
    CHECK(is_field_name(std::string(255, 'a')));
    CHECK_FALSE(is_field_name(std::string(256, 'a')));
    CHECK_FALSE(is_field_name(""));
    CHECK_FALSE(is_field_name(std::string_view("a\0b", 3)));
    for (const std::string name : {"a\nb", "\x1b[2J", "\x7f", "\u0080", "\u009b31m"}) {
        CAPTURE(name);
        CHECK_FALSE(is_field_name(name));
    }
    for (const std::string& name : not_utf8) {
        CAPTURE(name);
        CHECK_FALSE(is_field_name(name));
        CHECK_FALSE(is_field_name("a" + name));
    }
}

TEST_CASE("the checker names the fault of a field") {
    Hierarchy sound = random_family(3, 1).keys[0];
    Random random(3);
    sound.fields = coordinates(sound.positions);
    sound.fields.push_back(random_field(FieldKind::color, sound.vertex_count(), random));
    REQUIRE(check(sound) == std::vector<std::string>{});
    const auto with = [&](auto&& change) {
        Hierarchy key = sound;
        change(key.fields);
        return check(key);
    };
    using Fields = std::vector<Field>;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    CHECK(mentions(with([](Fields& f) { f[1].values[2] = nan; }), "field \"y\" is nan at vertex 2"));
    CHECK(mentions(with([](Fields& f) { f[1].values[2] = -infinity; }), "field \"y\" is -inf at vertex 2"));
    CHECK(mentions(with([](Fields& f) { f[3].values[7] = 1.5F; }), "field \"color\" is 1.5 at vertex 2"));
    CHECK(mentions(with([](Fields& f) { f[3].values[6] = -0.5F; }), "field \"color\" is -0.5 at vertex 2"));
    CHECK(mentions(with([](Fields& f) { f[3].values[0] = nan; }), "field \"color\" is nan at vertex 0"));
    CHECK(mentions(with([](Fields& f) { f[0].values.push_back(0); }), "field \"x\" has "));
    CHECK(mentions(with([](Fields& f) { f[3].values.pop_back(); }), "field \"color\" has "));
    CHECK(mentions(with([](Fields& f) { f[2].name = "x"; }), "two fields are called \"x\""));
    CHECK(mentions(with([](Fields& f) { f[2].name = ""; }), "the name of field 2"));
    CHECK(mentions(with([](Fields& f) { f[2].name = "a\nb"; }), "the name of field 2"));
    CHECK(mentions(with([](Fields& f) { f[0].kind = static_cast<FieldKind>(2); }), "is of kind 2"));
    const auto most = with([](Fields& f) {
        while (f.size() < 64) f.push_back({"f" + std::to_string(f.size()), f[0].kind, f[0].values});
    });
    CHECK(most == std::vector<std::string>{});
    const auto too_many = with([](Fields& f) {
        while (f.size() < 65) f.push_back({"f" + std::to_string(f.size()), f[0].kind, f[0].values});
    });
    CHECK(mentions(too_many, "there are 65 fields, expected at most 64"));
}
