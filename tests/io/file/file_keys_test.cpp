// The keys of several files brought to the same offsets of fields.
#include "io/file/file_keys.h"

#include <string>

#include "messages.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>

namespace interleaf {

namespace {

/// A key called \p name with a scalar "T" whose offset was subtracted.
FileKeys keys_with_offset(const std::string& name, double offset, float value) {
    FileKeys file;
    file.keys.emplace_back();
    file.keys.front().fields = {{.name = "T", .kind = FieldKind::scalar, .values = {value}}};
    file.sources = {{name, 0}};
    file.scales = {{.field = "T", .offset = offset, .unit = "K"}};
    return file;
}

}  // namespace

TEST_CASE("keys of later files get the offset that a field has in the files before") {
    FileKeys all;
    append_keys(all, keys_with_offset("first", 300, 0.25F), {"first", 0});
    append_keys(all, keys_with_offset("second", 200, 1), {"second", 1});
    REQUIRE(all.keys.size() == 2);
    CHECK(scale_of(all.scales, "T").offset == 300);
    CHECK(scale_of(all.scales, "T").unit == "K");
    CHECK(all.keys[0].fields[0].values.front() == 0.25F);
    CHECK(all.keys[1].fields[0].values.front() == -99);
}

TEST_CASE("offsets that are too far apart for floats are refused, naming the key") {
    FileKeys all;
    append_keys(all, keys_with_offset("first", 0, 0), {"first", 0});
    const std::string message = input_error_of([&] {
        append_keys(all, keys_with_offset("second", 1e300, 0), {"second", 1});
    });
    CHECK(contains(message, "key \"second\": the offset of the field \"T\" is too far"));
    CHECK(all.keys.size() == 1);
}

}  // namespace interleaf
