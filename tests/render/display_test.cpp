// Tests of the names of what the picture shows.
#include "render/display.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("every coloring has a name and a label of its own, and is found by its name") {
    std::set<std::string> names;
    std::size_t place = 0;
    for (const Coloring coloring : colorings(true)) {
        CHECK(static_cast<std::size_t>(coloring) == place++);
        const std::string name(name_of(coloring));
        CHECK(names.insert(name).second);
        CHECK(coloring_named(name) == coloring);
        std::string label = label_of(coloring);
        std::ranges::transform(label, label.begin(), [](unsigned char c) { return std::tolower(c); });
        CHECK(label == name);
    }
    CHECK_FALSE(coloring_named("Plain"));
    CHECK_FALSE(coloring_named(""));
    CHECK(colorings(false).size() + 1 == colorings(true).size());
}

TEST_CASE("colorings follow each other around, that by a field only where there is one") {
    for (const bool has_fields : {false, true}) {
        const auto all = colorings(has_fields);
        Coloring coloring = Coloring::plain;
        std::set<Coloring> seen;
        for (std::size_t i = 0; i < all.size(); ++i) {
            seen.insert(coloring);
            coloring = next_coloring(coloring, has_fields);
        }
        CHECK(seen.size() == all.size());
        CHECK(coloring == Coloring::plain);
    }
    CHECK(next_coloring(Coloring::field, false) == Coloring::plain);
}

TEST_CASE("the help says what each coloring shows") {
    CHECK(colorings_in_words() ==
          "plain, level (of each leaf), origin (which keys bisect this far), common (whether all, some or "
          "one of the "
          "keys bisect this far), checker (over the roots), angle (smallest of each leaf), curvature (mean "
          "curvature), "
          "moved (distance from the first active key)");
}

TEST_CASE("shadings are found by their names") {
    for (const Shading shading : {Shading::smooth, Shading::flat})
        CHECK(shading_named(name_of(shading)) == shading);
    CHECK_FALSE(shading_named("rough"));
}

TEST_CASE("every material has a name and a label, is found by its name, and leads to the next one") {
    std::set<std::string> names;
    Material next = Material::clay;
    for (const Material material : materials()) {
        CHECK(material == next);
        next = next_material(material);
        const std::string name(name_of(material));
        CHECK(names.insert(name).second);
        CHECK(material_named(name) == material);
        CHECK(materials_in_words().find(name) != std::string::npos);
        CHECK_FALSE(std::string(label_of(material)).empty());
    }
    CHECK(next == Material::clay);
    CHECK_FALSE(material_named("gold"));
}
