// family.json beside three keys over one root complex, a.ilh, b.ilh and c.ilh, and one over another,
// other.ilh.
#include <array>
#include <cmath>
#include <string>

#include "fuzz/scratch_file.h"
#include "fuzz/target.h"

#include "family/family_time.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf::fuzz {

namespace {

class FamilyFile : public ScratchFile {
  public:
    FamilyFile() : ScratchFile("family.json") {
        const Hierarchy triangle = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        const Hierarchy turned = unrefined(RootComplex(3, {{1, 2, 0}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        for (const char* const name : {"a.ilh", "b.ilh", "c.ilh"}) write_hierarchy(triangle, folder() / name);
        write_hierarchy(turned, folder() / "other.ilh");
    }
};

bool are_finite(const Weights& weights) {
    for (const Weight& weight : weights)
        if (!std::isfinite(weight.value)) return false;
    return !weights.empty();
}

std::string inspected(const Family& family) {
    if (!check(family).empty()) return "unsound: " + check(family).front();
    if (!std::isfinite(family.origin.x) || !std::isfinite(family.origin.y) || !std::isfinite(family.origin.z))
        return "the origin is not finite";
    if (family.timeline) {
        const double begin = family.timeline->begin();
        const double end = family.timeline->end();
        for (const double time : {begin, end, 0.5 * begin + 0.5 * end, 0.0})
            if (!are_finite(family.timeline->at(time))) return "the timeline's weights are not finite";
    }
    if (family.path) {
        const auto [begin, end] = interval_of(family, TimeSource::path);
        for (const double time : {begin, end, 0.5 * begin + 0.5 * end, 0.0})
            if (!are_finite(weights_at(family, time, TimeSource::path)))
                return "the path's weights are not finite";
    }
    if (family.domain)
        for (const glm::dvec2 point : {glm::dvec2(0), glm::dvec2(0.3, 0.4), glm::dvec2(-1e9, 1e30)})
            if (!are_finite(family.domain->weights(family.domain->locate(point))))
                return "the domain's weights are not finite";
    return {};
}

Inspection read(ByteSpan bytes) {
    static const FamilyFile file;
    file.set_content(bytes);
    return [family = read_family(file.path())] { return inspected(family); };
}

}  // namespace

const Target target{"family", read, whole_as_part, first_part, own_size};

}  // namespace interleaf::fuzz
