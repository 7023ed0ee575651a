// Tests of texts and names from outside, as they are shown.
#include "text/shown_text.h"

#include <doctest/doctest.h>

#include "text/characters.h"

namespace interleaf {

TEST_CASE("names of people's languages are shown as they are") {
    for (const char* name : {"sphere.ilh", "Fünf Schlüssel", "κλειδί", "ключ", "鍵", "🔑", "a\\b", ""}) {
        CHECK(shown_name(name) == name);
        CHECK(shown_text(name) == name);
    }
}

TEST_CASE("what is not UTF-8, and every control character, is shown escaped") {
    for (const auto& shown : {shown_name, shown_text}) {
        CHECK(shown("a\xff\xfe.ilh") == "a\\xff\\xfe.ilh");
        CHECK(shown("a\nb\x1b[0m\x7f") == "a\\x0ab\\x1b[0m\\x7f");
        CHECK(shown("cut \xc3") == "cut \\xc3");
        CHECK(shown("cut \xe9\x8d") == "cut \\xe9\\x8d");
        CHECK(shown("overlong \xc0\xaf \xe0\x80\xaf") == "overlong \\xc0\\xaf \\xe0\\x80\\xaf");
        CHECK(shown("surrogate \xed\xa0\x80") == "surrogate \\xed\\xa0\\x80");
        CHECK(shown("beyond \xf4\x90\x80\x80") == "beyond \\xf4\\x90\\x80\\x80");
        CHECK(shown("a\u0085") == "a\\xc2\\x85");
        CHECK(is_printable(shown("\xf4\x1b\u009b\xff\n")));
    }
}

TEST_CASE("the window escapes what would not be seen, a terminal shows it") {
    CHECK(shown_name("\u202egpj.exe") == "\\u{202e}gpj.exe");
    CHECK(shown_name("a\u200bb") == "a\\u{200b}b");
    CHECK(shown_text("a\u200bb") == "a\u200bb");
}

}  // namespace interleaf
