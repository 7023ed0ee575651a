// One Zstandard frame (RFC 8878).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hierarchy/buffer.h"

namespace interleaf {

/// Appends the frame that holds \p parts one after the other. Each part has its own statistics.
/// \throw MachineError if there is not enough memory
void append_frame(std::vector<std::byte>& target, std::span<const std::span<const std::byte>> parts);

/// The content of \p frame. The function uses memory only as far as \p frame has content, whatever \p size
/// says.
/// \throw InputError unless \p frame is whole and holds \p size bytes
Buffer<std::byte> frame_content(std::span<const std::byte> frame, std::size_t size);

}  // namespace interleaf
