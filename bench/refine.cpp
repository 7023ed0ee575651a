// Refines the icosahedron by one of the workloads and coarsens it back to its roots, each once, in fresh
// memory. Prints one line of JSON. The peers in bench/peers do the same work and print the same line.
#include <vector>

#include "json_line.h"
#include "workload.h"
#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/checker.h"
#include "shapes/icosahedron.h"

namespace {

using namespace interleaf;

/// Marks the leaves that are less deep than \p workload demands.
void mark(const AdaptiveMesh& mesh, bench::Workload workload, unsigned depth, std::vector<Index>& marks) {
    marks.clear();
    for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf) {
        const auto& [a, b, c] = mesh.vertices(leaf);
        const glm::vec3 centroid = (mesh.positions()[a] + mesh.positions()[b] + mesh.positions()[c]) / 3.0F;
        if (mesh.level(leaf) < bench::wanted_level(workload, depth, centroid.x, centroid.y, centroid.z))
            marks.push_back(leaf);
    }
}

void mark_all(const AdaptiveMesh& mesh, std::vector<Index>& marks) {
    marks.clear();
    for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf)
        if (mesh.is_leaf(leaf)) marks.push_back(leaf);
}

}  // namespace

int main(int argc, char** argv) {
    const auto arguments = bench::workload_arguments(argc, argv);
    if (!arguments) return 2;
    const auto [workload, depth] = *arguments;
    const Hierarchy roots = icosahedron();
    const AdaptiveMesh* self = nullptr;
    AdaptiveMesh mesh(roots.roots, roots.positions, [&](Index a, Index b, Index) {
        return glm::normalize(self->positions()[a] + self->positions()[b]);
    });
    self = &mesh;

    std::vector<Index> marks;
    double refining = 0;
    for (mark(mesh, workload, depth, marks); !marks.empty(); mark(mesh, workload, depth, marks))
        refining += bench::seconds_of([&] { mesh.refine(marks); });
    const Index leaves = mesh.leaf_count();
    const double bytes = static_cast<double>(mesh.byte_count()) / leaves;
    const bool sound = leaves > 2'000'000 || check(mesh.freeze()).empty();

    double coarsening = 0;
    while (mesh.leaf_count() > roots.leaf_count()) {
        mark_all(mesh, marks);
        coarsening += bench::seconds_of([&] { mesh.coarsen(marks); });
    }
    bench::print_line({{"program", "interleaf"},
                       {"workload", argv[1]},
                       {"depth", depth},
                       {"leaves", leaves},
                       {"refine_seconds", refining},
                       {"coarsen_seconds", coarsening},
                       {"leaves_after_coarsening", mesh.leaf_count()},
                       {"bytes_per_leaf", bytes}});
    return sound && mesh.violations().empty() ? 0 : 1;
}
