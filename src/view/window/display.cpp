#include "view/window/display.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

namespace glibra::view {

struct Display::Events {
    bool active = true;
    std::vector<std::filesystem::path> dropped;
    std::vector<KeyEvent> keys;
};

namespace {

constexpr std::array<std::pair<int, int>, 6> kVersions{{{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}}};
constexpr double kUsualRefreshRate = 60;

std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "unknown reason";
}

}  // namespace

Result<Display> Display::open(int width, int height, const std::string& title) {
    if (glfwInit() == GLFW_FALSE)
        return error("view-E02", "no display to open a window on (" + lastError() +
                                     "); `glibra render SCENE` makes a picture without one");
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    GLFWwindow* window = nullptr;
    for (const auto& [major, minor] : kVersions) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        if (window) break;
    }
    if (!window) {
        const std::string why = lastError();
        glfwTerminate();
        return error("view-E02", "no window with OpenGL 4.1 or later can be opened (" + why +
                                     "); `glibra render SCENE` makes a picture without one");
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    auto events = std::make_unique<Events>();
    glfwSetWindowUserPointer(window, events.get());
    const auto active = [](GLFWwindow* at) {
        static_cast<Events*>(glfwGetWindowUserPointer(at))->active = true;
    };
    glfwSetWindowRefreshCallback(window, active);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* at, int, int) {
        static_cast<Events*>(glfwGetWindowUserPointer(at))->active = true;
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* at, double, double) {
        static_cast<Events*>(glfwGetWindowUserPointer(at))->active = true;
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* at, int, int, int) {
        static_cast<Events*>(glfwGetWindowUserPointer(at))->active = true;
    });
    glfwSetScrollCallback(window, [](GLFWwindow* at, double, double) {
        static_cast<Events*>(glfwGetWindowUserPointer(at))->active = true;
    });
    glfwSetKeyCallback(window, [](GLFWwindow* at, int key, int, int action, int) {
        auto& all = *static_cast<Events*>(glfwGetWindowUserPointer(at));
        all.active = true;
        if (action != GLFW_REPEAT) all.keys.push_back({key, action == GLFW_PRESS, 0});
    });
    glfwSetCharCallback(window, [](GLFWwindow* at, unsigned int character) {
        auto& all = *static_cast<Events*>(glfwGetWindowUserPointer(at));
        all.active = true;
        all.keys.push_back({0, true, character});
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* at, int) {
        static_cast<Events*>(glfwGetWindowUserPointer(at))->active = true;
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* at, int) {
        static_cast<Events*>(glfwGetWindowUserPointer(at))->active = true;
    });
    glfwSetDropCallback(window, [](GLFWwindow* at, int count, const char** paths) {
        auto& all = *static_cast<Events*>(glfwGetWindowUserPointer(at));
        all.active = true;
        all.dropped.insert(all.dropped.end(), paths, paths + count);
    });
    return Display(window, std::move(events));
}

Display::Display(GLFWwindow* window, std::unique_ptr<Events> events)
    : window_(window), events_(std::move(events)) {}
Display::Display(Display&& other) noexcept
    : window_(std::exchange(other.window_, nullptr)), events_(std::move(other.events_)) {}
Display& Display::operator=(Display&& other) noexcept {
    std::swap(window_, other.window_);
    std::swap(events_, other.events_);
    return *this;
}
Display::~Display() {
    if (!window_) return;
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void* Display::address(const char* function) {
    return reinterpret_cast<void*>(glfwGetProcAddress(function));
}

bool Display::isOpen() const {
    return glfwWindowShouldClose(window_) == GLFW_FALSE;
}
void Display::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}
void Display::keepOpen() {
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
}
void Display::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}
void Display::setSize(int width, int height) {
    glfwSetWindowSize(window_, std::max(1, width), std::max(1, height));
}
std::pair<int, int> Display::size() const {
    std::pair<int, int> size;
    glfwGetWindowSize(window_, &size.first, &size.second);
    return size;
}
std::pair<int, int> Display::framebufferSize() const {
    std::pair<int, int> size;
    glfwGetFramebufferSize(window_, &size.first, &size.second);
    return size;
}
float Display::contentScale() const {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(x, .5F, 8.F);
}
double Display::refreshRate() const {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    return mode && mode->refreshRate > 0 ? mode->refreshRate : kUsualRefreshRate;
}

bool Display::hasSwapControl() {
    constexpr std::array<const char*, 3> kExtensions{"GLX_EXT_swap_control", "GLX_MESA_swap_control",
                                                     "GLX_SGI_swap_control"};
    return std::any_of(kExtensions.begin(), kExtensions.end(),
                       [](const char* each) { return glfwExtensionSupported(each) == GLFW_TRUE; });
}

void Display::present() {
    glfwSwapBuffers(window_);
}
void Display::takeEvents(double seconds) {
    if (seconds < 0)
        glfwWaitEvents();
    else if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}
void Display::wake() {
    glfwPostEmptyEvent();
}
bool Display::takeActivity() {
    return std::exchange(events_->active, false);
}
std::vector<Display::KeyEvent> Display::takeKeyEvents() {
    return std::exchange(events_->keys, {});
}
std::vector<std::filesystem::path> Display::takeDropped() {
    return std::exchange(events_->dropped, {});
}

}  // namespace glibra::view
