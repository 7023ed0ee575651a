// A family made from keys alone, with a default timeline and a default parameter domain.
#pragma once

#include <string_view>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// The family \p name of \p keys. Names have what is not printable escaped (names.h); those of keys are made
/// unique by numbers. With two keys or more it has a linear timeline of one second from key to key. With
/// three it has a triangle as its domain; with four to nine a regular polygon with the first key in the
/// middle and the others around it, so that the first blends with any two neighbors. With more keys there is
/// no domain: they are a series in time. \pre there is a key, and they have the same roots
Family family_of_keys(std::string_view name, std::vector<Key> keys);

}  // namespace interleaf
