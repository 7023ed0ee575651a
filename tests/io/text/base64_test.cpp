#include "io/text/base64.h"

#include <random>
#include <string>
#include <utility>

#include <doctest/doctest.h>

namespace interleaf {

TEST_CASE("base64 is that of RFC 4648") {
    for (const auto& [bytes, text] : {std::pair{"", ""},
                                      {"f", "Zg=="},
                                      {"fo", "Zm8="},
                                      {"foo", "Zm9v"},
                                      {"foob", "Zm9vYg=="},
                                      {"fooba", "Zm9vYmE="},
                                      {"foobar", "Zm9vYmFy"}}) {
        CHECK(to_base64(bytes) == text);
        CHECK(from_base64(text) == bytes);
    }
    CHECK(from_base64("Zg") == "f");
    CHECK_FALSE(from_base64("Z*=="));
    CHECK_FALSE(from_base64("Zg ="));
}

TEST_CASE("any bytes come back from base64") {
    std::mt19937 random(7);
    for (int trial = 0; trial < 100; ++trial) {
        std::string bytes(random() % 50, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random() & 0xff);
        CHECK(from_base64(to_base64(bytes)) == bytes);
    }
}

}  // namespace interleaf
