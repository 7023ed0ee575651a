// Dear ImGui's clipper of long lists. It ends even if an exception leaves the list half shown.
#pragma once

#include <cstddef>

#include <imgui.h>

namespace interleaf {

class RowClipper : public ImGuiListClipper {
  public:
    RowClipper(std::size_t rows, float height) { Begin(static_cast<int>(rows), height); }
    ~RowClipper() { End(); }
    RowClipper(const RowClipper&) = delete;
    RowClipper& operator=(const RowClipper&) = delete;
};

}  // namespace interleaf
