#include "app/sample_family.h"

namespace interleaf {

Family sample_family() {
    Family family;
    family.name = "sample";
    const RootComplex roots(3, {{0, 1, 2}});
    for (const char* name : {"a", "b", "c", "d", "e"})
        family.keys.push_back({name, unrefined(roots, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
    family.timeline.emplace(std::vector<TimelineKey>{{0, 0}, {1, 1}, {3, 4}, {4, 2}, {5, 0}});
    family.domain.emplace(
        std::vector<DomainVertex>{{{-1, -1}, 0}, {{1, -1}, 1}, {{1, 1}, 2}, {{-1, 1}, 3}, {{0, 0}, 4}},
        std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    return family;
}

Family named(const std::string& name) {
    Family family = sample_family();
    family.name = name;
    return family;
}

}  // namespace interleaf
