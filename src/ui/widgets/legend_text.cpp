#include "ui/widgets/legend_text.h"

#include <algorithm>

namespace interleaf {

std::string origin_name(KeySet origin, std::span<const std::string> names) {
    std::string name;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if ((origin & key_bit(i)) == 0) continue;
        if (!name.empty()) name += " + ";
        name += names[i];
    }
    return name;
}

std::vector<ShareMeaning> share_meanings(std::span<const KeySet> origins, std::size_t key_count) {
    std::vector<ShareMeaning> meanings = {
        {Share::all, "in all active keys",
         "The common complex: the leaves that are nodes in every active key."},
        {Share::some, "in some of them", "Several active keys bisect this far, but not all."},
        {Share::one, "in one of them", "A single active key bisects this far."},
    };
    std::erase_if(meanings, [&](const ShareMeaning& meaning) {
        return std::ranges::none_of(
            origins, [&](KeySet origin) { return share_of(origin, key_count) == meaning.share; });
    });
    return meanings;
}

}  // namespace interleaf
