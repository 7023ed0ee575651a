// Tests of coarsening, written from its specification in adaptive_mesh.h alone: the mesh stays sound, it
// agrees with the literal version, coarsening is the inverse of refinement, and indices behave as specified.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/greedy.h"
#include "hierarchy/literal.h"
#include "hierarchy/marking.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

using Steps = std::set<std::set<Index>>;

std::vector<Index> leaves_of(const AdaptiveMesh& mesh) {
    std::vector<Index> leaves;
    for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf)
        if (mesh.is_leaf(leaf)) leaves.push_back(leaf);
    return leaves;
}

/// The nodes of the leaves, with their indices.
std::map<Node, Index> indexed_nodes(const AdaptiveMesh& mesh) {
    const std::vector<Index> order = mesh.preorder();
    std::vector<unsigned> levels;
    levels.reserve(order.size());
    for (const Index leaf : order) levels.push_back(mesh.level(leaf));
    const std::vector<Node> nodes = nodes_of_levels(levels);
    std::map<Node, Index> result;
    for (std::size_t n = 0; n < order.size(); ++n) result[nodes[n]] = order[n];
    return result;
}

std::set<Node> node_set(const std::map<Node, Index>& nodes) {
    std::set<Node> result;
    for (const auto& [node, leaf] : nodes) result.insert(node);
    return result;
}

bool is_same(const Hierarchy& a, const Hierarchy& b) {
    return a.roots == b.roots && std::ranges::equal(a.bits, b.bits) &&
           std::ranges::equal(a.midpoints, b.midpoints) && std::ranges::equal(a.positions, b.positions);
}

bool contains(const std::set<Node>& all, const std::set<Node>& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

unsigned deepest_level(const AdaptiveMesh& mesh) {
    unsigned deepest = 0;
    for (const Index leaf : leaves_of(mesh)) deepest = std::max(deepest, mesh.level(leaf));
    return deepest;
}

/// All leaves, or the leaves near one place, or a random selection; never none.
std::vector<Index> random_marks(const AdaptiveMesh& mesh, Random& random) {
    std::vector<Index> leaves = leaves_of(mesh);
    const std::size_t kind = random.below(4);
    if (kind == 0) return leaves;
    const glm::vec3 place = random.point();
    const double density = kind == 1 ? 0.9 : random.unit() * (kind == 2 ? 0.1 : 0.7);
    std::vector<Index> marks;
    for (const Index leaf : leaves) {
        const bool near = kind == 2 && glm::distance(mesh.positions()[mesh.vertices(leaf)[0]], place) < 0.7F;
        if (near || random.chance(density)) marks.push_back(leaf);
    }
    if (marks.empty()) marks.push_back(leaves[random.below(leaves.size())]);
    return marks;
}

void shuffle(std::vector<Index>& values, Random& random) {
    for (std::size_t n = values.size(); n > 1; --n) std::swap(values[n - 1], values[random.below(n)]);
}

RootComplex random_marked_roots(Random& random) {
    const auto marking = static_cast<Marking>(random.below(3));
    return marked(random_roots(random), marking, random);
}

/// A pinwheel with a triangle behind each of its outer edges, which waits for that edge's triangle.
RootComplex pinwheel_with_tails(Index spokes) {
    std::vector<Triangle> triangles;
    for (Index n = 0; n < spokes; ++n) {
        const Index from = 1 + n, to = 1 + (n + 1) % spokes;
        triangles.push_back({from, to, 0});
        triangles.push_back({spokes + 1 + n, to, from});
    }
    return {2 * spokes + 1, std::move(triangles)};
}

/// An open fan: each triangle waits for the next, and the last one for none.
RootComplex open_fan(Index triangle_count) {
    std::vector<Triangle> triangles;
    for (Index n = 0; n < triangle_count; ++n) triangles.push_back({1 + n, 2 + n, 0});
    return {triangle_count + 2, std::move(triangles)};
}

/// A closed strip of squares, two triangles each, in which each triangle waits for the next: a cycle that
/// surrounds no vertex.
RootComplex ring(Index squares) {
    std::vector<Triangle> triangles;
    for (Index n = 0; n < squares; ++n) {
        const Index low = n, next_low = (n + 1) % squares, high = low + squares,
                    next_high = next_low + squares;
        triangles.push_back({low, next_low, high});
        triangles.push_back({high, next_low, next_high});
    }
    return {2 * squares, std::move(triangles)};
}

/// The marking with the number \p number: its digits to base 3 are the rotations of the triangles.
RootComplex with_marking(const RootComplex& roots, unsigned number) {
    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    for (Triangle& triangle : triangles) {
        std::rotate(triangle.begin(), triangle.begin() + number % 3, triangle.end());
        number /= 3;
    }
    return {roots.vertex_count(), std::move(triangles)};
}

/// Complexes in which leaves wait for each other in cycles.
RootComplex cyclic_roots(Random& random) {
    const auto size = static_cast<Index>(3 + random.below(4));
    switch (random.below(6)) {
        case 0:
            return pinwheel(size);
        case 1:
            return pinwheel_with_tails(size);
        case 2:
            return ring(size);
        case 3:
            return with_marking(tetrahedron(), static_cast<unsigned>(random.below(81)));
        case 4:
            return with_marking(octahedron(), static_cast<unsigned>(random.below(6561)));
        default:
            return marked(pinwheel_with_tails(size), Marking::random, random);
    }
}

/// A mesh, and beside it the state that the specification demands: the index of each node, and the place and
/// position of each vertex of the infinite complex. Compares every step with the literal version.
class WatchedMesh {
  public:
    WatchedMesh(const RootComplex& roots, Random& random)
        : roots_(roots),
          random_(random),
          complex_(roots_),
          mesh_(roots_, random_points(random, roots_.vertex_count()),
                [this](Index a, Index b, Index midpoint) { return place(a, b, midpoint); }),
          nodes_(indexed_nodes(mesh_)) {
        for (Index vertex = 0; vertex < roots_.vertex_count(); ++vertex)
            stored_[vertex] = {vertex, mesh_.positions()[vertex]};
        compare();
    }
    WatchedMesh(const WatchedMesh&) = delete;
    WatchedMesh& operator=(const WatchedMesh&) = delete;
    ~WatchedMesh() = default;

    const AdaptiveMesh& mesh() const { return mesh_; }

    /// Whether one of the midpoints belongs to a root edge.
    bool is_at_a_root(const std::set<Index>& midpoints) const {
        for (const auto& [a, b, c] : roots_.triangles())
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
                if (midpoints.contains(complex_.known_midpoint(from, to))) return true;
        return false;
    }

    void refine(const std::vector<Index>& marks) {
        const std::set<Node> before = node_set(nodes_);
        const std::set<Node> expected = rivara(complex_, before, nodes_of_marks(marks));
        const Index free_vertices = mesh_.vertex_bound() - mesh_.vertex_count(), bound = mesh_.vertex_bound();
        placed_ = placed_at_end_ = 0;
        is_refining_ = true;
        std::vector<Index> changed;
        mesh_.refine(marks, &changed);
        is_refining_ = false;
        REQUIRE(placed_at_end_ == placed_ - std::min(placed_, free_vertices));
        REQUIRE(mesh_.vertex_bound() == bound + placed_at_end_);
        compare_with(expected, changed);
    }

    /// \return the steps that coarsening took
    Steps coarsen(const std::vector<Index>& marks) {
        const std::set<Node> before = node_set(nodes_);
        Steps steps = coarsening_steps(complex_, before, nodes_of_marks(marks));
        const std::set<Node> expected = coarsened(complex_, before, steps);
        std::vector<Index> changed;
        mesh_.coarsen(marks, &changed);
        for (const std::set<Index>& step : steps)
            std::erase_if(stored_, [&](const auto& entry) { return step.contains(entry.second.name); });
        compare_with(expected, changed);
        REQUIRE(std::set<Index>(changed.begin(), changed.end()).size() == changed.size());
        return steps;
    }

  private:
    struct Stored {
        Index name;  ///< in the infinite complex
        glm::vec3 position;
    };

    std::set<Node> nodes_of_marks(const std::vector<Index>& marks) const {
        const std::set<Index> leaves(marks.begin(), marks.end());
        std::set<Node> result;
        for (const auto& [node, leaf] : nodes_)
            if (leaves.contains(leaf)) result.insert(node);
        return result;
    }

    /// The midpoint rule: the ends must be in place, the midpoint's own place must be free.
    glm::vec3 place(Index a, Index b, Index midpoint) {
        REQUIRE(is_refining_);
        REQUIRE(a < b);
        for (const Index end : {a, b}) {
            REQUIRE(stored_.contains(end));
            REQUIRE(mesh_.positions()[end] == stored_[end].position);
        }
        REQUIRE_FALSE(stored_.contains(midpoint));
        ++placed_;
        if (midpoint >= bound_) ++placed_at_end_;
        const glm::vec3 position = random_.point();
        stored_[midpoint] = {complex_.midpoint(stored_[a].name, stored_[b].name), position};
        return position;
    }

    /// Checks that the leaves are those of \p expected, that remaining leaves keep their index, and that
    /// \p changed lists the other leaves.
    void compare_with(const std::set<Node>& expected, const std::vector<Index>& changed) {
        const std::map<Node, Index> before = std::exchange(nodes_, indexed_nodes(mesh_));
        REQUIRE(node_set(nodes_) == expected);
        std::set<Index> others;
        for (const auto& [node, leaf] : nodes_) {
            const auto same = before.find(node);
            if (same == before.end())
                others.insert(leaf);
            else
                REQUIRE(same->second == leaf);
        }
        REQUIRE(std::set<Index>(changed.begin(), changed.end()) == others);
        compare();
    }

    void compare() {
        REQUIRE(mesh_.violations() == std::vector<std::string>{});
        REQUIRE(check(mesh_.freeze()) == std::vector<std::string>{});
        REQUIRE(mesh_.leaf_count() == nodes_.size());
        REQUIRE(leaves_of(mesh_).size() == nodes_.size());
        REQUIRE(mesh_.vertex_count() == stored_.size());
        peak_ = std::max(peak_, mesh_.leaf_count());
        REQUIRE(mesh_.leaf_bound() == peak_);  // a new place is taken only if none is free
        bound_ = mesh_.vertex_bound();

        std::map<std::pair<Index, Index>, Index> triangle_along;
        std::set<Index> used;
        bool is_right = true;
        for (const auto& [node, leaf] : nodes_) {
            const Triangle names = complex_.triangle(node), &vertices = mesh_.vertices(leaf);
            is_right &= mesh_.level(leaf) == node.level && mesh_.path(leaf) == node.path;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto place = stored_.find(vertices[k]);
                is_right &= place != stored_.end() && place->second.name == names[k] &&
                            mesh_.positions()[vertices[k]] == place->second.position;
                used.insert(vertices[k]);
                triangle_along[{vertices[(k + 1) % 3], vertices[(k + 2) % 3]}] = leaf;
            }
        }
        REQUIRE(is_right);
        REQUIRE(used.size() == stored_.size());
        for (const auto& [node, leaf] : nodes_)
            for (std::size_t k = 0; k < 3; ++k) {
                const Triangle& vertices = mesh_.vertices(leaf);
                const auto across = triangle_along.find({vertices[(k + 2) % 3], vertices[(k + 1) % 3]});
                is_right &=
                    mesh_.neighbors(leaf)[k] == (across == triangle_along.end() ? no_index : across->second);
            }
        REQUIRE(is_right);
    }

    RootComplex roots_;
    Random& random_;
    InfiniteComplex complex_;
    std::map<Index, Stored> stored_;  ///< by index
    Index peak_ = 0;                  ///< maximum number of leaves so far
    Index bound_ = 0;                 ///< vertex_bound() before the present call
    Index placed_ = 0;
    Index placed_at_end_ = 0;
    bool is_refining_ = false;
    AdaptiveMesh mesh_;
    std::map<Node, Index> nodes_;
};

struct Removed {
    std::size_t alone = 0;        ///< midpoints removed alone
    std::size_t cycles = 0;       ///< cycles of midpoints removed together
    std::size_t deep_cycles = 0;  ///< of these, away from the middle of a root edge

    Removed& operator+=(const Removed& other) {
        alone += other.alone;
        cycles += other.cycles;
        deep_cycles += other.deep_cycles;
        return *this;
    }
};

Removed refine_and_coarsen(WatchedMesh& mesh, Random& random, unsigned step_count, Index leaf_limit) {
    Removed removed;
    for (unsigned step = 0; step < step_count; ++step) {
        const bool refines = mesh.mesh().leaf_count() < leaf_limit && random.chance(0.55);
        std::vector<Index> marks = random_marks(mesh.mesh(), random);
        shuffle(marks, random);
        if (refines) {
            mesh.refine(marks);
            continue;
        }
        for (const std::set<Index>& step_taken : mesh.coarsen(marks)) {
            removed.alone += step_taken.size() == 1 ? 1 : 0;
            removed.cycles += step_taken.size() > 1 ? 1 : 0;
            removed.deep_cycles += step_taken.size() > 1 && !mesh.is_at_a_root(step_taken) ? 1 : 0;
        }
    }
    return removed;
}

/// Coarsens everything until no leaf can be coarsened.
/// \return the number of calls
unsigned coarsen_to_the_roots(AdaptiveMesh& mesh) {
    unsigned calls = 0;
    while (mesh.leaf_count() > mesh.roots().triangle_count()) {
        const Index before = mesh.leaf_count();
        mesh.coarsen(leaves_of(mesh));
        REQUIRE(mesh.leaf_count() < before);
        REQUIRE(mesh.violations() == std::vector<std::string>{});
        ++calls;
    }
    return calls;
}

void require_unrefined(const AdaptiveMesh& mesh, const std::vector<glm::vec3>& points) {
    const RootComplex& roots = mesh.roots();
    REQUIRE(mesh.leaf_count() == roots.triangle_count());
    REQUIRE(mesh.vertex_count() == roots.vertex_count());
    REQUIRE(is_same(mesh.freeze(), unrefined(roots, points)));
    for (Index root = 0; root < roots.triangle_count(); ++root) {
        REQUIRE(mesh.is_leaf(root));
        REQUIRE(mesh.level(root) == 0);
        REQUIRE(mesh.vertices(root) == roots.triangles()[root]);
        REQUIRE(mesh.neighbors(root) == roots.neighbors()[root]);
    }
}

/// Refines at random, and coarsens so that places become free.
void make_holes(AdaptiveMesh& mesh, Random& random) {
    for (unsigned step = 0; step < 3; ++step) {
        mesh.refine(random_marks(mesh, random));
        mesh.refine(random_marks(mesh, random));
        mesh.coarsen(random_marks(mesh, random));
    }
}

}  // namespace

TEST_CASE(
    "every refinement and coarsening conforms, freezes soundly and keeps the other leaves, 10,000 "
    "sequences") {
    std::size_t removed = 0;
    for (std::uint64_t seed = 1; seed <= trials(10000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_marked_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        std::vector<bool> was_used(roots.vertex_count(), true);
        std::vector<glm::vec3> positions(mesh.positions().begin(), mesh.positions().end());
        for (unsigned step = 0; step < 4; ++step) {
            const bool refines = step == 0 || (mesh.leaf_count() < 80 && random.chance(0.5));
            const Index leaves = mesh.leaf_count();
            if (refines)
                mesh.refine(random_marks(mesh, random));
            else
                mesh.coarsen(random_marks(mesh, random));
            if (!refines) removed += leaves - mesh.leaf_count();
            REQUIRE(mesh.violations() == std::vector<std::string>{});
            const Hierarchy hierarchy = mesh.freeze();
            REQUIRE(check(hierarchy) == std::vector<std::string>{});
            REQUIRE(hierarchy.leaf_count() == mesh.leaf_count());
            REQUIRE(hierarchy.vertex_count() == mesh.vertex_count());
            REQUIRE((refines ? mesh.leaf_count() > leaves : mesh.leaf_count() <= leaves));

            std::vector<bool> is_used(mesh.vertex_bound(), false);
            Index leaf_count = 0;
            for (const Index leaf : leaves_of(mesh)) {
                for (const Index vertex : mesh.vertices(leaf)) is_used[vertex] = true;
                ++leaf_count;
            }
            REQUIRE(leaf_count == mesh.leaf_count());
            REQUIRE(std::count(is_used.begin(), is_used.end(), true) == mesh.vertex_count());
            bool is_kept = true;
            for (Index vertex = 0; vertex < mesh.vertex_bound(); ++vertex) {
                const bool was = vertex < was_used.size() && was_used[vertex];
                if (was && is_used[vertex]) is_kept &= positions[vertex] == mesh.positions()[vertex];
                if (was != is_used[vertex]) is_kept &= refines == is_used[vertex];
            }
            REQUIRE(is_kept);
            was_used = std::move(is_used);
            positions.assign(mesh.positions().begin(), mesh.positions().end());
        }
    }
    CHECK(removed > trials(100000));
}

TEST_CASE("coarsening and refinement agree exactly with their literal versions, at the same indices") {
    Removed removed;
    for (std::uint64_t seed = 1; seed <= trials(1500); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        WatchedMesh mesh(random_marked_roots(random), random);
        removed += refine_and_coarsen(mesh, random, 6, 60);
    }
    CHECK(removed.alone > trials(10000));
    CHECK(removed.cycles > trials(10));
}

TEST_CASE("coarsening agrees with its literal version where leaves wait for each other in cycles") {
    Removed removed;
    for (std::uint64_t seed = 1; seed <= trials(1500); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        WatchedMesh mesh(cyclic_roots(random), random);
        removed += refine_and_coarsen(mesh, random, 9, 40);
    }
    CHECK(removed.alone > trials(10000));
    CHECK(removed.cycles > trials(400));
    CHECK(removed.deep_cycles > trials(200));
}

TEST_CASE("coarsening agrees with its literal version for every marking of a tetrahedron") {
    Removed removed;
    for (unsigned number = 0; number < 81; ++number) {
        CAPTURE(number);
        Random random(number);
        WatchedMesh mesh(with_marking(tetrahedron(), number), random);
        removed += refine_and_coarsen(mesh, random, 20, 30);
    }
    CHECK(removed.cycles > 20);
}

TEST_CASE(
    "coarsening agrees with its literal version on meshes of 1,000 leaves and more, down to the roots") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        WatchedMesh mesh(seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random), random);
        const auto refine_to = [&](Index leaf_count) {
            while (mesh.mesh().leaf_count() < leaf_count) mesh.refine(leaves_of(mesh.mesh()));
        };
        refine_to(1000);
        for (unsigned step = 0; step < 4; ++step) mesh.coarsen(random_marks(mesh.mesh(), random));
        refine_to(1200);
        while (mesh.mesh().leaf_count() > mesh.mesh().roots().triangle_count())
            mesh.coarsen(leaves_of(mesh.mesh()));
    }
}

TEST_CASE(
    "the midpoints of a cycle are removed in one step if all leaves around them are marked, never singly") {
    const auto look_at = [](const RootComplex& roots, std::size_t cycle) {
        CAPTURE(roots.triangle_count());
        Random random(1);
        for (std::size_t missing = 0; missing <= 3 * cycle; ++missing) {
            WatchedMesh mesh(roots, random);
            mesh.refine({0});
            std::vector<Index> marks = leaves_of(mesh.mesh());
            if (missing < marks.size()) {
                marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(missing));
                REQUIRE(mesh.coarsen(marks).empty());
            } else {
                const Steps steps = mesh.coarsen(marks);
                REQUIRE(steps.size() == 1);
                REQUIRE(steps.begin()->size() == cycle);
                REQUIRE(mesh.mesh().leaf_count() == roots.triangle_count());
            }
        }
    };
    for (Index spokes = 3; spokes <= 9; ++spokes) look_at(pinwheel(spokes), spokes);
    for (Index squares = 3; squares <= 6; ++squares) look_at(ring(squares), 2 * std::size_t{squares});
}

TEST_CASE("every choice of marks on a pinwheel's nine leaves agrees with the literal version") {
    std::size_t gone = 0;
    for (unsigned choice = 0; choice < 512; ++choice) {
        CAPTURE(choice);
        Random random(choice);
        WatchedMesh mesh(pinwheel(3), random);
        mesh.refine({choice % 3});
        std::vector<Index> marks;
        for (const Index leaf : leaves_of(mesh.mesh()))
            if ((choice >> leaf & 1) != 0) marks.push_back(leaf);
        gone += mesh.coarsen(marks).size();
    }
    CHECK(gone == 1);
}

TEST_CASE("coarsening everything again and again ends at the roots") {
    for (std::uint64_t seed = 1; seed <= trials(1000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
        const std::vector<glm::vec3> points = random_points(random, roots.vertex_count());
        AdaptiveMesh mesh(roots, points);
        for (unsigned round = 0; round < 5 && mesh.leaf_count() < 150; ++round)
            mesh.refine(random_marks(mesh, random));
        const unsigned deepest = deepest_level(mesh);
        const unsigned calls = coarsen_to_the_roots(mesh);
        require_unrefined(mesh, points);
        CHECK(calls >= deepest / 2);
        CHECK(calls <= deepest * (roots.triangle_count() + 2));
        if (is_compatibly_marked(roots)) CHECK(calls == deepest);

        std::vector<Index> changed;
        mesh.coarsen(leaves_of(mesh), &changed);
        CHECK(changed.empty());
        require_unrefined(mesh, points);
    }
}

TEST_CASE("pinwheels and rings, however deep, are coarsened to the roots") {
    for (Index size = 3; size <= 9; ++size)
        for (const RootComplex& roots :
             {pinwheel(size), pinwheel_with_tails(size), ring(size), open_fan(size)}) {
            CAPTURE(size);
            CAPTURE(roots.triangle_count());
            Random random(size);
            const std::vector<glm::vec3> points = random_points(random, roots.vertex_count());
            AdaptiveMesh mesh(roots, points);
            for (unsigned round = 0; round < 6; ++round) mesh.refine(leaves_of(mesh));
            const unsigned deepest = deepest_level(mesh);
            const unsigned calls = coarsen_to_the_roots(mesh);
            require_unrefined(mesh, points);
            CHECK(calls <= deepest * (roots.triangle_count() + 2));
        }
}

TEST_CASE("under every marking of an octahedron a refined mesh is coarsened to the roots") {
    for (unsigned number = 0; number < 6561; ++number) {
        CAPTURE(number);
        const RootComplex roots = with_marking(octahedron(), number);
        const std::vector<glm::vec3> points(roots.vertex_count(), glm::vec3(1));
        AdaptiveMesh mesh(roots, points);
        const Index first = number % 8;
        mesh.refine(std::span(&first, 1));
        if (number % 2 == 0) mesh.refine(leaves_of(mesh));
        coarsen_to_the_roots(mesh);
        require_unrefined(mesh, points);
    }
}

TEST_CASE(
    "in an open fan one midpoint waits for the next, so coarsening takes more calls than there are levels") {
    for (Index size = 2; size <= 9; ++size) {
        AdaptiveMesh mesh(open_fan(size), std::vector<glm::vec3>(size + 2, glm::vec3(0)));
        mesh.refine(std::vector<Index>{0});
        CHECK(deepest_level(mesh) == 2);
        CHECK(coarsen_to_the_roots(mesh) == size);
    }
}

TEST_CASE("leaves of the deepest level are coarsened to the roots") {
    for (const Marking marking : {Marking::random, Marking::compatible}) {
        Random random(7);
        const RootComplex roots = marked(octahedron(), marking, random);
        const std::vector<glm::vec3> points = random_points(random, roots.vertex_count());
        AdaptiveMesh mesh(roots, points);
        const auto level = [&](Index leaf) { return mesh.level(leaf); };
        CHECK_THROWS_AS(
            for (unsigned n = 0; n < 200; ++n) {
                const Index deepest = std::ranges::max(leaves_of(mesh), {}, level);
                mesh.refine(std::span(&deepest, 1));
            },
            InputError);
        CHECK(deepest_level(mesh) >= max_level - 1);
        coarsen_to_the_roots(mesh);
        require_unrefined(mesh, points);
    }
}

TEST_CASE("refining the triangles that coarsening has made leaves restores the mesh") {
    for (std::uint64_t seed = 1; seed <= trials(1500); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        for (unsigned round = 0; round < 4 && mesh.leaf_count() < 60; ++round)
            mesh.refine(random_marks(mesh, random));
        const Hierarchy before = mesh.freeze();
        std::vector<Index> changed;
        mesh.coarsen(random_marks(mesh, random), &changed);
        mesh.refine(changed);
        REQUIRE(is_same(mesh.freeze(), before));
    }
}

// Coarsening the leaves that a refinement changed undoes its last bisections. It undoes nothing from before
// the refinement. It undoes the refinement exactly if no triangle that the refinement bisected has a child
// that it bisected. Repeating this undoes all of it.
TEST_CASE(
    "coarsening the leaves that refinement changed restores the mesh, and removes nothing from before") {
    std::size_t at_once = 0, cycles_at_once = 0, in_several = 0;
    for (std::uint64_t seed = 1; seed <= trials(1500); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        const std::size_t rounds = random.below(3);
        for (std::size_t round = 0; round < rounds && mesh.leaf_count() < 60; ++round)
            mesh.refine(random_marks(mesh, random));
        const Hierarchy before = mesh.freeze();
        const std::set<Node> bisected_before = bisected_nodes(before);
        const std::set<Node> leaves_before = node_set(indexed_nodes(mesh));
        std::vector<Index> changed;
        mesh.refine(random_marks(mesh, random), &changed);
        const std::set<Node> bisected_after = bisected_nodes(mesh.freeze());
        bool bisects_once = true;
        for (const Node& node : bisected_after)
            bisects_once &= bisected_before.contains(node) || leaves_before.contains(node);
        const std::set<Node> leaves = node_set(indexed_nodes(mesh));

        mesh.coarsen(changed);
        const std::set<Node> bisected = bisected_nodes(mesh.freeze());
        REQUIRE(contains(bisected, bisected_before));
        REQUIRE(contains(bisected_after, bisected));
        REQUIRE(bisected.size() < bisected_after.size());
        if (bisects_once) REQUIRE(is_same(mesh.freeze(), before));

        InfiniteComplex complex(roots);
        std::set<Node> below;
        std::set_difference(leaves.begin(), leaves.end(), leaves_before.begin(), leaves_before.end(),
                            std::inserter(below, below.end()));
        bool is_in_one_step =
            coarsened(complex, leaves, coarsening_steps(complex, leaves, below)) == leaves_before;
        REQUIRE(is_in_one_step == (bisected == bisected_before));
        (bisects_once ? at_once : is_in_one_step ? cycles_at_once : in_several) += 1;

        for (unsigned calls = 0; bisected_nodes(mesh.freeze()) != bisected_before; ++calls) {
            REQUIRE(calls < 1000);
            std::vector<Index> marks;
            for (const auto& [node, leaf] : indexed_nodes(mesh))
                if (!leaves_before.contains(node)) marks.push_back(leaf);
            mesh.coarsen(marks);
        }
        REQUIRE(is_same(mesh.freeze(), before));
    }
    CHECK(at_once > trials(200));
    CHECK(cycles_at_once > trials(50));
    CHECK(in_several > trials(200));
}

TEST_CASE("the order of marks does not matter, and a leaf may be marked twice") {
    for (std::uint64_t seed = 1; seed <= trials(1000); ++seed) {
        CAPTURE(seed);
        struct Result {
            Hierarchy hierarchy;
            std::set<Index> changed;
        };
        const auto coarsened_in_order = [&](std::uint64_t order) {
            Random random(seed);
            const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
            AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
            for (unsigned round = 0; round < 4 && mesh.leaf_count() < 60; ++round)
                mesh.refine(random_marks(mesh, random));
            std::vector<Index> marks = random_marks(mesh, random);
            Random orders(seed + 1000000 * order);
            if (order == 1) std::reverse(marks.begin(), marks.end());
            if (order > 1) shuffle(marks, orders);
            if (order > 2)
                for (std::size_t n = marks.size(); n > 0; --n)
                    if (orders.chance(0.5)) marks.push_back(marks[orders.below(marks.size())]);
            std::vector<Index> changed;
            mesh.coarsen(marks, &changed);
            REQUIRE(mesh.violations() == std::vector<std::string>{});
            return Result{mesh.freeze(), {changed.begin(), changed.end()}};
        };
        const Result first = coarsened_in_order(0);
        for (std::uint64_t order = 1; order <= 4; ++order) {
            CAPTURE(order);
            const Result other = coarsened_in_order(order);
            REQUIRE(is_same(first.hierarchy, other.hierarchy));
            REQUIRE(first.changed == other.changed);
        }
    }
}

TEST_CASE("a leaf that is not marked keeps its vertices") {
    for (std::uint64_t seed = 1; seed <= trials(1000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        for (unsigned round = 0; round < 3 && mesh.leaf_count() < 60; ++round)
            mesh.refine(random_marks(mesh, random));
        for (unsigned round = 0; round < 8; ++round) {
            std::vector<Index> marks = leaves_of(mesh);
            const std::size_t place = random.below(marks.size());
            const Index leaf = marks[place];
            const Triangle vertices = mesh.vertices(leaf);
            const unsigned level = mesh.level(leaf);
            marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(place));
            mesh.coarsen(marks);
            REQUIRE(mesh.is_leaf(leaf));
            REQUIRE(mesh.vertices(leaf) == vertices);
            REQUIRE(mesh.level(leaf) == level);
        }
    }
}

TEST_CASE("marking nothing changes nothing, and roots among the marks do no harm") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_marked_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        std::vector<Index> changed = {no_index, 7};
        const Hierarchy unrefined_mesh = mesh.freeze();
        mesh.coarsen(leaves_of(mesh), &changed);
        mesh.coarsen(leaves_of(mesh));
        CHECK(is_same(mesh.freeze(), unrefined_mesh));
        const Index leaf = static_cast<Index>(random.below(mesh.leaf_count()));
        mesh.refine(std::span(&leaf, 1));
        const Hierarchy refined_mesh = mesh.freeze();
        const Index bound = mesh.leaf_bound();
        mesh.coarsen({}, &changed);
        mesh.coarsen({});
        CHECK(is_same(mesh.freeze(), refined_mesh));
        CHECK(mesh.leaf_bound() == bound);
        CHECK(mesh.leaf_count() == bound);
        CHECK(changed == std::vector<Index>{no_index, 7});

        std::vector<Index> only_roots;
        for (const Index root : leaves_of(mesh))
            if (mesh.level(root) == 0) only_roots.push_back(root);
        mesh.coarsen(only_roots, &changed);
        CHECK(is_same(mesh.freeze(), refined_mesh));
        mesh.coarsen(leaves_of(mesh), &changed);
        CHECK(mesh.leaf_count() < bound);
        CHECK(changed.size() > 2);
        CHECK(changed[0] == no_index);  // the earlier content is kept
        CHECK(changed[1] == 7);
    }
}

TEST_CASE("refining and coarsening in turn uses no more places than the largest mesh needs") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        Index leaves = mesh.leaf_bound(), vertices = mesh.vertex_bound();
        for (unsigned step = 0; step < 40; ++step) {
            if (mesh.leaf_count() < 100 && random.chance(0.5))
                mesh.refine(random_marks(mesh, random));
            else
                mesh.coarsen(random_marks(mesh, random));
            leaves = std::max(leaves, mesh.leaf_count());
            vertices = std::max(vertices, mesh.vertex_count());
            REQUIRE(mesh.leaf_bound() == leaves);
            REQUIRE(mesh.vertex_bound() == vertices);
        }
    }
}

TEST_CASE("leaves_added_by returns the number of leaves that refine adds to a coarsened mesh") {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        make_holes(mesh, random);
        for (unsigned step = 0; step < 10; ++step) {
            const std::vector<Index> leaves = leaves_of(mesh);
            const Index leaf = leaves[random.below(leaves.size())];
            const Index expected = mesh.leaf_count() + mesh.leaves_added_by(leaf);
            mesh.refine(std::span(&leaf, 1));
            REQUIRE(mesh.leaf_count() == expected);
            mesh.coarsen(random_marks(mesh, random));
        }
    }
}

TEST_CASE("a tolerance gives the same mesh with and without free places") {
    std::size_t with_holes = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = seed % 2 == 0 ? random_marked_roots(random) : cyclic_roots(random);
        const std::vector<glm::vec3> points = random_points(random, roots.vertex_count());
        AdaptiveMesh used(roots, points), fresh(roots, points);
        make_holes(used, random);
        coarsen_to_the_roots(used);
        const std::vector<Index> marks = random_marks(fresh, random);
        used.refine(marks);
        fresh.refine(marks);
        with_holes += used.leaf_count() < used.leaf_bound() ? 1 : 0;
        for (AdaptiveMesh* mesh : {&used, &fresh}) {
            refine_greedily(*mesh, longest_edge, {.tolerance = 0.6});
            for (const Index leaf : leaves_of(*mesh)) REQUIRE(longest_edge(*mesh, leaf) <= 0.6);
            REQUIRE(mesh->violations() == std::vector<std::string>{});
            REQUIRE(check(mesh->freeze()) == std::vector<std::string>{});
        }
        REQUIRE(is_same(used.freeze(), fresh.freeze()));
    }
    CHECK(with_holes > 100);
}

TEST_CASE("a budget on a coarsened mesh is never exceeded, and reached to within one bisection") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = mark_compatibly(octahedron());
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        make_holes(mesh, random);
        const Index budget = mesh.leaf_count() + static_cast<Index>(random.below(100));
        refine_greedily(mesh, longest_edge, {.leaves = budget});
        CHECK(mesh.leaf_count() <= budget);
        CHECK(mesh.leaf_count() + 2 > budget);
        CHECK(mesh.violations().empty());
        CHECK(check(mesh.freeze()).empty());
    }
}
