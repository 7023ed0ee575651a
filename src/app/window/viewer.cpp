// Ties the session, the panels and the renderer together: input to state, state to picture, one frame after
// the other.
#include "app/window/viewer.h"

// GLFW must not bring OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <glm/common.hpp>
#include <malloc.h>

#include "app/document/document_title.h"
#include "app/document/edit_commands.h"
#include "app/document/shown_field.h"
#include "app/pictures/key_portraits.h"
#include "app/pictures/mismatch_pictures.h"
#include "app/pictures/morph_surface.h"
#include "app/pictures/scene_picture.h"
#include "app/storage/document_files.h"
#include "app/window/camera_control.h"
#include "app/window/commands.h"
#include "app/window/comparison_view.h"
#include "app/window/document_panels.h"
#include "app/window/trace.h"
#include "app/window/window_input.h"
#include "hierarchy/color.h"
#include "hierarchy/error.h"
#include "io/file/safe_write.h"
#include "io/mesh/mesh_file.h"
#include "render/camera.h"
#include "render/context.h"
#include "ui/dialogs/message_panel.h"
#include "ui/gui.h"
#include "ui/layout.h"
#include "ui/panels/display_panel.h"
#include "ui/panels/help_overlay.h"
#include "ui/panels/keys_panel.h"
#include "ui/panels/menu_bar.h"
#include "ui/panels/status_line.h"
#include "ui/panels/view_area.h"
#include "ui/panels/weights_panel.h"
#include "ui/widgets/style.h"
#include "ui/widgets/value_label.h"

namespace interleaf {

namespace {

/// Frames drawn after the last input: Dear ImGui needs one more to settle, a window may need one to appear.
constexpr int settling_frames = 3;

/// Of the window when it is opened for the first time, screen coordinates.
constexpr glm::ivec2 first_size{1280, 800};

/// However still it is, autosave and the files on disk are looked after this often; seconds.
constexpr double longest_wait = 1;

/// How often it is shown how far work is; seconds.
constexpr double work_interval = 0.05;

std::vector<MenuEntry> entries_of(const ViewerState& state) {
    std::vector<MenuEntry> entries;
    for (const Command& command : commands()) entries.push_back(menu_entry(command, state));
    return entries;
}

Submenu recent_menu(const DocumentFiles& files) {
    Submenu menu{.menu = "File", .after = "Open", .name = "Open recent", .items = {}};
    for (const std::filesystem::path& file : files.recent_files()) menu.items.push_back(file.string());
    return menu;
}

class Viewer {
  public:
    /// \param meshes  to fit, as soon as nothing else is asked
    Viewer(Family family, std::vector<std::filesystem::path> sources,
           std::vector<std::filesystem::path> meshes, const ViewerOptions& options);
    void run();

  private:
    void outlive(const std::exception& error);
    void record();
    void wait();
    void frame();
    void read_input(double now);
    void take_drop(double now);
    void follow_document();
    void update_surface();
    void show_panels(double now);
    void show_message(double now);
    void show_comparison(const Rect& area);
    void show_document(float menu_height, double now);
    void show_keys_and_display(double now);
    void move_camera(const ViewInput& input);
    void frame_camera();
    const FamilyField* shown() const { return shown_field(state_.session.display, fields_); }
    void draw_surface();
    void draw_portraits();
    void draw_mismatch();
    void show_value();
    void save_picture();
    const Family& family() const { return state_.document.family(); }

    WindowInput input_;
    Window window_;
    ViewerState state_;
    DocumentFiles files_;
    std::shared_ptr<const Family> followed_;  ///< the document's state that all below is about
    std::string title_;
    std::vector<FamilyField> fields_;
    Gui gui_;
    MorphSurface surface_;
    KeyPortraits portraits_;
    MismatchPictures mismatch_pictures_;
    ScenePicture picture_;
    ComparisonView comparison_;
    bool shows_comparison_ = false;              ///< in this frame, instead of the document
    std::vector<std::filesystem::path> meshes_;  ///< that are still to be opened
    std::optional<std::filesystem::path> picture_file_;
    Camera camera_;
    std::optional<Trace> trace_;
    Layout layout_;
    TracePlaces places_;
    KeysPanelResult keys_in_sight_;
    bool pointed_at_view_ = false;
    bool is_asking_ = false;  ///< a question or the file browser is open
    std::size_t frame_ = 0;
    double frame_milliseconds_ = 0;
    int settling_ = settling_frames;
};

Viewer::Viewer(Family family, std::vector<std::filesystem::path> sources,
               std::vector<std::filesystem::path> meshes, const ViewerOptions& options)
    : window_("Interleaf", options.size.value_or(first_size).x, options.size.value_or(first_size).y),
      state_(std::move(family), family_folder(sources)),
      files_(state_, std::move(sources), options.picture.has_value()),
      gui_(watch_input(window_.handle(), input_)),
      meshes_(std::move(meshes)),
      picture_file_(options.picture) {
    if (options.trace) trace_.emplace(*options.trace);
    if (const auto last = files_.window_size(); last && !options.size)
        glfwSetWindowSize(window_.handle(), last->x, last->y);
    state_.session.display = options.display;
    if (options.time) state_.session.seek(*options.time, glfwGetTime());
    if (options.at) state_.session.move_point(*options.at, glfwGetTime());
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(window_.handle(), 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
    camera_.look_from(30, 20);
}

void Viewer::run() {
    bool has_failed = false;  // the frame before
    while (!state_.quit_wanted) {
        wait();
        try {
            frame();
            has_failed = false;
        } catch (const std::exception& error) {
            if (std::exchange(has_failed, true) || picture_file_) throw;
            outlive(error);
        }
        record();
        if (glfwWindowShouldClose(window_.handle()) == GLFW_FALSE) continue;
        glfwSetWindowShouldClose(window_.handle(), GLFW_FALSE);
        files_.grant(FileWish::quit);
        settling_ = settling_frames;
    }
    files_.remember_window(places_.window);
}

/// What was asked for has failed where nothing was prepared for it. What is not saved must not be lost by
/// that.
void Viewer::outlive(const std::exception& error) {
    files_.keep_unsaved();
    gui_.abandon_frame();
    state_.is_dragging = false;
    const auto present = state_.document.snapshot();
    if (&state_.session.family() != present.get()) state_.session.replace_family(present, glfwGetTime());
    if (state_.selected_key && *state_.selected_key >= present->keys.size()) state_.selected_key.reset();
    state_.message = message_of_mishap(error);
    settling_ = settling_frames;
}

void Viewer::record() {
    if (trace_ && frame_ > 0)
        trace_->record(frame_, glfwGetTime(), state_, surface_.figures(),
                       shows_comparison_ ? comparison_.eye() : camera_.eye(), places_);
}

void Viewer::wait() {
    if (settling_ > 0) {
        --settling_;
        glfwPollEvents();
    } else {
        const double longest = files_.is_working() || files_.is_saving() ? work_interval : longest_wait;
        const double before = glfwGetTime();
        glfwWaitEventsTimeout(longest);
        if (glfwGetTime() - before < longest) settling_ = settling_frames;  // something has come
    }
}

void Viewer::frame() {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_.handle(), &width, &height);
    if (width == 0 || height == 0) return;  // minimized

    const double now = glfwGetTime();
    gui_.begin_frame(std::exchange(input_.keyboard_keys, {}));
    read_input(now);
    state_.session.advance(now);
    places_ = {.window = {width, height},
               .view = {},
               .keys = {},
               .domain = std::nullopt,
               .timeline = std::nullopt,
               .pointer = gui_.pointer(),
               .button_down = gui_.is_button_down(),
               .is_asking = false,
               .takes_text = false,
               .popup = std::nullopt,
               .browsed = std::nullopt,
               .offer = nullptr};
    draw_mismatch();
    show_panels(now);
    files_.grant(std::exchange(state_.file_wish, FileWish::none));
    files_.look_after(now);
    const bool was_asking = std::exchange(is_asking_, files_.is_asking());
    if (is_asking_ != was_asking) settling_ = settling_frames;
    places_.is_asking = is_asking_ && was_asking;  // in the first frame it takes no keys yet
    places_.takes_text = gui_.takes_text();
    places_.popup = gui_.popup();
    places_.browsed = files_.browsed();
    places_.offer = files_.fitting().offered();
    follow_document();
    update_surface();
    if (state_.is_comparing != shows_comparison_) settling_ = settling_frames;
    if (shows_comparison_) {
        if (!comparison_.draw(state_.session.display, gui_, places_.window.y))
            settling_ = std::max(settling_, 1);
        comparison_.show_value();
    } else {
        frame_camera();
        draw_surface();
        draw_portraits();
        show_value();
    }
    gui_.end_frame();
    if (picture_file_ && settling_ == 0 && !files_.is_working()) save_picture();
    glfwSwapBuffers(window_.handle());

    frame_milliseconds_ = 1000 * (glfwGetTime() - now);
    if (state_.session.is_playing() || gui_.has_input()) settling_ = settling_frames;
    ++frame_;
}

void Viewer::read_input(double now) {
    if (!meshes_.empty() && !files_.is_asking()) files_.open(std::exchange(meshes_, {}));
    take_drop(now);
    if (gui_.takes_text() || gui_.has_menu() || files_.is_asking()) input_.pressed.clear();
    for (const Shortcut shortcut : std::exchange(input_.pressed, {}))
        run_command(*find_command(shortcut), state_, now);
    follow_document();
    if (!state_.reload_wanted) return;
    state_.reload_wanted = false;
    try {
        surface_.renderer().reload_shaders();
        comparison_.reload_shaders();
        picture_.forget();
    } catch (const std::runtime_error& error) {
        state_.message = message_of(error);
    }
}

/// Files that were dropped on the list of keys become keys, others a new document.
void Viewer::take_drop(double now) {
    const auto dropped = std::exchange(input_.dropped, {});
    if (dropped.empty() || files_.is_asking()) return;
    glm::dvec2 pointer;
    glfwGetCursorPos(window_.handle(), &pointer.x, &pointer.y);
    const Rect& list = keys_in_sight_.list;
    const bool is_on_list =
        pointer.x >= list.x && pointer.x < list.right() && pointer.y >= list.y && pointer.y < list.bottom();
    if (is_on_list) {
        files_.add_keys(dropped, now);
    } else {
        files_.open(dropped);
    }
}

/// Brings what is made from the document in line with its present state.
void Viewer::follow_document() {
    if (const std::string title = title_of(state_.document); title != title_) {
        title_ = title;
        glfwSetWindowTitle(window_.handle(), fmt::format("{} – Interleaf", title).c_str());
    }
    if (state_.document.snapshot() == followed_) return;
    followed_ = state_.document.snapshot();
    portraits_.update(family());
    fields_ = fields_of(family().keys);
    update_surface();
    settling_ = settling_frames;
}

void Viewer::update_surface() {
    adapt_display(state_.session.display, fields_);
    const FamilyField* const field = shown();
    surface_.update(state_.session.family(), state_.session.weights(), field ? &field->label : nullptr);
}

void Viewer::show_panels(double now) {
    const std::vector<MenuEntry> entries = entries_of(state_);
    const MenuBarResult menu = menu_bar(entries, recent_menu(files_), title_);
    const Rect below_menu{0, menu.height, places_.window.x, places_.window.y - menu.height};
    shows_comparison_ = state_.is_comparing && !compared_keys(family(), state_.comparisons).empty();
    if (shows_comparison_ && state_.session.is_playing()) state_.session.toggle_playing(now);
    if (shows_comparison_)
        show_comparison(below_menu);
    else
        show_document(menu.height, now);
    help_overlay(entries, below_menu, state_.help_shown);
    show_message(now);
    if (menu.chosen) run_command(commands()[*menu.chosen], state_, now);
    if (menu.chosen_item) files_.open({files_.recent_files()[*menu.chosen_item]});
    files_.show(below_menu, gui_.density(), now);
}

void Viewer::show_message(double now) {
    Message& message = state_.message;
    if (is_over(message, now)) message.clear();
    if (message.is_fault()) {
        if (message_panel(message.text, mismatch_pictures_.shown(), places_.view)) message.clear();
        return;
    }
    const NoticeResult notice = notice_panel(message.text, places_.view);
    if (notice.pointed_at) message.seen = now;
    if (notice.dismissed) message.clear();
}

void Viewer::show_comparison(const Rect& area) {
    comparison_.show(state_, area, camera_, !is_asking_ && !gui_.takes_text() && !gui_.has_menu());
    places_.view = area;
    pointed_at_view_ = false;
    keys_in_sight_ = {};
}

void Viewer::show_document(float menu_height, double now) {
    layout_ = lay_out(places_.window, menu_height, gui_.scale(), state_.session.has_timeline());
    places_.view = layout_.view;
    const ViewInput view_input = view_area(layout_.view);
    pointed_at_view_ = view_input.pointed_at;
    move_camera(view_input);

    if (layout_.left) {
        begin_panel("left", *layout_.left);
        show_keys_and_display(now);
        end_panel();
    }
    begin_panel("right", layout_.right);
    if (family().domain) {
        places_.domain = show_domain(state_, now);
        section_gap();
    }
    weights_panel(family(), state_.session.weights());
    if (!layout_.left) {
        section_gap();
        show_keys_and_display(now);
    }
    end_panel();
    if (state_.session.has_timeline()) places_.timeline = show_timeline(state_, layout_.timeline, now);
    if (!gui_.is_button_down()) end_drag(state_);

    const SurfaceFigures& figures = surface_.figures();
    status_line(layout_.status, {.active_keys = figures.keys.size(),
                                 .leaves = figures.leaves,
                                 .vertices = figures.vertices,
                                 .rebuild_milliseconds = figures.rebuild_milliseconds,
                                 .frame_milliseconds = frame_milliseconds_});
}

void Viewer::show_keys_and_display(double now) {
    const SurfaceFigures& figures = surface_.figures();
    keys_in_sight_ = show_keys(state_, portraits_.portraits(), 0.5F * layout_.view.height, now);
    places_.keys = keys_in_sight_.list;
    section_gap();
    display_panel(state_.session.display, {.levels = figures.levels,
                                           .origins = figures.origins,
                                           .active_keys = figures.keys,
                                           .active_names = figures.key_names,
                                           .fields = fields_,
                                           .key_without_field = figures.key_without_field});
}

void Viewer::move_camera(const ViewInput& input) {
    interleaf::move_camera(camera_, input, layout_.view, picture_.target());
    if (input.view_all) state_.view_target = ViewTarget::surface;
}

/// \pre the surface is that of the present weights
void Viewer::frame_camera() {
    const ViewTarget view_target = std::exchange(state_.view_target, ViewTarget::none);
    if (view_target == ViewTarget::surface)
        camera_.view_all(surface_.extent(state_.session.weights()), aspect_of(layout_.view));
    else if (view_target == ViewTarget::all_keys)
        camera_.view_all(portraits_.extent(), aspect_of(layout_.view));
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

/// One picture of a key a frame, so that the window stays quick.
void Viewer::draw_portraits() {
    const int side = static_cast<int>(std::lround(key_picture_side() * gui_.density()));
    if (portraits_.draw_next(keys_in_sight_.first, keys_in_sight_.end, side))
        settling_ = std::max(settling_, 2);
}

/// What the message is about; before the panels, which show it.
void Viewer::draw_mismatch() {
    const glm::vec2 size = message_picture_size() * gui_.density();
    mismatch_pictures_.update(state_.message.mismatch, glm::max(glm::ivec2(glm::round(size)), 1));
}

/// The value of the field under the pointer, unless the surface moves.
void Viewer::show_value() {
    const FamilyField* const field = shown();
    if (field == nullptr || !pointed_at_view_ || state_.session.is_playing()) return;
    const glm::vec2 pointer = device_coordinates(layout_.view, places_.pointer);
    const float aspect = aspect_of(layout_.view);
    const Ray ray{camera_.point_at(pointer, 0, aspect), camera_.point_at(pointer, 1, aspect)};
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

void run_viewer(Family family, std::vector<std::filesystem::path> sources,
                std::vector<std::filesystem::path> meshes, const ViewerOptions& options) {
    if (options.at && !family.domain) throw UsageError("--at: the family has no parameter domain");
    require_field(options.display, fields_of(family.keys));
    if (options.time && !family.timeline) throw UsageError("--time: the family has no timeline");
    // A software renderer takes and gives back its frame's memory every time otherwise, which costs it most
    // of its speed.
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    Viewer(std::move(family), std::move(sources), std::move(meshes), options).run();
}

}  // namespace interleaf
