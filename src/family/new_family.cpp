#include "family/new_family.h"

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "family/names.h"
#include "text/shown_text.h"

namespace interleaf {

namespace {

constexpr std::size_t max_domain_keys = 9;

void make_unique(std::vector<Key>& keys) {
    std::set<std::string> taken;
    for (Key& key : keys) {
        key.name = unused_name(key.name, [&](const std::string& name) { return taken.contains(name); });
        taken.insert(key.name);
    }
}

/// Corner \p corner of a regular polygon about the origin that stands on a side, rounded to millionths.
glm::dvec2 polygon_corner(std::size_t corner, std::size_t count) {
    const double turn = (static_cast<double>(corner) - 0.5) / static_cast<double>(count) - 0.25;
    const double angle = 2 * std::numbers::pi * turn;
    const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };
    return {rounded(std::cos(angle)), rounded(std::sin(angle))};
}

ParameterDomain domain_of(std::size_t key_count) {
    const bool has_middle = key_count > 3;
    const std::size_t corner_count = has_middle ? key_count - 1 : key_count;
    std::vector<DomainVertex> vertices;
    if (has_middle) vertices.push_back({{0, 0}, 0});
    for (std::size_t corner = 0; corner < corner_count; ++corner)
        vertices.push_back({polygon_corner(corner, corner_count), vertices.size()});

    std::vector<Triangle> triangles;
    const auto count = static_cast<Index>(corner_count);
    if (!has_middle) triangles.push_back({0, 1, 2});
    for (Index corner = 0; has_middle && corner < count; ++corner)
        triangles.push_back({0, 1 + corner, 1 + (corner + 1) % count});
    return {std::move(vertices), std::move(triangles)};
}

}  // namespace

Family family_of_keys(std::string_view name, std::vector<Key> keys) {
    make_unique(keys);
    Family family{.name = shown_text(name), .keys = std::move(keys), .timeline = {}, .domain = {}};
    const std::size_t count = family.keys.size();
    if (count >= 2) {
        std::vector<TimelineKey> times;
        times.reserve(count);
        for (std::size_t key = 0; key < count; ++key) times.push_back({static_cast<double>(key), key});
        family.timeline.emplace(std::move(times));
    }
    if (can_have_new_domain(family)) family.domain = domain_of(count);
    return family;
}

bool can_have_new_domain(const Family& family) {
    return family.keys.size() >= 3 && family.keys.size() <= max_domain_keys;
}

}  // namespace interleaf
