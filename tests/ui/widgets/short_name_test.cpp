// Tests of long names: they are cut in the middle, between characters, and no more than they must.
#include "ui/widgets/short_name.h"

#include <doctest/doctest.h>

#include "text/characters.h"
#include "ui/headless_gui.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

struct Frame {
    HeadlessGui gui{{400, 300}};
    Frame() {
        gui.begin_frame({0, 0}, false);
        ImGui::Begin("window");
    }
    ~Frame() {
        ImGui::End();
        gui.end_frame();
    }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
};

}  // namespace

TEST_CASE("a name that fits stays whole") {
    const Frame frame;
    CHECK(shortened("bunny", 400) == "bunny");
    CHECK(shortened("bunny", text_size("bunny").x) == "bunny");
    CHECK(shortened("", 0).empty());
}

TEST_CASE("a long name keeps its begin and its end") {
    const Frame frame;
    const std::string name = "a long name of a surface at step 0127";
    const std::string cut = shortened(name, 120);
    CHECK(text_size(cut).x <= 120);
    CHECK(text_size(cut).x > 100);
    CHECK(cut.starts_with("a l"));
    CHECK(cut.ends_with("127"));
    CHECK(cut.find("…") != std::string::npos);
}

TEST_CASE("no character of a name is cut into bytes, however little room there is") {
    const Frame frame;
    for (const std::string& name :
         {std::string("ääääääääääääääääääää"), std::string("名前が長い曲面の名前が長い曲面の名前")})
        for (float width = 0; width < 200; width += 7) CHECK(is_utf8(shortened(name, width)));
}

TEST_CASE("a long name returns quickly") {
    const Frame frame;
    CHECK(text_size(shortened(std::string(100'000, 'x'), 90)).x <= 90);
}
