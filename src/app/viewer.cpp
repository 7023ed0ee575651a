// Ties the session, the panels and the renderer together: input to state, state to picture, one frame after
// the other.
#include "app/viewer.h"

// GLFW must not bring OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <malloc.h>

#include "app/commands.h"
#include "app/family_extent.h"
#include "app/morph_surface.h"
#include "app/scene_picture.h"
#include "app/shown_field.h"
#include "app/trace.h"
#include "hierarchy/color.h"
#include "hierarchy/error.h"
#include "io/mesh_file.h"
#include "io/safe_write.h"
#include "render/camera.h"
#include "render/context.h"
#include "ui/display_panel.h"
#include "ui/gui.h"
#include "ui/help_overlay.h"
#include "ui/keys_panel.h"
#include "ui/layout.h"
#include "ui/menu_bar.h"
#include "ui/message_panel.h"
#include "ui/parameter_domain_panel.h"
#include "ui/status_line.h"
#include "ui/style.h"
#include "ui/timeline_panel.h"
#include "ui/value_label.h"
#include "ui/view_area.h"
#include "ui/weights_panel.h"

namespace interleaf {

namespace {

/// Frames drawn after the last input: Dear ImGui needs one more to settle, a window may need one to appear.
constexpr int settling_frames = 3;

/// What stays the same while the family is open.
struct FamilyFigures {
    Extent extent;
    std::vector<std::string> key_names;
    std::vector<KeyRow> key_rows;
    std::vector<glm::dvec2> path;  ///< of the timeline through the domain
    std::vector<FamilyField> fields;
};

FamilyFigures figures_of(const Family& family) {
    FamilyFigures figures;
    figures.extent = extent(family);
    figures.fields = fields_of(family.keys);
    for (const Key& key : family.keys) {
        const std::vector<Leaf> leaves = leaves_of(key.hierarchy);
        const unsigned deepest = std::ranges::max_element(leaves, {}, &Leaf::level)->level;
        figures.key_names.push_back(key.name);
        figures.key_rows.push_back({.name = key.name, .leaves = leaves.size(), .deepest = deepest});
    }
    if (!family.timeline || !family.domain) return figures;
    for (const TimelineKey& key : family.timeline->keys()) {
        if (const auto at = family.domain->point_of(family.timeline->at(key.time)))
            figures.path.push_back(*at);
    }
    return figures;
}

std::vector<MenuEntry> menu_entries(const ViewerState& state) {
    std::vector<MenuEntry> entries;
    for (const Command& command : commands()) {
        entries.push_back({.menu = command.menu,
                           .name = command.name,
                           .shortcut = shortcut_text(command),
                           .description = command.description,
                           .on = command.is_on != nullptr && command.is_on(state)});
    }
    return entries;
}

class Viewer {
  public:
    Viewer(Family family, const ViewerOptions& options);
    void run();

  private:
    void wait();
    void frame();
    void run_commands(double now);
    void show_panels(double now);
    void show_keys_and_display();
    void show_timeline(double now);
    void move_camera(const ViewInput& input);
    glm::vec2 device_coordinates(glm::vec2 point) const;
    void zoom(const ViewInput& input);
    const FamilyField* shown() const { return shown_field(state_.session.display, family_figures_.fields); }
    void draw_surface();
    void show_value();
    void save_picture();
    float aspect() const { return layout_.view.width / std::max(layout_.view.height, 1.0F); }

    Window window_;
    std::vector<Shortcut> pressed_;  ///< since the last frame; the key callback adds to it
    ViewerState state_;
    FamilyFigures family_figures_;
    Gui gui_;
    MorphSurface surface_;
    ScenePicture picture_;
    std::optional<std::filesystem::path> picture_file_;
    Camera camera_;
    std::optional<Trace> trace_;
    Layout layout_;
    TracePlaces places_;
    bool pointed_at_view_ = false;
    std::size_t frame_ = 0;
    double frame_milliseconds_ = 0;
    int settling_ = settling_frames;
};

/// Installed before Dear ImGui's own, which passes the event on.
GLFWwindow* watch_keys(GLFWwindow* window, std::vector<Shortcut>& pressed) {
    glfwSetWindowUserPointer(window, &pressed);
    glfwSetKeyCallback(window, [](GLFWwindow* source, int key, int, int action, int modifiers) {
        if (action == GLFW_RELEASE) return;
        const Shortcut shortcut{key, modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT)};
        const Command* const command = find_command(shortcut);
        if (command == nullptr || (action == GLFW_REPEAT && !command->repeats)) return;
        static_cast<std::vector<Shortcut>*>(glfwGetWindowUserPointer(source))->push_back(shortcut);
    });
    return window;
}

Viewer::Viewer(Family family, const ViewerOptions& options)
    : window_(family.name + " – Interleaf", options.width, options.height),
      state_{.session = Session(std::move(family))},
      family_figures_(figures_of(state_.session.family())),
      gui_(watch_keys(window_.handle(), pressed_)),
      picture_file_(options.picture) {
    if (options.trace) trace_.emplace(*options.trace);
    state_.session.display = options.display;
    if (options.time) state_.session.seek(*options.time, glfwGetTime());
    if (options.at) state_.session.move_point(*options.at, glfwGetTime());
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(window_.handle(), 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
    camera_.look_from(30, 20);
}

void Viewer::run() {
    while (glfwWindowShouldClose(window_.handle()) == GLFW_FALSE && !state_.quit_wanted) {
        wait();
        frame();
    }
}

void Viewer::wait() {
    if (settling_ > 0) {
        --settling_;
        glfwPollEvents();
    } else {
        glfwWaitEvents();
        settling_ = settling_frames;
    }
}

void Viewer::frame() {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_.handle(), &width, &height);
    if (width == 0 || height == 0) return;  // minimised

    const double now = glfwGetTime();
    gui_.begin_frame();
    run_commands(now);
    state_.session.advance(now);
    places_ = {.window = {width, height},
               .view = {},
               .domain = std::nullopt,
               .timeline = std::nullopt,
               .pointer = gui_.pointer(),
               .button_down = gui_.is_button_down()};
    show_panels(now);
    fit_display(state_.session.display, family_figures_.fields);
    const FamilyField* const field = shown();
    surface_.update(state_.session.family(), state_.session.weights(), field ? &field->label : nullptr);
    draw_surface();
    show_value();
    gui_.end_frame();
    if (picture_file_ && settling_ == 0) save_picture();
    glfwSwapBuffers(window_.handle());

    frame_milliseconds_ = 1000 * (glfwGetTime() - now);
    if (state_.session.is_playing() || gui_.has_input()) settling_ = settling_frames;
    ++frame_;
    if (trace_) trace_->record(frame_, state_, surface_.figures(), camera_.eye(), places_);
}

void Viewer::run_commands(double now) {
    if (gui_.takes_text()) pressed_.clear();
    for (const Shortcut shortcut : std::exchange(pressed_, {})) find_command(shortcut)->run(state_, now);
    if (!state_.reload_wanted) return;
    state_.reload_wanted = false;
    try {
        surface_.renderer().reload_shaders();
        picture_.forget();
    } catch (const std::runtime_error& error) {
        state_.message = error.what();
    }
}

void Viewer::show_panels(double now) {
    Session& session = state_.session;
    const Family& family = session.family();
    const std::vector<MenuEntry> entries = menu_entries(state_);
    const MenuBarResult menu = menu_bar(entries, family.name);
    if (menu.chosen) commands()[*menu.chosen].run(state_, now);

    layout_ = lay_out(places_.window, menu.height, gui_.scale(), session.has_timeline());
    places_.view = layout_.view;
    const ViewInput view_input = view_area(layout_.view);
    pointed_at_view_ = view_input.pointed_at;
    move_camera(view_input);

    if (layout_.left) {
        begin_panel("left", *layout_.left);
        show_keys_and_display();
        end_panel();
    }
    begin_panel("right", layout_.right);
    if (family.domain) {
        const auto result = parameter_domain_panel(family, session.point(), family_figures_.path);
        places_.domain = result.plot;
        if (result.moved_to) session.move_point(*result.moved_to, now);
        section_gap();
    }
    weights_panel(family, session.weights());
    if (!layout_.left) {
        section_gap();
        show_keys_and_display();
    }
    end_panel();
    show_timeline(now);
    const SurfaceFigures& figures = surface_.figures();
    status_line(layout_.status, {.active_keys = figures.keys.size(),
                                 .leaves = figures.leaves,
                                 .vertices = figures.vertices,
                                 .rebuild_milliseconds = figures.rebuild_milliseconds,
                                 .frame_milliseconds = frame_milliseconds_});
    const Rect below_menu{0, menu.height, places_.window.x, places_.window.y - menu.height};
    help_overlay(entries, below_menu, state_.help_shown);
    message_panel(state_.message, layout_.view);
}

void Viewer::show_keys_and_display() {
    const SurfaceFigures& figures = surface_.figures();
    keys_panel(family_figures_.key_rows, state_.session.weights());
    section_gap();
    display_panel(state_.session.display, {.levels = figures.levels,
                                           .origins = figures.origins,
                                           .active_keys = figures.keys,
                                           .fields = family_figures_.fields,
                                           .key_without_field = figures.key_without_field,
                                           .key_names = family_figures_.key_names});
}

void Viewer::show_timeline(double now) {
    Session& session = state_.session;
    if (!session.has_timeline()) return;
    const TimelineResult result = timeline_panel(layout_.timeline, session.family(),
                                                 {.time = session.time(),
                                                  .playing = session.is_playing(),
                                                  .loops = session.loops(),
                                                  .drives = session.driver() == Driver::timeline});
    places_.timeline = result.track;
    if (result.seek_to) session.seek(*result.seek_to, now);
    if (result.toggle_playing) session.toggle_playing(now);
    if (result.toggle_loop) session.toggle_loop(now);
}

void Viewer::move_camera(const ViewInput& input) {
    camera_.orbit(input.orbit);
    camera_.pan(input.pan);
    if (input.zoom != 1) zoom(input);
    if (input.frame || std::exchange(state_.frame_wanted, false))
        camera_.frame(family_figures_.extent, aspect());
}

/// A point of the window in the view's normalised device coordinates, -1 to 1, y up.
glm::vec2 Viewer::device_coordinates(glm::vec2 point) const {
    const Rect& view = layout_.view;
    return {2 * (point.x - view.x) / view.width - 1, 1 - 2 * (point.y - view.y) / view.height};
}

void Viewer::zoom(const ViewInput& input) {
    const glm::vec2 pointer = device_coordinates(input.pointer);
    const glm::vec2 part{(pointer.x + 1) / 2, (1 - pointer.y) / 2};
    const auto pixel = [](float place, int count) {
        return std::clamp(static_cast<int>(place * static_cast<float>(count)), 0, count - 1);
    };
    OffscreenTarget* const target = picture_.target();
    const float depth =
        target != nullptr ? target->depth_at(pixel(part.x, target->width()), pixel(part.y, target->height()))
                          : 1;
    if (depth < 1) {
        camera_.approach(input.zoom, camera_.point_at(pointer, depth, aspect()));
    } else {
        camera_.zoom(input.zoom, pointer, aspect());
    }
}

void Viewer::draw_surface() {
    const auto pixels = [this](float length) {
        return static_cast<int>(std::lround(length * gui_.density()));
    };
    const Rect& view = layout_.view;
    Scene scene{.width = std::max(pixels(view.width), 1),
                .height = std::max(pixels(view.height), 1),
                .camera = camera_,
                .weights = weight_values(state_.session.weights()),
                .display = state_.session.display,
                .surface = surface_.figures().rebuilds};
    scene.display.line_width *= gui_.scale() * gui_.density();
    if (!picture_.update(surface_.renderer(), scene)) settling_ = std::max(settling_, 1);
    picture_.target()->blit_to_window(pixels(view.x), pixels(places_.window.y - view.bottom()));
}

/// The value of the field under the pointer, unless the surface moves.
void Viewer::show_value() {
    const FamilyField* const field = shown();
    if (field == nullptr || !pointed_at_view_ || state_.session.is_playing()) return;
    const glm::vec2 pointer = device_coordinates(places_.pointer);
    const Ray ray{camera_.point_at(pointer, 0, aspect()), camera_.point_at(pointer, 1, aspect())};
    const std::optional<glm::vec3> value = surface_.field_at(ray, state_.session.weights());
    if (!value) return;
    const bool is_scalar = field->label.kind == FieldKind::scalar;
    const glm::vec3 color =
        is_scalar ? state_.session.display.scale.color(value->x) : encoded(glm::clamp(*value, 0.0F, 1.0F));
    const glm::ivec3 bytes(glm::round(255.0F * color));
    value_label(places_.pointer, layout_.view, color,
                is_scalar
                    ? fmt::format("{} {:.4g}", field->label.name, value->x)
                    : fmt::format("{} #{:02x}{:02x}{:02x}", field->label.name, bytes.r, bytes.g, bytes.b));
}

/// Once nothing changes any more.
void Viewer::save_picture() {
    const glm::ivec2 size = window_.framebuffer_size();
    write_file(*picture_file_, png_bytes(window_.read_rgba(), size.x, size.y));
    state_.quit_wanted = true;
}

}  // namespace

void run_viewer(Family family, const ViewerOptions& options) {
    if (options.at && !family.domain) throw UsageError("--at: the family has no parameter domain");
    require_field(options.display, fields_of(family.keys));
    if (options.time && !family.timeline) throw UsageError("--time: the family has no timeline");
    // A software renderer takes and gives back its frame's memory every time otherwise, which costs it most
    // of its speed.
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    Viewer(std::move(family), options).run();
}

}  // namespace interleaf
