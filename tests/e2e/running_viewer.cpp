#include "e2e/running_viewer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "e2e/confinement.h"
#include "e2e/file_drag.h"
#include "sanitized.h"
#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interleaf {

namespace {

/// Tries \p attempt every few milliseconds until it succeeds.
/// \return false after a minute; under the sanitizers, after four
bool comes(const std::function<bool()>& attempt) {
    using std::chrono::steady_clock;
    const auto deadline = steady_clock::now() + std::chrono::minutes(is_sanitized ? 4 : 1);
    while (!attempt()) {
        if (steady_clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

pid_t start(const std::filesystem::path& trace, const std::filesystem::path& home,
            const std::vector<std::filesystem::path>& files, Confined confined) {
    std::vector<std::string> arguments{INTERLEAF_PROGRAM, "view", "--trace", trace.string()};
    for (const std::filesystem::path& file : files) arguments.push_back(file.string());
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    std::filesystem::create_directories(home);
    const pid_t process = fork();
    if (process == 0) {
        // The file browser saves into this folder at first.
        if (chdir(home.c_str()) != 0) _exit(127);
        const std::array<std::filesystem::path, 2> written{trace, "/dev/null"};
        if (confined == Confined::yes && !confine_writes(std::span(&home, 1), written)) _exit(126);
        // Mesa keeps compiled shaders where it always does, so that not every viewer compiles them.
        if (const char* usual_home = std::getenv("HOME"))
            setenv("XDG_CACHE_HOME", fmt::format("{}/.cache", usual_home).c_str(), 0);
        // The tests must not touch the settings and recoveries of the person who runs them.
        for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
            setenv(variable, home.c_str(), 1);
        execv(INTERLEAF_PROGRAM, pointers.data());
        _exit(127);
    }
    return process;
}

/// The last line of the first \p size bytes that has an end; empty if there is none. A line without an end is still
/// being written.
std::string last_line(std::istream& file, std::streamoff size) {
    for (std::streamoff length = 1 << 14;; length *= 4) {
        const std::streamoff begin = std::max<std::streamoff>(size - length, 0);
        std::string text(static_cast<std::size_t>(size - begin), '\0');
        file.seekg(begin);
        file.read(text.data(), size - begin);
        text.resize(text.rfind('\n') + 1);  // to nothing if no line ends
        if (!text.empty()) text.pop_back();
        const std::size_t before = text.rfind('\n');
        if (before != std::string::npos) return text.substr(before + 1);
        if (begin == 0) return text;
    }
}

glm::vec2 vector_of(const nlohmann::json& json) {
    return {json[0].get<float>(), json[1].get<float>()};
}

}  // namespace

RunningViewer::RunningViewer(std::filesystem::path home, const std::vector<std::filesystem::path>& files,
                             Confined confined)
    : home_(std::move(home)),
      owns_home_(home_.empty()),
      trace_(std::filesystem::temp_directory_path() / fmt::format("interleaf-e2e-{}.trace", getpid())) {
    if (owns_home_) {
        home_ = trace_.string() + "-home";
        std::filesystem::remove_all(home_);
    }
    std::ofstream(trace_).close();
    process_ = start(trace_, home_, files, confined);
    if (!comes([&] { return (window_ = desktop_.window_of(process_)) != 0; })) {
        throw std::runtime_error("no window has appeared");
    }
    wait_for("a first frame", [](const State&) { return true; });
}

RunningViewer::~RunningViewer() {
    kill();
    std::filesystem::remove(trace_);
    if (owns_home_) std::filesystem::remove_all(home_);
}

bool RunningViewer::has_ended() const {
    siginfo_t info{};
    return process_ == 0 ||
           (waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            info.si_pid == process_);
}

void RunningViewer::limit_memory(std::size_t more) const {
    rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
    if (more > 0) {
        std::size_t pages = 0;
        std::ifstream(fmt::format("/proc/{}/statm", process_)) >> pages;
        limit.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more;
    }
    if (prlimit(process_, RLIMIT_AS, &limit, nullptr) != 0)
        throw std::runtime_error("cannot limit the memory");
}

void RunningViewer::kill() {
    if (process_ == 0) return;
    ::kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = 0;
}

const RunningViewer::State& RunningViewer::newest_state() const {
    std::ifstream file(trace_, std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    if (size <= read_size_) return newest_state_;
    if (const std::string line = last_line(file, size); !line.empty()) newest_state_ = State::parse(line);
    read_size_ = size;
    return newest_state_;
}

std::vector<RunningViewer::State> RunningViewer::states() const {
    std::vector<State> states;
    std::ifstream file(trace_);
    // A line without an end is still being written.
    for (std::string line; std::getline(file, line) && !file.eof();) states.push_back(State::parse(line));
    return states;
}

RunningViewer::State RunningViewer::wait_for(const std::string& what, const Condition& condition) const {
    const bool came = comes([&] {
        const State& newest = newest_state();
        return !newest.is_null() && condition(newest);
    });
    if (!came) {
        throw std::runtime_error(
            fmt::format("timed out waiting for: {}; the state is {}", what, newest_state_.dump()));
    }
    if (!newest_state_["opengl_messages"].empty())
        throw std::runtime_error(fmt::format("OpenGL says: {}", newest_state_["opengl_messages"].dump()));
    return newest_state_;
}

Area RunningViewer::view_area() const {
    const State& rect = newest_state()["rects"]["view"];
    return {rect[0].get<int>(), rect[1].get<int>(), rect[2].get<int>(), rect[3].get<int>()};
}

Picture RunningViewer::settled_picture() const {
    Picture last = desktop_.picture(window_, view_area());
    const bool settled = comes([&] {
        // On a busy machine the frames until the last one may take long. Asked after the second picture, the state could
        // already be that of a third one.
        const bool rested = newest_state()["rests"].get<bool>();
        std::this_thread::sleep_for(std::chrono::milliseconds(150));
        const bool is_same = last == std::exchange(last, desktop_.picture(window_, view_area()));
        return is_same && rested;
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

void RunningViewer::click(glm::vec2 at, unsigned button) const {
    point_at(at);
    set_button(button, true);
    set_button(button, false);
}

void RunningViewer::turn_wheel(bool forward) const {
    const unsigned button = forward ? 4 : 5;
    desktop_.set_button(button, true);
    desktop_.set_button(button, false);
}

void RunningViewer::press(KeyName key, KeyName modifier, KeyName second_modifier) const {
    if (modifier != 0) desktop_.set_key(modifier, true);
    if (second_modifier != 0) desktop_.set_key(second_modifier, true);
    desktop_.set_key(key, true);
    desktop_.set_key(key, false);
    if (second_modifier != 0) desktop_.set_key(second_modifier, false);
    if (modifier != 0) desktop_.set_key(modifier, false);
}

void RunningViewer::while_it_is_busy(const std::function<void()>& act) const {
    ::kill(process_, SIGSTOP);
    act();
    ::kill(process_, SIGCONT);
}

void RunningViewer::type(const std::string& text) const {
    wait_for("a field to type in", [](const State& s) { return s["takes_text"] == true; });
    desktop_.type(text);
}

void RunningViewer::drop(std::span<const std::filesystem::path> files, glm::vec2 at) const {
    desktop_.move_pointer(window_, at);
    drop_files(window_, glm::ivec2(glm::round(at)), files);
}

int RunningViewer::exit_status() {
    int status = 0;
    if (!comes([&] { return waitpid(process_, &status, WNOHANG) == process_; })) {
        throw std::runtime_error("the program has not ended");
    }
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace interleaf
