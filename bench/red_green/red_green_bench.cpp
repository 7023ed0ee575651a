// Red-green refinement instead of bisection (paper, section 1 and figure 5): the same surfaces, the union
// that their keys need, and its special cases. Prints one JSON object on one line. The output is the same on
// every machine whose mathematical library rounds in the same way. docs/red-green.md explains the figures.
//
// With --families FOLDER, it writes instead the families from which docs/draw-pictures makes that page's
// pictures.
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string_view>
#include <vector>

#include "comparison.h"
#include "figure_five.h"
#include "picture_family.h"

#include "hierarchy/morph.h"
#include "hierarchy/union_mesh.h"
#include "io/family/family_file.h"

namespace {

using namespace interleaf;
using namespace interleaf::bench;
using Json = nlohmann::ordered_json;

constexpr std::array tolerances = {0.008, 0.004, 0.002, 0.001, 0.0005};
constexpr double other_keys_tolerance = 0.001;
constexpr std::size_t same_leaves = 20000;
constexpr double picture_tolerance = 0.005;

Json names(std::span<Subject* const> subjects) {
    Json result = Json::array();
    for (const Subject* subject : subjects) result.push_back(subject->name());
    return result;
}

Json at_same_tolerance(std::span<Subject* const> subjects, double tolerance) {
    const std::vector<double> each(subjects.size(), tolerance);
    return {{"same", "tolerance"},
            {"tolerance", tolerance},
            {"keys", names(subjects)},
            {"bisection", bisection_figures(subjects, each)},
            {"red_green", red_green_figures(subjects, each)}};
}

Json at_same_leaves(std::span<Subject* const> subjects, std::size_t leaves) {
    std::vector<double> bisection;
    std::vector<double> red_green;
    for (Subject* subject : subjects) {
        bisection.push_back(subject->bisection_tolerance(leaves));
        red_green.push_back(subject->red_green_tolerance(leaves));
    }
    return {{"same", "leaves a key, at most"},
            {"leaves", leaves},
            {"keys", names(subjects)},
            {"bisection", bisection_figures(subjects, bisection)},
            {"red_green", red_green_figures(subjects, red_green)}};
}

Json all_runs() {
    RedComplex complex = sphere_complex();
    Subject sphere(complex, "sphere");
    Subject star(complex, "star");
    Subject bone(complex, "bone");
    Subject cushion(complex, "cushion");
    const std::array all = {&sphere, &star, &bone};
    Json runs = Json::array();
    for (const double tolerance : tolerances) runs.push_back(at_same_tolerance(all, tolerance));
    runs.push_back(at_same_tolerance(std::array{&star, &bone}, other_keys_tolerance));
    runs.push_back(at_same_tolerance(std::array{&sphere, &star, &bone, &cushion}, other_keys_tolerance));
    runs.push_back(at_same_leaves(all, same_leaves));
    return runs;
}

/// The blend in the pictures, coarse enough for its triangles to be distinguishable.
void write_families(const std::filesystem::path& folder) {
    RedComplex complex = sphere_complex();
    Subject sphere(complex, "sphere");
    Subject star(complex, "star");
    Subject bone(complex, "bone");
    const std::array subjects = {&sphere, &star, &bone};
    const std::array tolerance = {picture_tolerance, picture_tolerance, picture_tolerance};
    constexpr std::array weights = {0.2, 0.4, 0.4};

    const std::vector<RedGreenKey> red_green = red_green_keys(subjects, tolerance);
    write_family(picture_family(pieces_of(overlay(red_green), weights)), folder / "red-green");

    const std::vector<Hierarchy> bisected = bisected_keys(subjects, tolerance);
    const UnionMesh mesh = unite(std::array{&bisected[0], &bisected[1], &bisected[2]});
    const std::vector<float> values(weights.begin(), weights.end());
    write_family(picture_family(pieces_of(mesh.triangles, morph(mesh, values))), folder / "bisection");

    write_family(picture_family(figure_five()), folder / "figure-5");
}

}  // namespace

int main(int argument_count, char** arguments) {
    try {
        if (argument_count == 3 && arguments[1] == std::string_view("--families")) {
            write_families(arguments[2]);
        } else if (argument_count == 1) {
            std::puts(Json{{"runs", all_runs()}}.dump().c_str());
        } else {
            std::fputs("usage: bench_red_green [--families FOLDER]\n", stderr);
            return 2;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_red_green: %s\n", error.what());
        return 1;
    }
    return 0;
}
