// The compressed form of a hierarchy file. It holds the content of the plain form, to the last bit, in at
// most a third of the bytes where the surface is smooth.
//
// Connectivity is stored as open decisions (bisection_decisions.h). Positions and fields are stored as
// differences from values predicted from earlier vertices (position_prediction.h, position_planes.h,
// field_planes.h). Zstandard compresses all of them.
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

/// Reads the rest of a compressed file of \p size bytes after \p header. Checks both checksums, but does not
/// call check().
/// \throw InputError naming \p name, the place and what was expected
Hierarchy read_compressed(const hierarchy_format::Header& header, hierarchy_format::SummedInput& input,
                          std::uint64_t size, std::string_view name);

/// The compressed file of \p hierarchy, with \p positions instead of its own; none if the file would be so
/// small that readers would reject it.
/// \pre \p hierarchy has passed check()
std::optional<std::vector<std::byte>> compressed_bytes(const Hierarchy& hierarchy,
                                                       std::span<const glm::vec3> positions);

}  // namespace interleaf
