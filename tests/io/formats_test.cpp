// The table of formats: its rows agree with their readers and writers, and docs/file-formats.md with its
// rows.
#include "io/formats.h"

#include <algorithm>
#include <random>
#include <set>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "family/new_family.h"
#include "io/read_files.h"
#include "io/samples.h"
#include "io/text/joined_text.h"

namespace interleaf {

namespace fs = std::filesystem;

namespace {

std::string carried_in_words(const std::optional<Carried>& carried) {
    if (!carried) return "never";
    std::vector<std::string> parts;
    if (carried->fields) parts.emplace_back("fields");
    if (carried->colors) parts.emplace_back("colors");
    if (carried->hierarchy) parts.emplace_back("hierarchy");
    if (carried->origin) parts.emplace_back("origin");
    if (carried->time) parts.emplace_back("time");
    return joined(parts, ", ");
}

std::string contents_in_words(const Format& format) {
    std::vector<std::string> parts;
    if (format.holds_family()) parts.emplace_back("a family");
    if (format.holds_key()) parts.emplace_back("a key");
    if (format.holds_mesh()) parts.emplace_back("a mesh to fit");
    if (format.holds_series()) parts.emplace_back("a step of a series");
    return either_of(parts);
}

/// The table as docs/file-formats.md has it.
std::string table_in_markdown() {
    std::string text =
        "| extension | format | may hold | read | written | by `export` |\n|---|---|---|---|---|---|\n";
    for (const Format& format : formats())
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", format.extension, format.title,
                            contents_in_words(format), carried_in_words(format.read),
                            carried_in_words(format.written), format.is_exported() ? "yes" : "no");
    return text;
}

/// A family of one key with a color, a scalar, a bisection and an origin.
Family rich_family() {
    std::mt19937 random(7);
    Hierarchy key = random_hierarchy(random, false, 3);
    const std::size_t count = key.positions.size();
    key.fields.push_back({"color", FieldKind::color, Buffer<float>(3 * count, 0.5F)});
    key.fields.push_back({"height", FieldKind::scalar, Buffer<float>(count, 2)});
    std::vector<Key> keys;
    keys.push_back({"key", std::move(key)});
    Family family = family_of_keys("rich", std::move(keys));
    family.origin = {500'000, 5'400'000, 0};
    return family;
}

/// The content of \p file, and of the files beside it whose names begin in the same way.
std::string content_of_all(const fs::path& file) {
    std::string bytes = content(file);
    for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path()))
        if (entry.path().filename().string().starts_with(file.stem().string() + ".0"))
            bytes += content(entry.path());
    return bytes;
}

}  // namespace

TEST_CASE("extensions are small letters after a dot, each once, and are found in any case") {
    std::set<std::string_view> extensions;
    for (const Format& format : formats()) {
        CAPTURE(format.extension);
        CHECK(format.extension.starts_with('.'));
        CHECK(std::ranges::none_of(format.extension, [](char c) { return c >= 'A' && c <= 'Z'; }));
        CHECK(extensions.insert(format.extension).second);
        CHECK_FALSE(format.title.empty());
        std::string name = "a.b" + std::string(format.extension);
        CHECK(find_format(name) == &format);
        std::ranges::transform(name, name.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
        CHECK(find_format(name) == &format);
    }
    CHECK(find_format("notes.txt") == nullptr);
    CHECK(find_format("obj") == nullptr);
    CHECK(find_format(".obj") == nullptr);  // a hidden file without an extension
    CHECK(format_with_extension(".obj") == find_format("a.obj"));
    CHECK(format_with_extension("obj") == nullptr);
    CHECK(find_format("") == nullptr);
}

TEST_CASE("a row says what is carried exactly where there is a reader, and for every writer") {
    for (const Format& format : formats()) {
        CAPTURE(format.extension);
        CHECK(format.read.has_value() == format.is_openable());
        if (format.is_exported()) CHECK(format.written.has_value());
    }
}

TEST_CASE("extensions are listed in the table's order, in words with an or") {
    CHECK(
        extensions_in_words(&Format::is_openable) ==
        ".json, .ilh, .obj, .ply, .stl, .off, .glb, .gltf, .vtp, .vtu, .pvtp, .pvtu, .vtk, .pvd or .series");
    CHECK(extensions_in_words(&Format::holds_family_or_key) == ".json, .ilh, .obj, .glb or .gltf");
    CHECK(extensions_in_words(&Format::holds_key) == ".ilh, .obj, .glb or .gltf");
    CHECK(extensions_in_words(&Format::holds_mesh) == ".obj, .ply, .stl, .off, .glb or .gltf");
    CHECK(extensions_in_words(&Format::holds_mesh_as_key) == ".obj, .glb or .gltf");
    CHECK(extensions_of(&Format::opens_unfitted) == std::vector<std::string>{".json", ".ilh", ".glb", ".gltf",
                                                                             ".vtp", ".vtu", ".pvtp", ".pvtu",
                                                                             ".vtk", ".pvd", ".series"});
    CHECK(is_called("A.STL", &Format::holds_mesh));
    CHECK_FALSE(is_called("A.STL", &Format::holds_key));
    CHECK_FALSE(is_called("A.txt", &Format::is_openable));
}

TEST_CASE("an exported file carries what its row says, and what its reader takes comes back") {
    const Family family = rich_family();
    const ScratchFolder folder;
    std::size_t exported = 0;
    for (const Format& format : formats()) {
        if (!format.is_exported()) continue;
        ++exported;
        CAPTURE(format.extension);
        const fs::path file = folder / fmt::format("out-{}{}", format.extension.substr(1), format.extension);
        format.write({family, Weights{{0, 1.0}}, {}}, {file});
        const std::string bytes = content_of_all(file);
        const bool names_fields = bytes.find("height") != std::string::npos;
        CHECK(names_fields == format.written->fields);
        const Carried read_back = format.read.value_or(Carried());
        const Carried back{.fields = format.written->fields && read_back.fields,
                           .colors = format.written->colors && read_back.colors,
                           .hierarchy = format.written->hierarchy && read_back.hierarchy,
                           .origin = format.written->origin && read_back.origin};
        if (format.holds_key()) {
            const Family read = read_keys(std::span(&file, 1));
            const Hierarchy& key = *read.keys.front().hierarchy;
            const auto has = [&](const char* name, FieldKind kind) {
                return find_field(key.fields, {name, kind}) != nullptr;
            };
            CHECK(has("height", FieldKind::scalar) == back.fields);
            CHECK(has("color", FieldKind::color) == back.colors);
            CHECK((key.leaf_count() > key.roots.triangle_count()) == back.hierarchy);
            CHECK((read.origin != glm::dvec3(0)) == back.origin);
        }
        if (format.holds_mesh()) {
            const SurfaceFile read = read_surface(file);
            CHECK(!read.colors.empty() == back.colors);
            CHECK((read.positions.front().x > 400'000) == back.origin);
        }
    }
    CHECK(exported >= 3);
}

TEST_CASE("the table of docs/file-formats.md is the table of formats") {
    const std::string table = table_in_markdown();
    INFO("docs/file-formats.md needs this table:\n", table);
    CHECK(contains(content(FILE_FORMATS_PAGE), "\n\n" + table + "\n"));
}

TEST_CASE("a file of no mesh format is no surface, and of no key format no key") {
    const ScratchFolder folder;
    for (const char* const name : {"a.ilh", "family.json", "a.txt", "a"}) {
        CAPTURE(name);
        CHECK(contains(
            input_error_of([&] { read_surface(folder / name); }),
            std::string(name) + ": expected a file that ends in .obj, .ply, .stl, .off, .glb or .gltf"));
    }
    const std::vector<fs::path> unknown{folder / "a.txt", folder / "b.txt"};
    CHECK(contains(input_error_of([&] { read_keys(unknown); }),
                   "a.txt: expected a file that ends in .ilh, .obj, .glb or .gltf; `interleaf fit`"));
}

}  // namespace interleaf
