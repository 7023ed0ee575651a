// Tests of names of files: escaping, folding, and the order people expect.
#include "ui/widgets/file_name.h"

#include <algorithm>
#include <random>
#include <vector>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

bool before(std::string_view a, std::string_view b) {
    return is_naturally_before(folded(a), folded(b));
}

}  // namespace

TEST_CASE("names of people's languages are shown as they are") {
    for (const char* name : {"sphere.ilh", "Fünf Schlüssel", "κλειδί", "ключ", "鍵", "🔑", "a\\b", ""})
        CHECK(shown_name(name) == name);
}

TEST_CASE("what is not UTF-8, or would not be seen, is shown escaped") {
    CHECK(shown_name("a\xff\xfe.ilh") == "a\\xff\\xfe.ilh");
    CHECK(shown_name("a\nb\x1b[0m\x7f") == "a\\x0ab\\x1b[0m\\x7f");
    CHECK(shown_name("cut \xc3") == "cut \\xc3");
    CHECK(shown_name("cut \xe9\x8d") == "cut \\xe9\\x8d");
    CHECK(shown_name("overlong \xc0\xaf \xe0\x80\xaf") == "overlong \\xc0\\xaf \\xe0\\x80\\xaf");
    CHECK(shown_name("surrogate \xed\xa0\x80") == "surrogate \\xed\\xa0\\x80");
    CHECK(shown_name("beyond \xf4\x90\x80\x80") == "beyond \\xf4\\x90\\x80\\x80");
    CHECK(shown_name("\u202egpj.exe") == "\\u{202e}gpj.exe");
    CHECK(shown_name("a\u200bb\u0085") == "a\\u{200b}b\\xc2\\x85");
}

TEST_CASE("only what a text field gives back unchanged is editable") {
    for (const char* name : {"a b", "ä", "鍵"}) CHECK(is_editable(name));
    for (const char* name : {"a\nb", "\xff", "🔑"}) CHECK_FALSE(is_editable(name));
}

TEST_CASE("folding ignores case in every script, and keeps what is not UTF-8") {
    CHECK(folded("Flow.ILH") == "flow.ilh");
    CHECK(folded("ÄΩЖ") == "äωж");
    CHECK(folded("A\xff"
                 "B鍵🔑") ==
          "a\xff"
          "b鍵🔑");
}

TEST_CASE("numbers count by their value") {
    CHECK(before("flow.2", "flow.10"));
    CHECK(before("flow.2.ilh", "flow.10.ilh"));
    CHECK(before("flow.9", "FLOW.10"));
    CHECK(before("a", "B"));
    CHECK(before("a", "a1"));
    CHECK(before("7", "07"));
    CHECK(before("07", "8"));
    CHECK(before("a99999999999999999999998", "a99999999999999999999999"));
    CHECK(before("1.9", "1.10"));
    CHECK(before("0", "00"));
    CHECK_FALSE(before("a", "a"));
}

TEST_CASE("the order is a total one") {
    const unsigned seed = 5;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::vector<std::string> names;
    for (int i = 0; i < 120; ++i) {
        std::string name;
        const auto size = random() % 5;
        for (std::size_t k = 0; k < size; ++k) name += "01 9a:/\xff"[random() % 8];
        names.push_back(name);
    }
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    for (const auto& a : names) {
        CHECK_FALSE(is_naturally_before(a, a));
        for (const auto& b : names) {
            if (a != b) CHECK(is_naturally_before(a, b) != is_naturally_before(b, a));
            if (!is_naturally_before(a, b)) continue;
            for (const auto& c : names)
                if (is_naturally_before(b, c)) REQUIRE(is_naturally_before(a, c));
        }
    }
}
