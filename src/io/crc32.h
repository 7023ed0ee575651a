// CRC-32, the checksum of zlib, PNG and gzip (reflected polynomial 0xEDB88320, initial and final complement).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace interleaf {

/// The CRC-32 of \p bytes. Every change of up to 32 neighbouring bits changes it.
std::uint32_t crc32(std::span<const std::byte> bytes);

}  // namespace interleaf
