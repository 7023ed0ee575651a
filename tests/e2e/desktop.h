// The X display as a person has it: a pointer, a keyboard, and pictures of what a window shows.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <sys/types.h>

// Xlib's header takes names such as None and Bool for macros, so it stays in desktop.cpp.
struct _XDisplay;  // NOLINT(bugprone-reserved-identifier)

namespace interleaf {

/// Xlib's Window, 0 for none, and KeySym.
using WindowName = unsigned long;
using KeyName = unsigned long;

/// A part of a window: x, y, width, height in pixels.
struct Area {
    int x;
    int y;
    int width;
    int height;
};

/// One value a pixel, row after row.
using Picture = std::vector<std::uint32_t>;

class Desktop {
  public:
    /// \throw std::runtime_error when there is no display
    Desktop();

    /// The window of the process \p process; 0 while it has none.
    WindowName window_of(pid_t process) const;

    void move_pointer(WindowName window, glm::vec2 at) const;

    /// \param button  1 left, 2 middle, 3 right, 4 wheel forward, 5 wheel back
    void set_button(unsigned button, bool down) const;
    void set_key(KeyName key, bool down) const;

    /// Types \p text, of ASCII, as the keyboard in use has its letters.
    void type(const std::string& text) const;

    void resize(WindowName window, glm::ivec2 size) const;

    /// What a window manager shows above \p window; UTF-8.
    std::string title(WindowName window) const;

    Picture picture(WindowName window, const Area& area) const;

  private:
    struct CloseDisplay {
        void operator()(_XDisplay* display) const;
    };
    std::unique_ptr<_XDisplay, CloseDisplay> display_;
};

}  // namespace interleaf
