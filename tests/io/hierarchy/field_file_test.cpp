// Fields in hierarchy files of both forms: the same values are read back, and no table is trusted.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <string>

#include "messages.h"
#include "scratch_folder.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <libdeflate.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/random_families.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/key_bytes.h"
#include "io/samples.h"
#include "shapes/shapes.h"

namespace interleaf {

namespace {

constexpr HierarchyFileOptions plain_form{};
/// The offset of the field table.
constexpr std::size_t plain_table = 32, compressed_table = 72;

/// A key with a scalar field and a color field.
Hierarchy sample_with_fields() {
    std::mt19937 random(3);
    Hierarchy key = random_hierarchy(random, false, 10);
    Field height{"height", FieldKind::scalar, {}};
    Field color{"color", FieldKind::color, {}};
    for (const glm::vec3& p : key.positions) {
        height.values.push_back(p.z);
        const glm::vec3 mixed = 0.5F + 0.4F * p;
        color.values.insert(color.values.end(), {mixed.x, mixed.y, mixed.z});
    }
    key.fields.push_back(std::move(height));
    key.fields.push_back(std::move(color));
    return key;
}

}  // namespace

TEST_CASE("a file of either form holds the fields that were written, bit for bit") {
    const ScratchFolder folder;
    for (unsigned seed = 0; seed < 150; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const Hierarchy bare = random_hierarchy(random, seed % 2 == 1, static_cast<int>(seed));
        const Hierarchy key = with_fields(bare, random, seed % 7 == 6 ? 64 : seed % 7);
        REQUIRE(check(key) == std::vector<std::string>{});
        for (const HierarchyFileOptions& form : {plain_form, compressed_form}) {
            CHECK(is_same(parse_hierarchy(serialize_hierarchy(key, form), "memory"), key));
            write_hierarchy(key, folder / "key.ilh", form);
            CHECK(is_same(read_hierarchy(folder / "key.ilh"), key));
        }
    }
    testing::for_random_families(300, 1, [&](const testing::RandomFamily& family) {
        CAPTURE(family.seed);
        std::mt19937 random(static_cast<unsigned>(family.seed));
        const Hierarchy key = with_fields(family.keys[0], random, 3);
        CHECK(is_same(parse_hierarchy(serialize_hierarchy(key, compressed_form), "memory"), key));
    });
}

TEST_CASE("the layout of fields is the documented one") {
    Hierarchy key = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const std::size_t bare = serialize_hierarchy(key).size();
    key.fields.push_back({"T", FieldKind::scalar, {1, 2, 3}});
    key.fields.push_back({"color", FieldKind::color, {1, 0, 0, 0, 1, 0, 0, 0, 0.5F}});
    const Bytes bytes = serialize_hierarchy(key);
    constexpr std::array<unsigned char, 10> table{1, 1, 'T', 3, 5, 'c', 'o', 'l', 'o', 'r'};
    REQUIRE(bytes.size() == bare + table.size() + 12 + 36);
    CHECK(bytes[12] == std::byte{2});
    CHECK(std::memcmp(bytes.data() + plain_table, table.data(), table.size()) == 0);
    constexpr std::array<float, 12> values{1, 2, 3, 1, 0, 0, 0, 1, 0, 0, 0, 0.5F};
    CHECK(std::memcmp(bytes.data() + bytes.size() - 4 - sizeof(values), values.data(), sizeof(values)) == 0);

    const Bytes small = serialize_hierarchy(key, compressed_form);
    CHECK(small[12] == std::byte{2});
    CHECK(std::memcmp(small.data() + compressed_table, table.data(), table.size()) == 0);
    std::array<std::uint64_t, 2> first_sizes{};
    std::uint64_t fields_size = 0;
    std::memcpy(first_sizes.data(), small.data() + 40, sizeof(first_sizes));
    std::memcpy(&fields_size, small.data() + 64, sizeof(fields_size));
    CHECK(small.size() ==
          compressed_table + table.size() + first_sizes[0] + first_sizes[1] + fields_size + 4);
}

TEST_CASE("rounding does not change fields") {
    const Hierarchy key = sample_with_fields();
    const Hierarchy rounded =
        parse_hierarchy(serialize_hierarchy(key, {.compressed = true, .rounding_bits = 8}), "memory");
    CHECK_FALSE(rounded.positions == key.positions);
    for (std::size_t f = 0; f < key.fields.size(); ++f)
        CHECK(rounded.fields[f].values == key.fields[f].values);
}

TEST_CASE("a smooth field takes less than 2 bytes per vertex in the compressed form, 4 in the plain form") {
    ShapeBudget budget;
    budget.leaves = 20000;
    Hierarchy key = make_key(*find_shape("star"), budget);
    const std::size_t bare = serialize_hierarchy(key, compressed_form).size();
    const std::size_t bare_plain = serialize_hierarchy(key).size();
    Field height{"height", FieldKind::scalar, {}};
    for (const glm::vec3& p : key.positions) height.values.push_back(1 + 0.1F * p.y * p.y);
    key.fields.push_back(std::move(height));
    const double vertices = static_cast<double>(key.vertex_count());
    const double each =
        static_cast<double>(serialize_hierarchy(key, compressed_form).size() - bare) / vertices;
    MESSAGE("a smooth scalar takes " << each << " bytes per vertex");
    CHECK(each < 2);
    CHECK(serialize_hierarchy(key).size() - bare_plain == 4 * key.vertex_count() + 8);
}

TEST_CASE("a file with fields that is cut off anywhere is rejected") {
    for (const HierarchyFileOptions& form : {plain_form, compressed_form}) {
        const Bytes whole = serialize_hierarchy(sample_with_fields(), form);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            CAPTURE(size);
            const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            CHECK(contains(error_of(cut), "cut off"));
        }
        Bytes longer = whole;
        longer.resize(whole.size() + 4);
        CHECK(contains(error_of(longer), "too long"));
    }
}

TEST_CASE("every single damaged byte of a file with fields is found") {
    for (const HierarchyFileOptions& form : {plain_form, compressed_form})
        check_damage_is_found(serialize_hierarchy(sample_with_fields(), form));
}

TEST_CASE("any content with the right checksum is rejected or has sound fields") {
    int sound = 0;
    int refused = 0;
    for (unsigned seed = 0; seed < trials(30'000); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const HierarchyFileOptions& form = seed % 3 == 0 ? compressed_form : plain_form;
        Bytes bytes = serialize_hierarchy(
            with_fields(random_hierarchy(random, false, static_cast<int>(seed % 6)), random, 1 + seed % 3),
            form);
        for (auto flips = 1 + random() % 3; flips > 0; --flips) {
            // Half of the changes are in the field table.
            const std::size_t place = random() % 2 == 0 ? random() % bytes.size() : 8 + random() % 80;
            bytes[place % bytes.size()] ^= static_cast<std::byte>(1u << random() % 8);
        }
        repair_checksum(bytes);
        ++(is_sound_or_refused(bytes) ? sound : refused);
    }
    CHECK(sound > trials(1000));
    CHECK(refused > trials(1000));
}

TEST_CASE("random field tables cause no allocation that the file does not support") {
    for (unsigned seed = 0; seed < trials(20'000); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const bool is_plain = seed % 2 == 0;
        Bytes bytes = serialize_hierarchy(sample_with_fields(), is_plain ? plain_form : compressed_form);
        bytes[12] = static_cast<std::byte>(random() % 65);
        const std::size_t begin = is_plain ? plain_table : compressed_table;
        for (std::size_t place = begin; place < begin + 40; ++place)
            if (random() % 2 == 0) bytes[place] = static_cast<std::byte>(random() % 4);
        repair_checksum(bytes);
        is_sound_or_refused(bytes);
    }
}

TEST_CASE("the message names each wrong part of a field and what was expected") {
    const auto error_with = [](const HierarchyFileOptions& form, const std::function<void(Bytes&)>& change) {
        Bytes bytes = serialize_hierarchy(sample_with_fields(), form);
        change(bytes);
        repair_checksum(bytes);
        return error_of(bytes);
    };
    for (const bool is_plain : {true, false}) {
        CAPTURE(is_plain);
        const HierarchyFileOptions& form = is_plain ? plain_form : compressed_form;
        const std::size_t table = is_plain ? plain_table : compressed_table;
        const auto put = [&](std::size_t place, int value) {
            return error_with(form, [=](Bytes& b) { b[place] = static_cast<std::byte>(value); });
        };
        CHECK(contains(put(12, 65), "field count: is 65, expected at most 64"));
        CHECK(contains(put(table, 0), "field 0: the kind is 0, expected 1 (scalar) or 3 (color)"));
        CHECK(contains(put(table, 2), "field 0: the kind is 2"));
        CHECK(contains(put(table + 1, 0), "field 0: the name is empty"));
        CHECK(contains(put(table, 3), is_plain ? "size: " : "checksum of the content: "));
        CHECK(contains(put(12, 1), "key.ilh: size: "));
        CHECK_FALSE(put(table + 1, 255).empty());
    }
    // A name that moves a terminal's cursor, a value that is not a number, a color that is out of range.
    CHECK(contains(error_with(plain_form, [](Bytes& b) { b[plain_table + 2] = std::byte{0x1b}; }),
                   "hierarchy: the name of field 0 is not"));
    const auto last_float = [&](float value) {
        return error_with(plain_form, [=](Bytes& b) { std::memcpy(&b[b.size() - 8], &value, 4); });
    };
    CHECK(contains(last_float(1.5F), "hierarchy: field \"color\" is 1.5 at vertex"));
    CHECK(contains(last_float(-INFINITY), "hierarchy: field \"color\" is -inf at vertex"));
    CHECK(contains(error_with(compressed_form,
                              [](Bytes& b) {
                                  const std::uint64_t huge = ~std::uint64_t{0};
                                  std::memcpy(&b[64], &huge, 8);
                              }),
                   "size: the sizes of its parts are too large"));
}

}  // namespace interleaf
