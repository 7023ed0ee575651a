#include "e2e/random_person.h"

#include <array>
#include <chrono>
#include <thread>

#include <X11/keysym.h>
#include <fmt/core.h>

namespace interleaf {

using State = RunningViewer::State;

namespace {

constexpr std::array<KeyName, 62> keys{
    XK_a,     XK_b,      XK_c,         XK_d,     XK_e,       XK_f,         XK_g,      XK_h,      XK_i,
    XK_j,     XK_k,      XK_l,         XK_m,     XK_n,       XK_o,         XK_p,      XK_q,      XK_r,
    XK_s,     XK_t,      XK_u,         XK_v,     XK_w,       XK_x,         XK_y,      XK_z,      XK_0,
    XK_1,     XK_2,      XK_3,         XK_F1,    XK_F2,      XK_F5,        XK_F10,    XK_Up,     XK_Down,
    XK_Left,  XK_Right,  XK_Home,      XK_End,   XK_Page_Up, XK_Page_Down, XK_Return, XK_Escape, XK_Tab,
    XK_space, XK_Delete, XK_BackSpace, XK_minus, XK_period,  XK_comma,     XK_slash,  XK_equal,  XK_KP_Enter,
    XK_Up,    XK_Down,   XK_Left,      XK_Right, XK_Return,  XK_Tab,       XK_Delete, XK_Escape};

constexpr std::array<KeyName, 4> modifiers{XK_Control_L, XK_Shift_L, XK_Alt_L, XK_Super_L};

constexpr std::array<const char*, 14> texts{"a",  "blend", "3", "1e3",   "-5",  "0.25",        "nan",
                                            "~/", "../",   "/", "*.obj", "x y", "family.json", ""};

constexpr std::array<const char*, 5> parts{"view", "keys", "domain", "timeline", "popup"};

void wait(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

}  // namespace

struct RandomPerson::Deed {
    unsigned weight;
    std::string (RandomPerson::*act)(const RunningViewer& viewer);
};

const std::vector<RandomPerson::Deed>& RandomPerson::deeds() {
    static const std::vector<Deed> all{
        {16, &RandomPerson::move},          {18, &RandomPerson::click},
        {10, &RandomPerson::drag},          {4, &RandomPerson::drag_key},
        {4, &RandomPerson::hold_button},    {5, &RandomPerson::turn_wheel},
        {14, &RandomPerson::press_key},     {7, &RandomPerson::press_with_modifiers},
        {7, &RandomPerson::answer},         {4, &RandomPerson::type},
        {4, &RandomPerson::choose_in_menu}, {4, &RandomPerson::go_through_steps},
        {3, &RandomPerson::save},           {4, &RandomPerson::drop},
        {2, &RandomPerson::resize}};
    return all;
}

RandomPerson::RandomPerson(std::uint64_t seed, std::vector<std::filesystem::path> files)
    : random_(seed), files_(std::move(files)) {}

std::string RandomPerson::act(const RunningViewer& viewer) {
    unsigned sum = 0;
    for (const Deed& deed : deeds()) sum += deed.weight;
    auto left = static_cast<unsigned>(below(sum));
    for (const Deed& deed : deeds()) {
        if (left < deed.weight) {
            std::string done = (this->*deed.act)(viewer);
            wait(static_cast<int>(below(25)));
            return done;
        }
        left -= deed.weight;
    }
    return "";
}

void RandomPerson::let_go(const Desktop& desktop) {
    for (const unsigned button : {1U, 2U, 3U}) desktop.set_button(button, false);
    for (const KeyName key : modifiers) desktop.set_key(key, false);
}

std::size_t RandomPerson::below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
}

bool RandomPerson::happens(double chance) {
    return std::bernoulli_distribution(chance)(random_);
}

// ---- places ----

glm::vec2 RandomPerson::inside(const State& state, const char* part) {
    const State& rect = state["rects"][part];
    if (rect.is_null()) return anywhere(state);
    const auto within = [&](std::size_t side) {
        const float length = std::max(rect[side + 2].get<float>(), 1.0F);
        return rect[side].get<float>() + std::uniform_real_distribution<float>(-6, length + 6)(random_);
    };
    const float x = within(0);
    return {x, within(1)};
}

glm::vec2 RandomPerson::anywhere(const State& state) {
    const double chance = std::uniform_real_distribution<double>(0, 1)(random_);
    if (chance < 0.6) {
        const char* const part = parts.at(below(parts.size()));
        if (!state["rects"][part].is_null()) return inside(state, part);
    }
    if (chance < 0.66) return {below(280), 10};  // the menus
    return {below(state["window"][0].get<std::size_t>()), below(state["window"][1].get<std::size_t>())};
}

// ---- deeds ----

std::string RandomPerson::move(const RunningViewer& viewer) {
    const glm::vec2 to = anywhere(viewer.state());
    viewer.desktop().move_pointer(viewer.window(), to);
    return fmt::format("move to {:.0f},{:.0f}", to.x, to.y);
}

std::string RandomPerson::click(const RunningViewer& viewer) {
    const glm::vec2 at = anywhere(viewer.state());
    const unsigned button = happens(0.25) ? 3 : happens(0.05) ? 2 : 1;
    const int times = happens(0.2) ? 2 : 1;
    viewer.desktop().move_pointer(viewer.window(), at);
    wait(static_cast<int>(below(40)));
    for (int i = 0; i < times; ++i) {
        viewer.desktop().set_button(button, true);
        wait(25);
        viewer.desktop().set_button(button, false);
        wait(25);
    }
    return fmt::format("click {} {} times at {:.0f},{:.0f}", button, times, at.x, at.y);
}

std::string RandomPerson::drag(const RunningViewer& viewer) {
    const State state = viewer.state();
    const glm::vec2 from = anywhere(state);
    const glm::vec2 to = anywhere(state);
    const unsigned button = happens(0.2) ? 3 : 1;
    viewer.desktop().move_pointer(viewer.window(), from);
    wait(20);
    viewer.desktop().set_button(button, true);
    for (int i = 1; i <= 4; ++i) {
        wait(12);
        viewer.desktop().move_pointer(viewer.window(), from + (to - from) * (static_cast<float>(i) / 4));
        if (happens(0.05)) press_with_modifiers(viewer);
    }
    wait(12);
    viewer.desktop().set_button(button, false);
    return fmt::format("drag {} from {:.0f},{:.0f} to {:.0f},{:.0f}", button, from.x, from.y, to.x, to.y);
}

/// Drags a key from the list of keys to a place where keys can be dropped.
std::string RandomPerson::drag_key(const RunningViewer& viewer) {
    const State state = viewer.state();
    const glm::vec2 from = inside(state, "keys");
    const glm::vec2 to = inside(state, parts.at(1 + below(3)));
    viewer.desktop().move_pointer(viewer.window(), from);
    wait(20);
    viewer.desktop().set_button(1, true);
    for (int i = 1; i <= 4; ++i) {
        wait(15);
        viewer.desktop().move_pointer(viewer.window(), from + (to - from) * (static_cast<float>(i) / 4));
    }
    if (happens(0.2)) go_through_steps(viewer);
    if (happens(0.1)) drop(viewer);
    wait(20);
    viewer.desktop().set_button(1, false);
    return fmt::format("drag a key from {:.0f},{:.0f} to {:.0f},{:.0f}", from.x, from.y, to.x, to.y);
}

/// Holds a button while other acts follow.
std::string RandomPerson::hold_button(const RunningViewer& viewer) {
    const unsigned button = happens(0.8) ? 1 : 3;
    viewer.desktop().set_button(button, true);
    std::string done = fmt::format("hold {}", button);
    for (std::size_t i = below(4); i > 0; --i) {
        wait(25);
        done += ", " + (happens(0.5) ? type(viewer) : happens(0.5) ? move(viewer) : press_key(viewer));
    }
    wait(20);
    viewer.desktop().set_button(button, false);
    return done;
}

std::string RandomPerson::turn_wheel(const RunningViewer& viewer) {
    const bool forward = happens(0.5);
    for (std::size_t i = 1 + below(4); i > 0; --i) viewer.turn_wheel(forward);
    return "turn the wheel";
}

std::string RandomPerson::press_key(const RunningViewer& viewer) {
    const KeyName key = keys.at(below(keys.size()));
    viewer.press(key);
    return fmt::format("press {:#x}", key);
}

std::string RandomPerson::press_with_modifiers(const RunningViewer& viewer) {
    const KeyName key = keys.at(below(keys.size()));
    const KeyName first = happens(0.7) ? modifiers[0] : modifiers.at(below(modifiers.size()));
    const KeyName second = happens(0.3) ? modifiers[1] : 0;
    viewer.press(key, first, second);
    return fmt::format("press {:#x} with {:#x} and {:#x}", key, first, second);
}

std::string RandomPerson::answer(const RunningViewer& viewer) {
    const KeyName key = happens(0.6) ? XK_Return : XK_Escape;
    viewer.press(key);
    return key == XK_Return ? "Enter" : "Esc";
}

std::string RandomPerson::type(const RunningViewer& viewer) {
    const std::string text = texts.at(below(texts.size()));
    viewer.type_keys(text);
    return fmt::format("type \"{}\"", text);
}

std::string RandomPerson::choose_in_menu(const RunningViewer& viewer) {
    viewer.desktop().move_pointer(viewer.window(), {20 + below(250), 10});
    wait(20);
    viewer.desktop().set_button(1, true);
    wait(25);
    viewer.desktop().set_button(1, false);
    wait(60);
    const std::size_t downs = below(9);
    for (std::size_t i = 0; i < downs; ++i) {
        viewer.press(happens(0.1) ? XK_Right : XK_Down);
        wait(30);
    }
    viewer.press(happens(0.8) ? XK_Return : XK_Escape);
    return fmt::format("choose in a menu, {} down", downs);
}

std::string RandomPerson::go_through_steps(const RunningViewer& viewer) {
    const std::size_t count = 1 + below(5);
    const KeyName key = happens(0.6) ? XK_z : XK_y;
    for (std::size_t i = 0; i < count; ++i) {
        viewer.press(key, XK_Control_L);
        wait(10);
    }
    return fmt::format("{} {} times", key == XK_z ? "undo" : "redo", count);
}

std::string RandomPerson::save(const RunningViewer& viewer) {
    const bool elsewhere = happens(0.5);
    viewer.press(XK_s, XK_Control_L, elsewhere ? XK_Shift_L : 0);
    wait(120);
    if (happens(0.7)) viewer.type_keys(fmt::format("~/family {}", below(4)));
    if (happens(0.9)) viewer.press(XK_Return);
    wait(60);
    if (happens(0.5)) viewer.type_keys("r");  // confirms the replacement
    return elsewhere ? "save as" : "save";
}

std::string RandomPerson::drop(const RunningViewer& viewer) {
    std::vector<std::filesystem::path> dropped;
    for (std::size_t i = happens(0.6) ? 1 : 1 + below(4); i > 0; --i)
        dropped.push_back(files_.at(below(files_.size())));
    const State state = viewer.state();
    const glm::vec2 at = happens(0.4) ? inside(state, "keys") : anywhere(state);
    viewer.drop(dropped, at);
    std::string done = "drop";
    for (const std::filesystem::path& file : dropped) done += " " + file.filename().string();
    return done;
}

std::string RandomPerson::resize(const RunningViewer& viewer) {
    const glm::ivec2 size(480 + static_cast<int>(below(800)), 360 + static_cast<int>(below(440)));
    viewer.desktop().resize(viewer.window(), size);
    return fmt::format("make the window {} x {}", size.x, size.y);
}

}  // namespace interleaf
