// Small glTF files made by hand: a square of two triangles with morph targets.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace interleaf {

std::string base64_of(const std::string& bytes);

/// A mesh of the triangles (0, 1, 2), (3, 4, 5) and so on.
struct SquareText {
    std::vector<glm::vec3> positions;
    std::vector<std::vector<glm::vec3>> deltas;  ///< per target
    std::vector<std::vector<float>> scalars{};   ///< further accessors, after those of the targets
    std::string extras{};                        ///< JSON of the mesh's extras; none if empty
    std::string node{};                          ///< further members of the node, after a comma
    std::string rest{};                          ///< further members of the document, after a comma

    /// The buffer.
    std::string bytes() const;

    /// The file. Without \p uri, the buffer is a data URI.
    std::string text(const std::string& uri = "") const;
};

/// A square whose only target lifts the corner (1, 1, 0) by 5, as a sparse accessor without values.
std::string sparse_square();

/// A square whose positions are normalized bytes in rows of 4 bytes.
std::string packed_square();

}  // namespace interleaf
