// Tests of the texts that a text field can hold.
#include "ui/widgets/text_field.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("a text is editable only if a text field returns it unchanged") {
    for (const char* name : {"", "a b", "ä", "鍵"}) CHECK(is_editable(name));
    for (const char* name : {"a\nb", "\xff", "\u009b", "🔑"}) CHECK_FALSE(is_editable(name));
}
