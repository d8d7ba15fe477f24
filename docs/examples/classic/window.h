#pragma once
// The window of the examples: OpenGL 4.1 core. With a number as its argument a program ends after so many
// frames.

#include <GLFW/glfw3.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

class Window {
  public:
    Window(const char* title, int argc, char** argv) : frames_(argc > 1 ? std::atol(argv[1]) : -1) {
        if (!glfwInit()) return;
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        window_ = glfwCreateWindow(600, 600, title, nullptr, nullptr);
        if (window_ == nullptr) return;
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(frames_ < 0 ? 1 : 0);
        glEnable(GL_DEPTH_TEST);
        begin_ = glfwGetTime();
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window() { glfwTerminate(); }
    explicit operator bool() const { return window_ != nullptr; }

    /// Shows what was drawn, and begins the next frame; false at the end.
    bool next() {
        glfwPollEvents();
        if (glfwGetKey(window_, GLFW_KEY_ESCAPE) == GLFW_PRESS) glfwSetWindowShouldClose(window_, GLFW_TRUE);
        if (drawn_ == frames_ || glfwWindowShouldClose(window_)) {
            report();
            return false;
        }
        if (drawn_ > 0) glfwSwapBuffers(window_);
        if (++drawn_ == 2) second_ = glfwGetTime();
        glfwGetFramebufferSize(window_, &width_, &height_);
        glViewport(0, 0, width_, height_);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        return true;
    }
    float aspect() const {
        return static_cast<float>(width_) / static_cast<float>(height_ > 0 ? height_ : 1);
    }
    float seconds() const { return static_cast<float>(glfwGetTime() - begin_); }
    bool isPressed(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

  private:
    /// Frames per second, and how much of the window is not black.
    void report() const {
        std::vector<unsigned char> pixels(static_cast<std::size_t>(width_) *
                                          static_cast<std::size_t>(height_) * 4);
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        std::size_t drawn = 0;
        for (std::size_t i = 0; i < pixels.size(); i += 4)
            if (pixels[i] + pixels[i + 1] + pixels[i + 2] > 0) ++drawn;
        std::printf("%.1f frames per second; %.0f %% of the window drawn\n",
                    static_cast<double>(drawn_ - 1) / (glfwGetTime() - second_),
                    100.0 * static_cast<double>(drawn) / static_cast<double>(pixels.size() / 4));
    }

    GLFWwindow* window_ = nullptr;
    long frames_;
    long drawn_ = 0;
    int width_ = 600;
    int height_ = 600;
    double begin_ = 0;
    double second_ = 0;  // when the second frame began: the first one also compiles and copies
};
