// Reads the accessors of a glTF file as arrays of numbers: any component type, interleaved, normalized,
// sparse (sections 3.6.2 and 5.1 of the specification).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "hierarchy/triangle.h"
#include "io/gltf/gltf_file.h"

namespace interleaf {

/// One row per vertex.
struct GltfArray {
    std::size_t width = 1;  ///< numbers per row: 1 to 4
    std::vector<float> values;

    std::size_t count() const { return values.size() / width; }
};

class GltfArrays {
  public:
    /// All arrays together may hold a number per byte of the file, and 16 million more. So accessors that
    /// share their bytes, or have none, cannot ask for much more memory than the file has.
    explicit GltfArrays(const GltfFile& file)
        : file_(file), numbers_left_(std::uint64_t{file.byte_count} + extra_numbers) {}

    static constexpr std::uint64_t extra_numbers = 16'000'000;

    /// The accessor that \p place names, as finite numbers. Normalized integers become -1 to 1 or 0 to 1.
    /// \throw InputError naming the accessor and what was expected
    GltfArray numbers(const JsonPlace& place);

    /// The accessor that \p place names, as whole numbers below \p limit.
    /// \throw InputError naming the accessor and what was expected
    std::vector<Index> indices(const JsonPlace& place, std::size_t limit);

    /// Counts numbers that the caller makes, as for the accessor of \p place.
    /// \throw InputError if these are too many
    void charge(const JsonPlace& place, std::uint64_t numbers);

  private:
    struct Layout;
    Layout layout_of(const JsonPlace& accessor);
    void read_sparse(const JsonPlace& accessor, const Layout& layout, GltfArray& array) const;

    const GltfFile& file_;
    std::uint64_t numbers_left_;
};

}  // namespace interleaf
