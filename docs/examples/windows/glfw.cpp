// A scene at two times in the two halves of a window of GLFW, beside what the program draws itself.
//   glfw SCENE.glib [FRAMES]
#define GLFW_INCLUDE_GLCOREARB
#define GL_GLEXT_PROTOTYPES
#include <GLFW/glfw3.h>
#include <glibra/glibra.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc < 2 || !glfwInit()) return 2;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    GLFWwindow* window = glfwCreateWindow(640, 360, "Two times", nullptr, nullptr);
    if (window == nullptr) return std::fputs("no window with OpenGL 4.1\n", stderr), 4;
    glfwMakeContextCurrent(window);

    glibra::Result<glibra::Renderer> renderer = glibra::Renderer::open(glibra::Renderer::current());
    if (!renderer) return std::fprintf(stderr, "%s\n", renderer.message().c_str()), 4;
    glibra::Result<glibra::Scene> scene = renderer->load(argv[1]);
    if (!scene) return std::fprintf(stderr, "%s\n", scene.message().c_str()), 3;

    long left = argc > 2 ? std::atol(argv[2]) : -1;
    for (; left != 0 && !glfwWindowShouldClose(window); --left) {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        // What the program draws itself: here nothing but a colour. It sets what it needs, since the library
        // has its own state.
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glClearColor(.1f, .3f, .2f, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const int side = width / 2 - 16;
        for (int half = 0; half < 2 && side > 0 && height > 16; ++half) {
            const glibra::Surface surface{
                .x = 8 + half * width / 2, .y = 8, .width = side, .height = height - 16};
            const auto drawn = scene->drawInto(surface, {.time = glfwGetTime() + half, .samples = 4});
            if (!drawn) return std::fprintf(stderr, "%s\n", drawn.message().c_str()), 3;
        }
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    glfwTerminate();
}
