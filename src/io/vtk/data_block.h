// A block of bytes in a VTK XML file: a header with sizes, then the data, plain or in compressed parts
// (VTK file formats, "XML file formats", appended data).
#pragma once

#include <cstddef>

#include "io/vtk/encoded_bytes.h"
#include "io/vtk/number_array.h"

namespace interleaf {

struct BlockFormat {
    bool has_wide_headers = false;  ///< sizes have 64 bits instead of 32
    bool is_big_endian = false;
    bool is_compressed = false;  ///< by zlib
};

/// The bytes that the blocks of a file may still take in memory. Blocks that share their data, or are compressed
/// beyond measure, use it up.
struct BlockBudget {
    std::size_t bytes = 0;
};

/// Reads the block at the front of \p source, which holds the numbers of \p place.
/// \throw InputError naming \p place, if the sizes in the header disagree with \p place or the file, if the data
///                   is damaged, or if \p budget does not suffice
NumberArray read_block(EncodedBytes source, DataType type, const BlockFormat& format, const ArrayPlace& place,
                       BlockBudget& budget);

}  // namespace interleaf
