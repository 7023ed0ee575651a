#include "hierarchy/matching/synchronize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "trials.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/random_surfaces.h"
#include "hierarchy/union_mesh.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

using Kind = RootMismatch::Kind;
using Points = std::vector<glm::vec3>;

std::variant<RootMatch, RootMismatch> matched(const Hierarchy& reference, const Hierarchy& key,
                                              const RootMatchOptions& options = {}) {
    return match_roots(placed_roots(reference), placed_roots(key), options);
}

std::optional<RootMatch> match_of(const Hierarchy& reference, const Hierarchy& key,
                                  const RootMatchOptions& options = {}) {
    const auto result = matched(reference, key, options);
    if (const auto* match = std::get_if<RootMatch>(&result)) return *match;
    return std::nullopt;
}

RootMismatch mismatch_of(const Hierarchy& reference, const Hierarchy& key,
                         const RootMatchOptions& options = {}) {
    const auto result = matched(reference, key, options);
    REQUIRE(std::holds_alternative<RootMismatch>(result));
    return std::get<RootMismatch>(result);
}

std::string text_of(const RootMismatch& mismatch) {
    return interleaf::text_of(mismatch, "star", "sphere");
}

/// The leaves of the union of two keys, each corner with its positions in both.
using Corner = std::array<float, 6>;
std::multiset<std::array<Corner, 3>> union_triangles(const Hierarchy& a, const Hierarchy& b) {
    const UnionMesh mesh = unite(std::vector<const Hierarchy*>{&a, &b});
    std::multiset<std::array<Corner, 3>> result;
    for (const Triangle& triangle : mesh.triangles) {
        std::array<Corner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = mesh.positions[0][triangle[k]], q = mesh.positions[1][triangle[k]];
            corners[k] = {p.x, p.y, p.z, q.x, q.y, q.z};
        }
        result.insert(corners);
    }
    return result;
}

/// Moves the root vertices of \p key near those of \p reference, so that no other match is as close.
void move_near(Hierarchy& key, const Hierarchy& reference, Random& random) {
    for (Index v = 0; v < reference.roots.vertex_count(); ++v)
        key.positions[v] = reference.positions[v] + 0.001F * random.point();
}

bool is_same_key(const Hierarchy& a, const Hierarchy& b) {
    return a.roots == b.roots && a.bits == b.bits && a.midpoints == b.midpoints && a.positions == b.positions;
}

double distance_of(const RootMatch& match, const Hierarchy& reference, const Hierarchy& key) {
    double sum = 0;
    for (std::size_t v = 0; v < match.vertices.size(); ++v) {
        const glm::dvec3 way =
            glm::dvec3(reference.positions[v]) - glm::dvec3(key.positions[match.vertices[v]]);
        sum += glm::dot(way, way);
    }
    return sum;
}

/// The literal search over connected complexes: it tries each image of root 0, and extends it along directed
/// edges.
/// \return the minimum sum of squared distances; none if there is no isomorphism
std::optional<double> literal_least_distance(const Hierarchy& reference, const Hierarchy& key, bool marked) {
    const auto apexes = [](const RootComplex& roots) {
        std::map<std::array<Index, 2>, Index> result;
        for (const Triangle& triangle : roots.triangles())
            for (std::size_t k = 0; k < 3; ++k)
                result[{triangle[(k + 1) % 3], triangle[(k + 2) % 3]}] = triangle[k];
        return result;
    };
    if (reference.roots.triangle_count() != key.roots.triangle_count()) return std::nullopt;
    const auto ours = apexes(reference.roots), theirs = apexes(key.roots);
    const std::set<Triangle> key_triangles(key.roots.triangles().begin(), key.roots.triangles().end());
    std::optional<double> least;
    const Triangle& seed = reference.roots.triangles()[0];
    for (const Triangle& triangle : key.roots.triangles())
        for (std::size_t turn = 0; turn < 3; ++turn) {
            std::map<Index, Index> image;
            for (std::size_t k = 0; k < 3; ++k) image[seed[k]] = triangle[(k + turn) % 3];
            bool fits = true;
            for (bool grows = true; grows && fits;) {
                grows = false;
                for (const auto& [edge, apex] : ours) {
                    if (!image.contains(edge[0]) || !image.contains(edge[1])) continue;
                    const auto found = theirs.find({image[edge[0]], image[edge[1]]});
                    if (found == theirs.end()) {
                        fits = false;
                        break;
                    }
                    grows = image.emplace(apex, found->second).second || grows;
                }
            }
            std::set<Triangle> images;
            for (const Triangle& t : reference.roots.triangles()) {
                Triangle mapped{image[t[0]], image[t[1]], image[t[2]]};
                for (std::size_t k = 0; k < 3 && !marked && !key_triangles.contains(mapped); ++k)
                    std::rotate(mapped.begin(), mapped.begin() + 1, mapped.end());
                images.insert(mapped);
            }
            if (!fits || images != key_triangles) continue;
            double sum = 0;
            for (const auto& [from, to] : image) {
                const glm::dvec3 way = glm::dvec3(reference.positions[from]) - glm::dvec3(key.positions[to]);
                sum += glm::dot(way, way);
            }
            if (!least || sum < *least) least = sum;
        }
    return least;
}

/// Unrefined, with random positions.
Hierarchy scattered(const RootComplex& roots, Random& random) {
    return unrefined(roots, random_points(random, roots.vertex_count()));
}

}  // namespace

TEST_CASE(
    "synchronizing a renumbered key restores its union with the reference, 1,000 random surfaces of genus 0 "
    "to 3, open and closed") {
    std::map<int, unsigned> closed_seen, open_seen;
    for (std::uint64_t seed = 1; seed <= trials(1000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const auto genus = static_cast<unsigned>(seed % 4);
        const bool open = seed / 4 % 2 == 1;
        RootComplex roots = random_surface(genus, open, random);
        if (!open) REQUIRE(roots.euler_number() == 2 - 2 * static_cast<int>(genus));
        ++(open ? open_seen : closed_seen)[static_cast<int>(genus)];
        if (random.chance(0.2)) roots = side_by_side(roots, random_surface(0, random.chance(0.5), random));
        const Hierarchy reference = bisected_key(roots, random);
        Hierarchy key = bisected_key(roots, random);
        move_near(key, reference, random);

        const Hierarchy shuffled = renumbered(key, random_renumbering(roots, random));
        REQUIRE(check(shuffled) == std::vector<std::string>{});
        const std::optional<RootMatch> match = match_of(reference, shuffled);
        REQUIRE(match);
        const Hierarchy synchronized = with_roots_of(reference.roots, shuffled, *match);
        REQUIRE(check(synchronized) == std::vector<std::string>{});
        REQUIRE(synchronized.roots == reference.roots);
        REQUIRE(union_triangles(reference, synchronized) == union_triangles(reference, key));
        REQUIRE(is_same_key(synchronized, key));
    }
    for (int genus = 0; genus < 4; ++genus) {
        CHECK(closed_seen[genus] >= trials(125));
        CHECK(open_seen[genus] >= trials(125));
    }
}

TEST_CASE(
    "the search finds the closest of all isomorphisms, like the literal search, even of symmetric "
    "complexes") {
    std::size_t symmetric = 0;
    for (std::uint64_t seed = 1; seed <= trials(600); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const std::array<RootComplex, 6> shapes = {tetrahedron(), octahedron(), plate(0),
                                                   torus(3, 3),   torus(4, 3),  sheet(2, 2)};
        RootComplex roots = shapes[seed % 6];
        const bool is_marked = random.chance(0.5);
        if (random.chance(0.3)) roots = marked(roots, Marking::random, random);
        const Hierarchy reference = scattered(roots, random);
        const Hierarchy key = scattered(renumbered(roots, random_renumbering(roots, random)), random);
        const std::optional<RootMatch> match = match_of(reference, key, {.marked = is_marked});
        const std::optional<double> least = literal_least_distance(reference, key, is_marked);
        REQUIRE(match);
        REQUIRE(least);
        REQUIRE(distance_of(*match, reference, key) == doctest::Approx(*least));
        const RootMatch identity = [&] {
            RootMatch result = *match;
            std::iota(result.vertices.begin(), result.vertices.end(), Index{0});
            return result;
        }();
        symmetric += distance_of(identity, reference, key) != doctest::Approx(*least) ? 1 : 0;
    }
    CHECK(symmetric > trials(100));
}

TEST_CASE("two random surfaces match exactly if the literal search finds an isomorphism") {
    std::size_t matches = 0;
    for (std::uint64_t seed = 1; seed <= trials(1000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots =
            marked(random.chance(0.5) ? octahedron() : torus(3, 3), Marking::random, random);
        RootComplex other = roots;
        switch (random.below(4)) {
            case 0:
                other = mirrored(roots);
                break;
            case 1:
                other = flipped_at_random(roots, 1, random);
                break;
            case 2: {
                std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
                Triangle& triangle = triangles[random.below(triangles.size())];
                std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
                other = RootComplex(roots.vertex_count(), triangles);
                break;
            }
            default:
                break;
        }
        const bool is_marked = random.chance(0.7);
        const Hierarchy reference = scattered(roots, random);
        const Hierarchy key = scattered(renumbered(other, random_renumbering(other, random)), random);
        const bool expected = literal_least_distance(reference, key, is_marked).has_value();
        REQUIRE(match_of(reference, key, {.marked = is_marked}).has_value() == expected);
        matches += expected ? 1 : 0;
    }
    CHECK(matches > trials(200));
    CHECK(matches < 800);
}

TEST_CASE("moving a key as a whole does not change its match") {
    Random random(7);
    const Hierarchy reference = scattered(torus(4, 4), random);
    Hierarchy key = reference;
    for (glm::vec3& p : key.positions) p += glm::vec3(100, -20, 3);
    const Renumbering renumbering = random_renumbering(key.roots, random);
    const std::optional<RootMatch> match = match_of(reference, renumbered(key, renumbering));
    REQUIRE(match);
    CHECK(match->roots == renumbering.roots);
    CHECK(match->vertices == renumbering.vertices);
}

TEST_CASE("among equally close matches the one that maps the seed to the lowest root wins") {
    // All vertices have the same position, so every symmetry is equally close.
    const Hierarchy key = unrefined(octahedron(), Points(6));
    const std::optional<RootMatch> match = match_of(key, key, {.marked = false});
    REQUIRE(match);
    CHECK(match->roots[0] == 0);
    CHECK(match->vertices[0] == 0);
}

TEST_CASE("equal components are assigned at the minimum sum of squared distances over all permutations") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const std::size_t count = 2 + random.below(4);
        const RootComplex piece =
            random.chance(0.5) ? marked(octahedron(), Marking::random, random) : tetrahedron();
        RootComplex roots = piece;
        for (std::size_t n = 1; n < count; ++n) roots = side_by_side(roots, piece);
        const bool has_another = random.chance(0.5);
        if (has_another) roots = side_by_side(roots, torus(3, 3));
        const Hierarchy reference = scattered(roots, random);
        Hierarchy key = scattered(roots, random);
        move_near(key, reference, random);
        for (std::size_t v = 0; v < count * piece.vertex_count(); ++v) key.positions[v] = random.point();

        const auto part = [&](const Hierarchy& whole, std::size_t n) {
            const auto begin =
                whole.positions.begin() + static_cast<std::ptrdiff_t>(n * piece.vertex_count());
            return unrefined(piece, Points(begin, begin + piece.vertex_count()));
        };
        std::vector<std::size_t> order(count);
        std::iota(order.begin(), order.end(), std::size_t{0});
        double least = 1e300;
        do {
            double sum = 0;
            for (std::size_t n = 0; n < count; ++n)
                sum += *literal_least_distance(part(reference, n), part(key, order[n]), true);
            least = std::min(least, sum);
        } while (std::next_permutation(order.begin(), order.end()));
        for (std::size_t v = count * piece.vertex_count(); v < key.positions.size(); ++v)
            least +=
                std::pow(glm::distance(glm::dvec3(key.positions[v]), glm::dvec3(reference.positions[v])), 2);

        const Hierarchy shuffled = renumbered(key, random_renumbering(roots, random));
        const std::optional<RootMatch> match = match_of(reference, shuffled);
        REQUIRE(match);
        REQUIRE(distance_of(*match, reference, shuffled) == doctest::Approx(least));
    }
}

TEST_CASE("each of very many equal components takes the nearest one, relative to the center of all") {
    Random random(3);
    std::vector<Triangle> triangles;
    Points positions;
    for (Index n = 0; n < 700; ++n) {
        triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
        const glm::vec3 at(n % 7, n / 7 % 10, n / 70);
        positions.push_back(at);
        positions.push_back(at + glm::vec3(0.1, 0, 0));
        positions.push_back(at + glm::vec3(0, 0.1, 0));
    }
    const Hierarchy reference = unrefined(RootComplex(2100, triangles), positions);
    Hierarchy key = reference;
    for (glm::vec3& p : key.positions) p += 0.05F * random.point() + glm::vec3(3, 0, 20);
    const Renumbering renumbering = random_renumbering(key.roots, random);
    const std::optional<RootMatch> match = match_of(reference, renumbered(key, renumbering));
    REQUIRE(match);
    CHECK(match->roots == renumbering.roots);
    CHECK(match->vertices == renumbering.vertices);
}

TEST_CASE("fields follow the vertices of a key whose roots are renumbered") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_surface(0, false, random);
        const Hierarchy reference = bisected_key(roots, random);
        Hierarchy key = bisected_key(roots, random);
        move_near(key, reference, random);
        Hierarchy shuffled = renumbered(key, random_renumbering(roots, random));
        shuffled.fields = {{"x", FieldKind::scalar, {}}, {"place", FieldKind::color, {}}};
        for (const glm::vec3& position : shuffled.positions) {
            shuffled.fields[0].values.push_back(position.x);
            shuffled.fields[1].values.insert(shuffled.fields[1].values.end(),
                                             {position.x, position.y, position.z});
        }
        const std::optional<RootMatch> match = match_of(reference, shuffled);
        REQUIRE(match);
        const Hierarchy synchronized = with_roots_of(reference.roots, shuffled, *match);
        REQUIRE(synchronized.fields.size() == 2);
        CHECK(labels(synchronized.fields) == labels(shuffled.fields));
        REQUIRE(synchronized.fields[0].values.size() == synchronized.positions.size());
        for (Index v = 0; v < synchronized.vertex_count(); ++v) {
            const glm::vec3& position = synchronized.positions[v];
            REQUIRE(synchronized.fields[0].values[v] == position.x);
            const auto place = synchronized.fields[1].at(v);
            REQUIRE(glm::vec3(place[0], place[1], place[2]) == position);
        }
    }
}

TEST_CASE("a key without bisections takes the marking of the roots it is put over") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_surface(static_cast<unsigned>(seed % 3), random.chance(0.5), random);
        const Hierarchy reference = bisected_key(roots, random);
        Hierarchy key = scattered(marked(roots, Marking::random, random), random);
        move_near(key, reference, random);
        const Hierarchy shuffled = renumbered(key, random_renumbering(roots, random));
        const std::optional<RootMatch> match = match_of(reference, shuffled, {.marked = false});
        REQUIRE(match);
        const Hierarchy synchronized = with_roots_of(roots, shuffled, *match);
        REQUIRE(synchronized.roots == roots);
        REQUIRE(synchronized.positions == key.positions);
        REQUIRE(check(synchronized) == std::vector<std::string>{});

        // In the other direction, the marking of the roots changes.
        const std::optional<RootMatch> back = match_of(shuffled, reference, {.marked = false});
        REQUIRE(back);
        const RootComplex remarked = with_marking_of(shuffled.roots, roots, *back);
        const Hierarchy moved = with_roots_of(remarked, reference, *back);
        REQUIRE(check(moved) == std::vector<std::string>{});
        REQUIRE(moved.leaf_count() == reference.leaf_count());
        REQUIRE(match_of(unrefined(remarked, Points(roots.vertex_count())), reference).has_value());
    }
}

TEST_CASE("the mismatch names different refinement edges") {
    Random random(5);
    const RootComplex roots = flipped_at_random(plate(1), 60, random);
    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    std::rotate(triangles[12].begin(), triangles[12].begin() + 1, triangles[12].end());
    const Hierarchy reference = scattered(roots, random);
    Hierarchy key = scattered(RootComplex(roots.vertex_count(), triangles), random);
    move_near(key, reference, random);
    const RootMismatch mismatch = mismatch_of(reference, key);
    CHECK(mismatch.kind == Kind::refinement_edge);
    CHECK(mismatch.root == 12);
    CHECK(mismatch.reference_root == 12);
    CHECK(mismatch.edge == RootMismatch::Edge{triangles[12][1], triangles[12][2]});
    CHECK(mismatch.reference_edge == mismatch.edge);
    const std::string edge = fmt::format("({}, {})", mismatch.edge[0], mismatch.edge[1]);
    CHECK(text_of(mismatch) ==
          fmt::format("key star: root 12: its refinement edge {0} corresponds to edge {0} of key sphere's "
                      "root 12, which is not its refinement edge",
                      edge));

    const Renumbering renumbering = random_renumbering(roots, random);
    CHECK(mismatch_of(reference, renumbered(key, renumbering)).root == renumbering.roots[12]);
}

TEST_CASE("a mirrored complex is recognized as a mismatch; one that is its own mirror image matches") {
    std::size_t chiral = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_surface(static_cast<unsigned>(seed % 3), false, random);
        const Hierarchy reference = scattered(roots, random);
        const Hierarchy key = scattered(mirrored(roots), random);
        if (literal_least_distance(reference, key, false)) continue;
        ++chiral;
        REQUIRE(mismatch_of(reference, key).kind == Kind::mirrored);
        REQUIRE(mismatch_of(reference, key, {.marked = false}).kind == Kind::mirrored);
    }
    CHECK(chiral > 50);
    Random random(1);
    const Hierarchy reference = scattered(octahedron(), random);
    CHECK(match_of(reference, scattered(mirrored(octahedron()), random), {.marked = false}).has_value());
    CHECK(text_of(mismatch_of(scattered(RootComplex(4, {{0, 1, 2}, {1, 0, 3}}), random),
                              scattered(RootComplex(4, {{0, 1, 2}, {0, 2, 3}}), random)))
              .starts_with("key star: "));
}

TEST_CASE("the mismatch names the difference and its place") {
    Random random(11);
    const Hierarchy reference = scattered(flipped_at_random(torus(12, 12), 500, random), random);
    const auto with_roots = [&](RootComplex roots) { return scattered(roots, random); };

    CHECK(text_of(mismatch_of(reference, with_roots(octahedron()))) ==
          "key star: 8 root triangles, 6 root vertices, 0 boundary edges, 1 component, expected 288 root "
          "triangles, 144 root vertices, 0 boundary edges, 1 component as key sphere has");

    // One flipped edge: the mismatch is at one of the four vertices around it.
    std::vector<Triangle> triangles(reference.roots.triangles().begin(), reference.roots.triangles().end());
    RootComplex flipped;
    for (std::uint64_t seed = 1; flipped.triangle_count() == 0 || flipped == reference.roots; ++seed) {
        Random one(seed);
        flipped = flipped_at_random(reference.roots, 1, one);
    }
    std::set<Index> around;
    for (Index n = 0; n < triangles.size(); ++n)
        if (flipped.triangles()[n] != triangles[n]) around.insert(triangles[n].begin(), triangles[n].end());
    REQUIRE(around.size() == 4);
    const RootMismatch mismatch = mismatch_of(reference, with_roots(flipped));
    CHECK(mismatch.kind == Kind::surroundings);
    CHECK(around.contains(mismatch.vertex));
    CHECK(around.contains(mismatch.reference_vertex));
    CHECK(text_of(mismatch).find(" triangles around it, the second has ") != std::string::npos);

    // Components of the same sizes and in the same numbers, but with different connectivity.
    const RootComplex sphere = octahedron();
    const RootComplex ours =
        side_by_side(side_by_side(tetrahedron(), sphere), side_by_side(tetrahedron(), sphere));
    RootComplex bipyramid = connected_sum(tetrahedron(), 0, tetrahedron(), 0);
    const RootComplex theirs =
        side_by_side(side_by_side(tetrahedron(), sphere), side_by_side(bipyramid, bipyramid));
    CHECK(mismatch_of(with_roots(ours), with_roots(theirs)).kind == Kind::components);
    CHECK(mismatch_of(with_roots(theirs), with_roots(ours)).kind == Kind::no_counterpart);
}

TEST_CASE("the search follows given roots, and the mismatch names a wrong one") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        RootComplex roots = random_surface(static_cast<unsigned>(seed % 4), random.chance(0.5), random);
        if (random.chance(0.3)) roots = side_by_side(roots, octahedron());
        const Hierarchy reference = bisected_key(roots, random);
        const Hierarchy key = bisected_key(roots, random);  // far from the reference
        const Renumbering renumbering = random_renumbering(roots, random);
        const Hierarchy shuffled = renumbered(key, renumbering);
        std::vector<Index> given = renumbering.roots;
        const std::optional<RootMatch> match = match_of(reference, shuffled, {.given = given});
        REQUIRE(match);
        REQUIRE(match->roots == given);
        REQUIRE(is_same_key(with_roots_of(roots, shuffled, *match), key));
        REQUIRE(match_of(reference, shuffled, {.marked = false, .given = given}).has_value());

        const std::size_t a = random.below(given.size()), b = random.below(given.size());
        std::swap(given[a], given[b]);
        const std::optional<RootMatch> other = match_of(reference, shuffled, {.given = given});
        if (other) {  // also a symmetry
            REQUIRE(other->roots == given);
            REQUIRE(check(with_roots_of(roots, shuffled, *other)).empty());
        } else {
            const RootMismatch mismatch = mismatch_of(reference, shuffled, {.given = given});
            REQUIRE(mismatch.root < roots.triangle_count());
            REQUIRE(mismatch.reference_root < roots.triangle_count());
            REQUIRE(given[mismatch.reference_root] == mismatch.root);
            REQUIRE(text_of(mismatch).starts_with("key star: root "));
        }
    }
}

TEST_CASE("given roots may be any symmetry, not only the closest") {
    const Hierarchy reference =
        unrefined(octahedron(), Points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    // A quarter turn about the third axis.
    const std::vector<Index> given{1, 2, 3, 0, 5, 6, 7, 4};
    const std::optional<RootMatch> match = match_of(reference, reference, {.marked = false, .given = given});
    REQUIRE(match);
    CHECK(match->roots == given);
    CHECK(match->vertices == std::vector<Index>{2, 3, 1, 0, 4, 5});
}

TEST_CASE("a torus of 20,000 roots that all look the same is matched by its closest symmetry") {
    Random random(13);
    const RootComplex roots = torus(100, 100);
    const Hierarchy reference = scattered(roots, random);
    const Hierarchy shuffled = renumbered(reference, random_renumbering(roots, random));
    const std::optional<RootMatch> match = match_of(reference, shuffled);
    REQUIRE(match);
    CHECK(distance_of(*match, reference, shuffled) == 0);
}

TEST_CASE("the search ends at its limit: with a match if there is one, undecided if none was found") {
    Random random(17);
    const Hierarchy reference = scattered(torus(60, 10), random);
    const Hierarchy key =
        scattered(renumbered(reference.roots, random_renumbering(reference.roots, random)), random);
    const std::optional<RootMatch> match = match_of(reference, key, {.step_limit = 1});
    REQUIRE(match);
    CHECK(is_same_key(with_roots_of(reference.roots, key, *match), unrefined(reference.roots, [&] {
                          Points points;
                          for (const Index v : match->vertices) points.push_back(key.positions[v]);
                          return points;
                      }())));

    // Another torus with as many roots. Up to a large radius, each of its roots looks like each root of the
    // first.
    const Hierarchy other = scattered(torus(30, 20), random);
    CHECK(mismatch_of(reference, other, {.step_limit = 1}).kind == Kind::undecided);
    CHECK(mismatch_of(reference, other).kind == Kind::neighbor);
    CHECK(text_of(mismatch_of(reference, other, {.step_limit = 1})).find("too symmetric") !=
          std::string::npos);
}
