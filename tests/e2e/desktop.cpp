#include "e2e/desktop.h"

#include <span>
#include <stdexcept>

#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#include <glm/common.hpp>

namespace interleaf {

namespace {

struct FreeX {
    void operator()(void* memory) const { XFree(memory); }
};

bool belongs_to(Display* display, Window window, pid_t process) {
    Atom type = None;
    int format = 0;
    unsigned long count = 0;
    unsigned long rest = 0;
    unsigned char* bytes = nullptr;
    const Atom property = XInternAtom(display, "_NET_WM_PID", False);
    XGetWindowProperty(display, window, property, 0, 1, False, XA_CARDINAL, &type, &format, &count, &rest,
                       &bytes);
    const std::unique_ptr<unsigned char, FreeX> owner(bytes);
    // Xlib returns 32-bit values as longs.
    return bytes != nullptr && format == 32 && count == 1 &&
           *reinterpret_cast<const unsigned long*>(bytes) == static_cast<unsigned long>(process);
}

bool is_shown(Display* display, Window window) {
    XWindowAttributes attributes;
    return XGetWindowAttributes(display, window, &attributes) != 0 && attributes.map_state == IsViewable;
}

}  // namespace

void Desktop::CloseDisplay::operator()(_XDisplay* display) const {
    XCloseDisplay(display);
}

Desktop::Desktop() : display_(XOpenDisplay(nullptr)) {
    if (!display_) throw std::runtime_error("the end-to-end tests need an X display");
    // A window may vanish between being listed and being queried.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
}

glm::ivec2 Desktop::screen_size() const {
    const int screen = DefaultScreen(display_.get());
    return {DisplayWidth(display_.get(), screen), DisplayHeight(display_.get(), screen)};
}

WindowName Desktop::window_of(pid_t process) const {
    Window root = None;
    Window parent = None;
    Window* children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display_.get(), DefaultRootWindow(display_.get()), &root, &parent, &children, &count) == 0)
        return None;
    const std::unique_ptr<Window, FreeX> owner(children);
    for (const Window window : std::span(children, count)) {
        if (is_shown(display_.get(), window) && belongs_to(display_.get(), window, process)) return window;
    }
    return None;
}

void Desktop::move_pointer(WindowName window, glm::vec2 at) const {
    int x = 0;
    int y = 0;
    Window child = None;
    const glm::ivec2 pixel(glm::round(at));
    XTranslateCoordinates(display_.get(), window, DefaultRootWindow(display_.get()), pixel.x, pixel.y, &x, &y,
                          &child);
    XTestFakeMotionEvent(display_.get(), -1, x, y, CurrentTime);
    XSync(display_.get(), False);
}

void Desktop::set_button(unsigned button, bool down) const {
    XTestFakeButtonEvent(display_.get(), button, down ? True : False, CurrentTime);
    XSync(display_.get(), False);
}

void Desktop::set_key(KeyName key, bool down) const {
    XTestFakeKeyEvent(display_.get(), XKeysymToKeycode(display_.get(), key), down ? True : False,
                      CurrentTime);
    XSync(display_.get(), False);
}

void Desktop::type(const std::string& text) const {
    // For printable ASCII, the name of a key is the letter.
    for (const char letter : text) {
        const auto name = static_cast<KeyName>(static_cast<unsigned char>(letter));
        const KeyCode code = XKeysymToKeycode(display_.get(), name);
        const bool is_shifted = XkbKeycodeToKeysym(display_.get(), code, 0, 0) != name;
        if (is_shifted) set_key(XK_Shift_L, true);
        set_key(name, true);
        set_key(name, false);
        if (is_shifted) set_key(XK_Shift_L, false);
    }
}

void Desktop::resize(WindowName window, glm::ivec2 size) const {
    XResizeWindow(display_.get(), window, static_cast<unsigned>(size.x), static_cast<unsigned>(size.y));
    XSync(display_.get(), False);
}

std::string Desktop::title(WindowName window) const {
    Atom type = None;
    int format = 0;
    unsigned long count = 0;
    unsigned long rest = 0;
    unsigned char* bytes = nullptr;
    XGetWindowProperty(display_.get(), window, XInternAtom(display_.get(), "_NET_WM_NAME", False), 0, 1024,
                       False, XInternAtom(display_.get(), "UTF8_STRING", False), &type, &format, &count,
                       &rest, &bytes);
    const std::unique_ptr<unsigned char, FreeX> owner(bytes);
    return bytes == nullptr ? "" : std::string(reinterpret_cast<const char*>(bytes), count);
}

Picture Desktop::picture(WindowName window, const Area& area) const {
    XImage* const image = XGetImage(display_.get(), window, area.x, area.y, static_cast<unsigned>(area.width),
                                    static_cast<unsigned>(area.height), AllPlanes, ZPixmap);
    if (image == nullptr) throw std::runtime_error("cannot read the picture of the window");
    Picture pixels;
    pixels.reserve(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
    for (int y = 0; y < area.height; ++y) {
        for (int x = 0; x < area.width; ++x) {
            pixels.push_back(static_cast<std::uint32_t>(XGetPixel(image, x, y) & 0xffffff));
        }
    }
    XDestroyImage(image);
    return pixels;
}

}  // namespace interleaf
