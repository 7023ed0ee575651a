#include "e2e/running_viewer.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interleaf {

namespace {

/// Tries \p attempt every few milliseconds until it holds; false after a minute.
bool comes(const std::function<bool()>& attempt) {
    using std::chrono::steady_clock;
    const auto deadline = steady_clock::now() + std::chrono::minutes(1);
    while (!attempt()) {
        if (steady_clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

/// Where the program under test keeps what it keeps of its user.
std::filesystem::path user_folder(const std::filesystem::path& trace) {
    return trace.string() + "-user";
}

pid_t start(const std::filesystem::path& trace, const std::filesystem::path& family) {
    const pid_t process = fork();
    if (process == 0) {
        // Settings and recoveries of the person who runs the tests are none of theirs.
        setenv("XDG_CONFIG_HOME", user_folder(trace).c_str(), 1);
        setenv("XDG_STATE_HOME", user_folder(trace).c_str(), 1);
        const char* const argument = family.empty() ? nullptr : family.c_str();
        execl(INTERLEAF_PROGRAM, INTERLEAF_PROGRAM, "view", "--trace", trace.c_str(), argument, nullptr);
        _exit(127);
    }
    return process;
}

glm::vec2 vector_of(const nlohmann::json& json) {
    return {json[0].get<float>(), json[1].get<float>()};
}

}  // namespace

RunningViewer::RunningViewer(const std::filesystem::path& family)
    : trace_(std::filesystem::temp_directory_path() / fmt::format("interleaf-e2e-{}.trace", getpid())) {
    std::filesystem::remove(trace_);
    std::filesystem::remove_all(user_folder(trace_));
    process_ = start(trace_, family);
    if (!comes([&] { return (window_ = desktop_.window_of(process_)) != 0; })) {
        throw std::runtime_error("no window has come");
    }
    wait_for("a first frame", [](const State&) { return true; });
}

RunningViewer::~RunningViewer() {
    if (process_ != 0) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    std::filesystem::remove(trace_);
    std::filesystem::remove_all(user_folder(trace_));
}

RunningViewer::State RunningViewer::state() const {
    std::ifstream file(trace_);
    std::string line;
    State last;
    // The line that is being written has no end yet.
    while (std::getline(file, line) && !file.eof()) {
        last = State::parse(line);
    }
    return last;
}

RunningViewer::State RunningViewer::wait_for(const std::string& what, const Condition& condition) const {
    State last;
    if (!comes([&] { return !(last = state()).is_null() && condition(last); })) {
        throw std::runtime_error(fmt::format("this has not come: {}; the state is {}", what, last.dump()));
    }
    return last;
}

Area RunningViewer::view_area() const {
    const State rect = state()["rects"]["view"];
    return {rect[0].get<int>(), rect[1].get<int>(), rect[2].get<int>(), rect[3].get<int>()};
}

Picture RunningViewer::settled_picture() const {
    Picture last = desktop_.picture(window_, view_area());
    const bool settled = comes([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(150));
        return last == std::exchange(last, desktop_.picture(window_, view_area()));
    });
    if (!settled) throw std::runtime_error("the picture does not stop changing");
    return last;
}

Picture RunningViewer::changed_picture(const Picture& before) const {
    if (!comes([&] { return desktop_.picture(window_, view_area()) != before; })) {
        throw std::runtime_error("the picture has not changed");
    }
    return settled_picture();
}

bool RunningViewer::shows(const Picture& picture) const {
    return comes([&] { return desktop_.picture(window_, view_area()) == picture; });
}

void RunningViewer::point_at(glm::vec2 at) const {
    desktop_.move_pointer(window_, at);
    wait_for("the pointer", [at](const State& s) { return glm::distance(vector_of(s["pointer"]), at) < 1; });
}

void RunningViewer::set_button(unsigned button, bool down) const {
    desktop_.set_button(button, down);
    wait_for("the button", [down](const State& s) { return s["button_down"] == down; });
}

void RunningViewer::drag(glm::vec2 from, glm::vec2 to, unsigned button) const {
    constexpr int steps = 4;
    point_at(from);
    set_button(button, true);
    for (int i = 1; i <= steps; ++i)
        point_at(from + (to - from) * static_cast<float>(i) / static_cast<float>(steps));
    set_button(button, false);
}

void RunningViewer::turn_wheel(bool forward) const {
    const unsigned button = forward ? 4 : 5;
    desktop_.set_button(button, true);
    desktop_.set_button(button, false);
}

void RunningViewer::press(KeyName key, KeyName modifier) const {
    if (modifier != 0) desktop_.set_key(modifier, true);
    desktop_.set_key(key, true);
    desktop_.set_key(key, false);
    if (modifier != 0) desktop_.set_key(modifier, false);
}

int RunningViewer::exit_status() {
    int status = 0;
    if (!comes([&] { return waitpid(process_, &status, WNOHANG) == process_; })) {
        throw std::runtime_error("the program has not ended");
    }
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace interleaf
