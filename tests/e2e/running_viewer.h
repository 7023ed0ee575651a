// A running `interleaf view` with a user before it: does what the user does, and sees what the user sees. A
// wait of more than a minute fails the test, with a message that names the missing event. So does a wait after
// OpenGL has complained (KHR_debug).
#pragma once

#include <filesystem>
#include <functional>
#include <ios>
#include <span>
#include <string>
#include <vector>

#include "e2e/desktop.h"
#include <nlohmann/json.hpp>

namespace interleaf {

/// Whether the program can change only the files in its user's home.
enum class Confined { no, yes };

class RunningViewer {
  public:
    /// Starts the program, and waits for its first frame.
    /// \param home  home of the program's user, with settings and recoveries; if empty, a temporary folder of
    ///     this object
    /// \param files  files to open; empty for the built-in family
    explicit RunningViewer(std::filesystem::path home = {},
                           const std::vector<std::filesystem::path>& files = {},
                           Confined confined = Confined::no);
    ~RunningViewer();
    RunningViewer(const RunningViewer&) = delete;
    RunningViewer& operator=(const RunningViewer&) = delete;

    using State = nlohmann::json;
    using Condition = std::function<bool(const State&)>;

    /// The last line of the trace.
    State state() const { return newest_state(); }

    /// All lines of the trace: the state of each frame that showed something new.
    std::vector<State> states() const;

    /// Waits until the state fulfills \p condition.
    /// \throw std::runtime_error if it does not within a minute, or if OpenGL has complained
    State wait_for(const std::string& what, const Condition& condition) const;

    /// The picture in the view, once it has stopped changing.
    Picture settled_picture() const;

    /// Waits until the view shows a picture other than \p before and has stopped changing.
    Picture changed_picture(const Picture& before) const;

    /// Waits until the view shows \p picture.
    /// \return false if it never does
    bool shows(const Picture& picture) const;

    /// Moves the pointer, and waits until the program has seen it there.
    void point_at(glm::vec2 at) const;

    /// Presses or releases a button, and waits until the program has seen it.
    void set_button(unsigned button, bool down) const;

    /// Presses the left button (or another) at \p from, moves in steps to \p to, and releases.
    void drag(glm::vec2 from, glm::vec2 to, unsigned button = 1) const;

    /// Presses and releases a button at \p at.
    void click(glm::vec2 at, unsigned button = 1) const;

    void turn_wheel(bool forward) const;

    /// Lets all that \p act does with mouse and keys reach the program in one frame, as if it were busy
    /// meanwhile.
    void while_it_is_busy(const std::function<void()>& act) const;

    /// Presses and releases \p key, with the modifiers, if any, held down.
    void press(KeyName key, KeyName modifier = 0, KeyName second_modifier = 0) const;

    /// Types \p text, which is ASCII, once there is a field for it.
    void type(const std::string& text) const;

    /// Types \p text where no field takes it: in a list, or in a question that has only buttons.
    void type_keys(const std::string& text) const { desktop_.type(text); }

    /// Drags files from another program and drops them at \p at.
    void drop(std::span<const std::filesystem::path> files, glm::vec2 at) const;

    const Desktop& desktop() const { return desktop_; }
    WindowName window() const { return window_; }

    /// Whether the program has ended by itself; exit_status() says how.
    bool has_ended() const;

    /// The title of the window.
    std::string title() const { return desktop_.title(window_); }

    /// Limits the program's memory to its current use and \p more bytes; 0 removes the limit.
    void limit_memory(std::size_t more) const;

    /// Ends the program as a crash would.
    void kill();

    /// Waits for the program to end.
    /// \return its exit status; if a signal has ended it, the negative number of the signal
    int exit_status();

  private:
    /// state(), parsed anew only if the trace has grown.
    const State& newest_state() const;

    Area view_area() const;

    Desktop desktop_;
    std::filesystem::path home_;
    bool owns_home_;
    std::filesystem::path trace_;
    pid_t process_ = 0;  ///< 0 if the program has ended
    WindowName window_ = 0;
    mutable State newest_state_;
    mutable std::streamoff read_size_ = 0;  ///< bytes of the trace when newest_state_ was read
};

}  // namespace interleaf
