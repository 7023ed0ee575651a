// Tests of the names of keys and families.
#include "family/names.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("a name is not empty and printable; the fault says whose name it is") {
    for (const char* name : {"a", "two words", "Schlüssel 鍵", "\"", "a/b"})
        CHECK(fault_of_name(name, "a key") == "");
    CHECK(fault_of_name("", "a key") == "a key needs a name");
    for (const char* name : {"\n", "a\x1b[2J", "\x7f", "\u0080", "\u009f", "\xff"})
        CHECK(fault_of_name(name, "key 3") == "the name of key 3 is not UTF-8 without control characters");
}

TEST_CASE("an unused name has no fault and is not taken") {
    const auto none = [](const std::string&) { return false; };
    CHECK(unused_name("a", none) == "a");
    CHECK(unused_name("", none) == "key");
    CHECK(unused_name("a\u009b", none) == "a\\xc2\\x9b");
    CHECK(unused_name("a", [](const std::string& name) { return name == "a" || name == "a 2"; }) == "a 3");
}
