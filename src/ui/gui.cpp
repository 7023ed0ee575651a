#include "ui/gui.h"

// GLFW must not bring OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <iterator>
#include <string_view>

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include "hierarchy/error.h"
#include "ui/widgets/glyphs.h"
#include "ui/widgets/style.h"
#include "ui/widgets/theme.h"

namespace interleaf {

namespace {

/// Time between the two passes of a frame, in seconds.
constexpr float min_delta = 1e-6F;

void follow_modifiers() {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
    io.KeyAlt = io.KeysDown[GLFW_KEY_LEFT_ALT] || io.KeysDown[GLFW_KEY_RIGHT_ALT];
}

bool is_modifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

/// Gives the fonts to OpenGL. Everything else of Dear ImGui's backend stays: buffers that it makes anew would have
/// no room for the next frame (1.86).
void renew_font_texture() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

bool mouse_does_something() {
    const ImGuiIO& io = ImGui::GetIO();
    const auto changed = [](const bool(&flags)[5]) {
        return std::ranges::find(flags, true) != std::end(flags);
    };
    return io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || changed(io.MouseClicked) ||
           changed(io.MouseReleased);
}

}  // namespace

Gui::Gui(GLFWwindow* window) : window_(window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.UserData = &state_;
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;  // frames are drawn only after input
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        throw MachineError("cannot draw the user interface: no OpenGL library that Dear ImGui can load");
    }
    ImGui_ImplOpenGL3_CreateDeviceObjects();
    follow_display();
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::follow(const Appearance& appearance) {
    text_scale_ = appearance.text_scale;
    if (!has_sections_) {
        state_.closed_sections.insert(appearance.closed_sections.begin(), appearance.closed_sections.end());
        has_sections_ = true;
    }
    if (appearance.theme == state_.theme) return;
    state_.theme = appearance.theme;
    set_colors(ImGui::GetStyle());
}

std::vector<std::string> Gui::closed_sections() const {
    return {state_.closed_sections.begin(), state_.closed_sections.end()};
}

/// Makes the characters that texts have asked for.
/// \pre no frame has begun
void Gui::add_glyphs() {
    if (!state_.lacks_glyphs) return;
    make_fonts(scale_, density_);
    renew_font_texture();
}

void Gui::begin_frame(std::span<const int> pressed) {
    follow_display();
    add_glyphs();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    follow_menu();
    hold_taps(pressed);
    panel_keyboard_.follow();
    give_keys();
    ImGui::NewFrame();
    has_mouse_input_ = mouse_does_something();
}

void Gui::begin_drawing() {
    ImGui::EndFrame();
    add_glyphs();
    release_taps();
    // Skip the backends, which would read the pointer again. Dear ImGui requires that some time passes.
    ImGui::GetIO().DeltaTime = min_delta;
    follow_menu();
    give_keys();
    ImGui::NewFrame();
}

void Gui::follow_menu() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    has_menu_ = false;
    if (context.OpenPopupStack.empty()) return;
    const ImGuiPopupData& front = context.OpenPopupStack.back();
    // A popup that opens has no window yet. A popup whose panel is no longer shown stays in the list, but is
    // not visible.
    has_menu_ = front.Window == nullptr
                    ? front.OpenFrameCount == context.FrameCount
                    : front.Window->Active && (front.Window->Flags & ImGuiWindowFlags_Modal) == 0;
}

/// Turns on Dear ImGui's keyboard navigation while a menu is open or a panel has the keyboard. Otherwise it is off.
void Gui::give_keys() {
    ImGuiIO& io = ImGui::GetIO();
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (!has_menu_ && !panel_keyboard_.has_keyboard()) {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
        return;
    }
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    if (io.KeysDown[GLFW_KEY_ENTER] || io.KeysDown[GLFW_KEY_KP_ENTER])
        io.NavInputs[ImGuiNavInput_Activate] = 1;
    if (!has_menu_) return;
    // In a menu that the mouse has opened, the first arrow key selects the first entry, not the second. A
    // list of choices starts at the current choice.
    const ImGuiWindow* const front = context.OpenPopupStack.back().Window;
    const bool is_list = front != nullptr && std::string_view(front->Name).starts_with("##Combo");
    if (context.NavDisableHighlight && !context.NavInitRequestFromMove && !is_list)
        context.NavInitResultId = 0;
}

void Gui::end_frame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    release_taps();
}

void Gui::abandon_frame() {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.WithinFrameScope) {
        context.FontStack.clear();  // ErrorCheckEndFrameRecover() unwinds all other stacks
        ImGui::ErrorCheckEndFrameRecover(nullptr);
        ImGui::EndFrame();
    }
    release_taps();
}

/// Gives each frame one key, with the modifiers that were pressed before it. Dear ImGui reads only which keys
/// are down when a frame begins: during a slow frame it would miss a key that is pressed and released, and
/// the order of several keys. It also sees a key pressed again only after a frame in which the key is up.
void Gui::hold_taps(std::span<const int> pressed) {
    ImGuiIO& io = ImGui::GetIO();
    waiting_taps_.insert(waiting_taps_.end(), pressed.begin(), pressed.end());
    std::erase_if(waiting_taps_, [](int key) { return key < 0 || key > GLFW_KEY_LAST; });
    if (waiting_taps_.empty()) return;
    const auto key = std::ranges::find_if_not(waiting_taps_, is_modifier);
    const auto end = key == waiting_taps_.end() ? key : key + 1;
    // Dear ImGui also expects no key before an opening menu has its window.
    const bool is_opening = has_menu_ && ImGui::GetCurrentContext()->OpenPopupStack.back().Window == nullptr;
    const auto is_down = [&](int tap) {
        const bool is_held = is_modifier(tap) && io.KeysDown[tap];  // it may be held for the next key, too
        return io.KeysDownDuration[tap] >= 0 && !is_held;
    };
    const bool is_early = is_opening || std::any_of(waiting_taps_.begin(), end, is_down);
    for (const int waiting : waiting_taps_) io.KeysDown[waiting] = false;
    if (!is_early) {
        for (auto tap = waiting_taps_.begin(); tap != end; ++tap) io.KeysDown[*tap] = true;
        taps_.assign(waiting_taps_.begin(), end);
        waiting_taps_.erase(waiting_taps_.begin(), end);
    }
    follow_modifiers();
}

void Gui::release_taps() {
    for (const int key : taps_) ImGui::GetIO().KeysDown[key] = glfwGetKey(window_, key) == GLFW_PRESS;
    if (!taps_.empty()) follow_modifiers();
    taps_.clear();
}

bool Gui::has_input() const {
    return has_mouse_input_ || !waiting_taps_.empty();
}

glm::vec2 Gui::pointer() const {
    return from_imgui(ImGui::GetIO().MousePos);
}

bool Gui::is_button_down() const {
    return ImGui::IsAnyMouseDown();
}

bool Gui::takes_text() const {
    return ImGui::GetIO().WantTextInput;
}

std::optional<Rect> Gui::popup() const {
    const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
    if (popups.empty()) return std::nullopt;
    const ImGuiWindow* const window = popups.back().Window;
    if (window == nullptr || !window->Active || window->Hidden) return std::nullopt;
    return Rect{window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
}

void Gui::follow_display() {
    int window_width = 0;
    int framebuffer_width = 0;
    int width_after = 0;
    float content_scale = 1;
    glfwGetWindowSize(window_, &window_width, nullptr);
    glfwGetFramebufferSize(window_, &framebuffer_width, nullptr);
    glfwGetWindowSize(window_, &width_after, nullptr);
    glfwGetWindowContentScale(window_, &content_scale, nullptr);
    if (window_width == 0 || framebuffer_width == 0) return;  // minimized
    if (window_width != width_after && scale_ > 0) return;    // resized between the two calls
    const float density = static_cast<float>(framebuffer_width) / static_cast<float>(window_width);
    // Where screen coordinates are coarser than pixels, they already include that part of the scale.
    const float scale = content_scale / density * text_scale_;
    if (scale == scale_ && density == density_) return;
    scale_ = scale;
    density_ = density;
    apply_style(scale, density);
    renew_font_texture();
}

}  // namespace interleaf
