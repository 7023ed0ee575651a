#include "family/key_edits.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "family/domain_edits.h"
#include "family/family_time.h"
#include "family/names.h"
#include "hierarchy/checker.h"
#include "hierarchy/error.h"

namespace interleaf {

namespace {

void check_time_is_free(const Family& family, double time, std::optional<std::size_t> moved = {}) {
    if (!family.timeline) return;
    const auto place = family.timeline->place_at(time);
    if (place && place != moved)
        throw InputError(fmt::format("the time {:.10g} s is already taken by key \"{}\"", time,
                                     family.keys[family.timeline->keys()[*place].key].name));
}

/// Replaces the key indices in timeline and domain by the new ones.
void renumber_keys(Family& family, const std::function<std::size_t(std::size_t)>& new_index) {
    if (family.timeline) family.timeline = family.timeline->with_keys_renumbered(new_index);
    if (!family.domain) return;
    std::vector<DomainVertex> vertices(family.domain->vertices().begin(), family.domain->vertices().end());
    for (DomainVertex& vertex : vertices) vertex.key = new_index(vertex.key);
    const auto triangles = family.domain->triangles();
    family.domain.emplace(std::move(vertices), std::vector<Triangle>(triangles.begin(), triangles.end()));
}

void remove_from_domain(Family& family, std::size_t key) {
    const auto vertex_of_key = [&]() -> std::optional<Index> {
        if (!family.domain) return std::nullopt;
        const auto vertices = family.domain->vertices();
        const auto found = std::ranges::find(vertices, key, &DomainVertex::key);
        if (found == vertices.end()) return std::nullopt;
        return static_cast<Index>(found - vertices.begin());
    };
    while (const auto vertex = vertex_of_key()) {
        std::optional<ParameterDomain> domain = without_vertex(*family.domain, *vertex);
        family = with_domain(std::move(family), std::move(domain));
    }
}

}  // namespace

std::string unused_name(const Family& family, std::string_view wanted) {
    return unused_name(wanted, [&](const std::string& name) { return find_key(family, name).has_value(); });
}

Family with_key_added(Family family, Key key) {
    key.name = unused_name(family, key.name);
    if (!family.keys.empty()) {
        const Key& first = family.keys.front();
        const std::string found = difference(first.hierarchy->roots, key.hierarchy->roots);
        if (!found.empty())
            throw InputError(
                fmt::format("key \"{}\" has different roots from \"{}\": {}", key.name, first.name, found));
    }
    family.keys.push_back(std::move(key));
    return family;
}

Family with_key_duplicated(Family family, std::size_t key) {
    Key copy = family.keys[key];
    const std::size_t last = family.keys.size();
    return with_key_moved(with_key_added(std::move(family), std::move(copy)), last, key + 1);
}

Family with_key_removed(Family family, std::size_t key) {
    if (family.keys.size() == 1) throw InputError("a family needs at least one key");
    if (family.timeline) family.timeline = family.timeline->without_key(key);
    remove_from_domain(family, key);
    renumber_keys(family, [&](std::size_t index) { return index > key ? index - 1 : index; });
    family.keys.erase(family.keys.begin() + static_cast<std::ptrdiff_t>(key));
    return family;
}

Family with_key_renamed(Family family, std::size_t key, std::string name) {
    if (const std::string fault = fault_of_name(name, "a key"); !fault.empty()) throw InputError(fault);
    const auto same = find_key(family, name);
    if (same && *same != key) throw InputError(fmt::format("another key is already called \"{}\"", name));
    family.keys[key].name = std::move(name);
    return family;
}

Family with_key_moved(Family family, std::size_t from, std::size_t to) {
    const auto at = [&](std::size_t index) {
        return family.keys.begin() + static_cast<std::ptrdiff_t>(index);
    };
    if (from < to) {
        std::rotate(at(from), at(from + 1), at(to + 1));
    } else {
        std::rotate(at(to), at(from), at(from + 1));
    }
    renumber_keys(family, [&](std::size_t index) {
        if (index == from) return to;
        if (from < index && index <= to) return index - 1;
        if (to <= index && index < from) return index + 1;
        return index;
    });
    return family;
}

std::optional<std::size_t> place_after_change(std::span<const Key> keys, const Key& key, std::size_t place,
                                              const std::vector<bool>& is_taken) {
    const auto is_free = [&](std::size_t n) { return n < keys.size() && (is_taken.empty() || !is_taken[n]); };
    const auto has_name = [&](std::size_t n) { return keys[n].name == key.name; };
    std::optional<std::size_t> same;
    for (std::size_t n = 0; n < keys.size(); ++n) {
        if (!is_free(n) || !keys[n].hierarchy.is_same(key.hierarchy)) continue;
        if (has_name(n)) return n;
        if (!same || n == place) same = n;
    }
    return is_free(place) && has_name(place) ? place : same;
}

Family with_family_renamed(Family family, std::string name) {
    if (const std::string fault = fault_of_name(name, "a family"); !fault.empty()) throw InputError(fault);
    family.name = std::move(name);
    return family;
}

Family with_time_added(Family family, std::size_t key, double time) {
    check_time_is_free(family, time);
    const TimelineKey added{time, key};
    family.timeline = family.timeline ? family.timeline->with_entry(added) : Timeline({added});
    return family;
}

Family with_time_moved(Family family, std::size_t place, double time) {
    check_time_is_free(family, time, place);
    family.timeline = family.timeline->with_time(place, time);
    return family;
}

Family with_interpolation(Family family, Interpolation interpolation) {
    family.timeline = family.timeline->with_interpolation(interpolation);
    return family;
}

Family with_time_removed(Family family, std::size_t place) {
    family.timeline = family.timeline->without_entry(place);
    return family;
}

}  // namespace interleaf
