// Peer OpenMesh 9 (M. Botsch et al., OpenMesh: a generic and efficient polygon mesh data structure, 2002):
// newest-vertex bisection as a user would write it with split(edge, vertex), timed on the workloads of
// bench/workload.h. Prints one line of JSON, where bytes_per_leaf is the growth of the resident memory by
// refinement. Ends with status 1 if the mesh is wrong.
//
// OpenMesh lets its user choose the halfedge that a face refers to. Here it is the one at the refinement
// edge, which therefore takes no memory and no look-up. Coarsening is left out: it would be a collapse of
// edges, with status attributes and garbage collection. Debian builds split() with assertions. Without them
// and with -O3, the program refines 1.3 (curve) to 1.7 times (uniform) as fast.
#include <cmath>
#include <cstdio>
#include <vector>

#include "peers/peer.h"
#include "workload.h"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <unistd.h>

namespace {

using namespace interleaf::bench;

struct Traits : OpenMesh::DefaultTraits {
    FaceTraits { unsigned char level = 0; };
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

[[noreturn]] void fail(const char* what) {
    interleaf::bench::fail("peer_openmesh", what);
}

Mesh icosahedron() {
    Mesh mesh;
    const float phi = (1 + std::sqrt(5.0F)) / 2;
    for (const Mesh::Point& corner :
         {Mesh::Point(0, 1, phi), Mesh::Point(0, 1, -phi), Mesh::Point(0, -1, phi), Mesh::Point(0, -1, -phi),
          Mesh::Point(1, phi, 0), Mesh::Point(1, -phi, 0), Mesh::Point(-1, phi, 0), Mesh::Point(-1, -phi, 0),
          Mesh::Point(phi, 0, 1), Mesh::Point(-phi, 0, 1), Mesh::Point(phi, 0, -1), Mesh::Point(-phi, 0, -1)})
        mesh.add_vertex(corner.normalized());
    for (const auto& [i, j, k] : roots) {
        const auto apex = Mesh::VertexHandle(i), from = Mesh::VertexHandle(j), to = Mesh::VertexHandle(k);
        const auto face = mesh.add_face(apex, from, to);
        mesh.set_halfedge_handle(face, mesh.find_halfedge(from, to));
    }
    return mesh;
}

/// A leaf to be bisected. After a bisection the handle refers to one of the children, which the level
/// reveals.
struct Mark {
    Mesh::FaceHandle face;
    unsigned char level;
};

/// The leaves that are less deep than \p workload demands.
std::vector<Mark> marks_of(const Mesh& mesh, Workload workload, unsigned depth) {
    std::vector<Mark> marks;
    for (const auto face : mesh.faces()) {
        const auto centroid = mesh.calc_face_centroid(face);
        const auto level = mesh.data(face).level;
        if (level < wanted_level(workload, depth, centroid[0], centroid[1], centroid[2]))
            marks.push_back({face, level});
    }
    return marks;
}

/// Bisects \p face and its neighbor at their common refinement edge. If the neighbor has another refinement
/// edge, it is bisected there first. The marking of the icosahedron is compatible, so after one such
/// bisection they share the edge, and each recursion is one level up.
void bisect(Mesh& mesh, Mesh::FaceHandle face) {
    const auto side = mesh.halfedge_handle(face);
    const auto other_side = mesh.opposite_halfedge_handle(side);
    const auto waiting_for = mesh.face_handle(other_side);
    if (mesh.halfedge_handle(waiting_for) != other_side) bisect(mesh, waiting_for);

    const auto edge = mesh.edge_handle(side);
    const auto middle = mesh.point(mesh.from_vertex_handle(side)) + mesh.point(mesh.to_vertex_handle(side));
    const int children = static_cast<int>(mesh.n_faces());
    mesh.split(edge, mesh.add_vertex(middle.normalized()));

    // Each child's refinement edge is opposite the new vertex. For the two new faces, split() has set it. The
    // two old ones lie at the half that is still called edge: its halfedge 0 starts at the new vertex,
    // halfedge 1 ends there.
    const auto out = mesh.halfedge_handle(edge, 0), in = mesh.halfedge_handle(edge, 1);
    const auto left = mesh.face_handle(out), right = mesh.face_handle(in);
    mesh.set_halfedge_handle(left, mesh.next_halfedge_handle(out));
    mesh.set_halfedge_handle(right, mesh.prev_halfedge_handle(in));
    const auto level = static_cast<unsigned char>(mesh.data(left).level + 1);
    for (const auto child : {left, right, Mesh::FaceHandle(children), Mesh::FaceHandle(children + 1)})
        mesh.data(child).level = level;
}

/// Seconds spent in bisecting the marked leaves, with closure.
double refine_to(Mesh& mesh, Workload workload, unsigned depth) {
    double seconds = 0;
    while (true) {
        const auto marks = marks_of(mesh, workload, depth);
        if (marks.empty()) return seconds;
        const auto start = Clock::now();
        for (const auto& [face, level] : marks)
            if (mesh.data(face).level == level) bisect(mesh, face);
        seconds += seconds_since(start);
    }
}

/// Fails unless each vertex, halfedge and face agrees with its neighbors, and all vertices are on the
/// sphere.
void check(const Mesh& mesh) {
    for (const auto vertex : mesh.vertices()) {
        if (std::abs(mesh.point(vertex).norm() - 1) > 1e-5F) fail("a vertex is not on the sphere");
        if (mesh.from_vertex_handle(mesh.halfedge_handle(vertex)) != vertex)
            fail("a vertex's halfedge is not its");
    }
    for (const auto side : mesh.halfedges()) {
        const auto next = mesh.next_halfedge_handle(side), last = mesh.next_halfedge_handle(next);
        if (mesh.is_boundary(side) || mesh.next_halfedge_handle(last) != side ||
            mesh.prev_halfedge_handle(next) != side || mesh.face_handle(next) != mesh.face_handle(side) ||
            mesh.from_vertex_handle(next) != mesh.to_vertex_handle(side))
            fail("a halfedge does not fit");
    }
    for (const auto face : mesh.faces())
        if (mesh.face_handle(mesh.halfedge_handle(face)) != face) fail("a face's halfedge is not its");
}

}  // namespace

int main(int argc, char** argv) {
    const auto arguments = workload_arguments(argc, argv);
    if (!arguments) return 2;
    const auto [workload, depth] = *arguments;
    Mesh mesh = icosahedron();
    const std::size_t uniform_count = std::size_t{root_count} << depth;
    // Only here does a user know how large the mesh becomes.
    if (workload == Workload::uniform)
        mesh.reserve(uniform_count / 2 + 2, uniform_count / 2 * 3, uniform_count);
    const double bytes_before = resident_bytes();
    const double refine_seconds = refine_to(mesh, workload, depth);
    const double bytes = resident_bytes() - bytes_before;
    const std::size_t leaves = mesh.n_faces(), vertices = mesh.n_vertices(), edges = mesh.n_edges();
    if (workload == Workload::uniform && leaves != uniform_count) fail("wrong number of leaves");
    check(mesh);
    const long euler = static_cast<long>(vertices + leaves) - static_cast<long>(edges);
    if (euler != 2) fail("the mesh is no sphere");
    std::printf(
        "{\"program\":\"openmesh\",\"version\":\"%d.%d\",\"workload\":\"%s\",\"depth\":%u,\"leaves\":%zu,"
        "\"vertices\":%zu,\"euler\":%ld,\"refine_seconds\":%.6f,\"bytes_per_leaf\":%.1f}\n",
        OM_GET_VER, OM_GET_MAJ, argv[1], depth, leaves, vertices, euler, refine_seconds,
        bytes / static_cast<double>(leaves));
}
