#include "sequence/evolving_mesh.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"

namespace interleaf {
namespace {

/// A square of two triangles, whose height over the plane a test changes.
struct HeightField {
    explicit HeightField(double (*height)(const glm::dvec3&))
        : surface(RootComplex(4, {{1, 2, 0}, {3, 0, 2}}), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                  [this](Index a, Index b, Index) { return lifted(middle(a, b)); }),
          shape(height) {
        lift();
    }

    glm::dvec3 middle(Index a, Index b) const {
        return (surface.positions()[a] + surface.positions()[b]) / 2.0;
    }
    glm::dvec3 lifted(const glm::dvec3& p) const { return {p.x, p.y, shape({p.x, p.y, 0})}; }
    double error(Index a, Index b) const { return glm::distance(middle(a, b), lifted(middle(a, b))); }
    void lift() {
        for (glm::dvec3& position : surface.positions()) position = lifted(position);
    }
    void adapt(double tolerance) {
        surface.adapt([this](Index a, Index b) { return error(a, b); }, tolerance);
    }
    double largest_error() const {
        double largest = 0;
        for (const auto& [a, b, c] : surface.triangles())
            largest = std::max({largest, error(a, b), error(b, c), error(c, a)});
        return largest;
    }

    EvolvingMesh surface;
    double (*shape)(const glm::dvec3&);
};

double hill(const glm::dvec3& p) {
    return std::exp(-20 * (p.x * p.x + p.y * p.y));
}

double flat(const glm::dvec3&) {
    return 0;
}

TEST_CASE("after adapt() no edge has an error above the tolerance, and only curved parts are fine") {
    HeightField field(hill);
    for (const double tolerance : {0.05, 0.01, 0.002}) {
        CAPTURE(tolerance);
        const Index before = field.surface.mesh().leaf_count();
        field.adapt(tolerance);
        CHECK(field.largest_error() <= tolerance);
        CHECK(field.surface.mesh().leaf_count() > before);
        CHECK(field.surface.mesh().violations().empty());
        CHECK(check(field.surface.freeze({})).empty());
    }
}

TEST_CASE("adapt() twice changes nothing the second time") {
    HeightField field(hill);
    field.adapt(0.002);
    const Hierarchy once = field.surface.freeze({});
    field.adapt(0.002);
    CHECK(field.surface.freeze({}).bits == once.bits);
    CHECK(field.surface.freeze({}).positions == once.positions);
}

TEST_CASE("a surface that becomes flat is coarsened to its roots, and can be refined anew") {
    HeightField field(hill);
    field.adapt(0.002);
    const Index fine = field.surface.mesh().leaf_count();
    field.shape = flat;
    field.lift();
    field.adapt(0.002);
    CHECK(field.surface.mesh().leaf_count() == 2);
    field.shape = hill;
    field.lift();
    field.adapt(0.002);
    CHECK(field.surface.mesh().leaf_count() == fine);
    CHECK(field.largest_error() <= 0.002);
    CHECK(check(field.surface.freeze({})).empty());
}

TEST_CASE("an error that no refinement lessens is refused at the limit of levels") {
    HeightField field(flat);
    const EdgeError at_corner = [](Index a, Index b) { return a == 0 || b == 0 ? 1.0 : 0.0; };
    CHECK_THROWS_AS(field.surface.adapt(at_corner, 0.5), InputError);
    CHECK(field.surface.mesh().violations().empty());
}

}  // namespace
}  // namespace interleaf
