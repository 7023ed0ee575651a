// The compressed form of a hierarchy file: the content of the plain form, to the last bit, in a third of its
// bytes or less where the surface is smooth.
//
// Connectivity is kept as open decisions (bisection_decisions.h), positions and fields as differences
// from what earlier vertices let expect (position_prediction.h, position_planes.h, field_planes.h); all are
// compressed by Zstandard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "io/hierarchy/hierarchy_format.h"

namespace interleaf {

/// Reads what follows \p header in a compressed file of \p size bytes. The checksums have been checked,
/// check() has not been called. \throw InputError naming \p name, the place and what was expected
Hierarchy read_compressed(const hierarchy_format::Header& header, hierarchy_format::SummedInput& input,
                          std::uint64_t size, std::string_view name);

/// The compressed file of \p hierarchy with other \p positions; none if it would be so small that readers
/// refuse it. \pre \p hierarchy has passed check()
std::optional<std::vector<std::byte>> compressed_bytes(const Hierarchy& hierarchy,
                                                       std::span<const glm::vec3> positions);

}  // namespace interleaf
