#include "hierarchy/root_complex.h"

#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/error.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("neighbors are mutual and share the edge opposite the vertex they are listed at") {
    for (std::uint64_t seed = 1; seed <= trials(2000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_roots(random);
        Index boundary = 0;
        for (Index t = 0; t < roots.triangle_count(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const Index neighbor = roots.neighbors()[t][k];
                if (neighbor == no_index) {
                    ++boundary;
                    continue;
                }
                const Index from = roots.triangles()[t][(k + 1) % 3], to = roots.triangles()[t][(k + 2) % 3];
                bool shared = false;
                for (std::size_t n = 0; n < 3; ++n)
                    shared = shared || (roots.neighbors()[neighbor][n] == t &&
                                        roots.triangles()[neighbor][(n + 1) % 3] == to &&
                                        roots.triangles()[neighbor][(n + 2) % 3] == from);
                REQUIRE(shared);
            }
        REQUIRE(boundary == roots.boundary_edge_count());
    }
}

TEST_CASE("triangles that form no orientable manifold are rejected, naming the place") {
    const auto message = [](Index vertex_count, std::vector<Triangle> triangles) -> std::string {
        try {
            RootComplex(vertex_count, std::move(triangles));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message(0, {}) == "there are no triangles, expected at least one");
    CHECK(message(3, {{0, 1, 3}}) == "triangle 0 has the vertices (0, 1, 3), expected indices below 3");
    CHECK(message(3, {{0, 1, 1}}) == "triangle 0 has the vertices (0, 1, 1), expected three different ones");
    CHECK(message(4, {{0, 1, 2}}) == "vertex 3 belongs to no triangle");
    CHECK(message(4, {{0, 1, 2}, {1, 2, 3}})
              .starts_with("triangles 0 and 1 run along edge (1, 2) in the same direction"));
    CHECK(message(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}).find("belongs to 3 triangles") != std::string::npos);
    CHECK(message(3, {{0, 1, 2}, {0, 2, 1}}) == "triangles 0 and 1 have the same vertices");
    CHECK(
        message(5, {{0, 1, 2}, {0, 3, 4}}).starts_with("vertex 0 joins triangles that share no edge there"));
    CHECK(message(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}).empty());
}

TEST_CASE("complexes are equal if their triples are equal, including the marking") {
    CHECK(octahedron() == octahedron());
    CHECK_FALSE(RootComplex(3, {{0, 1, 2}}) == RootComplex(3, {{1, 2, 0}}));
}
