// Landmark files: the named points of one mesh, as JSON. docs/file-formats.md has the layout.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "hierarchy/landmark.h"
#include "io/text/json_place.h"

namespace interleaf {

/// The largest number of landmarks in a file. The work of a fit grows with its square.
inline constexpr std::size_t max_landmarks = 256;

/// The landmarks in \p text, at least one. Names are unique and can be printed; positions are finite and within
/// 1e30; directions are unit vectors, or nearly so, and then made to be. Messages call the text \p file.
/// \throw InputError naming \p file, the place and what was expected
LandmarkSet parse_landmarks(std::string_view text, std::string_view file);

/// \throw InputError   as parse_landmarks(), and if the file is larger than 1 MiB
/// \throw MachineError if the file cannot be read
LandmarkSet read_landmarks(const std::filesystem::path& file);

/// The text of a landmark file. Reading it gives the same bits.
std::string landmarks_text(const LandmarkSet& set);

/// The unit vector at \p place; divided by its length unless that is 1 up to rounding.
/// \throw InputError if its length is not 1 within a thousandth
glm::dvec3 direction_at(const JsonPlace& place);

}  // namespace interleaf
