#include "io/key_bytes.h"

#include <cstdint>
#include <cstring>
#include <string_view>

#include <doctest/doctest.h>
#include <libdeflate.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "io/scratch_folder.h"

namespace interleaf {

void repair_checksum(Bytes& bytes) {
    const std::size_t end = bytes.size() - 4;
    const std::uint32_t checksum = libdeflate_crc32(0, bytes.data(), end);
    std::memcpy(bytes.data() + end, &checksum, 4);
}

std::string error_of(const Bytes& bytes) {
    return input_error_of([&] { parse_hierarchy(bytes, "key.ilh"); });
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
