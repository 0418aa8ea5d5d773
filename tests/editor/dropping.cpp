#include "dropping.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

namespace wrinkle::editor {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds patience(60);  // time limit of a drop

std::string as_uris(const std::vector<std::string>& files) {
    std::string text;
    for (const std::string& file : files) {
        text += "file://";
        for (const char c : file)
            text += c == ' ' ? "%20" : std::string(1, c);
        text += "\r\n";
    }
    return text;
}

class Source {
public:
    explicit Source(const VirtualScreen& screen)
        : display_(XOpenDisplay(screen.variable().substr(8).c_str()), XCloseDisplay) {}

    std::string drop(int x, int y, const std::string& uris) {
        if (!display_) return "no display";
        window_ = XCreateSimpleWindow(get(), root(), 0, 0, 1, 1, 0, 0, 0);
        while (!(target_ = aware(root())))
            if (!rest()) return "no window takes drops";
        XSetSelectionOwner(get(), atom("XdndSelection"), window_, CurrentTime);
        send("XdndEnter", {5L << 24, static_cast<long>(atom("text/uri-list")), 0, 0});
        send("XdndPosition",
             {0, x << 16 | y, CurrentTime, static_cast<long>(atom("XdndActionCopy"))});
        const auto status = answer("XdndStatus", uris);
        if (!status || !(status->data.l[1] & 1)) return "the window does not take files";
        send("XdndDrop", {0, CurrentTime, 0, 0});
        return answer("XdndFinished", uris) ? "" : "the window never finished the drop";
    }

private:
    Display* get() const { return display_.get(); }
    Window root() const { return DefaultRootWindow(get()); }
    Atom atom(const char* name) const { return XInternAtom(get(), name, False); }

    bool rest() const {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return Clock::now() < end_;
    }

    // Returns the window below `parent` that accepts drops; 0 if there is none.
    Window aware(Window parent) const {
        Window ignored = 0, *children = nullptr, found = 0;
        unsigned count = 0;
        XQueryTree(get(), parent, &ignored, &ignored, &children, &count);
        for (unsigned i = 0; i < count && !found; ++i) {
            int formats = 0;
            Atom* properties = XListProperties(get(), children[i], &formats);
            for (int p = 0; p < formats; ++p)
                if (properties[p] == atom("XdndAware")) found = children[i];
            if (properties) XFree(properties);
        }
        if (children) XFree(children);
        return found;
    }

    void send(const char* type, std::array<long, 4> data) const {
        XEvent event = {};
        event.xclient = {.type = ClientMessage,
                         .serial = 0,
                         .send_event = True,
                         .display = get(),
                         .window = target_,
                         .message_type = atom(type),
                         .format = 32,
                         .data = {}};
        event.xclient.data.l[0] = static_cast<long>(window_);
        for (size_t i = 0; i < data.size(); ++i)
            event.xclient.data.l[i + 1] = data[i];
        XSendEvent(get(), target_, False, NoEventMask, &event);
        XFlush(get());
    }

    // Returns the window's next message of this type; std::nullopt after the time limit. Sends the
    // files if the window requests them meanwhile.
    std::optional<XClientMessageEvent> answer(const char* type, const std::string& uris) const {
        do {
            while (XPending(get()) > 0) {
                XEvent event;
                XNextEvent(get(), &event);
                if (event.type == SelectionRequest) hand_over(event.xselectionrequest, uris);
                if (event.type == ClientMessage && event.xclient.message_type == atom(type))
                    return event.xclient;
            }
        } while (rest());
        return std::nullopt;
    }

    void hand_over(const XSelectionRequestEvent& asked, const std::string& uris) const {
        XChangeProperty(get(), asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uris.data()),
                        static_cast<int>(uris.size()));
        XEvent event = {};
        event.xselection = {.type = SelectionNotify,
                            .serial = 0,
                            .send_event = True,
                            .display = get(),
                            .requestor = asked.requestor,
                            .selection = asked.selection,
                            .target = asked.target,
                            .property = asked.property,
                            .time = asked.time};
        XSendEvent(get(), asked.requestor, False, NoEventMask, &event);
        XFlush(get());
    }

    std::unique_ptr<Display, decltype(&XCloseDisplay)> display_;
    Window window_ = 0, target_ = 0;
    Clock::time_point end_ = Clock::now() + patience;
};

}  // namespace

std::string drop_files(const VirtualScreen& screen, int x, int y,
                       const std::vector<std::string>& files) {
    return Source(screen).drop(x, y, as_uris(files));
}

}  // namespace wrinkle::editor
