// Peer ALBERTA 3 (A. Schmidt, K. G. Siebert, Design of Adaptive Finite Element Software, Springer 2005): its
// own bisection of a triangle mesh in space, timed on the workloads of bench/workload.h, and its own
// coarsening back to the icosahedron. Prints one line of JSON, where bytes_per_leaf is the growth of the
// resident memory by refinement. Ends with status 1 if the mesh is wrong.
//
// The program adds nothing to ALBERTA's own work: no finite elements, no vectors. ALBERTA computes positions
// on its way down from the macro triangulation, and projected positions in EL::new_coord. refine() always
// numbers vertices.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "peers/peer.h"
#include "workload.h"
#include <alberta/alberta.h>
#include <malloc.h>
#include <unistd.h>

namespace {

using namespace interleaf::bench;

constexpr int corner_count = 12;

[[noreturn]] void fail(const char* what) {
    interleaf::bench::fail("peer_alberta", what);
}

double radius(const REAL_D point) {
    return std::sqrt(point[0] * point[0] + point[1] * point[1] + point[2] * point[2]);
}

void put_on_sphere(REAL_D point, const EL_INFO*, const REAL_B) {
    const double factor = 1 / radius(point);
    for (int axis = 0; axis < 3; ++axis) point[axis] *= factor;
}

NODE_PROJECTION sphere{put_on_sphere};

/// Slot 0 of a macro element is the projection of every new vertex in it, the other slots are for its edges
/// alone.
NODE_PROJECTION* projection_of(MESH*, MACRO_EL*, int slot) {
    return slot == 0 ? &sphere : nullptr;
}

MESH* icosahedron() {
    MACRO_DATA* data = alloc_macro_data(2, corner_count, root_count);
    const double phi = (1 + std::sqrt(5.0)) / 2;
    const double corners[corner_count][3] = {{0, 1, phi}, {0, 1, -phi}, {0, -1, phi}, {0, -1, -phi},
                                             {1, phi, 0}, {1, -phi, 0}, {-1, phi, 0}, {-1, -phi, 0},
                                             {phi, 0, 1}, {-phi, 0, 1}, {phi, 0, -1}, {-phi, 0, -1}};
    for (int corner = 0; corner < corner_count; ++corner) {
        std::memcpy(data->coords[corner], corners[corner], sizeof(REAL_D));
        put_on_sphere(data->coords[corner], nullptr, nullptr);
    }
    for (int root = 0; root < root_count; ++root) {
        // ALBERTA's refinement edge connects the local vertices 0 and 1.
        for (int i = 0; i < 3; ++i) data->mel_vertices[3 * root + i] = roots[root][(i + 1) % 3];
    }
    compute_neigh_fast(data);
    default_boundary(data, DIRICHLET, true);
    MESH* mesh = GET_MESH(2, "icosahedron", data, projection_of, nullptr);
    free_macro_data(data);
    return mesh;
}

template <typename Visit>
void for_each_leaf(MESH* mesh, FLAGS filled, Visit visit) {
    TRAVERSE_STACK* stack = get_traverse_stack();
    const EL_INFO* leaf = traverse_first(stack, mesh, -1, CALL_LEAF_EL | filled);
    for (; leaf != nullptr; leaf = traverse_next(stack, leaf)) visit(*leaf);
    free_traverse_stack(stack);
}

/// Marks the leaves that are less deep than \p workload demands for one bisection.
/// \return false if there is none
bool mark_for_refinement(MESH* mesh, Workload workload, unsigned depth) {
    bool any = false;
    for_each_leaf(mesh, FILL_COORDS, [&](const EL_INFO& leaf) {
        const auto& corners = leaf.coord;
        const auto centroid = [&](int axis) {
            return (corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3;
        };
        const bool marked = leaf.level < wanted_level(workload, depth, centroid(0), centroid(1), centroid(2));
        leaf.el->mark = marked ? 1 : 0;
        any = any || marked;
    });
    return any;
}

/// Seconds spent in refine().
double refine_to(MESH* mesh, Workload workload, unsigned depth) {
    double seconds = 0;
    while (mark_for_refinement(mesh, workload, depth)) {
        const auto start = Clock::now();
        refine(mesh, FILL_NOTHING);
        seconds += seconds_since(start);
    }
    return seconds;
}

/// Seconds spent in coarsen().
double coarsen_to_roots(MESH* mesh) {
    double seconds = 0;
    bool coarsened = true;
    while (coarsened && mesh->n_elements > root_count) {
        for_each_leaf(mesh, FILL_NOTHING, [](const EL_INFO& leaf) { leaf.el->mark = -1; });
        const auto start = Clock::now();
        coarsened = (coarsen(mesh, FILL_NOTHING) & MESH_COARSENED) != 0;
        seconds += seconds_since(start);
    }
    return seconds;
}

/// The Euler number, counted from the leaves. Fails unless each edge joins two leaves that have its ends in
/// opposite order, and all vertices are on the sphere.
long checked_euler_number(MESH* mesh) {
    const DOF_ADMIN* numbering = get_vertex_admin(mesh, ADM_FLAGS_DFLT);
    const int at = numbering->n0_dof[VERTEX];
    const auto vertex = [at](const EL* el, int corner) { return el->dof[corner % 3][at]; };
    std::vector<bool> met(static_cast<std::size_t>(numbering->size_used));
    long vertices = 0, sides = 0, leaves = 0;
    for_each_leaf(mesh, FILL_COORDS | FILL_NEIGH, [&](const EL_INFO& leaf) {
        ++leaves;
        for (int i = 0; i < 3; ++i) {
            if (std::abs(radius(leaf.coord[i]) - 1) > 1e-5) fail("a vertex is not on the sphere");
            const EL* other = leaf.neigh[i];
            const int opposite = leaf.opp_vertex[i];
            if (other == nullptr || !IS_LEAF_EL(other) ||
                vertex(leaf.el, i + 1) != vertex(other, opposite + 2) ||
                vertex(leaf.el, i + 2) != vertex(other, opposite + 1))
                fail("two neighbors do not fit");
            ++sides;
            auto seen = met[static_cast<std::size_t>(vertex(leaf.el, i))];
            if (!seen) ++vertices;
            seen = true;
        }
    });
    if (vertices != mesh->n_vertices || leaves != mesh->n_elements) fail("the mesh miscounts");
    return vertices - sides / 2 + leaves;
}

}  // namespace

int main(int argc, char** argv) {
    const auto arguments = workload_arguments(argc, argv);
    if (!arguments) return 2;
    const auto [workload, depth] = *arguments;
    // refine() mostly copies one array to another. malloc puts them 20 KiB and 16 bytes apart, for copying
    // the worst of distances (4 KiB aliasing); on pages of their own refine() is up to twice as fast.
    mallopt(M_MMAP_THRESHOLD, 8 * 1024);
    open_msg_file("/dev/null", "w");  // standard output is only for the one line
    MESH* mesh = icosahedron();
    const double bytes_before = resident_bytes();
    const double refine_seconds = refine_to(mesh, workload, depth);
    const double bytes = resident_bytes() - bytes_before;
    const int leaves = mesh->n_elements, vertices = mesh->n_vertices;
    if (workload == Workload::uniform && leaves != root_count << depth) fail("wrong number of leaves");
    const long euler = checked_euler_number(mesh);
    if (euler != 2) fail("the mesh is no sphere");
    const double coarsen_seconds = coarsen_to_roots(mesh);
    if (mesh->n_elements != root_count) fail("coarsening stopped early");
    checked_euler_number(mesh);
    std::printf(
        "{\"program\":\"alberta\",\"version\":\"%s\",\"workload\":\"%s\",\"depth\":%u,\"leaves\":%d,"
        "\"vertices\":%d,\"euler\":%ld,\"refine_seconds\":%.6f,\"coarsen_seconds\":%.6f,"
        "\"leaves_after_coarsening\":%d,\"bytes_per_leaf\":%.1f}\n",
        ALBERTA_PACKAGE_VERSION, argv[1], depth, leaves, vertices, euler, refine_seconds, coarsen_seconds,
        mesh->n_elements, bytes / leaves);
}
