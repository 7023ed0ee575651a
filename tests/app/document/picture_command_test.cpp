// Tests of the command that draws what the window shows.
#include "app/document/picture_command.h"

#include <array>
#include <memory>
#include <string>
#include <utility>

#include <doctest/doctest.h>
#include <fmt/core.h>

#include "app/cli/option_text.h"
#include "app/sample_family.h"
#include "family/family_time.h"

using namespace interleaf;

TEST_CASE("the command has the files, the blend, the view and the size") {
    Session session(std::make_shared<const Family>(sample_family()));
    const std::array<std::filesystem::path, 2> files{"/a b/it's.ilh", "/c.ilh"};
    session.show_key(0, 0);
    CHECK(picture_command(files, session, {}, {.direction = {1, 2, 0}}, {640, 480}) ==
          "interleaf render '/a b/it'\\''s.ilh' /c.ilh --weights=" + session.family().keys[0].name +
              "=1 --camera=1,2 --size=640x480 -o picture.png");
}

TEST_CASE("what drives the blend is the option of the command") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.seek(0.1, 0);
    CHECK(blend_option(session) == "--time=0.1");
    session.move_point(session.family().domain->vertices()[0].at, 0);
    CHECK(blend_option(session).starts_with("--at="));
    session.show_key(1, 0);
    CHECK(blend_option(session) == "--weights=" + session.family().keys[1].name + "=1");
}

TEST_CASE("where a time can belong to the keys or the path, the command says to which") {
    const Family family = sample_family();
    Session of_keys(std::make_shared<const Family>(family));
    of_keys.seek(0.1, 0);
    CHECK(picture_command({}, of_keys, {}, {}, {8, 8}).find("--along") == std::string::npos);
    const Family with_both = with_path(family, DomainPath({{0, {0, 0}}, {1, {1, 0}}}));
    for (const TimeSource source : {TimeSource::keys, TimeSource::path}) {
        Session session(std::make_shared<const Family>(with_time_source(with_both, source)));
        session.seek(0.1, 0);
        CHECK(picture_command({}, session, {}, {}, {8, 8})
                  .find(fmt::format("--time=0.1 --along={} ", name_of(source))) != std::string::npos);
    }
}

TEST_CASE("only options that differ from the defaults are named") {
    Display display;
    CHECK(display_options(display).empty());
    display.wireframe = display.root_edges = true;
    display.shading = Shading::flat;
    display.occlusion = false;
    display.line_width = 3;
    display.coloring = Coloring::field;
    display.field = "level";
    display.scale = {.map = ColorMap::magma, .range = {-1, 2.5F}};
    CHECK(display_options(display) ==
          std::vector<std::string>{"--show=wireframe,root-edges", "--line-width=3", "--shading=flat",
                                   "--no-occlusion", "--color=field:level", "--color-map=magma"});
    display.range_locked = true;
    CHECK(display_options(display).back() == "--range=-1,2.5");
    display.scale.range = {-0x1p-20F, 0x1p-20F};
    display.scale.offset = 1'000'000;
    CHECK(display_options(display).back() == "--range=999999.9999990463,1000000.0000009537");
    display.scale.offset = 0;
    display.scale.is_logarithmic = true;
    CHECK(display_options(display).back() == "--log-scale");
    display.field = "heat";
    CHECK(display_options(display)[4] == "--color=heat");
    Display measured;
    measured.coloring = Coloring::moved;
    measured.measured_range = {Coloring::curvature, {-1, 1}};
    CHECK(display_options(measured) == std::vector<std::string>{"--color=moved"});
    measured.measured_range = {Coloring::moved, {0, 0.5F}};
    CHECK(display_options(measured) == std::vector<std::string>{"--color=moved", "--range=0,0.5"});
    Display made;
    made.material = Material::steel;
    made.ground = made.light_background = true;
    CHECK(display_options(made) == std::vector<std::string>{"--ground", "--material=steel", "--theme=light"});
}

TEST_CASE("commas and backslashes in names of arrows are escaped, and read again as they were") {
    for (const std::string name : {"u", "u,x", "a\\b", "a\\,b", ",", "end\\"}) {
        CAPTURE(name);
        Family family = sample_family();
        for (Key& key : family.keys) {
            Hierarchy changed = *key.hierarchy;
            const Buffer<float> values(changed.positions.size(), 1);
            changed.fields = {{name, FieldKind::scalar, values}, {"w", FieldKind::scalar, values}};
            key.hierarchy = std::move(changed);
        }
        const Session session(std::make_shared<const Family>(std::move(family)));
        Display display;
        CHECK(field_options(session, display).empty());
        display.arrows = true;
        for (const std::array<std::string, 3>& parts :
             {std::array<std::string, 3>{name, "w", ""}, {"w", name, name}}) {
            display.arrow_parts = parts;
            const std::vector<std::string> options = field_options(session, display);
            REQUIRE(options.size() == 1);
            Display again;
            parse_arrows(std::string_view(options.front()).substr(std::string_view("--arrows=").size()),
                         again);
            CHECK(again.arrow_parts == parts);
        }
    }
}

TEST_CASE("a word of a shell needs quotes where the shell would read more than the word") {
    CHECK(command_word("/a/b-c_1.ilh") == "/a/b-c_1.ilh");
    CHECK(command_word("") == "''");
    CHECK(command_word("a b") == "'a b'");
    CHECK(command_word("$(x)`y`\"\\\n;#*?") == "'$(x)`y`\"\\\n;#*?'");
    CHECK(command_word("it's") == "'it'\\''s'");
    CHECK(command_word("\xe5\xae\xb6") == "'\xe5\xae\xb6'");
}
