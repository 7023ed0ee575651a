#include "io/vtk/data_block.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <fmt/core.h>
#include <libdeflate.h>

namespace interleaf {
namespace {

/// The most bytes that deflate makes of one byte.
constexpr std::size_t max_deflate_ratio = 1032;

struct Inflater {
    void operator()(libdeflate_decompressor* decompressor) const {
        libdeflate_free_decompressor(decompressor);
    }
};

class BlockReader {
  public:
    BlockReader(EncodedBytes source, const BlockFormat& format, const ArrayPlace& place)
        : source_(source), format_(format), place_(place) {}

    /// Fills \p bytes with the data of the block.
    void read(std::vector<std::byte>& bytes, std::size_t size) {
        if (format_.is_compressed)
            read_compressed(bytes, size);
        else
            read_plain(bytes, size);
    }

  private:
    std::uint64_t read_size() {
        std::array<std::byte, 8> bytes{};
        const auto used = std::span(bytes).first(format_.has_wide_headers ? 8 : 4);
        if (!source_.read(used)) place_.fail("the data is cut off within its header");
        if (format_.is_big_endian) std::ranges::reverse(used);
        std::uint64_t size = 0;
        for (std::size_t n = used.size(); n-- > 0;)
            size = size << 8U | std::to_integer<std::uint64_t>(used[n]);
        return size;
    }

    void read_data(std::span<std::byte> bytes) {
        if (!source_.read(bytes)) place_.fail("the data is cut off");
    }

    void read_plain(std::vector<std::byte>& bytes, std::size_t size) {
        const std::uint64_t claimed = read_size();
        check_size(claimed, size);
        if (size > source_.available()) fail_short(size);
        bytes.resize(size);
        read_data(bytes);
    }

    void read_compressed(std::vector<std::byte>& bytes, std::size_t size) {
        const std::uint64_t parts = read_size();
        if (parts == 0) return check_size(0, size);
        const std::uint64_t part_size = read_size();
        const std::uint64_t short_size = read_size();  // of the last part; 0 if it is as large as the others
        const std::uint64_t last_size = short_size == 0 ? part_size : short_size;
        if (parts > source_.available()) fail_short(parts);
        if (last_size > part_size || (part_size > 0 && parts - 1 > size / part_size))
            place_.fail(fmt::format("{} compressed parts of {} bytes, expected {} bytes in all", parts,
                                    part_size, size));
        check_size((parts - 1) * part_size + last_size, size);

        const std::vector<std::size_t> packed_sizes = read_packed_sizes(parts, size);
        bytes.resize(size);
        std::span<std::byte> rest(bytes);
        for (const std::size_t packed : packed_sizes) {
            const std::size_t plain = std::min<std::size_t>(part_size, rest.size());
            inflate(packed, rest.first(plain));
            rest = rest.subspan(plain);
        }
    }

    /// The sizes of the compressed parts, which become \p size bytes together.
    std::vector<std::size_t> read_packed_sizes(std::uint64_t parts, std::size_t size) {
        std::vector<std::size_t> sizes;
        std::size_t total = 0;
        for (std::uint64_t part = 0; part < parts; ++part) {
            sizes.push_back(read_size());
            if (sizes.back() > source_.available() - total) fail_short(sizes.back());
            total += sizes.back();
        }
        if (size / max_deflate_ratio > total)
            place_.fail(
                fmt::format("{} compressed bytes, expected at least {}", total, size / max_deflate_ratio));
        return sizes;
    }

    void inflate(std::size_t packed_bytes, std::span<std::byte> plain) {
        std::vector<std::byte> packed(packed_bytes);
        read_data(packed);
        const libdeflate_result result = libdeflate_zlib_decompress(
            inflater_.get(), packed.data(), packed.size(), plain.data(), plain.size(), nullptr);
        if (result != LIBDEFLATE_SUCCESS)
            place_.fail(
                fmt::format("the compressed data is damaged, expected {} bytes by zlib", plain.size()));
    }

    void check_size(std::uint64_t claimed, std::size_t expected) const {
        if (claimed != expected) place_.fail(fmt::format("{} bytes of data, expected {}", claimed, expected));
    }

    [[noreturn]] void fail_short(std::uint64_t size) const {
        place_.fail(fmt::format("the data is cut off, expected {} bytes", size));
    }

    EncodedBytes source_;
    const BlockFormat& format_;
    const ArrayPlace& place_;
    std::unique_ptr<libdeflate_decompressor, Inflater> inflater_{libdeflate_alloc_decompressor()};
};

}  // namespace

NumberArray read_block(EncodedBytes source, DataType type, const BlockFormat& format, const ArrayPlace& place,
                       BlockBudget& budget) {
    const std::size_t size = place.values() * size_of(type);
    if (size > budget.bytes) place.fail(fmt::format("{} bytes, more than a file of its size can have", size));
    budget.bytes -= size;
    NumberArray array{type, {}};
    BlockReader(source, format, place).read(array.bytes, size);
    if (format.is_big_endian) swap_byte_order(array);
    return array;
}

}  // namespace interleaf
