// Tests of a key under the brush: it agrees with the literal version, stays sound, and keeps its surface where new
// vertices are at the middle of their edges.
#include "app/brushing/brushed_key.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/mesh/space_triangle.h"
#include "hierarchy/checker.h"
#include "hierarchy/color.h"
#include "hierarchy/literal.h"
#include "hierarchy/marking.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using interleaf::testing::Node;
using interleaf::testing::Random;

namespace {

/// The literal brush: sets of nodes, with positions by name of the vertex.
class LiteralBrush {
  public:
    LiteralBrush(const Hierarchy& key) : complex_(key.roots), positions_(roots_of(key)) {
        const std::set<Node> bisected = testing::bisected_nodes(key);
        std::vector<Node> nodes = testing::leaf_nodes(bisected, key.roots.triangle_count());
        leaves_.insert(nodes.begin(), nodes.end());
        const std::vector<Leaf> own = leaves_of(key);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const Triangle triangle = complex_.triangle(nodes[n]);
            for (std::size_t corner = 0; corner < 3; ++corner)
                positions_[triangle[corner]] = key.positions[own[n].vertices[corner]];
        }
        order_ = std::move(nodes);
    }

    /// \param leaf  place in the preorder of the present leaves
    void touch(std::size_t leaf, const glm::vec3& center, float radius) {
        center_ = center;
        radius_ = radius;
        touched_ = {order_[leaf]};
        for (bool grows = true; std::exchange(grows, false);)
            for (const Node& node : leaves_)
                if (!touched_.contains(node) && meets(node) &&
                    std::ranges::any_of(touched_,
                                        [&](const Node& other) { return share_edge(node, other); })) {
                    touched_.insert(node);
                    grows = true;
                }
    }

    /// \return the number of bisections that nothing but closure asks for
    std::size_t refine(unsigned level) {
        const std::set<Node> before = leaves_;
        std::size_t wanted = 0;
        for (;;) {
            std::set<Node> marked;
            for (const Node& node : leaves_)
                if (node.level < level && is_below_touched(node) && meets(node)) marked.insert(node);
            if (marked.empty()) break;
            leaves_ = testing::rivara(complex_, leaves_, marked);
        }
        for (const Node& node : before) wanted += wanted_below(node, level);
        return leaves_.size() - before.size() - wanted;
    }

    void coarsen(unsigned level) {
        for (;;) {
            std::set<Node> marked;
            for (const Node& node : leaves_)
                if (node.level > level && touched_.contains(node) && meets(node)) marked.insert(node);
            const auto steps = testing::coarsening_steps(complex_, leaves_, marked);
            if (steps.empty()) return;
            const std::set<Node> before =
                std::exchange(leaves_, testing::coarsened(complex_, leaves_, steps));
            std::ranges::set_difference(leaves_, before, std::inserter(touched_, touched_.end()));
        }
    }

    const std::set<Node>& leaves() const { return leaves_; }

  private:
    static std::map<Index, glm::vec3> roots_of(const Hierarchy& key) {
        std::map<Index, glm::vec3> positions;
        for (Index v = 0; v < key.roots.vertex_count(); ++v) positions[v] = key.positions[v];
        return positions;
    }

    /// Finds the positions of the corners of \p node.
    void place_corners(const Node& node) {
        const Triangle triangle = complex_.triangle(node);
        if (std::ranges::all_of(triangle, [&](Index vertex) { return positions_.contains(vertex); })) return;
        place_corners(node.parent());
        const Triangle parent = complex_.triangle(node.parent());
        positions_.try_emplace(triangle[0], (positions_.at(parent[1]) + positions_.at(parent[2])) * 0.5F);
    }

    std::array<glm::dvec3, 3> corners(const Node& node) {
        place_corners(node);
        const Triangle triangle = complex_.triangle(node);
        return {positions_.at(triangle[0]), positions_.at(triangle[1]), positions_.at(triangle[2])};
    }

    bool meets(const Node& node) {
        return squared_distance_to_triangle(center_, corners(node)) <= double(radius_) * radius_;
    }

    bool share_edge(const Node& a, const Node& b) {
        const Triangle one = complex_.triangle(a);
        const Triangle other = complex_.triangle(b);
        return std::ranges::count_if(
                   one, [&](Index vertex) { return std::ranges::find(other, vertex) != other.end(); }) == 2;
    }

    bool is_below_touched(Node node) {
        while (!touched_.contains(node)) {
            if (node.level == 0) return false;
            node = node.parent();
        }
        return true;
    }

    /// The bisections at \p node, a leaf before, and below it that the brush itself marks.
    std::size_t wanted_below(const Node& node, unsigned level) {
        if (leaves_.contains(node)) return 0;
        const bool is_wanted = node.level < level && is_below_touched(node) && meets(node);
        return (is_wanted ? 1U : 0U) + wanted_below(node.child(0), level) +
               wanted_below(node.child(1), level);
    }

    testing::InfiniteComplex complex_;
    std::map<Index, glm::vec3> positions_;
    std::vector<Node> order_;
    std::set<Node> leaves_;
    std::set<Node> touched_;
    glm::vec3 center_{0};
    float radius_ = 0;
};

std::set<Node> leaf_set(const Hierarchy& key) {
    const std::vector<Node> nodes =
        testing::leaf_nodes(testing::bisected_nodes(key), key.roots.triangle_count());
    return {nodes.begin(), nodes.end()};
}

/// A touch of a random leaf of \p brushed, and the place of that leaf in preorder.
std::pair<BrushTouch, std::size_t> random_touch(const BrushedKey& brushed, Random& random) {
    const std::vector<Index> order = brushed.mesh().preorder();
    const std::size_t place = random.below(order.size());
    const auto& [a, b, c] = brushed.mesh().vertices(order[place]);
    const auto positions = brushed.mesh().positions();
    return {{order[place], (positions[a] + positions[b] + positions[c]) / 3.0F,
             static_cast<float>(random.unit()) * 0.7F},
            place};
}

/// Whether two keys have the same bits, numbers and values.
bool are_equal(const Hierarchy& a, const Hierarchy& b) {
    const bool has_same_fields = std::ranges::equal(
        a.fields, b.fields, [](const Field& x, const Field& y) { return x.values == y.values; });
    return a.roots == b.roots && a.bits == b.bits && a.midpoints == b.midpoints &&
           a.positions == b.positions && has_same_fields;
}

}  // namespace

TEST_CASE("the brush refines and coarsens exactly as its literal version, and the key stays sound") {
    std::size_t refined = 0;
    std::size_t coarsened = 0;
    std::size_t by_closure = 0;
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const testing::RandomFamily family = testing::random_family(seed, 1);
        Hierarchy key = family.keys.front();
        if (key.leaf_count() > 150) continue;
        for (int stroke = 0; stroke < 3; ++stroke) {
            CAPTURE(stroke);
            BrushedKey brushed(key);
            LiteralBrush literal(key);
            const auto [touch, place] = random_touch(brushed, random);
            literal.touch(place, touch.center, touch.radius);
            if (random.chance(0.6)) {
                const auto level = static_cast<unsigned>(random.below(6));
                brushed.refine(touch, level);
                const std::size_t closed = literal.refine(level);
                if (family.marking == testing::Marking::compatible)
                    CHECK(brushed.figures().by_closure == closed);
                refined += brushed.figures().leaves - brushed.figures().leaves_before;
                by_closure += closed;
            } else {
                const auto level = static_cast<unsigned>(random.below(4));
                brushed.coarsen(touch, level);
                literal.coarsen(level);
                coarsened += brushed.figures().leaves_before - brushed.figures().leaves;
            }
            key = brushed.freeze();
            REQUIRE(leaf_set(key) == literal.leaves());
            REQUIRE(check(key) == std::vector<std::string>{});
            REQUIRE(brushed.mesh().violations() == std::vector<std::string>{});
            REQUIRE(brushed.figures().leaves == key.leaf_count());
        }
    }
    CHECK(refined > 1000);
    CHECK(coarsened > 100);
    CHECK(by_closure > 100);
}

TEST_CASE("a stroke that changes nothing gives the identical key") {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Hierarchy key = testing::random_family(seed, 1).keys.front();
        BrushedKey brushed(key);
        brushed.refine(random_touch(brushed, random).first, 0);
        brushed.coarsen(random_touch(brushed, random).first, max_level);
        CHECK(are_equal(brushed.freeze(), key));
    }
}

TEST_CASE("new vertices carry the mean of a scalar, and of a color in linear light") {
    Hierarchy key = unrefined(testing::octahedron(),
                              {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    key.fields.push_back({"height", FieldKind::scalar, {1, 2, 3, 4, 5, 6}});
    key.fields.push_back({"paint", FieldKind::color, Buffer<float>(18, 0)});
    for (std::size_t c = 0; c < 3; ++c) key.fields[1].values[c] = 1;
    BrushedKey brushed(key);
    brushed.refine({0, {0, 0, 0}, 2}, 1);
    const Hierarchy refined = brushed.freeze();
    CHECK(check(refined) == std::vector<std::string>{});
    REQUIRE(refined.vertex_count() > 6);
    for (Index vertex = 6; vertex < refined.vertex_count(); ++vertex) {
        float height = 0;
        float paint = 0;
        for (Index root = 0; root < 6; ++root) {
            const float part = std::max(glm::dot(refined.positions[vertex], refined.positions[root]), 0.0F);
            height += part * key.fields[0].values[root];
            paint += part * key.fields[1].values[3 * root];
        }
        CHECK(refined.fields[0].at(vertex)[0] == height);
        CHECK(refined.fields[1].at(vertex)[0] == doctest::Approx(encoded(glm::vec3(paint)).x));
    }
}

TEST_CASE("the rule places new vertices, and removed vertices leave no trace") {
    const Hierarchy key = unrefined(mark_compatibly(testing::octahedron()),
                                    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    BrushedKey brushed(key, [](const glm::vec3& middle, float) { return glm::normalize(middle); });
    const BrushTouch everywhere{0, {0, 0, 0}, 2};
    brushed.refine(everywhere, 5);
    const Hierarchy refined = brushed.freeze();
    CHECK(refined.leaf_count() == 8 * 32);
    for (const glm::vec3& position : refined.positions) CHECK(glm::length(position) == doctest::Approx(1));
    brushed.coarsen(everywhere, 0);
    CHECK(are_equal(brushed.freeze(), key));
}

TEST_CASE("the brush does not reach the other side of a thin body") {
    // Two squares, 0.01 apart, with sides between them; the pointer is in the middle of the upper square.
    const RootComplex roots(8, {{0, 2, 1},
                                {0, 3, 2},
                                {4, 5, 6},
                                {4, 6, 7},
                                {0, 1, 5},
                                {0, 5, 4},
                                {1, 2, 6},
                                {1, 6, 5},
                                {2, 3, 7},
                                {2, 7, 6},
                                {3, 0, 4},
                                {3, 4, 7}});
    const Hierarchy key = unrefined(
        mark_compatibly(roots),
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0.01}, {1, 0, 0.01}, {1, 1, 0.01}, {0, 1, 0.01}});
    BrushedKey brushed(key);
    const auto touch = brushed.touch({{0.5F, 0.4F, 1}, {0.5F, 0.4F, -1}}, 0.1F);
    REQUIRE(touch);
    CHECK(glm::distance(touch->center, glm::vec3(0.5F, 0.4F, 0.01F)) < 1e-5F);
    brushed.refine(*touch, 8);
    const AdaptiveMesh& mesh = brushed.mesh();
    for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf) {
        const Triangle& vertices = mesh.vertices(leaf);
        const bool is_lower =
            std::ranges::all_of(vertices, [&](Index v) { return mesh.positions()[v].z == 0; });
        if (is_lower) CHECK(mesh.level(leaf) < 6);
    }
    CHECK(brushed.figures().leaves > 30);
    CHECK(!brushed.touch({{2, 2, 1}, {2, 2, -1}}, 0.1F));
}
