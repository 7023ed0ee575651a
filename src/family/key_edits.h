// Edits of a family's keys, of their times and of its name. Each takes a family and gives the changed one;
// copying a family copies no hierarchy. What names keys by index, timeline and domain, is kept in step.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "family/family.h"

namespace interleaf {

/// The same as unused_name() (names.h), where the names of \p family's keys are taken.
std::string unused_name(const Family& family, std::string_view wanted);

/// With \p key as the last one, under a name of its own.
/// \throw InputError if its roots are not the family's
Family with_key_added(Family family, Key key);

/// With a second key of the same hierarchy, under a name of its own, just after \p key; neither on the
/// timeline nor in the domain.
Family with_key_duplicated(Family family, std::size_t key);

/// Without \p key, its times and its domain vertices; timeline and domain go with the last of them.
/// \throw InputError if it is the only key, or as without_vertex()
Family with_key_removed(Family family, std::size_t key);

/// \throw InputError if \p name is taken, or fault_of_name() (names.h) finds fault
Family with_key_renamed(Family family, std::size_t key, std::string name);

/// With the name \p name of the family itself.
/// \throw InputError if fault_of_name() finds fault
Family with_family_renamed(Family family, std::string name);

/// With the key \p from at the place \p to, and those between moved up or down by one.
Family with_key_moved(Family family, std::size_t from, std::size_t to);

/// With \p key at \p time, in seconds, too; it makes the timeline if there is none.
/// \throw InputError if the time is taken or not finite
Family with_time_added(Family family, std::size_t key, double time);

/// With the entry \p place of the timeline at \p time; it may pass others.
/// \throw InputError if the time is taken or not finite
Family with_time_moved(Family family, std::size_t place, double time);

/// Without the entry \p place of the timeline, which goes with its last one.
Family with_time_removed(Family family, std::size_t place);

}  // namespace interleaf
