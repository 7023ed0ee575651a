#include "io/key_bytes.h"

#include <cstdint>
#include <cstring>
#include <random>
#include <string_view>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <libdeflate.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"

namespace interleaf {

void repair_checksum(Bytes& bytes) {
    const std::size_t end = bytes.size() - 4;
    const std::uint32_t checksum = libdeflate_crc32(0, bytes.data(), end);
    std::memcpy(bytes.data() + end, &checksum, 4);
}

std::string error_of(const Bytes& bytes) {
    return input_error_of([&] { parse_hierarchy(bytes, "key.ilh"); });
}

void check_damage_is_found(const Bytes& whole) {
    std::mt19937 random(5);
    for (std::size_t place = 0; place < whole.size(); ++place) {
        CAPTURE(place);
        Bytes damaged = whole;
        damaged[place] ^= static_cast<std::byte>(1 + random() % 255);
        CHECK_FALSE(error_of(damaged).empty());
    }
}

bool is_sound_or_refused(const Bytes& bytes) {
    try {
        const Hierarchy parsed = parse_hierarchy(bytes, "key.ilh");
        CHECK(check(parsed).empty());
        return true;
    } catch (const InputError& error) {
        CHECK(std::string_view(error.what()).starts_with("key.ilh: "));
        return false;
    }
}

}  // namespace interleaf
