#include "hierarchy/detail/key_detail.h"

#include "hierarchy/detail/vertex_errors.h"

namespace interleaf {

KeyDetail measure_detail(const Hierarchy& hierarchy, const DetailProgress& progress) {
    constexpr double part_of_deviations = 0.6;
    KeyDetail detail;
    detail.deviations =
        deviations(hierarchy, progress ? [&progress](double part) { progress(part_of_deviations * part); }
                                       : DetailProgress());
    if (progress) progress(part_of_deviations);
    detail.forest = bisection_forest(hierarchy);
    detail.cones = normal_cones(hierarchy, detail.forest);
    if (progress) progress(0.75);
    detail.errors = vertex_errors(hierarchy, detail.forest, detail.deviations);
    if (progress) progress(1);
    return detail;
}

}  // namespace interleaf
