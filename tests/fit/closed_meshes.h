// Surfaces for the tests of the map and of cleaning up: all made here, most of genus 0.
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

/// An icosahedron, each triangle divided into 4 as often as told; 10 4^n + 2 vertices.
SurfaceMesh icosphere(unsigned divisions);

/// Meridians by parallels, with needles around the poles, where all meridians meet in one vertex.
SurfaceMesh globe(unsigned meridians, unsigned parallels);

SurfaceMesh tetrahedron();

/// How the polygon at the end of a cylinder is cut into triangles.
enum class Cap { corner_fan, center_fan, zigzag };

/// Upright, of radius 1, over a regular polygon of so many sides.
SurfaceMesh cylinder(unsigned sides, double height, Cap cap);

/// Closed: a tube bent to a ring. Not of genus 0.
SurfaceMesh torus(unsigned around, unsigned across);

/// A square of so many by so many squares, open.
SurfaceMesh sheet(unsigned squares);

/// The directions of the vertices from 0.
std::vector<glm::dvec3> on_sphere(const SurfaceMesh& mesh);

SurfaceMesh moved(SurfaceMesh mesh, const std::function<glm::dvec3(const glm::dvec3&)>& map);

/// The two meshes side by side, as one.
SurfaceMesh joined(SurfaceMesh first, const SurfaceMesh& second);

/// A tetrahedron of which random triangles and edges are divided until it has \p vertices, at random
/// positions: any simplicial sphere may come out, in any position, self-intersecting.
SurfaceMesh random_sphere(std::uint32_t seed, unsigned vertices);

/// A double pyramid over a polygon of that many vertices: its two tips are joined to all of them.
SurfaceMesh double_pyramid(unsigned vertices);

/// Closed surfaces of genus 0 that a map can have trouble with.
std::vector<NamedMesh> closed_meshes();

}  // namespace interleaf::testing
