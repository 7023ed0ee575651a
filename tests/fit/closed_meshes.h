// Surfaces for the tests of the map and of the clean-up: all generated here, most of genus 0.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fit/mesh/surface_mesh.h"

namespace interleaf::testing {

struct NamedMesh {
    std::string name;
    SurfaceMesh mesh;
};

/// An icosahedron whose triangles are divided into 4, n times; 10 4^n + 2 vertices.
SurfaceMesh icosphere(unsigned divisions);

/// A sphere of meridians and parallels. All meridians meet in one vertex at each pole, with needles around
/// it.
SurfaceMesh globe(unsigned meridians, unsigned parallels);

SurfaceMesh tetrahedron();

/// How the polygon at the end of a cylinder is divided into triangles: by a fan, a zigzag, or by cutting off every
/// other corner until none is left, as the readers do.
enum class Cap { corner_fan, center_fan, zigzag, every_other };

/// An upright cylinder of radius 1 over a regular polygon with the given number of sides.
SurfaceMesh cylinder(unsigned sides, double height, Cap cap);

/// A closed torus: a tube bent to a ring. Not of genus 0.
SurfaceMesh torus(unsigned around, unsigned across);

/// An open square, divided into squares.
SurfaceMesh sheet(unsigned squares);

/// The directions of the vertices from the origin.
std::vector<glm::dvec3> on_sphere(const SurfaceMesh& mesh);

SurfaceMesh moved(SurfaceMesh mesh, const std::function<glm::dvec3(const glm::dvec3&)>& map);

/// The two meshes side by side, as one mesh.
SurfaceMesh joined(SurfaceMesh first, const SurfaceMesh& second);

/// A tetrahedron in which random triangles and edges are divided until it has \p vertices vertices, at random
/// positions. Any simplicial sphere may result, in any position, self-intersecting.
SurfaceMesh random_sphere(std::uint32_t seed, unsigned vertices);

/// A double pyramid over a polygon with the given number of vertices. Its two tips are joined to all of them.
SurfaceMesh double_pyramid(unsigned vertices);

/// Closed surfaces of genus 0 that are difficult to map.
std::vector<NamedMesh> closed_meshes();

}  // namespace interleaf::testing
