// Text from different editors and systems.
#include "io/text/plain_text.h"

#include <string>
#include <vector>

#include <doctest/doctest.h>

namespace interleaf {

namespace {

using namespace std::string_literals;

std::string plain(std::string text) {
    std::vector<std::string> remarks;
    return plain_text(std::move(text), remarks);
}

/// \p text in UTF-16; it has only characters below U+0100.
std::string utf16(std::string_view text, bool big_endian) {
    std::string result;
    for (const char c : text) result += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
    return result;
}

}  // namespace

TEST_CASE("plain text is unchanged") {
    std::vector<std::string> remarks;
    for (const std::string& text :
         {""s, "v"s, "v 0 0 0\n"s, "a\r\nb\r\n"s, "\xc3\xa4\n"s, "\0\0\0\0"s, "\xff"s})
        CHECK(plain_text(text, remarks) == text);
    CHECK(remarks.empty());
}

TEST_CASE("a byte order mark is removed, and line ends are converted") {
    CHECK(plain("\xef\xbb\xbfv 0 0 0\n") == "v 0 0 0\n");
    CHECK(plain("\xef\xbb\xbf") == "");
    CHECK(plain("a\rb\rc") == "a\nb\nc");
    CHECK(plain("a\r\rb\r") == "a\n\nb\n");
    CHECK(plain("a\r\r\nb\r\n") == "a\n\r\nb\r\n");
}

TEST_CASE("UTF-16 is converted, with or without a byte order mark, and a remark says so") {
    const std::string text = "v 0 0 0\r\n# \xe4\rf";
    const std::string expected = "v 0 0 0\r\n# \xc3\xa4\nf";
    for (const bool big_endian : {false, true})
        for (const bool has_mark : {false, true}) {
            CAPTURE(big_endian);
            CAPTURE(has_mark);
            std::vector<std::string> remarks;
            const std::string mark = big_endian ? "\xfe\xff" : "\xff\xfe";
            CHECK(plain_text((has_mark ? mark : "") + utf16(text, big_endian), remarks) == expected);
            CHECK(remarks == std::vector<std::string>{"The text was converted from UTF-16."});
        }
    CHECK(plain("\xff\xfe"
                "a\0\xac\x20"
                "b\0c"s) ==
          "a\xe2\x82\xac"
          "b");  // half a character at the end
}

TEST_CASE("control characters distinguish binary from text") {
    CHECK(looks_like_text(""));
    CHECK(looks_like_text("solid \xc3\xa4\t\r\n\v\f"));
    CHECK_FALSE(looks_like_text("solid \0"s));
    CHECK_FALSE(looks_like_text("\x1b[2J"));
    CHECK_FALSE(looks_like_text("\x7f"));
    CHECK(looks_like_text(std::string(1024, ' ').append(1, '\0')));
}

}  // namespace interleaf
