// Drags files onto a window and drops them, as a file manager does: the source side of the XDND protocol,
// version 5 (https://freedesktop.org/wiki/Specifications/XDND).
//
//     drop_files WINDOW URI...
// Exits with 0 when the window reports that it is done, and with 1 and a message if it refuses or does not
// answer.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;
constexpr long kVersion = 5;
constexpr std::chrono::seconds kPatience{60};
constexpr int kInside = 20;  ///< pixels from the window's corner to the drop position

class Source {
  public:
    Source(Display& display, Window target, std::string uris)
        : display_(display),
          target_(target),
          uris_(std::move(uris)),
          window_(XCreateSimpleWindow(&display, DefaultRootWindow(&display), 0, 0, 1, 1, 0, 0, 0)) {}

    void drag() {
        XSetSelectionOwner(&display_, atom("XdndSelection"), window_, CurrentTime);
        int x = 0;
        int y = 0;
        Window child = 0;
        XTranslateCoordinates(&display_, target_, DefaultRootWindow(&display_), kInside, kInside, &x, &y,
                              &child);
        send("XdndEnter", {kVersion << 24, number("text/uri-list")});
        send("XdndPosition", {0, static_cast<long>(x) << 16 | y, CurrentTime, number("XdndActionCopy")});
        if ((await("XdndStatus").data.l[1] & 1) == 0)
            throw std::runtime_error("the window refuses the files");
        send("XdndDrop", {0, CurrentTime});
        await("XdndFinished");
    }

  private:
    Atom atom(const char* name) { return XInternAtom(&display_, name, False); }
    long number(const char* name) { return static_cast<long>(atom(name)); }

    void send(const char* kind, const std::array<long, 4>& numbers) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(kind);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(window_);
        for (std::size_t i = 0; i < numbers.size(); ++i) event.xclient.data.l[i + 1] = numbers[i];
        XSendEvent(&display_, target_, False, NoEventMask, &event);
        XFlush(&display_);
    }

    /// Waits for the window's message of that kind, and meanwhile sends the data that the window requests.
    XClientMessageEvent await(const char* kind) {
        const Clock::time_point end = Clock::now() + kPatience;
        while (Clock::now() < end) {
            while (XPending(&display_) > 0) {
                XEvent event{};
                XNextEvent(&display_, &event);
                if (event.type == SelectionRequest) give(event.xselectionrequest);
                if (event.type == ClientMessage && event.xclient.message_type == atom(kind))
                    return event.xclient;
            }
            pollfd connection{ConnectionNumber(&display_), POLLIN, 0};
            poll(&connection, 1, 100);
        }
        throw std::runtime_error(std::string("the window sent no ") + kind);
    }

    void give(const XSelectionRequestEvent& request) {
        const bool isKnown = request.target == atom("text/uri-list");
        if (isKnown)
            XChangeProperty(&display_, request.requestor, request.property, request.target, 8,
                            PropModeReplace, reinterpret_cast<const unsigned char*>(uris_.data()),
                            static_cast<int>(uris_.size()));
        XEvent answer{};
        answer.xselection.type = SelectionNotify;
        answer.xselection.requestor = request.requestor;
        answer.xselection.selection = request.selection;
        answer.xselection.target = request.target;
        answer.xselection.property = isKnown ? request.property : None;
        answer.xselection.time = request.time;
        XSendEvent(&display_, request.requestor, False, NoEventMask, &answer);
        XFlush(&display_);
    }

    Display& display_;
    Window target_;
    std::string uris_;
    Window window_;
};

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 3) throw std::runtime_error("drop_files WINDOW URI...");
        const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr), XCloseDisplay);
        if (!display) throw std::runtime_error("no display");
        std::string uris;
        for (int i = 2; i < argc; ++i) uris += std::string(argv[i]) + "\r\n";
        Source(*display, std::strtoul(argv[1], nullptr, 0), std::move(uris)).drag();
        return 0;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "drop_files: %s\n", failure.what());
        return 1;
    }
}
