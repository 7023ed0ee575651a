// Time in a family: what drives the blend over time, the keys of the timeline or the path through the
// parameter domain, and the blend at a time (paper, sections 4.1 and 4.2).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "family/family.h"
#include "family/playback.h"

namespace interleaf {

/// "keys" or "path".
std::string_view name_of(TimeSource source);

/// The source called \p name; none when there is none.
std::optional<TimeSource> time_source_named(std::string_view name);

/// Whether \p family has a timeline for the source keys, or a path for the source path.
bool has_source(const Family& family, TimeSource source);

/// What drives the blend over time: the family's choice, or without that part the other one; none if the
/// family has neither a timeline nor a path.
std::optional<TimeSource> source_of_time(const Family& family);

/// What the times of \p source count; those of a path are seconds.
/// \pre has_source(family, source)
TimeUnit unit_of(const Family& family, TimeSource source);

/// The unit of these times as people write it: that of the family, or "s"; empty for steps.
/// \pre has_source(family, source)
std::string unit_name_of(const Family& family, TimeSource source);

/// The times of \p source from its begin to its end.
/// \pre has_source(family, source)
TimeRange interval_of(const Family& family, TimeSource source);

/// The times of the keys of the timeline, or of the points of the path, ascending.
/// \pre has_source(family, source)
std::vector<double> marked_times(const Family& family, TimeSource source);

/// The weights at \p time, clamped to the interval. Those of the path are the weights of place_on_path().
/// \throw InputError if \p time is not a number
/// \pre has_source(family, source)
Weights weights_at(const Family& family, double time, TimeSource source);

/// The point of the domain at \p time of the path. Where the path leaves the domain, the nearest point of the
/// domain counts.
/// \throw InputError if \p time is not a number
/// \pre the family has a path, and with it a domain
DomainPoint place_on_path(const Family& family, double time);

/// Edits. Each returns the changed family.
/// @{

/// With another domain. The path stays as it is, even where it leaves the new domain, so that the domain can
/// come back to it; without a domain, it goes, too.
Family with_domain(Family family, std::optional<ParameterDomain> domain);

/// With another path, or without one. Without a path, keys drive.
/// \throw InputError if there is a path, but the family has no domain
Family with_path(Family family, std::optional<DomainPath> path);

/// With \p source as its choice.
/// \throw InputError unless has_source()
Family with_time_source(Family family, TimeSource source);

/// @}

}  // namespace interleaf
