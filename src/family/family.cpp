#include "family/family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "family/names.h"
#include "hierarchy/checker.h"
#include "hierarchy/field.h"
#include "text/characters.h"

namespace interleaf {
namespace {

void check_names(const Family& family, std::vector<std::string>& violations) {
    if (!is_printable(family.name))
        violations.emplace_back("the family's name is not UTF-8 without control characters");
    for (std::size_t i = 0; i < family.keys.size(); ++i) {
        const std::string& name = family.keys[i].name;
        if (name.empty()) {
            violations.push_back(fmt::format("key {} has no name", i));
        } else if (const std::string fault = fault_of_name(name, fmt::format("key {}", i)); !fault.empty()) {
            violations.push_back(fault);
        } else if (find_key(family, name) != i) {
            violations.push_back(fmt::format("two keys are called \"{}\"", name));
        }
    }
}

void check_roots(const Family& family, std::vector<std::string>& violations) {
    for (std::size_t i = 1; i < family.keys.size(); ++i) {
        const Key& first = family.keys.front();
        const Key& key = family.keys[i];
        const std::string found = difference(first.hierarchy->roots, key.hierarchy->roots);
        if (found.empty()) continue;
        violations.push_back(fmt::format("keys \"{}\" (key 0) and \"{}\" (key {}) have different roots: {}",
                                         first.name, key.name, i, found));
    }
}

void check_references(const Family& family, std::vector<std::string>& violations) {
    const auto check_key = [&](std::string_view place, std::size_t i, std::size_t key) {
        if (key < family.keys.size()) return;
        violations.push_back(fmt::format("{} {} refers to key {}, but there are only {} keys", place, i, key,
                                         family.keys.size()));
    };
    if (family.timeline) {
        const auto keys = family.timeline->keys();
        for (std::size_t i = 0; i < keys.size(); ++i) check_key("timeline key", i, keys[i].key);
    }
    if (family.domain) {
        const auto vertices = family.domain->vertices();
        for (std::size_t i = 0; i < vertices.size(); ++i) check_key("domain vertex", i, vertices[i].key);
    }
}

void check_path(const Family& family, std::vector<std::string>& violations) {
    if (family.path && !family.domain)
        violations.emplace_back("the family has a path, but no parameter domain for it");
    if (!family.path && family.time_source == TimeSource::path)
        violations.emplace_back("the path drives the blend over time, but the family has no path");
}

void check_landmarks(const Family& family, std::vector<std::string>& violations) {
    constexpr double rounding = 1e-9;
    for (std::size_t i = 0; i < family.landmarks.size(); ++i) {
        const auto& [name, direction] = family.landmarks[i];
        if (name.empty() || !is_printable(name))
            violations.push_back(
                fmt::format("landmark {} has no name of UTF-8 without control characters", i));
        if (std::ranges::find(family.landmarks, name, &LandmarkDirection::name) !=
            family.landmarks.begin() + std::ptrdiff_t(i))
            violations.push_back(fmt::format("two landmarks are called \"{}\"", name));
        if (!(std::abs(glm::dot(direction, direction) - 1) < rounding))
            violations.push_back(fmt::format("the direction of landmark {} is not a unit vector", i));
    }
}

void check_scales(const Family& family, std::vector<std::string>& violations) {
    if (!is_unit(family.time_unit)) violations.emplace_back("the unit of time is no unit");
    for (std::size_t i = 0; i < family.field_scales.size(); ++i) {
        const FieldScale& scale = family.field_scales[i];
        const auto first = std::ranges::find(family.field_scales, scale.field, &FieldScale::field);
        if (!is_field_name(scale.field) || !is_unit(scale.unit) || !std::isfinite(scale.offset))
            violations.push_back(fmt::format("scale {} has no name, no unit or no finite offset", i));
        else if (first != family.field_scales.begin() + std::ptrdiff_t(i))
            violations.push_back(fmt::format("two scales are of the field \"{}\"", scale.field));
    }
}

}  // namespace

std::optional<std::size_t> find_key(const Family& family, std::string_view name) {
    const auto key = std::find_if(family.keys.begin(), family.keys.end(),
                                  [&](const Key& candidate) { return candidate.name == name; });
    if (key == family.keys.end()) return std::nullopt;
    return static_cast<std::size_t>(key - family.keys.begin());
}

std::vector<std::string> check(const Family& family) {
    std::vector<std::string> violations;
    if (family.keys.empty()) violations.emplace_back("the family has no key; it needs at least one");
    check_names(family, violations);
    check_roots(family, violations);
    check_references(family, violations);
    check_path(family, violations);
    check_landmarks(family, violations);
    check_scales(family, violations);
    return violations;
}

UnionMesh unite(const Family& family, const Weights& weights) {
    UnionMesh mesh;
    unite(family, weights, mesh);
    return mesh;
}

void unite(const Family& family, const Weights& weights, UnionMesh& mesh) {
    std::vector<const Hierarchy*> active;
    active.reserve(weights.size());
    for (const Weight& weight : weights) active.push_back(&*family.keys[weight.key].hierarchy);
    unite(active, mesh);
}

}  // namespace interleaf
