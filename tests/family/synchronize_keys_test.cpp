#include "family/synchronize_keys.h"

#include <algorithm>

#include "messages.h"
#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "hierarchy/random_surfaces.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// Keys over one random surface, each renumbered at random; the first has no bisections if \p flat.
struct Shuffled {
    std::vector<Key> originals;
    std::vector<Key> keys;
    std::vector<std::vector<Index>> given;
};

Shuffled shuffled_keys(std::uint64_t seed, bool flat) {
    Random random(seed);
    const RootComplex roots = random_surface(static_cast<unsigned>(seed % 4), seed % 3 == 0, random);
    Shuffled result;
    for (int n = 0; n < 4; ++n) {
        Hierarchy key = bisected_key(roots, random);
        if (flat && n == 0) key = unrefined(roots, random_points(random, roots.vertex_count()));
        for (Index v = 0; n > 0 && v < roots.vertex_count(); ++v)
            key.positions[v] = result.originals[0].hierarchy->positions[v] + 0.001F * random.point();
        const std::string name(1, static_cast<char>('a' + n));
        result.originals.push_back({name, key});
        const Renumbering renumbering = random_renumbering(roots, random);
        result.given.push_back(n == 0 ? std::vector<Index>() : renumbering.roots);
        result.keys.push_back({name, n == 0 ? key : renumbered(key, renumbering)});
    }
    return result;
}

bool is_same(const Hierarchy& a, const Hierarchy& b) {
    return a.roots == b.roots && a.bits == b.bits && a.midpoints == b.midpoints && a.positions == b.positions;
}

Hierarchy with_roots(const RootComplex& roots) {
    return unrefined(roots, std::vector<glm::vec3>(roots.vertex_count()));
}

/// The unrefined roots with root \p root bisected.
Hierarchy bisected(const RootComplex& roots, Index root) {
    AdaptiveMesh mesh(roots, std::vector<glm::vec3>(roots.vertex_count()));
    mesh.refine({{root}});
    return mesh.freeze();
}

/// \p roots with another refinement edge in root \p root.
RootComplex marked_otherwise(const RootComplex& roots, Index root) {
    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    std::rotate(triangles[root].begin(), triangles[root].begin() + 1, triangles[root].end());
    return {roots.vertex_count(), std::move(triangles)};
}

}  // namespace

TEST_CASE(
    "keys are put over the roots of the first key, by a found or a given match, and share their memory") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        const Shuffled shuffled = shuffled_keys(seed, seed % 2 == 0);
        for (const bool is_given : {false, true}) {
            std::vector<Key> keys = shuffled.keys;
            const Synchronization result = synchronize(
                keys, is_given ? std::span(shuffled.given) : std::span<const std::vector<Index>>());
            REQUIRE(result.mismatches.empty());
            for (std::size_t n = 0; n < keys.size(); ++n) {
                REQUIRE(is_same(*keys[n].hierarchy, *shuffled.originals[n].hierarchy));
                REQUIRE(keys[n].hierarchy->roots.triangles().data() ==
                        keys[0].hierarchy->roots.triangles().data());
            }
            std::vector<Key> again = keys;
            const Synchronization nothing = synchronize(again);
            REQUIRE(nothing.changes.empty());
            REQUIRE(nothing.mismatches.empty());
        }
    }
}

TEST_CASE("the result has a sentence for each change") {
    Random random(1);
    const RootComplex roots = flipped_at_random(plate(1), 60, random);
    std::vector<Key> keys{{"sphere", bisected(roots, 0)},
                          {"star", renumbered(bisected(roots, 1), random_renumbering(roots, random))},
                          {"same", bisected(roots, 2)},
                          {"flat", with_roots(marked_otherwise(roots, 5))}};
    const Synchronization result = synchronize(keys);
    REQUIRE(result.changes.size() == 2);
    CHECK(result.changes[0] == "key star: its roots were renumbered to match key sphere");
    CHECK(result.changes[1] ==
          "key flat: it has no bisections, so 1 of its 64 roots took other refinement edges");
    for (const Key& key : keys) CHECK(key.hierarchy->roots == roots);
}

TEST_CASE("a first key without bisections gets the marking of the first key with bisections") {
    Random random(2);
    const RootComplex roots = flipped_at_random(plate(1), 60, random);
    const RootComplex marked = marked_otherwise(roots, 3);
    std::vector<Key> keys{{"flat", with_roots(roots)},
                          {"flat too", with_roots(marked_otherwise(roots, 9))},
                          {"star", renumbered(bisected(marked, 7), random_renumbering(roots, random))},
                          {"bone", bisected(marked_otherwise(marked, 12), 0)}};
    const Synchronization result = synchronize(keys);
    for (const std::size_t n : {0U, 1U, 2U}) {
        CHECK(keys[n].hierarchy->roots == marked);
        CHECK(check(*keys[n].hierarchy).empty());
    }
    REQUIRE(result.mismatches.size() == 1);
    CHECK(result.mismatches[0].key == 3);
    CHECK(result.mismatches[0].mismatch.kind == RootMismatch::Kind::refinement_edge);
    CHECK(result.mismatches[0].mismatch.root == 12);
    CHECK(contains(result.mismatches[0].text, "key bone: root 12: its refinement edge ("));
    CHECK(contains(result.mismatches[0].text, "marked as those of key star"));
}

TEST_CASE(
    "two bisected keys with different refinement edges stay unchanged, and the mismatch names the edge") {
    Random random(3);
    const RootComplex roots = flipped_at_random(plate(1), 60, random);
    std::vector<Key> keys{{"sphere", bisected(roots, 0)}, {"star", bisected(marked_otherwise(roots, 4), 0)}};
    const Hierarchy before = *keys[1].hierarchy;
    const Synchronization result = synchronize(keys);
    CHECK(result.changes.empty());
    REQUIRE(result.mismatches.size() == 1);
    CHECK(contains(result.mismatches[0].text, "key star: root 4: its refinement edge ("));
    CHECK(contains(result.mismatches[0].text,
                   " of key sphere's root 4, which is not its refinement edge; both "
                   "keys have bisections, so neither can be marked anew"));
    CHECK(is_same(*keys[1].hierarchy, before));

    const MismatchError error("what is wrong", keys, result.mismatches[0]);
    CHECK(error.what() == std::string("what is wrong"));
    CHECK(error.keys->key.name == "star");
    CHECK(error.keys->key.hierarchy.is_same(keys[1].hierarchy));
    CHECK(error.keys->reference.hierarchy.is_same(keys[0].hierarchy));
    CHECK(error.keys->mismatch.root == 4);
}
