// The X display as a user has it: a pointer, a keyboard, and pictures of what a window shows.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <sys/types.h>

// Xlib's header defines macros such as None and Bool, so only desktop.cpp includes it.
struct _XDisplay;  // NOLINT(bugprone-reserved-identifier)

namespace interleaf {

/// Xlib's Window (0 for none) and KeySym.
using WindowName = unsigned long;
using KeyName = unsigned long;

/// A part of a window: x, y, width, height in pixels.
struct Area {
    int x;
    int y;
    int width;
    int height;
};

/// One value per pixel, row by row.
using Picture = std::vector<std::uint32_t>;

class Desktop {
  public:
    /// \throw std::runtime_error if there is no display
    Desktop();

    /// Pixels.
    glm::ivec2 screen_size() const;

    /// The window of \p process; 0 while it has none.
    WindowName window_of(pid_t process) const;

    void move_pointer(WindowName window, glm::vec2 at) const;

    /// \param button  1 left, 2 middle, 3 right, 4 wheel forward, 5 wheel back
    void set_button(unsigned button, bool down) const;
    void set_key(KeyName key, bool down) const;

    /// Types \p text, which is ASCII, with the layout of the current keyboard.
    void type(const std::string& text) const;

    void resize(WindowName window, glm::ivec2 size) const;

    /// The title that a window manager shows above \p window, in UTF-8.
    std::string title(WindowName window) const;

    Picture picture(WindowName window, const Area& area) const;

  private:
    struct CloseDisplay {
        void operator()(_XDisplay* display) const;
    };
    std::unique_ptr<_XDisplay, CloseDisplay> display_;
};

}  // namespace interleaf
