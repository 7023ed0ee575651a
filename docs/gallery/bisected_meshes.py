#!/usr/bin/env python3
"""Writes the flat meshes of the paper's figures 1 to 7 as series that `interleaf import` reads: bisected_meshes.py FOLDER

The bisection here is the paper's algorithm (A), word for word. It shares no code with the program, which finds the
hierarchies in the meshes again.
"""
import sys
from pathlib import Path


class Mesh:
    """A conforming mesh. The refinement edge of a triangle lies opposite its first vertex (figure 4)."""

    def __init__(self, points, triangles):
        self.points = [tuple(map(float, point)) for point in points]
        self.triangles = list(triangles)
        self.middles = {}  # edge -> the vertex at its midpoint

    def middle(self, edge):
        if edge not in self.middles:
            ends = [self.points[vertex] for vertex in edge]
            self.points.append(tuple(sum(values) / 2 for values in zip(*ends)))
            self.middles[edge] = len(self.points) - 1
        return self.middles[edge]

    def bisect(self, marked):
        """One step of algorithm (A): bisects the marked triangles, then those that are not conforming."""
        while marked:
            bisected = []
            for triangle in self.triangles:
                if triangle in marked:
                    i, j, k = triangle
                    new = self.middle(frozenset((j, k)))
                    bisected += [(new, k, i), (new, i, j)]
                else:
                    bisected.append(triangle)
            self.triangles = bisected
            marked = {triangle for triangle in self.triangles if self.has_hanging_vertex(triangle)}

    def has_hanging_vertex(self, triangle):
        i, j, k = triangle
        return any(frozenset(edge) in self.middles for edge in ((i, j), (j, k), (k, i)))

    def bisect_at(self, place, steps):
        """Marks, `steps` times, every triangle that the place lies in."""
        for _ in range(steps):
            self.bisect({triangle for triangle in self.triangles if self.holds(triangle, place)})

    def holds(self, triangle, place):
        corners = [self.points[vertex] for vertex in triangle]
        sides = [(b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0])
                 for a, b in zip(corners, corners[1:] + corners[:1])]
        return min(sides) >= 0 or max(sides) <= 0

    def write(self, file, shift):
        """Writes the mesh with the field `shift`, which import --displacement adds to the points."""
        lines = ["# vtk DataFile Version 3.0", file.stem, "ASCII", "DATASET POLYDATA",
                 f"POINTS {len(self.points)} double", *(f"{x} {y} 0" for x, y in self.points),
                 f"POLYGONS {len(self.triangles)} {4 * len(self.triangles)}",
                 *("3 {} {} {}".format(*triangle) for triangle in self.triangles),
                 f"POINT_DATA {len(self.points)}", "VECTORS shift double",
                 *("{} {} {}".format(*shift(point)) for point in self.points)]
        file.write_text("\n".join(lines) + "\n")


def triangle():
    return Mesh([(0, 0.8), (-1, -0.6), (1, -0.6)], [(0, 1, 2)])


def square():
    """Four triangles around the middle, whose refinement edges are the sides of the square."""
    return Mesh([(0, 0), (-1, -1), (1, -1), (1, 1), (-1, 1)], [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1)])


def patch():
    """Triangles whose refinement edges point at each other in a chain: marking one bisects its neighbors."""
    return Mesh([(-1.5, -0.7), (-0.5, -0.8), (0.5, -0.8), (1.5, -0.7), (-1, 0.1), (0, 0), (1, 0.1), (-0.5, 0.9), (0.5, 0.9)],
                [(0, 1, 4), (1, 4, 5), (1, 2, 5), (2, 5, 6), (3, 6, 2), (4, 5, 7), (8, 5, 7), (8, 6, 5)])


def bulge(point):
    """Bends the triangle: each vertex that a bisection adds leaves the edge that it halves."""
    x, y = point
    return 0.2 * (y * y - 0.3), 0.35 * (1 - x * x) * (0.8 - y) - 0.3, 0


def write_series(folder, name, meshes):
    """`meshes` has pairs of a mesh and the field that shifts its points; without the field, a mesh that stays."""
    series = folder / name
    series.mkdir(parents=True)
    for number, item in enumerate(meshes):
        mesh, shift = item if isinstance(item, tuple) else (item, lambda point: (0, 0, 0))
        mesh.write(series / f"{name}.{number}.vtk", shift)


def main(folder):
    halves = triangle()
    halves.bisect(set(halves.triangles))
    quarters = triangle()
    for _ in range(2):
        quarters.bisect(set(quarters.triangles))
    write_series(folder, "figure-1", [triangle(), halves])
    write_series(folder, "figure-2", [triangle(), halves, quarters])

    before, after = patch(), patch()
    after.bisect({after.triangles[0]})
    write_series(folder, "figure-3", [before, after])

    left, right = square(), square()
    left.bisect_at((-0.97, -0.9), 6)
    right.bisect_at((0.6, 0.3), 5)
    write_series(folder, "figure-6", [square(), left, right])

    fine = triangle()
    fine.bisect_at((-0.2, 0.1), 4)
    write_series(folder, "figure-7", [triangle(), (fine, bulge)])


if __name__ == "__main__":
    main(Path(sys.argv[1]))
