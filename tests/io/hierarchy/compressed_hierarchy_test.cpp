// The compressed form: the same content for every key, less space, and a reader that trusts nothing.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include "messages.h"
#include "sanitized.h"
#include "scratch_folder.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <libdeflate.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"
#include "hierarchy/random_families.h"
#include "io/family/family_file.h"
#include "io/hierarchy/bisection_decisions.h"
#include "io/hierarchy/coordinate_grid.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/hierarchy/position_planes.h"
#include "io/key_bytes.h"
#include "io/samples.h"
#include "shapes/shapes.h"

namespace interleaf {

namespace {

using testing::for_random_families;
using testing::RandomFamily;

constexpr std::size_t header_size = 64;

Bytes compressed_to(const Hierarchy& hierarchy, unsigned bits) {
    return serialize_hierarchy(hierarchy, {.compressed = true, .rounding_bits = bits});
}

double bytes_a_leaf(const Bytes& bytes, const Hierarchy& key) {
    return static_cast<double>(bytes.size()) / static_cast<double>(key.leaf_count());
}

template <typename Value>
void set(Bytes& bytes, std::size_t offset, Value value) {
    std::memcpy(bytes.data() + offset, &value, sizeof(value));
}

template <typename Value>
Value get(const Bytes& bytes, std::size_t offset) {
    Value value;
    std::memcpy(&value, bytes.data() + offset, sizeof(value));
    return value;
}

Hierarchy compressed_sample() {
    std::mt19937 random(3);
    return random_hierarchy(random, false, 20);
}

/// The peak of this process's memory while \p action runs, minus its memory before; bytes.
std::size_t memory_of(const std::function<void()>& action) {
    const auto held = [](std::string_view what) {
        const std::string status = content("/proc/self/status");
        return std::stoul(status.substr(status.find(what) + what.size())) << 10;
    };
    std::ofstream("/proc/self/clear_refs") << "5";  // resets the peak
    const std::size_t before = held("VmRSS:");
    action();
    return std::max(held("VmHWM:"), before) - before;
}

/// The sanitizer keeps freed memory for some time.
constexpr std::size_t memory_limit = std::size_t{is_sanitized ? 1024 : 32} << 20;

}  // namespace

TEST_CASE("a compressed file holds what was written, bit for bit") {
    const ScratchFolder folder;
    for_random_families(600, 2, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        for (const Hierarchy& key : family.keys)
            CHECK(is_same(parse_hierarchy(serialize_hierarchy(key, compressed_form), "memory"), key));
    });
    const Hierarchy key = compressed_sample();
    write_hierarchy(key, folder / "key.ilh", compressed_form);
    CHECK(is_compressed_hierarchy(folder / "key.ilh"));
    CHECK(is_same(read_hierarchy(folder / "key.ilh"), key));
    write_hierarchy(key, folder / "plain.ilh");
    CHECK_FALSE(is_compressed_hierarchy(folder / "plain.ilh"));
    CHECK_THROWS_AS(is_compressed_hierarchy(folder / "missing.ilh"), MachineError);
}

TEST_CASE("any floats are read back, including both zeros and the extremes") {
    constexpr float odd[] = {0.0F,
                             -0.0F,
                             1.0F,
                             -1.0F,
                             std::numeric_limits<float>::max(),
                             std::numeric_limits<float>::lowest(),
                             std::numeric_limits<float>::denorm_min(),
                             -std::numeric_limits<float>::denorm_min(),
                             std::numeric_limits<float>::min(),
                             0.1F};
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        Hierarchy key = random_hierarchy(random, seed % 2 == 1, static_cast<int>(seed % 40));
        for (glm::vec3& position : key.positions)
            for (int axis = 0; axis < 3; ++axis)
                if (random() % 4 == 0) position[axis] = odd[random() % std::size(odd)];
        CHECK(is_same(parse_hierarchy(serialize_hierarchy(key, compressed_form), "memory"), key));
    }
}

TEST_CASE("the five keys are compressed to a fifth, without loss") {
    const Family family = read_family(INTERLEAF_FIVE_KEYS);
    for (const Key& key : family.keys) {
        CAPTURE(key.name);
        const Bytes bytes = serialize_hierarchy(*key.hierarchy, compressed_form);
        CHECK(is_same(parse_hierarchy(bytes, "memory"), *key.hierarchy));
        if (key.hierarchy->leaf_count() > 1000) CHECK(bytes_a_leaf(bytes, *key.hierarchy) < 2.05);
    }
}

TEST_CASE("keys of 40,000 leaves take at most 2.8 bytes per leaf, and less when rounded") {
    for (const Shape& shape : shapes()) {
        if (shape.surface == nullptr) continue;
        CAPTURE(shape.name);
        const Hierarchy key = make_key(shape, {.leaves = 40'000, .tolerance = {}});
        REQUIRE(key.leaf_count() > 39'000);
        const double lossless = bytes_a_leaf(serialize_hierarchy(key, compressed_form), key);
        CHECK(lossless <= 2.8);
        double before = lossless;
        for (const unsigned bits : {20U, 16U, 12U, 8U}) {
            CAPTURE(bits);
            const double now = bytes_a_leaf(compressed_to(key, bits), key);
            CHECK(now < before);
            before = now;
        }
    }
}

TEST_CASE("a rounded file holds coordinates within the stated bound, in either form") {
    for_random_families(200, 1, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const Box box = bounding_box(key.positions);
        const double side = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
        for (unsigned bits = 8; bits <= 24; ++bits) {
            CAPTURE(bits);
            const Bytes bytes = compressed_to(key, bits);
            const Hierarchy rounded = parse_hierarchy(bytes, "memory");
            CHECK(std::ranges::equal(rounded.bits, key.bits));
            for (std::size_t v = 0; v < key.vertex_count(); ++v)
                for (int axis = 0; axis < 3; ++axis)
                    CHECK(std::abs(double{rounded.positions[v][axis]} - double{key.positions[v][axis]}) <=
                          side / std::exp2(bits + 1) * (1 + 1e-6));
            const Bytes plain = serialize_hierarchy(key, {.compressed = false, .rounding_bits = bits});
            CHECK(is_same(parse_hierarchy(plain, "memory"), rounded));
            // Rounded positions remain small when they are compressed again without rounding.
            CHECK(serialize_hierarchy(rounded, compressed_form) == bytes);
        }
    });
}

TEST_CASE("the layout of the compressed form is the documented one") {
    const Hierarchy triangle =
        unrefined(RootComplex(3, {{0, 1, 2}}), std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const Bytes bytes = serialize_hierarchy(triangle, compressed_form);
    CHECK(get<std::uint32_t>(bytes, 8) == 2);   // version
    CHECK(get<std::uint32_t>(bytes, 12) == 0);  // fields
    CHECK(get<std::uint32_t>(bytes, 16) == 3);  // root vertices
    CHECK(get<std::uint32_t>(bytes, 20) == 1);  // root triangles
    CHECK(get<std::uint32_t>(bytes, 24) == 0);  // midpoints
    CHECK(get<std::uint32_t>(bytes, 28) == 3);  // vertices
    CHECK(get<std::uint64_t>(bytes, 32) == 1);  // decisions
    const auto first = get<std::uint64_t>(bytes, 40);
    const auto second = get<std::uint64_t>(bytes, 48);
    CHECK(bytes.size() == header_size + first + second + 4);
    CHECK(get<std::int32_t>(bytes, 56) == 0);  // grid exponent
    const Bytes plain = serialize_hierarchy(triangle);
    CHECK(get<std::uint32_t>(bytes, 60) == get<std::uint32_t>(plain, plain.size() - 4));
    constexpr std::uint32_t zstd_magic = 0xfd2fb528;
    CHECK(get<std::uint32_t>(bytes, header_size) == zstd_magic);
    CHECK(get<std::uint32_t>(bytes, header_size + first) == zstd_magic);
}

TEST_CASE("a compressed file that is cut off anywhere, or too long, is rejected") {
    const ScratchFolder folder;
    const Bytes whole = serialize_hierarchy(compressed_sample(), compressed_form);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        CHECK(contains(error_of(cut), "key.ilh: size: " + std::to_string(size) + " bytes, expected "));
        CHECK(contains(error_of(cut), "cut off"));
        put(folder / "key.ilh", {reinterpret_cast<const char*>(cut.data()), cut.size()});
        CHECK_THROWS_AS(read_hierarchy(folder / "key.ilh"), InputError);
    }
    Bytes longer = whole;
    longer.resize(whole.size() + 1);
    CHECK(contains(error_of(longer), "too long"));
}

TEST_CASE("every single damaged byte of a compressed file is found") {
    check_damage_is_found(serialize_hierarchy(compressed_sample(), compressed_form));
}

TEST_CASE("any content with the right checksums is rejected or sound") {
    const std::size_t memory = memory_of([] {
        for (unsigned seed = 0; seed < trials(6000); ++seed) {
            CAPTURE(seed);
            std::mt19937 random(seed);
            const Hierarchy key = random_hierarchy(random, seed % 2 == 1, static_cast<int>(seed % 30));
            Bytes bytes = compressed_to(key, seed % 3 == 0 ? 12 : 0);
            for (auto flips = 1 + random() % 3; flips > 0; --flips)
                bytes[random() % bytes.size()] ^= static_cast<std::byte>(1u << random() % 8);
            repair_checksum(bytes);
            is_sound_or_refused(bytes);
        }
    });
    CHECK(memory < memory_limit);
}

TEST_CASE("counts that the content does not support take no memory") {
    constexpr unsigned seed = 11;
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Bytes whole = serialize_hierarchy(compressed_sample(), compressed_form);
    const std::size_t memory = memory_of([&] {
        for (int round = 0; round < 20'000; ++round) {
            Bytes bytes = whole;
            for (std::size_t offset = 16; offset < header_size; offset += 4)
                if (random() % 4 == 0)
                    set<std::uint32_t>(bytes, offset, static_cast<std::uint32_t>(random() >> random() % 32));
            repair_checksum(bytes);
            is_sound_or_refused(bytes);
        }
    });
    CHECK(memory < memory_limit);
}

TEST_CASE("a frame that is cut off anywhere is rejected, even with matching sizes and checksum") {
    const Bytes whole = serialize_hierarchy(compressed_sample(), compressed_form);
    const auto first = get<std::uint64_t>(whole, 40);
    const auto second = get<std::uint64_t>(whole, 48);
    const auto error_without = [&](std::size_t size_offset, std::size_t end, std::uint64_t cut) {
        Bytes bytes = whole;
        const auto frame_end = bytes.begin() + static_cast<std::ptrdiff_t>(end);
        bytes.erase(frame_end - static_cast<std::ptrdiff_t>(cut), frame_end);
        set(bytes, size_offset, get<std::uint64_t>(bytes, size_offset) - cut);
        repair_checksum(bytes);
        return error_of(bytes);
    };
    for (std::uint64_t cut = 1; cut <= first; ++cut)
        CHECK(contains(error_without(40, header_size + first, cut), "connectivity: "));
    for (std::uint64_t cut = 1; cut <= second; ++cut)
        CHECK(contains(error_without(48, header_size + first + second, cut), "positions: "));
}

TEST_CASE("any planes of positions give positions") {
    const Hierarchy key = compressed_sample();
    const Connectivity connectivity = open_decisions(key).connectivity;
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        Buffer<std::byte> planes = position_planes(key.positions, connectivity, std::nullopt);
        for (std::byte& byte : planes)
            if (random() % 4 == 0) byte = static_cast<std::byte>(random());
        std::optional<CoordinateGrid> grid;
        if (seed % 2 == 1) grid.emplace(static_cast<int>(random() % 277) - 149);
        CHECK(positions_of(planes, connectivity, grid).size() == key.vertex_count());
    }
}

TEST_CASE("the message names each wrong part of a compressed file") {
    const auto error_with = [](auto&& change) {
        Bytes bytes = serialize_hierarchy(compressed_sample(), compressed_form);
        change(bytes);
        repair_checksum(bytes);
        return error_of(bytes);
    };
    const auto error_of_change = [&](std::size_t offset, auto value) {
        return error_with([&](Bytes& b) { set(b, offset, value); });
    };
    CHECK(error_with([](Bytes&) {}).empty());
    CHECK(contains(error_of_change(12, 65U), "field count: is 65, expected at most 64"));
    CHECK(contains(error_of_change(16, 0xffffffffU), "root vertex count: is 4294967295, expected at most"));
    CHECK(contains(error_of_change(20, 0U), "root triangle count: is 0"));
    CHECK(contains(error_of_change(24, 0x40000000U), "counts: stand for "));
    CHECK(contains(error_of_change(24, 0U), "decision count: is "));
    CHECK(contains(error_of_change(24, 1000U), "connectivity: "));
    CHECK(contains(error_of_change(28, 10'000U), "connectivity: "));
    CHECK(contains(error_of_change(32, std::uint64_t{3}), "connectivity: "));
    CHECK(contains(error_of_change(32, ~std::uint64_t{0}), "decision count: is "));
    CHECK(contains(error_of_change(40, ~std::uint64_t{0}), "size: "));
    CHECK(contains(error_of_change(48, ~std::uint64_t{0} - 99), "size: "));
    CHECK(contains(error_of_change(56, 128), "grid exponent: is 128, expected -149 to 127"));
    CHECK(contains(error_of_change(56, -150), "grid exponent: is -150"));
    CHECK(contains(error_of_change(56, -3), "checksum of the content: is "));
    CHECK(contains(error_of_change(60, 0U), "checksum of the content: is 00000000, expected "));
    CHECK(contains(error_of_change(header_size, 0U), "connectivity: cannot be decompressed: "));
    CHECK(contains(error_with([](Bytes& b) { set(b, header_size + get<std::uint64_t>(b, 40), 0U); }),
                   "positions: cannot be decompressed: "));
    Bytes damaged = serialize_hierarchy(compressed_sample(), compressed_form);
    damaged[header_size + 5] ^= std::byte{1};
    CHECK(contains(error_of(damaged), "key.ilh: checksum: is "));
}

TEST_CASE("a key that would shrink too much is written plain") {
    // All vertices are in one place, so only the counts take space: 2.3 million leaves.
    const auto flat = [](unsigned side) {
        const RootComplex roots = testing::sheet(side, side);
        return unrefined(roots, std::vector<glm::vec3>(roots.vertex_count()));
    };
    const Hierarchy small = flat(200);
    const Bytes little = serialize_hierarchy(small, compressed_form);
    CHECK(bytes_a_leaf(little, small) < 0.1);
    CHECK(is_same(parse_hierarchy(little, "memory"), small));

    const Hierarchy large = flat(1000);
    const Bytes bytes = serialize_hierarchy(large, compressed_form);
    CHECK(bytes == serialize_hierarchy(large));
}

}  // namespace interleaf
