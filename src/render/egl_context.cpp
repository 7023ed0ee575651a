// EGL on Mesa's surfaceless platform: a context without a display and without a surface.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/core.h>
#include <glad/gl.h>

#include "hierarchy/error.h"
#include "render/context.h"
#include "render/debug_messages.h"

namespace interleaf {

struct EglContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    State();
    ~State();
    State(const State&) = delete;
    State& operator=(const State&) = delete;

  private:
    void open();
    void close() const;
};

namespace {

[[noreturn]] void fail_egl(const char* step) {
    throw MachineError(fmt::format("cannot draw without a display: {} failed (EGL error {:#x})", step,
                                   static_cast<unsigned>(eglGetError())));
}

EGLDisplay surfaceless_display() {
    const auto get_platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_platform_display == nullptr) fail_egl("eglGetPlatformDisplayEXT");
    return get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

EGLConfig choose_config(EGLDisplay display) {
    constexpr EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                     EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, attributes, &config, 1, &count) == EGL_FALSE || count == 0)
        fail_egl("eglChooseConfig");
    return config;
}

EGLContext create_context(EGLDisplay display) {
    constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_CONTEXT_OPENGL_DEBUG,
                                     EGL_TRUE,
                                     EGL_NONE};
    return eglCreateContext(display, choose_config(display), EGL_NO_CONTEXT, attributes);
}

}  // namespace

EglContext::State::State() {
    try {
        open();
    } catch (...) {
        close();
        throw;
    }
}

EglContext::State::~State() {
    close();
}

void EglContext::State::open() {
    display = surfaceless_display();
    if (display == EGL_NO_DISPLAY) fail_egl("eglGetPlatformDisplayEXT");
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) fail_egl("eglInitialize");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail_egl("eglBindAPI");
    context = create_context(display);
    if (context == EGL_NO_CONTEXT) fail_egl("eglCreateContext");
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE)
        fail_egl("eglMakeCurrent");
    if (gladLoadGL(reinterpret_cast<GLADloadfunc>(eglGetProcAddress)) == 0) fail_egl("loading OpenGL 3.3");
    collect_debug_messages();
}

void EglContext::State::close() const {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
    eglReleaseThread();
}

EglContext::EglContext() : state_(std::make_unique<State>()) {}
EglContext::~EglContext() = default;
EglContext::EglContext(EglContext&& other) noexcept = default;
EglContext& EglContext::operator=(EglContext&& other) noexcept = default;

}  // namespace interleaf
