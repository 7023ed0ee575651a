// Tests of the characters of the typeface.
#include "ui/widgets/glyphs.h"

#include <string>

#include <doctest/doctest.h>
#include <imgui.h>

#include "text/characters.h"
#include "ui/headless_gui.h"
#include "ui/widgets/gui_state.h"

using namespace interleaf;

namespace {

bool has_glyph(unsigned code) {
    const auto character = static_cast<ImWchar>(code);
    return ImGui::GetIO().Fonts->Fonts[0]->FindGlyphNoFallback(character) != nullptr &&
           ImGui::GetIO().Fonts->Fonts[1]->FindGlyphNoFallback(character) != nullptr;
}

}  // namespace

TEST_CASE("characters of other scripts are in the typeface after a text has needed them") {
    const HeadlessGui gui({100, 100});
    need_glyphs("Œuvre – Ελληνικά, Кириллица…");
    CHECK_FALSE(gui_state()->lacks_glyphs);
    CHECK_FALSE(has_glyph(0x66f2));
    need_glyphs("曲面 ひらがな 한국어 עברית العربية");
    REQUIRE(gui_state()->lacks_glyphs);
    make_fonts(1, 1);
    CHECK_FALSE(gui_state()->lacks_glyphs);
    for (const unsigned code : {0x66f2U, 0x9762U, 0x3072U, 0xd55cU, 0x5e2U, 0x639U}) {
        CAPTURE(code);
        CHECK(has_glyph(code));
    }
    need_glyphs("曲面");
    CHECK_FALSE(gui_state()->lacks_glyphs);
}

TEST_CASE("no text harms the typeface") {
    const HeadlessGui gui({100, 100});
    need_glyphs("\xff\xfe\xed\xa0\x80 \xf0\x9f\x98\x80 \xc2");
    CHECK(gui_state()->glyphs.empty());
    std::string all;
    for (char32_t code = 0x80; code < 0xd800; ++code) append_character(all, code);
    need_glyphs(all);
    CHECK(gui_state()->glyphs.size() <= 2000);
    make_fonts(1, 1);
    CHECK_FALSE(gui_state()->lacks_glyphs);
}
