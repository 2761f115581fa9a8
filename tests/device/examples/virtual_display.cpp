#include "virtual_display.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <thread>

struct VirtualDisplay::Connection {
    Display* display;

    explicit Connection(const std::string& name) : display(XOpenDisplay(name.c_str())) {
        if (!display) throw std::runtime_error("no connection to Xvfb " + name);
        XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });  // windows may disappear at any time
    }
    ~Connection() { XCloseDisplay(display); }
    Connection(const Connection&) = delete;

    void done() const { XSync(display, False); }
    Atom atom(const char* name) const { return XInternAtom(display, name, False); }
    void set_state(unsigned long window, long state) const {  // as window managers do
        const long values[] = {state, None};
        XChangeProperty(display, window, atom("WM_STATE"), atom("WM_STATE"), 32, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(values), 2);
        done();
    }
};

namespace {

/// The display's number, which Xvfb chooses and writes to the pipe.
std::string number_from(int pipe) {
    std::string text;
    char letter = 0;
    while (read(pipe, &letter, 1) == 1 && letter != '\n') text += letter;
    if (text.empty()) throw std::runtime_error("Xvfb does not start; tools/setup installs it");
    return text;
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("no process can be started");
    if (process_ == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // Xvfb ends also if the test is killed
        close(ends[0]);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        execlp("Xvfb", "Xvfb", "-displayfd", std::to_string(ends[1]).c_str(), "-screen", "0", "1000x700x24",
               "-nolisten", "tcp", static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    name_ = ":" + number_from(ends[0]);
    close(ends[0]);
    connection_ = new Connection(name_);
}

VirtualDisplay::~VirtualDisplay() { end(); }

void VirtualDisplay::end() {
    delete connection_;
    connection_ = nullptr;
    if (process_ == 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = 0;
}

bool VirtualDisplay::has_window(const std::string& title) {
    Display* display = connection_->display;
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (!XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count)) return false;
    bool found = false;
    for (unsigned i = 0; i < count; ++i) {
        char* name = nullptr;
        if (!XFetchName(display, children[i], &name) || !name) continue;
        if (name == title) {
            found = true;
            window_ = children[i];
        }
        XFree(name);
    }
    if (children) XFree(children);
    return found;
}

Seen VirtualDisplay::seen() const {
    XWindowAttributes window;
    if (!XGetWindowAttributes(connection_->display, window_, &window)) return {};
    Seen seen{static_cast<std::uint32_t>(window.width), static_cast<std::uint32_t>(window.height), {}};
    XImage* image = XGetImage(connection_->display, window_, 0, 0, seen.width, seen.height, AllPlanes, ZPixmap);
    if (!image) return {};
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            const unsigned long pixel = XGetPixel(image, x, y);
            seen.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
                                   static_cast<std::uint8_t>(pixel)});
        }
    XDestroyImage(image);
    return seen;
}

void VirtualDisplay::move_to(int x, int y) const {
    XWarpPointer(connection_->display, None, window_, 0, 0, 0, 0, x, y);
    connection_->done();
}

void VirtualDisplay::press(unsigned button) const {
    XTestFakeButtonEvent(connection_->display, button, True, CurrentTime);
    connection_->done();
}

void VirtualDisplay::release(unsigned button) const {
    XTestFakeButtonEvent(connection_->display, button, False, CurrentTime);
    connection_->done();
}

void VirtualDisplay::type(const std::string& key) const {
    Display* display = connection_->display;
    XSetInputFocus(display, window_, RevertToPointerRoot, CurrentTime);
    const KeyCode code = XKeysymToKeycode(display, XStringToKeysym(key.c_str()));
    XTestFakeKeyEvent(display, code, True, CurrentTime);
    XTestFakeKeyEvent(display, code, False, CurrentTime);
    connection_->done();
    // GLFW drops a press of a key whose time stamp, in milliseconds, is that of the key's press before it.
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

void VirtualDisplay::resize(unsigned width, unsigned height) const {
    XResizeWindow(connection_->display, window_, width, height);
    connection_->done();
}

void VirtualDisplay::minimise() const {
    connection_->set_state(window_, IconicState);
    XUnmapWindow(connection_->display, window_);
    connection_->done();
}

void VirtualDisplay::restore() const {
    XMapWindow(connection_->display, window_);
    connection_->set_state(window_, NormalState);
}

void VirtualDisplay::ask_to_close() const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window_;
    event.xclient.message_type = connection_->atom("WM_PROTOCOLS");
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(connection_->atom("WM_DELETE_WINDOW"));
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(connection_->display, window_, False, NoEventMask, &event);
    connection_->done();
}
