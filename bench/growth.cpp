// How refine, union, morph and load grow: two keys of one size, each uniform but for half of its leaves,
// which are bisected once more, a different half in each. Prints one line of JSON. The morph is read against
// a triad of the same size, for its speed follows that of the memory level it fits in.
#include <algorithm>
#include <filesystem>
#include <random>
#include <vector>

#include "json_line.h"
#include "text/parsed_number.h"
#include <glm/geometric.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/morph.h"
#include "hierarchy/union_mesh.h"
#include "io/hierarchy/hierarchy_file.h"
#include "shapes/icosahedron.h"

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

/// Bytes a second of a = b + factor * c, counted as in STREAM, over arrays of \p count floats in all.
double triad_rate(std::size_t count) {
    Buffer<float> a(count / 3), b(count / 3, 1.0F), c(count / 3, 2.0F);
    std::fill(a.begin(), a.end(), 0.0F);
    const double seconds = bench::least_seconds_of(runs, [&] {
        for (std::size_t n = 0; n < a.size(); ++n) a[n] = b[n] + 3.0F * c[n];
    });
    return a.back() == 7.0F ? 3 * sizeof(float) * static_cast<double>(a.size()) / seconds : 0;
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
    const double uniting = bench::least_seconds_of(runs, [&] { unite(pointers, mesh); });

    const std::vector<float> weights = {0.3F, 0.7F};
    Buffer<glm::vec3> positions;
    morph(mesh, weights, positions);
    const double morphing = bench::least_seconds_of(runs, [&] { morph(mesh, weights, positions); });
    const std::size_t morph_bytes = 3 * positions.size() * sizeof(glm::vec3);

    const auto file =
        std::filesystem::temp_directory_path() / ("interleaf-growth-" + std::to_string(::getpid()) + ".ilh");
    write_hierarchy(keys[0], file);
    const double loading = bench::least_seconds_of(runs, [&] { read_hierarchy(file); });
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
                       {"triad_bytes_per_second", triad_rate(morph_bytes / sizeof(float))},
                       {"load_seconds", loading},
                       {"file_bytes", file_bytes}});
    return 0;
}
