// The keys of a family as a web page holds them: the hierarchies themselves, with positions and fields in
// whole numbers, compressed with zlib. docs/file-formats.md describes the bytes.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "family/family.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct PagePayload {
    /// The members of composition_text(), and the counts, ranges and fields that the bytes need.
    nlohmann::ordered_json description;
    std::string base64;
};

/// The largest number of vertices of a key, so that differences of vertex numbers fit into three bytes.
inline constexpr std::size_t max_page_vertices = std::size_t{1} << 22;

/// The number of steps of positions along the longest side of the box of all keys, and of the range of a
/// scalar. Positions are right to half a step.
inline constexpr double page_steps = 65535;

/// \throw InputError if a key has more than max_page_vertices vertices
/// \throw Cancelled  when \p progress says so
PagePayload page_payload(const Family& family, const Progress& progress = {});

}  // namespace interleaf
