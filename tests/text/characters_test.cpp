// Tests of characters: what is UTF-8, what is a control character, and lower case.
#include "text/characters.h"

#include "not_utf8.h"
#include <doctest/doctest.h>

namespace interleaf {

TEST_CASE("every character is read as it was appended, but for surrogates") {
    for (char32_t code = 0; code <= 0x10ffff; code += code < 0x3000 ? 1 : 89) {
        CAPTURE(static_cast<unsigned>(code));
        std::string text;
        append_character(text, code);
        const std::size_t size = text.size();
        text += "more";
        const auto character = first_character(text);
        REQUIRE(character.has_value() == (code < 0xd800 || code >= 0xe000));
        if (!character) continue;
        REQUIRE(character->code == code);
        REQUIRE(character->size == size);
        for (std::size_t i = 0; i < size; ++i) REQUIRE(continues_character(text[i]) == (i > 0));
        for (std::size_t cut = 1; cut < size; ++cut) REQUIRE_FALSE(first_character(text.substr(0, cut)));
    }
}

TEST_CASE("what is no character of UTF-8 is refused, wherever it stands") {
    for (const std::string& text : not_utf8) {
        CAPTURE(text);
        CHECK_FALSE(first_character(text));
        for (const std::string& before : {std::string(), std::string("ä鍵🔑")}) {
            CHECK_FALSE(is_utf8(before + text));
            CHECK_FALSE(is_printable(before + text));
        }
    }
}

TEST_CASE("UTF-8 without control characters is printable, also the characters next to the controls") {
    for (const std::string text : {"", "T", "a b", "Höhe über NN", "三", "🔑", "\xc2\xa0", "~", "\u2028"}) {
        CAPTURE(text);
        CHECK(is_utf8(text));
        CHECK(is_printable(text));
    }
}

TEST_CASE("every control character makes a text unprintable, those of terminals beyond ASCII too") {
    for (char32_t code = 0; code < 0x100; ++code) {
        const bool is_one = code < 0x20 || code == 0x7f || (code >= 0x80 && code <= 0x9f);
        CAPTURE(static_cast<unsigned>(code));
        CHECK(is_control(code) == is_one);
        std::string text = "a";
        append_character(text, code);
        CHECK(is_utf8(text));
        CHECK(is_printable(text) != is_one);
        CHECK(is_printable(text + "b") != is_one);
    }
}

TEST_CASE("blanks around a text go, blanks in it stay") {
    CHECK(without_blanks(" \t12 \r\n") == "12");
    CHECK(without_blanks("a b\n\nc ") == "a b\n\nc");
    CHECK(without_blanks("a") == "a");
    for (const std::string_view blank : {"", " ", "\r\n\t "}) CHECK(without_blanks(blank).empty());
}

TEST_CASE("folding ignores case in every script, and keeps what is not UTF-8") {
    CHECK(folded("Flow.ILH") == "flow.ilh");
    CHECK(folded("ÄΩЖ") == "äωж");
    CHECK(folded("A\xff"
                 "B鍵🔑") ==
          "a\xff"
          "b鍵🔑");
}

}  // namespace interleaf
