// Tests of keys without their deepest levels.
#include "hierarchy/detail/level_cut.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "hierarchy/literal.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE(
    "a cut at a level has the nodes of the key down to that level, and conforms under a compatible marking") {
    for_random_families(trials(400), 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys.front();
        const std::set<Node> bisected = bisected_nodes(key);
        for (const unsigned level : {0U, 1U, 3U, 6U, max_level}) {
            CAPTURE(level);
            const Hierarchy cut = cut_at_level(key, level);
            std::set<Node> wanted;
            for (const Node& node : bisected)
                if (node.level < level) wanted.insert(node);
            CHECK(bisected_nodes(cut) == wanted);
            if (level == max_level) CHECK(cut.positions == key.positions);
            if (family.marking == Marking::compatible) CHECK(check(cut) == std::vector<std::string>{});
        }
    });
}

TEST_CASE("the level for a number of leaves is the deepest one that keeps to it") {
    for_random_families(trials(400), 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys.front();
        for (const std::size_t leaves :
             {std::size_t{1}, key.leaf_count() / 3, key.leaf_count() - 1, key.leaf_count()}) {
            CAPTURE(leaves);
            const unsigned level = level_with_at_most(key, leaves);
            const std::size_t kept = cut_at_level(key, level).leaf_count();
            CHECK((kept <= leaves || level == 0));
            if (level < max_level) CHECK(cut_at_level(key, level + 1).leaf_count() > leaves);
        }
    });
}
