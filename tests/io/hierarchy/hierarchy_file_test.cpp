#include "io/hierarchy/hierarchy_file.h"

#include <array>
#include <cstring>
#include <limits>
#include <random>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <libdeflate.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "io/key_bytes.h"
#include "io/samples.h"

namespace interleaf {

namespace {

constexpr std::size_t plain_header_size = 32;

/// The error of reading \p bytes.
std::string file_error_of(const ScratchFolder& folder, const Bytes& bytes) {
    put(folder / "key.ilh", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return input_error_of([&] { read_hierarchy(folder / "key.ilh"); });
}

void set_word(Bytes& bytes, std::size_t offset, std::uint32_t value) {
    std::memcpy(bytes.data() + offset, &value, sizeof(value));
}

Bytes plain_sample() {
    std::mt19937 random(3);
    return serialize_hierarchy(random_hierarchy(random, false, 10));
}

/// CRC-32 by definition, bit by bit.
std::uint32_t literal_crc32(std::span<const std::byte> bytes) {
    std::uint32_t crc = ~0u;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

}  // namespace

TEST_CASE("a hierarchy file holds what was written, bit for bit") {
    const ScratchFolder folder;
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const Hierarchy hierarchy = random_hierarchy(random, seed % 2 == 1, static_cast<int>(3 * seed));
        const Bytes bytes = serialize_hierarchy(hierarchy);
        CHECK(is_same(parse_hierarchy(bytes, "memory"), hierarchy));
        write_hierarchy(hierarchy, folder / "key.ilh");
        CHECK(is_same(read_hierarchy(folder / "key.ilh"), hierarchy));
        CHECK(std::filesystem::file_size(folder / "key.ilh") == bytes.size());
    }
}

TEST_CASE("the layout is the documented one") {
    const Hierarchy triangle = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const Bytes bytes = serialize_hierarchy(triangle);
    constexpr std::array<unsigned char, plain_header_size> header{
        0x89, 'I', 'L', 'H', 0x0d, 0x0a, 0x1a, 0x0a,  // signature
        1,    0,   0,   0,   0,    0,    0,    0,     // version, fields
        3,    0,   0,   0,   1,    0,    0,    0,     // root vertices, root triangles
        0,    0,   0,   0,   3,    0,    0,    0};    // midpoints, vertices
    REQUIRE(bytes.size() == plain_header_size + 12 + 8 + 0 + 36 + 4);
    CHECK(std::memcmp(bytes.data(), header.data(), header.size()) == 0);
    constexpr std::array<Index, 3> root{0, 1, 2};
    CHECK(std::memcmp(bytes.data() + 32, root.data(), 12) == 0);
    float x_of_second = 0;
    std::memcpy(&x_of_second, bytes.data() + 32 + 12 + 8 + 12, 4);
    CHECK(x_of_second == 1);
}

TEST_CASE("the checksum is CRC-32, by its published check value and by its definition") {
    constexpr std::string_view digits = "123456789";
    CHECK(libdeflate_crc32(0, digits.data(), digits.size()) == 0xcbf43926);
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const Hierarchy hierarchy = random_hierarchy(random, false, static_cast<int>(20 * seed));
        for (const bool compressed : {false, true}) {
            const Bytes bytes = serialize_hierarchy(hierarchy, {compressed, 0});
            std::uint32_t stored = 0;
            std::memcpy(&stored, bytes.data() + bytes.size() - 4, 4);
            CHECK(stored == literal_crc32(std::span(bytes).first(bytes.size() - 4)));
        }
    }
}

TEST_CASE("a file that is cut off anywhere is rejected") {
    const ScratchFolder folder;
    const Bytes whole = plain_sample();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        const std::string error = error_of(cut);
        CHECK(contains(error, "key.ilh: size: " + std::to_string(size) + " bytes, expected "));
        CHECK(contains(error, "cut off"));
        if (size >= plain_header_size + 4) CHECK(contains(error, std::to_string(whole.size())));
        CHECK(file_error_of(folder, cut) == (folder.path() / error).string());
    }
}

TEST_CASE("a file that is too long is rejected") {
    const ScratchFolder folder;
    Bytes bytes = plain_sample();
    const std::size_t size = bytes.size();
    for (const std::size_t extra : {1u, 3u, 4u, 8u, 12u, 4096u}) {
        CAPTURE(extra);
        bytes.resize(size + extra);
        CHECK(contains(error_of(bytes), "too long"));
        CHECK(contains(file_error_of(folder, bytes), "expected " + std::to_string(size)));
    }
}

TEST_CASE("every single damaged byte is found") {
    check_damage_is_found(plain_sample());
}

TEST_CASE("any content with the right checksum is rejected or is a sound hierarchy") {
    int sound = 0;
    int refused = 0;
    for (unsigned seed = 0; seed < trials(20'000); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        Bytes bytes =
            serialize_hierarchy(random_hierarchy(random, seed % 2 == 1, static_cast<int>(seed % 8)));
        for (auto flips = 1 + random() % 3; flips > 0; --flips)
            bytes[random() % bytes.size()] ^= static_cast<std::byte>(1u << random() % 8);
        repair_checksum(bytes);
        try {
            const Hierarchy parsed = parse_hierarchy(bytes, "key.ilh");
            CHECK(check(parsed).empty());
            ++sound;
        } catch (const InputError& error) {
            CHECK(std::string_view(error.what()).starts_with("key.ilh: "));
            ++refused;
        }
    }
    CHECK(sound > trials(1000));
    CHECK(refused > trials(1000));
}

TEST_CASE("random counts cause no allocation that the file does not support") {
    constexpr unsigned seed = 11;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 20'000; ++round) {
        Bytes bytes = plain_sample();
        for (std::size_t offset = 16; offset < plain_header_size; offset += 4)
            if (random() % 2 == 0)
                set_word(bytes, offset, static_cast<std::uint32_t>(random() >> random() % 32));
        repair_checksum(bytes);
        try {
            const Hierarchy parsed = parse_hierarchy(bytes, "key.ilh");
            CHECK(check(parsed).empty());
        } catch (const InputError& error) {
            CHECK(std::string_view(error.what()).starts_with("key.ilh: "));
        }
    }
}

TEST_CASE("the largest counts are compared with the size before anything else") {
    constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
    Bytes bytes = plain_sample();
    for (std::size_t offset = 16; offset < plain_header_size; offset += 4) set_word(bytes, offset, most);
    // 36 + 12 n + 8 ceil(3 n / 64) + 4 n + 12 n with n = 2^32 - 1
    CHECK(contains(error_of(bytes), "expected 121869697032 by its counts"));

    // Root vertices do not change the size of the file.
    Bytes roots = plain_sample();
    set_word(roots, 16, most);
    repair_checksum(roots);
    CHECK(contains(error_of(roots), "key.ilh: root vertex count: is 4294967295, expected at most"));
}

TEST_CASE("the message names each wrong part and what was expected") {
    const auto error_with = [](auto&& change) {
        Bytes bytes = plain_sample();
        change(bytes);
        repair_checksum(bytes);
        return error_of(bytes);
    };
    CHECK(contains(error_with([](Bytes& b) { b[1] = std::byte{'X'}; }),
                   "signature: is not that of a hierarchy file"));
    CHECK(contains(error_with([](Bytes& b) { b.erase(b.begin() + 4); }), "as by a transfer in text mode"));
    CHECK(contains(error_with([](Bytes& b) { set_word(b, 8, 2); }), "size: "));
    CHECK(contains(error_with([](Bytes& b) { set_word(b, 8, 3); }), "version: is 3, expected 1 or 2"));
    CHECK(contains(error_with([](Bytes& b) { set_word(b, 12, 65); }),
                   "field count: is 65, expected at most 64"));
    CHECK(contains(error_with([](Bytes& b) { set_word(b, plain_header_size, 77); }), "root complex: "));
    CHECK(contains(error_with([](Bytes& b) { b[plain_header_size + std::size_t{8} * 12] ^= std::byte{1}; }),
                   "hierarchy: "));
    CHECK(contains(error_with([](Bytes& b) { set_word(b, b.size() - 8, 0x7fc00000); }), "hierarchy: "));

    Bytes damaged = plain_sample();
    damaged[plain_header_size] ^= std::byte{1};
    CHECK(contains(error_of(damaged), "checksum: is "));

    const Hierarchy empty;
    CHECK(contains(error_of(serialize_hierarchy(empty)), "root triangle count: is 0, expected at least 1"));
}

TEST_CASE("anything but a file is an error, not a wait or a crash") {
    const ScratchFolder folder;
    CHECK(contains(input_error_of([&] { read_hierarchy(folder.path()); }), "is a folder, expected a file"));
    CHECK(contains(input_error_of([&] { read_hierarchy("/dev/zero"); }), "expected a file"));
    CHECK(contains(machine_error_of([&] { read_hierarchy(folder / "missing.ilh"); }), "No such file"));
}

}  // namespace interleaf
