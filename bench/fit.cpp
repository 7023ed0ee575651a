// The cost of fitting a key to a mesh, by stage, and of sampling a large key. The mesh is a shape's key with
// the requested number of vertices, denser where the shape bends more. Prints one line of JSON. Seconds are
// processor time, which other work on the machine disturbs least.
#include "fit/fit.h"

#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "json_line.h"

#include "fit/clean_up/clean_up.h"
#include "fit/sampling/surface_sampling.h"
#include "fit/sphere_map/alignment.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/hierarchy.h"
#include "shapes/shapes.h"
#include "text/parsed_number.h"

namespace {

using namespace interleaf;

/// As many as the first bunny of the paper's appendix has.
constexpr Index sampled_leaves = 127000;

SurfaceMesh make_mesh(const Shape& shape, Index vertices) {
    const Hierarchy key = make_key(shape, {.leaves = 2 * vertices - 4, .tolerance = {}});
    SurfaceMesh mesh;
    mesh.positions.assign(key.positions.begin(), key.positions.end());
    for (const Leaf& leaf : leaves_of(key)) mesh.triangles.push_back(leaf.vertices);
    return mesh;
}

/// Processor seconds that \p work takes.
template <typename Work>
double processor_seconds_of(Work&& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Samples the mesh as fit() does, with more leaves.
double sampling_seconds(const SurfaceMesh& mesh, std::vector<glm::dvec3> points, Index& leaves) {
    rotate(points, rotation_to_surface(mesh, points));
    const MappedSurface mapped(mesh, points);
    const SphereRoots roots = FitOptions().roots;
    return processor_seconds_of([&] {
        leaves =
            static_cast<Index>(sample_surface(mapped, roots, {.leaves = sampled_leaves}, {}).leaves.size());
    });
}

}  // namespace

int main(int argc, char** argv) {
    const Shape* shape = argc == 3 ? find_shape(argv[1]) : nullptr;
    const auto vertices = argc == 3 ? parsed_number<Index>(argv[2]).value_or(0) : 0;
    if (shape == nullptr || vertices < 12 || vertices > 2'000'000) {
        std::fprintf(stderr, "usage: %s SHAPE VERTICES (12 to 2000000)\n", argv[0]);
        return 2;
    }
    SurfaceMesh mesh = make_mesh(*shape, vertices);
    CleanMesh clean;
    const double cleaning = processor_seconds_of([&] { clean = clean_up(std::move(mesh), {}); });
    SphericalMap map;
    const double mapping = processor_seconds_of([&] { map = map_to_sphere(clean.mesh, {}, Keeps::shapes); });
    const double centering = processor_seconds_of([&] { center_map(clean.mesh, map.points); });
    FittedKey key;
    const double sampling = processor_seconds_of([&] { key = fit_mapped(clean.mesh, map.points, {}); });
    Index leaves = 0;
    const double sampling_more = sampling_seconds(clean.mesh, map.points, leaves);

    bench::print_line({{"shape", argv[1]},
                       {"vertices", clean.mesh.positions.size()},
                       {"clean_up_seconds", cleaning},
                       {"map_seconds", mapping},
                       {"centering_seconds", centering},
                       {"sample_and_measure_seconds", sampling},
                       {"fit_seconds", cleaning + mapping + centering + sampling},
                       {"hausdorff", key.report.quality.hausdorff},
                       {"least_angle", key.report.quality.min_angle},
                       {"flipped_leaves", key.report.quality.flipped_leaves},
                       {"sampled_leaves", leaves},
                       {"sampling_seconds", sampling_more}});
    return 0;
}
