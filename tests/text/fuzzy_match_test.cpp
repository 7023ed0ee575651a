// Tests of the search by a few letters: what matches, and what ranks before what.
#include "text/fuzzy_match.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

/// The texts that match, the best first, equal ones in their order.
std::vector<std::string_view> found(std::string_view pattern, std::vector<std::string_view> texts) {
    std::erase_if(texts, [&](std::string_view text) { return !match_rank(pattern, text); });
    std::ranges::stable_sort(texts, {}, [&](std::string_view text) { return *match_rank(pattern, text); });
    return texts;
}

using Texts = std::vector<std::string_view>;

}  // namespace

TEST_CASE("the begin of a text ranks before the begin of a word, initials, a part, and scattered letters") {
    CHECK(found("sp", {"a wisp", "slow play", "stop it", "normal speed", "speed"}) ==
          Texts{"speed", "normal speed", "slow play", "a wisp", "stop it"});
}

TEST_CASE("every word of the pattern must match, in any order and any case") {
    CHECK(found("KEY next", {"Go to next key", "Go to key", "Next"}) == Texts{"Go to next key"});
    CHECK(found("edges  ref ", {"Refinement edges", "Root edges"}) == Texts{"Refinement edges"});
    CHECK_FALSE(match_rank("xyz", "Refinement edges"));
}

TEST_CASE("letters that lie closer together rank better") {
    CHECK(found("ply", {"possibly", "p l y", "apply", "playback"}).front() == "p l y");
    CHECK(*match_rank("abd", "xabcd") < *match_rank("abd", "xabcccccd"));
}

TEST_CASE("an empty pattern matches every text equally, also an empty one") {
    CHECK(match_rank("", "text") == 0u);
    CHECK(match_rank("  ", "") == 0u);
    CHECK_FALSE(match_rank("a", ""));
}

TEST_CASE("letters beyond ASCII are found in any case, and bytes that are not UTF-8 do no harm") {
    CHECK(match_rank("ÉT", "été") == 0u);
    CHECK(match_rank("\xff", "a\xff"));
    CHECK_FALSE(match_rank("\xff\xfe", "a"));
}

TEST_CASE("a text contains words only as they are, in any order and any case") {
    CHECK(contains_words("KEY next", "Go to next key"));
    CHECK(contains_words("", "anything"));
    CHECK_FALSE(contains_words("ball7", "ball17"));
    CHECK_FALSE(contains_words("next door", "Go to next key"));
}
