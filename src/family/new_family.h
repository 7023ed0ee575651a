// A family made from keys alone, with a default timeline and a default parameter domain.
#pragma once

#include <string_view>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// The family \p name of \p keys. Unprintable characters of names are escaped (names.h), and numbers make the
/// names of keys unique.
///
/// Two or more keys get a linear timeline with one second from key to key. Three keys get a triangle as their
/// domain. Four to nine keys get a regular polygon with the first key in the middle and the others around it,
/// so that the first key blends with any two adjacent ones. More keys get no domain: they are a series in
/// time.
/// \pre there is at least one key, and all have the same roots
Family family_of_keys(std::string_view name, std::vector<Key> keys);

/// Whether that gives a domain for the number of keys of \p family.
bool can_have_new_domain(const Family& family);

}  // namespace interleaf
