// Finds a name in a list from its first typed letters.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/browser/folder_listing.h"

namespace interleaf {

/// Letters typed soon after one another are one beginning; the same letter again and again goes from one name
/// with it to the next.
class TypeAhead {
  public:
    /// \param letters  what is typed at time \p now, seconds of any clock; UTF-8
    /// \param shown    the list, as indices of \p entries
    /// \param cursor   the place in it to start from
    /// \return the place in \p shown to go to, the end being followed by the beginning; none if no name
    /// begins so
    std::optional<std::size_t> type(std::string_view letters, double now,
                                    std::span<const FolderEntry> entries, std::span<const std::size_t> shown,
                                    std::size_t cursor);

    /// Whether a letter typed at time \p now would be added to others.
    bool is_typing(double now) const { return !typed_.empty() && now - last_ < patience; }

  private:
    static constexpr double patience = 1;  ///< seconds

    std::string typed_;  ///< folded
    double last_ = 0;
};

}  // namespace interleaf
