// The growth of refine, union, morph and load. The two keys have the same size. Each is uniform, except that
// half of its leaves are bisected once more, a different half in each key. Prints one line of JSON. The morph
// is compared with a triad of the same size, because its speed depends on the memory level that the data fit
// in.
#include <algorithm>
#include <filesystem>
#include <random>
#include <vector>

#include "json_line.h"
#include "triad.h"
#include <glm/geometric.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/morph.h"
#include "hierarchy/union_mesh.h"
#include "io/hierarchy/hierarchy_file.h"
#include "shapes/icosahedron.h"
#include "text/parsed_number.h"

namespace {

using namespace interleaf;

constexpr int runs = 5;

Hierarchy make_key(unsigned depth, unsigned seed, double& refining) {
    const Hierarchy roots = icosahedron();
    const AdaptiveMesh* self = nullptr;
    AdaptiveMesh mesh(roots.roots, roots.positions, [&](Index a, Index b, Index) {
        return glm::normalize(self->positions()[a] + self->positions()[b]);
    });
    self = &mesh;
    std::mt19937 random(seed);
    std::vector<Index> marks;
    for (unsigned round = 0; round <= depth; ++round) {
        marks.clear();
        for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf)
            if (mesh.level(leaf) == round && (round < depth || random() % 4 == 0)) marks.push_back(leaf);
        refining += bench::seconds_of([&] { mesh.refine(marks); });
    }
    return mesh.freeze();
}

long page_faults() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

}  // namespace

int main(int argc, char** argv) {
    const unsigned depth = argc == 2 ? parsed_number<unsigned>(argv[1]).value_or(0) : 0;
    if (depth < 1 || depth > 20) {
        std::fprintf(stderr, "usage: %s DEPTH (1 to 20: 20 * 2^DEPTH leaves a key, and half as many again)\n",
                     argv[0]);
        return 2;
    }
    double refining = 0;
    const std::vector<Hierarchy> keys = {make_key(depth, 1, refining), make_key(depth, 2, refining)};
    const std::vector<const Hierarchy*> pointers = {&keys[0], &keys[1]};

    UnionMesh mesh;
    const long faults_before = page_faults();
    const double first_union = bench::seconds_of([&] { unite(pointers, mesh); });
    const long faults = page_faults() - faults_before;
    const double uniting = bench::min_seconds_of(runs, [&] { unite(pointers, mesh); });

    const std::vector<float> weights = {0.3F, 0.7F};
    Buffer<glm::vec3> positions;
    morph(mesh, weights, positions);
    const double morphing = bench::min_seconds_of(runs, [&] { morph(mesh, weights, positions); });
    const std::size_t morph_bytes = 3 * positions.size() * sizeof(glm::vec3);

    const auto file =
        std::filesystem::temp_directory_path() / ("interleaf-growth-" + std::to_string(::getpid()) + ".ilh");
    write_hierarchy(keys[0], file);
    const double loading = bench::min_seconds_of(runs, [&] { read_hierarchy(file); });
    const auto file_bytes = std::filesystem::file_size(file);
    std::filesystem::remove(file);

    bench::print_line({{"leaves", keys[0].leaf_count()},
                       {"refine_seconds", refining / 2},
                       {"union_leaves", mesh.leaf_count()},
                       {"union_seconds", uniting},
                       {"first_union_seconds", first_union},
                       {"first_union_page_faults", faults},
                       {"morph_seconds", morphing},
                       {"morph_bytes", morph_bytes},
                       {"triad_bytes_per_second", bench::triad_rate(morph_bytes / sizeof(float), runs)},
                       {"load_seconds", loading},
                       {"file_bytes", file_bytes}});
    return 0;
}
