// The program `interleaf view`, running, with a person before it: does what they do and sees what they see.
// Whatever is waited for comes within a minute, or the test fails saying what has not come.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "e2e/desktop.h"
#include <nlohmann/json.hpp>

namespace interleaf {

/// Whether the program can change no files but those in its user's home.
enum class Confined { no, yes };

class RunningViewer {
  public:
    /// Starts it and waits for the first frame.
    /// \param home   its user's home with settings and recoveries; if empty, one that goes with it
    /// \param files  to open; none for the built-in family
    explicit RunningViewer(std::filesystem::path home = {},
                           const std::vector<std::filesystem::path>& files = {},
                           Confined confined = Confined::no);
    ~RunningViewer();
    RunningViewer(const RunningViewer&) = delete;
    RunningViewer& operator=(const RunningViewer&) = delete;

    using State = nlohmann::json;
    using Condition = std::function<bool(const State&)>;

    /// The last line of the trace.
    State state() const;

    /// All lines of the trace: the state of each frame that showed something new.
    std::vector<State> states() const;

    /// Waits until the state fulfills \p condition.
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

    /// Presses and releases a button at \p at.
    void click(glm::vec2 at, unsigned button = 1) const;

    void turn_wheel(bool forward) const;

    /// All that \p act does with mouse and keys reaches the program in one frame, as if it were busy meanwhile.
    void while_it_is_busy(const std::function<void()>& act) const;

    /// Presses and releases \p key, held down with the modifiers if any.
    void press(KeyName key, KeyName modifier = 0, KeyName second_modifier = 0) const;

    /// Types \p text, of ASCII, once there is a field for it.
    void type(const std::string& text) const;

    /// Types \p text where no field takes it: in a list, or at a question with buttons only.
    void type_keys(const std::string& text) const { desktop_.type(text); }

    /// Drags files from another program and drops them at \p at.
    void drop(std::span<const std::filesystem::path> files, glm::vec2 at) const;

    const Desktop& desktop() const { return desktop_; }
    WindowName window() const { return window_; }

    /// Whether it has ended by itself; exit_status() says how.
    bool has_ended() const;

    /// Of the window.
    std::string title() const { return desktop_.title(window_); }

    /// Lets it take at most \p more bytes of memory beyond what it has; as many as there are for 0.
    void limit_memory(std::size_t more) const;

    /// Ends it as a crash would.
    void kill();

    /// Waits for the program to end.
    /// \return its exit status; the negative number of the signal that has ended it, if one has
    int exit_status();

  private:
    Area view_area() const;

    Desktop desktop_;
    std::filesystem::path home_;
    bool owns_home_;
    std::filesystem::path trace_;
    pid_t process_ = 0;  ///< 0 when it has ended
    WindowName window_ = 0;
};

}  // namespace interleaf
