#include "family/key_edits.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "family/domain_edits.h"
#include "hierarchy/checker.h"
#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// If two entries have the same time, the error names the later one in \p keys.
void set_times(Family& family, std::vector<TimelineKey> keys) {
    std::ranges::stable_sort(keys, {}, &TimelineKey::time);
    const auto same = std::ranges::adjacent_find(keys, {}, &TimelineKey::time);
    if (same != keys.end())
        throw InputError(fmt::format("the time {:.10g} s is already taken by key \"{}\"", same->time,
                                     family.keys[same->key].name));
    family.timeline.reset();
    if (!keys.empty()) family.timeline.emplace(std::move(keys));
}

std::vector<TimelineKey> times_of(const Family& family) {
    if (!family.timeline) return {};
    return {family.timeline->keys().begin(), family.timeline->keys().end()};
}

/// Replaces the key indices in timeline and domain by the new ones.
void renumber_keys(Family& family, const std::function<std::size_t(std::size_t)>& new_index) {
    std::vector<TimelineKey> times = times_of(family);
    for (TimelineKey& time : times) time.key = new_index(time.key);
    set_times(family, std::move(times));
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
    while (const auto vertex = vertex_of_key()) family.domain = without_vertex(*family.domain, *vertex);
}

bool has_control_characters(std::string_view name) {
    return std::ranges::any_of(name,
                               [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

}  // namespace

std::string unused_name(const Family& family, std::string_view wanted) {
    const std::string_view stem = wanted.empty() ? "key" : wanted;
    std::string name(stem);
    for (unsigned number = 2; find_key(family, name); ++number) name = fmt::format("{} {}", stem, number);
    return name;
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
    std::vector<TimelineKey> times = times_of(family);
    std::erase_if(times, [&](const TimelineKey& time) { return time.key == key; });
    set_times(family, std::move(times));
    remove_from_domain(family, key);
    renumber_keys(family, [&](std::size_t index) { return index > key ? index - 1 : index; });
    family.keys.erase(family.keys.begin() + static_cast<std::ptrdiff_t>(key));
    return family;
}

Family with_key_renamed(Family family, std::size_t key, std::string name) {
    if (name.empty()) throw InputError("a key needs a name");
    if (has_control_characters(name)) throw InputError("the name of a key holds no control characters");
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

Family with_time_added(Family family, std::size_t key, double time) {
    std::vector<TimelineKey> times = times_of(family);
    times.push_back({time, key});
    set_times(family, std::move(times));
    return family;
}

Family with_time_moved(Family family, std::size_t place, double time) {
    const std::size_t key = family.timeline->keys()[place].key;
    return with_time_added(with_time_removed(std::move(family), place), key, time);
}

Family with_time_removed(Family family, std::size_t place) {
    std::vector<TimelineKey> times = times_of(family);
    times.erase(times.begin() + static_cast<std::ptrdiff_t>(place));
    set_times(family, std::move(times));
    return family;
}

}  // namespace interleaf
