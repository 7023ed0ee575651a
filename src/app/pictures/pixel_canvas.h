// Draws shapes and text over a picture in memory: for legends and arrows in files, where there is no window.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace interleaf {

class PixelCanvas {
  public:
    /// \param rgba  8 bits per channel, sRGB-encoded, top row first; must outlive this object
    PixelCanvas(std::span<std::uint8_t> rgba, int width, int height)
        : rgba_(rgba), width_(width), height_(height) {}

    int width() const { return width_; }
    int height() const { return height_; }

    /// Colors are sRGB-encoded, with the opacity as fourth component, 0 to 1. Places are in pixels, y down.
    /// @{

    /// A rectangle between two corners with rounded corners of \p radius.
    void fill(glm::vec2 low, glm::vec2 high, float radius, const glm::vec4& color);

    /// A line with round ends.
    void line(glm::vec2 from, glm::vec2 to, float width, const glm::vec4& color);

    void triangle(glm::vec2 a, glm::vec2 b, glm::vec2 c, const glm::vec4& color);

    /// Text of the user interface's typeface.
    /// \param corner  upper left corner of the line
    /// \param size    height of a line
    void text(glm::vec2 corner, float size, std::string_view utf8, const glm::vec4& color);

    /// @}

    /// Width of text in pixels.
    static float text_width(float size, std::string_view utf8);

  private:
    template <typename Coverage>
    void cover(glm::vec2 low, glm::vec2 high, const glm::vec4& color, const Coverage& coverage);
    void blend(int x, int y, const glm::vec4& color, float coverage);

    std::span<std::uint8_t> rgba_;
    int width_;
    int height_;
};

}  // namespace interleaf
