// The timed refinements, the same for Interleaf and for its peers.
//
// Each starts from the icosahedron on the unit sphere and proceeds in rounds until no leaf is marked. A round
// marks every leaf that is less deep than demanded at its centroid, and refines the mesh once. New vertices
// are placed on the sphere.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>

#include "text/parsed_number.h"

namespace interleaf::bench {

enum class Workload {
    uniform,  ///< the same depth everywhere
    point,    ///< deepest around the point (1, 0, 0), less deep farther away
    curve,    ///< deepest along the circle z = 0.3, less deep farther away
};

inline std::optional<Workload> workload_named(std::string_view name) {
    if (name == "uniform") return Workload::uniform;
    if (name == "point") return Workload::point;
    if (name == "curve") return Workload::curve;
    return std::nullopt;
}

/// What a program that runs a workload is told on its command line.
struct WorkloadArguments {
    Workload workload;
    unsigned depth;  ///< at most 24, since the peers count in int
};

/// The arguments "uniform|point|curve DEPTH". None, after the usage on standard error, if they are others.
inline std::optional<WorkloadArguments> workload_arguments(int argc, char** argv) {
    const auto workload = argc == 3 ? workload_named(argv[1]) : std::nullopt;
    const auto depth = argc == 3 ? parsed_number<unsigned>(argv[2]) : std::nullopt;
    if (workload && depth && *depth <= 24) return WorkloadArguments{*workload, *depth};
    std::fprintf(stderr, "usage: %s uniform|point|curve DEPTH (at most 24)\n", argv[0]);
    return std::nullopt;
}

/// The level demanded at the centroid (\p x, \p y, \p z) of a leaf: \p depth where the workload is deepest,
/// and two levels less (half the edge length) for each doubling of the distance beyond \p core.
inline double wanted_level(Workload workload, unsigned depth, double x, double y, double z) {
    if (workload == Workload::uniform) return depth;
    constexpr double core = 0.05;
    const double distance = workload == Workload::point ? std::hypot(x - 1, y, z) : std::abs(z - 0.3);
    return depth - 2 * std::log2(std::max(1.0, distance / core));
}

}  // namespace interleaf::bench
