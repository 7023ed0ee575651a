// The web page: what it holds, and that nothing in a family can become a part of its code.
// tests/cli/check_page.py decodes the payload and checks the hashes.
#include "io/page/page_export.h"

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>

#include "family/interpolation.h"
#include "family/new_family.h"
#include "io/page/embedded_page.h"
#include "io/page/page_payload.h"
#include "io/samples.h"
#include "io/text/joined_text.h"

namespace interleaf {

namespace {

std::string page_of(const Family& family) {
    const ScratchFolder folder;
    export_page({family, std::nullopt, {}}, {folder / "a.html"});
    return content(folder / "a.html");
}

std::size_t count_of(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// \p count keys with fields, over the octahedron.
Family family_of(std::size_t count) {
    std::mt19937 random(17);
    std::vector<Key> keys;
    for (std::size_t n = 0; n < count; ++n) {
        Hierarchy key = random_hierarchy(random, false, 6);
        key.fields.push_back({"height", FieldKind::scalar, Buffer<float>(key.vertex_count(), 1)});
        if (n > 0)
            key.fields.push_back({"color", FieldKind::color, Buffer<float>(3 * key.vertex_count(), 1)});
        keys.push_back({"key", std::move(key)});
    }
    return family_of_keys("sample", std::move(keys));
}

/// The names in the table of interpolation bases of the page's script (timeline.js).
std::set<std::string> bases_of_page() {
    const auto part = std::ranges::find(embedded_page(), "script", &EmbeddedPart::name);
    REQUIRE(part != embedded_page().end());
    constexpr std::string_view head = "\nconst bases = {\n";
    const std::size_t begin = part->text.find(head);
    REQUIRE(begin != std::string_view::npos);
    std::string_view rows = part->text.substr(begin + head.size());
    rows = rows.substr(0, rows.find("\n};\n"));
    // A row begins with its name, in quotes where that is no identifier, and a colon.
    std::set<std::string> names;
    for (std::string_view line : split_at(rows, '\n')) {
        const std::size_t colon = line.find(": ");
        if (colon == std::string_view::npos) continue;
        std::string_view name = line.substr(0, colon);
        if (name.starts_with('"') && name.ends_with('"')) name = name.substr(1, name.size() - 2);
        names.emplace(name);
    }
    return names;
}

}  // namespace

TEST_CASE("the page has the interpolation bases of the library") {
    std::set<std::string> names;
    for (const Basis basis : bases()) names.emplace(name_of(basis));
    CHECK(bases_of_page() == names);
}

TEST_CASE("names cannot end a script or begin an element") {
    std::mt19937 random(1);
    Family family = sample_family(random);
    const std::string plain = page_of(family);
    family.name = "</title></script><script>alert(1)</script><!-- {{script}} &amp; \xe2\x80\xa8";
    family.keys[0].name = "</script><!--<script>";
    const std::string page = page_of(family);
    for (const char* const tag : {"<script", "</script", "<!--", "<style", "</title", "-->"}) {
        CAPTURE(tag);
        CHECK(count_of(page, tag) == count_of(plain, tag));
    }
    CHECK(contains(page, "<title>&lt;/title&gt;&lt;/script&gt;"));
    CHECK(contains(page, "{{script}} &amp;amp;"));
    CHECK(contains(page, "\\u003c/script\\u003e"));
}

TEST_CASE("the page may load nothing") {
    const std::string page = page_of(family_of(2));
    CHECK(contains(page, "content=\"default-src 'none'; script-src 'sha256-"));
    for (const char* const part :
         {"http:", "https:", "//cdn", "src=", "href=", "@import", "url(", "unsafe", "eval("}) {
        CAPTURE(part);
        CHECK_FALSE(contains(page, part));
    }
}

TEST_CASE("the description has the counts of each key, and the fields that all keys have") {
    const Family family = family_of(3);
    const PagePayload payload = page_payload(family);
    const auto& description = payload.description;
    CHECK(description["name"] == "sample");
    CHECK(description["roots"] == 8);
    CHECK(description["rootVertices"] == 6);
    REQUIRE(description["keys"].size() == 3);
    for (std::size_t n = 0; n < 3; ++n) {
        CHECK(description["keys"][n]["name"] == family.keys[n].name);
        CHECK(description["keys"][n]["vertices"] == family.keys[n].hierarchy->vertex_count());
        CHECK(description["keys"][n]["bisections"] == family.keys[n].hierarchy->midpoints.size());
    }
    REQUIRE(description["fields"].size() == 1);
    CHECK(description["fields"][0]["name"] == "height");
    CHECK(description["timeline"]["keys"].size() == 3);
}

TEST_CASE("equal families make equal pages") {
    CHECK(page_of(family_of(2)) == page_of(family_of(2)));
}

TEST_CASE("a timeline that blends more keys than the page's walk can hold is refused") {
    Family family = family_of(32);
    CHECK_NOTHROW(page_of(family));
    family.timeline = family.timeline->with_interpolation({Basis::bernstein});
    CHECK(contains(input_error_of([&] { page_of(family); }),
                   "blends 32 keys at once; a web page blends at most 31"));
    family.timeline = family.timeline->with_interpolation({Basis::bernstein, 30});
    CHECK_NOTHROW(page_of(family));
}

TEST_CASE("a key without extent is a page, too") {
    std::vector<Key> keys;
    keys.push_back(
        {"point", unrefined(RootComplex(3, {{0, 1, 2}}), std::vector<glm::vec3>(3, glm::vec3(2)))});
    const PagePayload payload = page_payload(family_of_keys("point", std::move(keys)));
    CHECK(payload.description["unit"] == 1.0);
    CHECK(payload.description["box"][0] == nlohmann::ordered_json{2.0, 2.0, 2.0});
}

}  // namespace interleaf
