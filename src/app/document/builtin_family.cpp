#include "app/document/builtin_family.h"

#include <string>
#include <string_view>
#include <vector>

#include "shapes/shapes.h"

namespace interleaf {

std::filesystem::path builtin_family_folder() {
    std::error_code error;
    const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", error);
    std::filesystem::path installed =
        executable.parent_path().parent_path() / "share" / "interleaf" / "families" / "five-keys";
    if (std::filesystem::is_directory(installed, error)) return installed;
    return INTERLEAF_SOURCE_FAMILY;
}

Family make_five_keys() {
    Family family{.name = "Five keys", .keys = {}, .timeline = {}, .domain = {}};
    for (const ShippedKey& key : five_keys()) {
        family.keys.push_back({std::string(key.shape), make_key(*find_shape(key.shape), key.budget)});
    }
    const auto key = [&](std::string_view name) { return find_key(family, name).value(); };
    family.timeline.emplace(std::vector<TimelineKey>{{0, key("star")},
                                                     {2, key("cushion")},
                                                     {4, key("bone")},
                                                     {6, key("icosahedron")},
                                                     {8, key("sphere")},
                                                     {10, key("star")}});
    family.domain.emplace(std::vector<DomainVertex>{{{-1, -1}, key("icosahedron")},
                                                    {{1, -1}, key("bone")},
                                                    {{1, 1}, key("cushion")},
                                                    {{-1, 1}, key("star")},
                                                    {{0, 0}, key("sphere")}},
                          std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    return family;
}

}  // namespace interleaf
