// Finds a name in a list by its first letters.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/browser/folder_listing.h"

namespace interleaf {

/// Letters typed in quick succession form one beginning. The same letter typed repeatedly goes through the
/// names that begin with it.
class TypeAhead {
  public:
    /// \param letters  the letters typed at time \p now, in UTF-8
    /// \param now  seconds of any clock
    /// \param shown  the list, as indices into \p entries
    /// \param cursor  the place in \p shown to start from
    /// \return the place in \p shown to go to, where the beginning follows the end; none if no name matches
    std::optional<std::size_t> type(std::string_view letters, double now,
                                    std::span<const FolderEntry> entries, std::span<const std::size_t> shown,
                                    std::size_t cursor);

    /// Whether a letter typed at time \p now would continue the beginning.
    bool is_typing(double now) const { return !typed_.empty() && now - last_ < patience; }

  private:
    static constexpr double patience = 1;  ///< seconds

    std::string typed_;  ///< folded
    double last_ = 0;
};

}  // namespace interleaf
