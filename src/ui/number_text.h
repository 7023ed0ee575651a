// Numbers as people read them.
#pragma once

#include <cstddef>
#include <string>

namespace interleaf {

/// "34,612": thousands grouped.
std::string grouped(std::size_t number);

}  // namespace interleaf
