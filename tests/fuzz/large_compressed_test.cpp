// Small files that stand for large content.
#include <cstring>

#include "fuzz/allocation_count.h"
#include "fuzz/hierarchy_parts.h"
#include "fuzz/target.h"
#include <doctest/doctest.h>

#include "hierarchy/adaptive_mesh.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf::fuzz {

namespace {

/// A square that is bisected \p rounds times everywhere, with all vertices in one place.
Bytes flat_file(int rounds) {
    const std::vector<glm::vec3> corners(4, glm::vec3(0));
    AdaptiveMesh mesh(RootComplex(4, {{1, 2, 0}, {3, 0, 2}}), corners,
                      [](Index, Index, Index) { return glm::vec3(0); });
    for (int round = 0; round < rounds; ++round) {
        std::vector<Index> leaves(mesh.leaf_count());
        for (Index leaf = 0; leaf < leaves.size(); ++leaf) leaves[leaf] = leaf;
        mesh.refine(leaves);
    }
    return serialize_hierarchy(mesh.freeze(), {.compressed = true, .rounding_bits = 0});
}

}  // namespace

TEST_CASE("a file that stands for thousands of times its size is read in little memory, or written plain") {
    const Bytes file = flat_file(19);  // a million leaves
    CHECK(header_at(file).version == hierarchy_format::compressed_version);
    CHECK(file.size() < 20'000);
    const Outcome outcome = outcome_of(file);
    CHECK(outcome.fault == "");
    CHECK(outcome.accepted);
    begin_count();
    target.read(file);
    CHECK(max_bytes() < 64'000'000);
}

TEST_CASE("counts that the content does not support take no more memory than others") {
    Bytes file = flat_file(3);
    for (const auto& [midpoints, vertices] :
         {std::pair{1'600'000U, 800'000U}, std::pair{3'400'000U, 20U}, std::pair{20U, 1'300'000U}}) {
        CAPTURE(midpoints);
        std::memcpy(file.data() + 24, &midpoints, 4);
        std::memcpy(file.data() + 28, &vertices, 4);
        file.resize(file.size() - 4);
        append_checksum(file);
        begin_count();
        CHECK_FALSE(outcome_of(file).accepted);
        CHECK(max_bytes() < 64'000'000);
    }
}

}  // namespace interleaf::fuzz
