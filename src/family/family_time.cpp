#include "family/family_time.h"

#include <utility>

#include "hierarchy/error.h"

namespace interleaf {

std::string_view name_of(TimeSource source) {
    return source == TimeSource::path ? "path" : "keys";
}

std::optional<TimeSource> time_source_named(std::string_view name) {
    for (const TimeSource source : {TimeSource::keys, TimeSource::path})
        if (name == name_of(source)) return source;
    return std::nullopt;
}

bool has_source(const Family& family, TimeSource source) {
    return source == TimeSource::path ? family.path.has_value() : family.timeline.has_value();
}

std::optional<TimeSource> source_of_time(const Family& family) {
    for (const TimeSource source : {family.time_source, TimeSource::keys, TimeSource::path})
        if (has_source(family, source)) return source;
    return std::nullopt;
}

TimeUnit unit_of(const Family& family, TimeSource source) {
    return source == TimeSource::path ? TimeUnit::seconds : family.timeline->unit();
}

std::string unit_name_of(const Family& family, TimeSource source) {
    if (source == TimeSource::keys && !family.time_unit.empty()) return family.time_unit;
    return unit_of(family, source) == TimeUnit::steps ? "" : "s";
}

TimeRange interval_of(const Family& family, TimeSource source) {
    if (source == TimeSource::path) return {family.path->begin(), family.path->end()};
    return {family.timeline->begin(), family.timeline->end()};
}

std::vector<double> marked_times(const Family& family, TimeSource source) {
    std::vector<double> times;
    if (source == TimeSource::path) {
        times.reserve(family.path->points().size());
        for (const PathPoint& point : family.path->points()) times.push_back(point.time);
    } else {
        times.reserve(family.timeline->keys().size());
        for (const TimelineKey& key : family.timeline->keys()) times.push_back(key.time);
    }
    return times;
}

Weights weights_at(const Family& family, double time, TimeSource source) {
    if (source == TimeSource::keys) return family.timeline->at(time);
    return family.domain->weights(place_on_path(family, time));
}

DomainPoint place_on_path(const Family& family, double time) {
    return family.domain->locate(family.path->at(time));
}

Family with_domain(Family family, std::optional<ParameterDomain> domain) {
    family.domain = std::move(domain);
    return family.domain ? std::move(family) : with_path(std::move(family), std::nullopt);
}

Family with_path(Family family, std::optional<DomainPath> path) {
    if (path && !family.domain) throw InputError("a path needs a parameter domain, and the family has none");
    family.path = std::move(path);
    if (!family.path) family.time_source = TimeSource::keys;
    return family;
}

Family with_time_source(Family family, TimeSource source) {
    if (!has_source(family, source))
        throw InputError(source == TimeSource::path ? "the family has no path through a parameter domain"
                                                    : "the family has no timeline");
    family.time_source = source;
    return family;
}

}  // namespace interleaf
