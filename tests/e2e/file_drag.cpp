#include "e2e/file_drag.h"

#include <array>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <fmt/core.h>

namespace interleaf {

namespace {

constexpr long xdnd_version = 5;

/// A list of URIs (RFC 2483). Escapes every byte but letters, digits and a few signs.
std::string uri_list(std::span<const std::filesystem::path> files) {
    std::string list;
    for (const std::filesystem::path& file : files) {
        list += "file://";
        for (const char c : file.string()) {
            const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("/-._~", c);
            list += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
        list += "\r\n";
    }
    return list;
}

class FileDrag {
  public:
    FileDrag(Window target, std::string list) : target_(target), list_(std::move(list)) {
        if (display_ == nullptr) throw std::runtime_error("there is no display to drag on");
        source_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
    }
    ~FileDrag() { XCloseDisplay(display_); }
    FileDrag(const FileDrag&) = delete;
    FileDrag& operator=(const FileDrag&) = delete;

    void drop(glm::ivec2 at) {
        int x = 0;
        int y = 0;
        Window child = None;
        XTranslateCoordinates(display_, target_, DefaultRootWindow(display_), at.x, at.y, &x, &y, &child);
        tell("XdndEnter", {xdnd_version << 24, static_cast<long>(atom("text/uri-list")), None, None});
        tell("XdndPosition",
             {0, static_cast<long>(x) << 16 | y, CurrentTime, static_cast<long>(atom("XdndActionCopy"))});
        const XClientMessageEvent status = answer("XdndStatus");
        if ((status.data.l[1] & 1) == 0) throw std::runtime_error("the window rejects the files");
        tell("XdndDrop", {0, CurrentTime, 0, 0});
        answer("XdndFinished");
    }

  private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    void tell(const char* message, const std::array<long, 4>& data) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(message);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(source_);
        for (std::size_t i = 0; i < data.size(); ++i) event.xclient.data.l[i + 1] = data[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Waits for \p message. Meanwhile, hands out the files when the window asks for them.
    XClientMessageEvent answer(const char* message) const {
        using std::chrono::steady_clock;
        const auto deadline = steady_clock::now() + std::chrono::minutes(1);
        while (steady_clock::now() < deadline) {
            if (XPending(display_) == 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                continue;
            }
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) hand_out(event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(message))
                return event.xclient;
        }
        throw std::runtime_error(fmt::format("the window has not answered with {}", message));
    }

    void hand_out(const XSelectionRequestEvent& request) const {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(list_.data()), static_cast<int>(list_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display* display_ = XOpenDisplay(nullptr);
    Window source_ = None;
    Window target_;
    std::string list_;
};

}  // namespace

void drop_files(WindowName window, glm::ivec2 at, std::span<const std::filesystem::path> files) {
    FileDrag(window, uri_list(files)).drop(at);
}

}  // namespace interleaf
