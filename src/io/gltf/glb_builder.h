// Builds a binary glTF 2.0 file (Khronos Group, glTF 2.0 specification, 2021): collects arrays, describes
// each by an accessor and a buffer view of its own, and joins them with the JSON document.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// A file has its size in 32 bits.
inline constexpr std::uint64_t max_glb_size = 0xffffffff;

enum class GlbBounds { without, with };

class GlbBuilder {
  public:
    /// Each function adds an array, tightly packed from a multiple of four bytes on.
    /// \return the number of its accessor
    /// @{

    /// A vertex attribute. With bounds, the accessor has the least and the largest value per component, as
    /// glTF requires of positions.
    std::size_t add_vectors(std::span<const glm::vec3> vectors, GlbBounds bounds);

    /// A vertex attribute of one number.
    std::size_t add_scalars(std::span<const float> values);

    /// Input or output of an animation. Of input, glTF requires bounds.
    std::size_t add_animation(std::span<const float> values, GlbBounds bounds);
    std::size_t add_animation(std::span<const glm::vec3> values);

    /// 16 bits per index where these suffice. The largest number of each width is left out, because it ends a
    /// strip of triangles.
    std::size_t add_indices(std::span<const Triangle> triangles, std::size_t vertex_count);

    /// @}

    /// The bytes of the file.
    /// \param document    all members but `bufferViews`, `accessors` and `buffers`
    /// \throw InputError  if the file would be larger than max_glb_size
    std::string file(nlohmann::ordered_json document) const;

  private:
    std::size_t add(const void* data, std::size_t size, int target, nlohmann::ordered_json accessor);

    std::string bytes_;
    nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

}  // namespace interleaf
