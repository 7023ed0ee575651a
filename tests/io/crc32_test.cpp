#include "io/crc32.h"

#include <random>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

namespace interleaf {

namespace {

/// The definition, bit by bit.
std::uint32_t literal_crc32(std::span<const std::byte> bytes) {
    std::uint32_t crc = ~0u;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

}  // namespace

TEST_CASE("the checksum has the published check value") {
    constexpr std::string_view digits = "123456789";
    CHECK(crc32(std::as_bytes(std::span(digits))) == 0xcbf43926);
    CHECK(crc32({}) == 0);
}

TEST_CASE("the checksum agrees with its definition at every length") {
    constexpr unsigned seed = 7;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::vector<std::byte> bytes;
    for (int length = 0; length < 100; ++length) {
        CHECK(crc32(bytes) == literal_crc32(bytes));
        bytes.push_back(static_cast<std::byte>(random()));
    }
}

}  // namespace interleaf
