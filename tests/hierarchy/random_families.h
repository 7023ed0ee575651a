// Random root complexes and random keys over them: the input of the property tests. A seed determines
// everything.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/hierarchy.h"

namespace interleaf::testing {

/// Random numbers that are the same with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// A number from 0 to \p bound - 1.
    std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }
    /// A number from 0 to 1.
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    bool chance(double probability) { return unit() < probability; }
    glm::vec3 point() {
        const double x = unit(), y = unit(), z = unit();
        return 2.0F * glm::vec3(x, y, z) - 1.0F;
    }

  private:
    std::mt19937_64 engine_;
};

enum class Marking { random, longest_edge, compatible };

struct RandomFamily {
    std::uint64_t seed;
    Marking marking;
    RootComplex roots;
    std::vector<Hierarchy> keys;

    std::vector<const Hierarchy*> key_pointers() const;
};

/// The complex of the given triangles; unused vertices are dropped.
RootComplex compacted(const std::vector<Triangle>& triangles);

/// Cuts up to \p count triangles out, as long as the rest remains a manifold.
RootComplex cut_open(RootComplex roots, std::size_t count, Random& random);

/// \p a and \p b as two components of one complex.
RootComplex side_by_side(const RootComplex& a, const RootComplex& b);

/// The surface of a plate of cubes with \p genus holes, each square split by a diagonal.
RootComplex plate(unsigned genus);

/// The four triangles of the tetrahedron.
RootComplex tetrahedron();

/// The eight triangles of the octahedron.
RootComplex octahedron();

/// A flat sheet of \p columns x \p rows squares, two triangles each.
RootComplex sheet(unsigned columns, unsigned rows);

/// A closed torus of \p columns x \p rows squares, at least 3 x 3.
RootComplex torus(unsigned columns, unsigned rows);

/// A closed fan of triangles around vertex 0 in which each triangle waits for the next: its refinement edge
/// is the spoke that it shares with the next triangle.
RootComplex pinwheel(Index spokes);

/// A closed surface of genus 0 to 3, an open one made by cutting triangles out, a sheet, or two of these side
/// by side. Vertices and triangles are in random order, and each triple is rotated at random.
RootComplex random_roots(Random& random);

RootComplex marked(const RootComplex& roots, Marking marking, Random& random);

std::vector<glm::vec3> random_points(Random& random, std::size_t count);

/// Refines in up to \p rounds rounds with random marks, often near one place, up to about \p leaf_limit
/// leaves.
void refine_at_random(AdaptiveMesh& mesh, Random& random, unsigned rounds, Index leaf_limit);

/// A key over \p roots, refined at random, with midpoints moved off their edges.
Hierarchy random_key(const RootComplex& roots, Random& random);

/// Length of the longest edge of a leaf.
float longest_edge(const AdaptiveMesh& mesh, Index leaf);

RandomFamily random_family(std::uint64_t seed, std::size_t key_count);

/// Calls \p property on families of \p key_count keys until it has been given trials(\p hierarchy_count)
/// keys.
void for_random_families(unsigned hierarchy_count, std::size_t key_count,
                         const std::function<void(const RandomFamily&)>& property);

}  // namespace interleaf::testing
