// Edits of a family's keys and of their times. Each takes a family and returns the changed one; copying a
// family copies no hierarchy. Timeline and domain refer to keys by index, and the edits keep these indices
// valid.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// A name that no key of \p family has: \p wanted, with a number appended if it is taken. An empty \p wanted
/// counts as "key".
std::string unused_name(const Family& family, std::string_view wanted);

/// The family with \p key as its last key, under a unique name.
/// \throw InputError if the key's roots differ from the family's
Family with_key_added(Family family, Key key);

/// The place among \p keys, those of a changed family, of the key that was \p key at \p place before: the key with
/// the same hierarchy and name; otherwise the key in the same place if it has the same name; otherwise the key in the
/// same place, or else the first one, with the same hierarchy.
/// \param is_taken  the places that do not count; empty for none
/// \return none if the key has gone
std::optional<std::size_t> place_after_change(std::span<const Key> keys, const Key& key, std::size_t place,
                                              const std::vector<bool>& is_taken = {});

/// The family with a second key of the same hierarchy just after \p key, under a unique name. The new key is
/// neither on the timeline nor in the domain.
Family with_key_duplicated(Family family, std::size_t key);

/// The family without \p key, its times and its domain vertices. The timeline is removed with its last entry,
/// the domain and its path with the last triangle.
/// \throw InputError if it is the only key, or as without_vertex() does
Family with_key_removed(Family family, std::size_t key);

/// The family with \p key called \p name.
/// \throw InputError if \p name is empty, taken, or contains control characters
Family with_key_renamed(Family family, std::size_t key, std::string name);

/// With the name \p name of the family itself.
/// \throw InputError if fault_of_name() finds fault
Family with_family_renamed(Family family, std::string name);

/// The family with the key \p from moved to the place \p to; the keys between move up or down by one.
Family with_key_moved(Family family, std::size_t from, std::size_t to);

/// The family with another timeline entry of \p key at \p time. Creates the timeline if there is none.
/// \param time  in the unit of the timeline
/// \throw InputError if the time is taken or not finite
Family with_time_added(Family family, std::size_t key, double time);

/// The family with the timeline entry \p place moved to \p time; it may pass other entries.
/// \throw InputError if the time is taken or not finite
Family with_time_moved(Family family, std::size_t place, double time);

/// The family whose timeline blends its keys by \p interpolation.
/// \pre the family has a timeline
Family with_interpolation(Family family, Interpolation interpolation);

/// The family without the timeline entry \p place. The timeline is removed with its last entry.
Family with_time_removed(Family family, std::size_t place);

}  // namespace interleaf
