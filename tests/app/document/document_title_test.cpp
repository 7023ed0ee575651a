// Tests of what a document is called in the window's title.
#include "app/document/document_title.h"

#include <doctest/doctest.h>

#include "app/sample_family.h"

using namespace interleaf;

TEST_CASE("the title names the family, and its folder where that is called otherwise") {
    CHECK(title_of(Document(named("Five keys"))) == "Five keys");
    CHECK(title_of(Document(named("Five keys"), "/a/five-keys")) == "Five keys");
    CHECK(title_of(Document(named("Five keys"), "/a/copy")) == "Five keys (copy)");

    Document document(named("Five keys"));
    document.edit("Rename", named("Six keys"));
    CHECK(title_of(document) == "\u2022 Six keys");
    document.mark_saved(document.snapshot(), "/b/mine");
    CHECK(title_of(document) == "Six keys (mine)");
}
