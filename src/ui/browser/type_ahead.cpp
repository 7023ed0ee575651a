#include "ui/browser/type_ahead.h"

#include "text/characters.h"

namespace interleaf {

namespace {

/// The first place, from \p from on, of a name that begins with \p beginning. Wraps around at the end of the
/// list.
std::optional<std::size_t> find(std::string_view beginning, std::span<const FolderEntry> entries,
                                std::span<const std::size_t> shown, std::size_t from) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const std::size_t place = (from + i) % shown.size();
        if (entries[shown[place]].order.folded.starts_with(beginning)) return place;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::size_t> TypeAhead::type(std::string_view letters, double now,
                                           std::span<const FolderEntry> entries,
                                           std::span<const std::size_t> shown, std::size_t cursor) {
    const std::string latest = folded(letters);
    const bool begins = !is_typing(now);
    if (begins) typed_.clear();
    const bool repeats = !begins && typed_ == latest;
    if (!repeats) typed_ += latest;
    last_ = now;
    if (repeats) {
        // The user may mean a name that begins with "oo".
        if (const auto place = find(typed_ + latest, entries, shown, cursor)) {
            typed_ += latest;
            return place;
        }
    }
    return find(typed_, entries, shown, begins || repeats ? cursor + 1 : cursor);
}

}  // namespace interleaf
