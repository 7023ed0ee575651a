// The program `interleaf view`, running, with a person before it: does what they do and sees what they see.
// Whatever is waited for comes within a minute, or the test fails saying what has not come.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "e2e/desktop.h"
#include <nlohmann/json.hpp>

namespace interleaf {

class RunningViewer {
  public:
    /// Starts it on \p family, the built-in one if that is empty, and waits for the first frame.
    explicit RunningViewer(const std::filesystem::path& family = {});
    ~RunningViewer();
    RunningViewer(const RunningViewer&) = delete;
    RunningViewer& operator=(const RunningViewer&) = delete;

    using State = nlohmann::json;
    using Condition = std::function<bool(const State&)>;

    /// The last line of the trace.
    State state() const;

    /// Waits until the state fulfils \p condition.
    State wait_for(const std::string& what, const Condition& condition) const;

    /// What the view shows, once it has stopped changing.
    Picture settled_picture() const;

    /// Waits until the view shows something other than \p before and has stopped changing.
    Picture changed_picture(const Picture& before) const;

    /// Waits until the view shows \p picture; false if it never does.
    bool shows(const Picture& picture) const;

    /// Moves the pointer, and waits until the program has seen it there.
    void point_at(glm::vec2 at) const;

    /// Presses or releases a button, and waits until the program has seen it.
    void set_button(unsigned button, bool down) const;

    /// Presses the left button (or another) at \p from, moves in steps to \p to, and releases.
    void drag(glm::vec2 from, glm::vec2 to, unsigned button = 1) const;

    void turn_wheel(bool forward) const;

    /// Presses and releases \p key, held down with \p modifier if any.
    void press(KeyName key, KeyName modifier = 0) const;

    /// Waits for the program to end.
    /// \return its exit status
    int exit_status();

  private:
    Area view_area() const;

    Desktop desktop_;
    std::filesystem::path trace_;
    pid_t process_ = 0;  ///< 0 when it has ended
    WindowName window_ = 0;
};

}  // namespace interleaf
