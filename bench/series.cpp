// Recovery of keys from a series of flat meshes: time per step, and memory per triangle of a step. The steps are
// a front that moves over a square, refined by bisection. Each method gets what it needs: the order of the
// bisection, the same triangles in random order, or a tolerance. Prints one line of JSON.
#include "sequence/series/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "json_line.h"
#include <malloc.h>
#include <sys/resource.h>

#include "hierarchy/adaptive_mesh.h"
#include "text/parsed_number.h"

namespace {

using namespace interleaf;

constexpr unsigned step_count = 3;

/// A square of eight triangles around its center, with their longest edges on the boundary and the axes.
Hierarchy square_roots() {
    std::vector<glm::vec3> positions;
    for (const float y : {-1.0F, 0.0F, 1.0F})
        for (const float x : {-1.0F, 0.0F, 1.0F}) positions.emplace_back(x, y, 0);
    return unrefined(
        RootComplex(9,
                    {{1, 4, 0}, {3, 0, 4}, {1, 2, 4}, {5, 4, 2}, {7, 6, 4}, {3, 4, 6}, {7, 4, 8}, {5, 8, 4}}),
        positions);
}

/// The front at step \p step: a field from 0 to 1.
double front(const glm::dvec3& at, unsigned step) {
    const double x = at.x - 0.1 * step;
    return 1 / (1 + std::exp((std::sqrt(x * x + at.y * at.y) - 0.5) * 40));
}

/// The roots, refined at the front until there are \p triangles leaves.
FieldMesh make_step(const Hierarchy& roots, unsigned step, std::size_t triangles) {
    AdaptiveMesh mesh(roots.roots, roots.positions);
    std::vector<Index> marked;
    while (mesh.leaf_count() < triangles) {
        marked.clear();
        for (Index leaf = 0; leaf < mesh.leaf_bound() && mesh.leaf_count() + marked.size() < triangles;
             ++leaf) {
            const auto& [a, b, c] = mesh.vertices(leaf);
            const glm::dvec3 middle((mesh.positions()[a] + mesh.positions()[b] + mesh.positions()[c]) / 3.0F);
            const double value = front(middle, step);
            if (mesh.level(leaf) < 4 || 4 * value * (1 - value) * 24 > mesh.level(leaf))
                marked.push_back(leaf);
        }
        if (marked.empty())
            for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf) marked.push_back(leaf);
        mesh.refine(marked);
    }
    FieldMesh flat;
    for (const glm::vec3& position : mesh.positions()) flat.points.emplace_back(position);
    for (const Index leaf : mesh.preorder()) flat.triangles.push_back(mesh.vertices(leaf));
    MeshField field{"u", 1, {}};
    for (const glm::dvec3& point : flat.points) field.values.push_back(front(point, step));
    flat.point_fields.push_back(std::move(field));
    return flat;
}

void shuffle(FieldMesh& mesh, unsigned seed) {
    std::mt19937 random(seed);
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    for (auto& corners : mesh.triangles)
        std::rotate(corners.begin(), corners.begin() + random() % 3, corners.end());
}

/// The memory of the program at its peak, in bytes.
std::size_t peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Gives back freed memory, and begins a new peak at the present memory (Linux).
void begin_peak() {
    malloc_trim(0);
    if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {
        std::fputs("5", file);
        std::fclose(file);
    }
}

/// Seconds of the processor that \p work takes, because other programs may run at the same time.
template <typename Work>
double processor_seconds_of(Work&& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view method = argc == 3 ? argv[1] : "";
    const std::size_t triangles = argc == 3 ? parsed_number<std::size_t>(argv[2]).value_or(0) : 0;
    if (triangles < 100 || triangles > 10'000'000 ||
        (method != "order" && method != "place" && method != "sampling")) {
        std::fprintf(stderr, "usage: %s order|place|sampling TRIANGLES (100 to 10,000,000)\n", argv[0]);
        return 2;
    }
    const Hierarchy roots = square_roots();
    std::vector<FieldMesh> steps;
    for (unsigned step = 0; step < step_count; ++step) {
        steps.push_back(make_step(roots, step, triangles));
        if (method != "order") shuffle(steps.back(), step);
    }
    SeriesOptions options;
    if (method == "sampling") options.tolerance = 0.001;
    const Series series{steps.size(), [&](std::size_t step) { return steps[step]; }};

    begin_peak();
    const std::size_t before = peak_bytes();
    SeriesReport report;
    const double seconds = processor_seconds_of(
        [&] { report = recover(series, options, [](std::size_t, const Hierarchy&) {}); });
    std::size_t leaves = 0;
    std::size_t most_triangles = 0;
    for (const StepReport& step : report.steps) {
        leaves += step.leaves;
        most_triangles = std::max(most_triangles, step.triangles);
    }
    bench::print_line({{"method", std::string(name_of(report.method))},
                       {"roots", report.root_count},
                       {"triangles_per_step", most_triangles},
                       {"leaves", leaves},
                       {"seconds_per_step", seconds / step_count},
                       {"bytes_per_triangle", (peak_bytes() - before) / most_triangles}});
    return 0;
}
