// Bytes compressed by Zstandard (RFC 8878), one frame.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hierarchy/buffer.h"

namespace interleaf {

/// Appends the frame that holds \p parts one after the other. Statistics are taken for each part by itself.
/// \throw MachineError when there is not enough memory
void append_frame(std::vector<std::byte>& target, std::span<const std::span<const std::byte>> parts);

/// The content of \p frame. Memory is used as far as \p frame has content, whatever \p size says.
/// \throw InputError unless it is whole and has \p size bytes
Buffer<std::byte> frame_content(std::span<const std::byte> frame, std::size_t size);

}  // namespace interleaf
