// The three phases of the window's frame. Input reads the user's actions, update applies them to the state,
// draw draws the new state. The input phase shows the panels in order to read them, the draw phase shows them
// again in order to draw them.
#include "app/window/viewer.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <memory>
#include <optional>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <malloc.h>

#include "app/document/document_title.h"
#include "app/document/edit_commands.h"
#include "app/storage/document_files.h"
#include "app/window/camera_control.h"
#include "app/window/command_search.h"
#include "app/window/commands.h"
#include "app/window/document_views.h"
#include "app/window/film_export.h"
#include "app/window/frame_failures.h"
#include "app/window/frame_layout.h"
#include "app/window/frame_stats.h"
#include "app/window/initial_state.h"
#include "app/window/redraw.h"
#include "app/window/trace.h"
#include "app/window/view_clipboard.h"
#include "app/window/window_actions.h"
#include "app/window/window_input.h"
#include "app/window/window_panels.h"
#include "io/file/safe_write.h"
#include "io/film/png_bytes.h"
#include "render/context.h"
#include "ui/gui.h"

namespace interleaf {

namespace {

/// Size of the window when it is opened for the first time, if the screen has room for it; screen coordinates.
constexpr glm::ivec2 first_size{1280, 800};

/// Longest interval between two checks of the autosave and of the files on disk; seconds.
constexpr double max_check_interval = 1;

/// Interval between progress reports; seconds.
constexpr double work_interval = 0.05;

/// The user's actions since the last frame.
struct FrameInput {
    WindowActions actions;
    std::vector<Shortcut> pressed;
    std::vector<std::filesystem::path> dropped;
    bool drops_on_keys = false;  ///< whether the files were dropped on the list of keys
};

/// The subject of the window. The window draws again when it changes.
struct WindowSubject {
    std::shared_ptr<const Family> family;
    std::string message;
    bool is_asking = false;     ///< whether a question or the file browser is open
    bool is_comparing = false;  ///< whether a comparison is shown instead of the document
    bool operator==(const WindowSubject&) const = default;
};

class Viewer {
  public:
    /// \param meshes  meshes to fit; the viewer offers this as soon as no question is open
    Viewer(Family family, std::vector<std::filesystem::path> sources,
           std::vector<std::filesystem::path> meshes, const ViewerOptions& options);
    void run();

  private:
    bool dismiss_dialogs();
    void outlive(const std::exception& error);
    void wait();
    void frame();

    FrameInput read_input();
    bool has_keyboard() const;
    bool is_asking() const { return files_.is_asking() || film_.is_open() || search_.is_open(); }

    void update(const FrameInput& input, double now);
    void apply_actions(const WindowActions& actions, double now);
    void update_files(const FrameInput& input, double now);
    void update_film(double now);
    void update_clipboard(double now);
    void follow_state(double now);

    void draw(const std::optional<ViewInput>& view);

    WindowResult show_panels();
    FrameLayout layout() const { return lay_out_frame(size_, menu_bar_height(), gui_.scale(), state_); }
    void record();
    void save_picture();

    WindowInput input_;
    Window window_;
    ViewerState state_;
    DocumentFiles files_;
    FilmExport film_;
    CommandSearch search_;
    std::vector<std::filesystem::path> meshes_;  ///< not opened yet
    Gui gui_;
    MouseHolds holds_;
    double now_ = 0;  ///< when the frame began, seconds since GLFW was ready

    // Derived from the state.
    DocumentViews views_;
    std::string title_;
    WindowSubject subject_;

    // The last drawn frame.
    glm::ivec2 size_{0};  ///< of the window, screen coordinates
    WindowResult drawn_;
    FrameRest rest_;
    Redraw redraw_;
    std::size_t frame_ = 0;
    double frame_milliseconds_ = 0;
    bool takes_keys_ = false;  ///< a question or the file browser is open for at least two frames
    std::optional<std::filesystem::path> picture_file_;
    std::optional<Trace> trace_;
    std::optional<FrameStats> stats_;
};

Viewer::Viewer(Family family, std::vector<std::filesystem::path> sources,
               std::vector<std::filesystem::path> meshes, const ViewerOptions& options)
    : window_("Interleaf", options.size.value_or(first_size).x, options.size.value_or(first_size).y, false),
      state_(std::move(family), family_folder(sources)),
      files_(state_, std::move(sources), options.picture.has_value()),
      meshes_(std::move(meshes)),
      gui_(watch_input(window_.handle(), input_)),
      picture_file_(options.picture) {
    if (options.trace) trace_.emplace(*options.trace);
    if (options.stats) stats_.emplace(*options.stats);
    if (!options.size) window_.resize_within_screen(files_.window_size().value_or(first_size));
    glfwShowWindow(window_.handle());
    state_.appearance = files_.appearance();
    begin_with(options, state_, glfwGetTime());
    change_shortcuts(input_.shortcuts, files_.settings(), state_, gui_);
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(window_.handle(), 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
}

void Viewer::run() {
    FrameFailures failures(!picture_file_);
    while (!state_.quit_wanted) {
        wait();
        try {
            frame();
            failures.note_success();
        } catch (const std::exception& error) {
            if (!failures.outlives_failure()) throw;
            outlive(error);
        }
        record();
        if (glfwWindowShouldClose(window_.handle()) == GLFW_FALSE) continue;
        redraw_.settle();
        if (dismiss_dialogs()) continue;  // the window closes after them
        glfwSetWindowShouldClose(window_.handle(), GLFW_FALSE);
        files_.grant(FileWish::quit);
    }
    files_.remember_window(size_, gui_.closed_sections());
}

/// Has the dialogs closed that would stand beside the question for unsaved changes.
/// \return whether to wait for one that is still open, and shown: not in a minimized window
bool Viewer::dismiss_dialogs() {
    search_.dismiss();
    film_.dismiss_dialog();
    return size_.x > 0 && size_.y > 0 && (search_.is_open() || film_.dialog().is_open());
}

/// Continues after an unexpected error, and keeps the unsaved changes.
void Viewer::outlive(const std::exception& error) {
    files_.keep_unsaved();
    gui_.abandon_frame();
    state_.is_dragging = false;
    const auto present = state_.document.snapshot();
    if (&state_.session.family() != present.get()) state_.session.replace_family(present, glfwGetTime());
    if (state_.selected_key && *state_.selected_key >= present->keys.size()) state_.selected_key.reset();
    state_.message = message_of_mishap(error);
    redraw_.settle();
}

void Viewer::wait() {
    if (redraw_.is_due()) {
        redraw_.begin_frame();
        glfwPollEvents();
        return;
    }
    const bool works =
        files_.is_working() || files_.is_saving() || files_.is_exporting() || views_.is_working();
    const double longest = works ? work_interval : max_check_interval;
    const double before = glfwGetTime();
    glfwWaitEventsTimeout(longest);
    if (glfwGetTime() - before < longest) redraw_.settle();  // an event has come
}

void Viewer::frame() {
    glfwGetWindowSize(window_.handle(), &size_.x, &size_.y);
    if (size_.x == 0 || size_.y == 0) return;  // minimized

    now_ = glfwGetTime();
    rest_ = {};
    const FrameInput input = read_input();
    update(input, now_);
    draw(input.actions.view);
    redraw_.follow(rest_);
    if (picture_file_ && !redraw_.is_due() && !files_.is_working() && !views_.is_working()) save_picture();
    glfwSwapBuffers(window_.handle());
    frame_milliseconds_ = 1000 * (glfwGetTime() - now_);
    if (stats_)
        stats_->record(frame_, now_, frame_milliseconds_, views_.figures().waits, views_.figures().is_late);
    ++frame_;
}

// ---- input ----

FrameInput Viewer::read_input() {
    const bool has_panel = gui_.panel_keyboard().has_keyboard();  // Esc takes it away in this frame
    gui_.follow(state_.appearance);
    gui_.begin_frame(std::exchange(input_.keyboard_keys, {}));
    FrameInput input;
    input.pressed = std::exchange(input_.pressed, {});
    input.dropped = std::exchange(input_.dropped, {});
    if (!has_keyboard()) input.pressed.clear();
    if (has_panel) std::erase_if(input.pressed, belongs_to_panel);
    if (is_asking()) input.dropped.clear();
    const WindowResult shown = show_panels();
    input.drops_on_keys = !input.dropped.empty() && is_pointer_over(shown.layout.keys, window_.handle());
    input.actions = shown.actions;
    return input;
}

/// Whether the document or the comparison receives the keyboard, and no text field, menu or question does.
bool Viewer::has_keyboard() const {
    return !gui_.takes_text() && !gui_.has_menu() && !is_asking();
}

// ---- update ----

void Viewer::update(const FrameInput& input, double now) {
    state_.session.advance(now);
    apply_actions(input.actions, now);
    input_.pressed = run_pressed(input.pressed, input_.shortcuts, state_, now);
    if (!input_.pressed.empty()) redraw_.settle();
    if (const auto file = search_.act(state_, now)) files_.open_recent(*file);
    if (gui_.panel_keyboard().step(std::exchange(state_.panel_step, 0))) redraw_.settle();
    update_files(input, now);
    update_clipboard(now);
    follow_state(now);
}

/// Applies \p actions before anything else changes the state that the panels have shown.
void Viewer::apply_actions(const WindowActions& actions, double now) {
    views_.apply_to_views(actions, state_, layout());
    views_.brush(actions, state_, layout(), now);
    apply_to_state(actions, state_, holds_, now);
    if (!gui_.is_button_down()) end_drag(state_);
    if (actions.menu.chosen_item) files_.open_recent(*actions.menu.chosen_item);
}

void Viewer::update_files(const FrameInput& input, double now) {
    files_.act(gui_.density(), now);
    if (!meshes_.empty() && !is_asking()) files_.open(std::exchange(meshes_, {}));
    if (!input.dropped.empty() && input.drops_on_keys) files_.add_keys(input.dropped, now);
    if (!input.dropped.empty() && !input.drops_on_keys) files_.open(input.dropped);
    files_.grant(std::exchange(state_.file_wish, FileWish::none));
    update_film(now);
    files_.look_after(now);
}

void Viewer::update_film(double now) {
    if (const auto file = std::exchange(state_.film_wish, std::nullopt))
        film_.offer(*file, state_.document.snapshot(), state_.session, views_.camera(),
                    pixels_of(layout().panels.view, gui_.density()));
    if (auto message = film_.update(gui_.density(), now)) state_.message = *std::move(message);
    state_.makes_film = film_.is_working();
}

void Viewer::update_clipboard(double now) {
    const ClipboardWish wish = std::exchange(state_.camera_wishes.clipboard, ClipboardWish::none);
    const SeenPicture seen{.files = files_.sources(),
                           .camera = views_.camera(),
                           .line_scale = gui_.scale() * gui_.density(),
                           .size = pixels_of(layout().panels.view, gui_.density())};
    use_clipboard(wish, state_, seen, now);
}

/// Updates everything that is derived from the state.
void Viewer::follow_state(double now) {
    if (is_over(state_.message, now)) state_.message.clear();
    views_.follow(state_, layout(), gui_, now);
    const bool is_comparing = views_.comparison() != nullptr;
    if (is_comparing && state_.session.is_playing()) state_.session.pause(now);
    if (const std::string title = title_of(state_.document); title != title_) {
        title_ = title;
        glfwSetWindowTitle(window_.handle(), fmt::format("{} – Interleaf", title).c_str());
    }
    const WindowSubject subject{state_.document.snapshot(), state_.message.text, is_asking(), is_comparing};
    takes_keys_ = subject_.is_asking && subject.is_asking;  // a question reads no keys in its first frame
    rest_.has_changed = subject != subject_;
    subject_ = subject;
}

// ---- draw ----

/// \param view  the mouse input over the surface
void Viewer::draw(const std::optional<ViewInput>& view) {
    // A list of keys that follows playback shows ever new rows; their pictures must not slow it, or a drag.
    rest_.lacks_portraits =
        !state_.session.is_playing() && !state_.is_dragging && views_.draw_portrait(drawn_, gui_);
    gui_.begin_drawing();
    drawn_ = show_panels();
    rest_.is_coarse = !views_.draw(state_, drawn_.layout, view, gui_);
    rest_.moves =
        state_.session.is_playing() || state_.camera.spins || film_.is_working() || views_.is_measuring();
    rest_.has_input = gui_.has_input();
    gui_.end_frame();
}

// ---- the panels, for input and for drawing ----

WindowResult Viewer::show_panels() {
    const FrameLayout frame = layout();
    auto shown = show_window({.state = state_,
                              .recent_files = files_.recent_files(),
                              .shortcuts = input_.shortcuts,
                              .title = title_,
                              .portraits = views_.portraits(),
                              .fields = views_.fields(),
                              .field_curves = &views_.field_curves(),
                              .measured_scale = views_.measured_scale(),
                              .blend_curves = &views_.blend_curves(),
                              .is_flat = views_.is_flat(),
                              .curves = views_.curves(),
                              .figures = views_.figures(),
                              .camera_axes = views_.camera().axes(),
                              .follows_camera = views_.follows_camera(),
                              .measured_part = views_.measured_part(),
                              .pictures = views_.message_pictures(),
                              .frame_milliseconds = frame_milliseconds_,
                              .is_over_surface = views_.is_over_surface(),
                              .holds = holds_,
                              .layout = frame,
                              .inspected = views_.inspected(),
                              .comparison = views_.comparison(),
                              .has_keyboard = has_keyboard() && !gui_.panel_keyboard().has_keyboard()});
    files_.show(frame.content, now_);
    if (!files_.is_asking()) film_.show(frame.content, now_);  // there is room for one dialog
    search_.show(frame.content, state_, input_.shortcuts, files_.recent_files());
    return shown;
}

// ---- output to files ----

void Viewer::record() {
    if (!trace_ || frame_ == 0) return;
    trace_->record(
        frame_, glfwGetTime(), state_, views_.figures(),
        {.shown = drawn_,
         .eye = views_.eye(),
         .camera = views_.camera(),
         .pointer = gui_.pointer(),
         .follows_camera = views_.follows_camera(),
         .rests = !redraw_.is_due(),
         .button_down = gui_.is_button_down(),
         .is_asking = takes_keys_,
         .takes_text = gui_.takes_text(),
         .popup = gui_.popup(),
         .browsed = files_.browsed(),
         .picture_row = film_.dialog().is_open() ? film_.dialog().row() : "",
         .offer = files_.fitting().offered(),
         .landmarks = files_.fitting().landmarks().is_open() ? &files_.fitting().landmarks() : nullptr,
         .opengl_messages = take_debug_messages()});
}

/// Saves the picture of the window, which no longer changes, and closes the window.
void Viewer::save_picture() {
    const glm::ivec2 size = window_.framebuffer_size();
    write_file(*picture_file_, png_bytes(window_.read_rgba(), size.x, size.y));
    state_.quit_wanted = true;
}

}  // namespace

void run_viewer(Family family, std::vector<std::filesystem::path> sources,
                std::vector<std::filesystem::path> meshes, const ViewerOptions& options) {
    require_for(options, family);
    // A software renderer would otherwise return its memory in every frame, which costs most of its speed.
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    Viewer(std::move(family), std::move(sources), std::move(meshes), options).run();
}

}  // namespace interleaf
