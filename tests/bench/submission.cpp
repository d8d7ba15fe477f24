// The paths by which vertices reach OpenGL, in a compatibility profile where all of them exist:
// glBegin/glEnd, a display list, client arrays, buffers, and VertexArray with and without its buffer objects,
// with and without collapsed vertices; the book's grid as one strip; the time to collapse, hashed and all
// pairs; a uniform by name with cached locations and without. For the figures of docs/classic.md.

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <glibra/classic/classic.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "classic/vertex_lists.h"

namespace {

using namespace glibra::classic;

void openCompatibilityContext() {
    const auto platformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display = platformDisplay != nullptr
                             ? platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                             : EGL_NO_DISPLAY;
    const EGLint wanted[] = {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                             EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (eglInitialize(display, nullptr, nullptr) == EGL_TRUE && eglBindAPI(EGL_OPENGL_API) == EGL_TRUE)
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE &&
        context != EGL_NO_CONTEXT)
        return;
    std::fputs("no compatibility profile without a surface\n", stderr);
    std::exit(4);
}

/// The median of several runs in milliseconds; each run ends when the driver has done all.
double milliseconds(const std::function<void()>& run) {
    std::vector<double> times;
    const auto begin = std::chrono::steady_clock::now();
    while (times.size() < 5 ||
           (times.size() < 200 && std::chrono::steady_clock::now() - begin < std::chrono::seconds(1))) {
        const auto start = std::chrono::steady_clock::now();
        run();
        glFinish();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                     times.end());
    return times[times.size() / 2];
}

/// A grid of side x side cells as separate triangles: six vertices of which one remains per cell.
std::vector<float> gridTriangles(int side) {
    std::vector<float> places;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
                for (const float each : {2 * static_cast<float>(column + x) / static_cast<float>(side) - 1,
                                         2 * static_cast<float>(row + y) / static_cast<float>(side) - 1, 0.F})
                    places.push_back(each);
    return places;
}

template <class Target>
void give(Target&& vertex, const std::vector<float>& places) {
    for (std::size_t i = 0; i < places.size(); i += 3) vertex(&places[i]);
}

VertexArray arrayOf(const std::vector<float>& places, bool collapses, bool buffers) {
    VertexArray array;
    array.CollapseCommonVertices(collapses);
    array.UseBufferObjects(buffers);
    array.glBegin(GL_TRIANGLES);
    give([&](const float* at) { array.glVertex3fv(at); }, places);
    array.glEnd();
    return array;
}

void submission() {
    std::puts(
        "vertices | glBegin/glEnd | display list | client array | buffer | VertexArray | collapsed | without "
        "buffer objects (ms)");
    for (const int side : {41, 129, 408, 1291}) {
        const std::vector<float> places = gridTriangles(side);
        const auto count = static_cast<GLsizei>(places.size() / 3);
        std::printf("%d", static_cast<int>(count));
        const auto immediate = [&] {
            ::glBegin(GL_TRIANGLES);
            give([](const float* at) { ::glVertex3fv(at); }, places);
            ::glEnd();
        };
        std::printf(" | %.3f", milliseconds(immediate));
        const GLuint list = glGenLists(1);
        glNewList(list, GL_COMPILE);
        immediate();
        glEndList();
        std::printf(" | %.3f", milliseconds([&] { glCallList(list); }));
        glDeleteLists(list, 1);
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, places.data());
        std::printf(" | %.3f", milliseconds([&] { glDrawArrays(GL_TRIANGLES, 0, count); }));
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(float)), places.data(),
                     GL_STATIC_DRAW);
        glVertexPointer(3, GL_FLOAT, 0, nullptr);
        std::printf(" | %.3f", milliseconds([&] { glDrawArrays(GL_TRIANGLES, 0, count); }));
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glDeleteBuffers(1, &buffer);
        glDisableClientState(GL_VERTEX_ARRAY);
        VertexArray plain = arrayOf(places, false, true);
        std::printf(" | %.3f", milliseconds([&] { plain.Draw(); }));
        VertexArray collapsed = arrayOf(places, true, true);
        std::printf(" | %.3f", milliseconds([&] { collapsed.Draw(); }));
        VertexArray streamed = arrayOf(places, false, false);
        std::printf(" | %.3f\n", milliseconds([&] { streamed.Draw(); }));
    }
}

void grid() {
    VertexArray strip;
    strip.CollapseCommonVertices(true);
    strip.glBegin(GL_TRIANGLE_STRIP);
    for (int row = 0; row < 568; ++row) {
        strip.RestartPrimitive();
        for (int column = 0; column < 1024; ++column)
            for (const int up : {1, 0})
                strip.glVertex3f(2 * static_cast<float>(column) / 1023 - 1,
                                 2 * static_cast<float>(row + up) / 568 - 1, 0);
    }
    strip.glEnd();
    const double time = milliseconds([&] { strip.Draw(); });
    std::printf("grid of 1024 x 569 as one strip: %.2f ms, %.1f frames per second\n", time, 1000 / time);
}

/// The collapse that compares each vertex with all that were kept.
std::size_t allPairs(const std::vector<float>& places, float tolerance) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < places.size(); i += 3) {
        const bool isKnown = std::any_of(kept.begin(), kept.end(), [&](std::size_t each) {
            return std::abs(places[i] - places[each]) <= tolerance &&
                   std::abs(places[i + 1] - places[each + 1]) <= tolerance &&
                   std::abs(places[i + 2] - places[each + 2]) <= tolerance;
        });
        if (!isKnown) kept.push_back(i);
    }
    return kept.size();
}

void collapsing() {
    std::puts("\nvertices | unique | hashed, tolerance 0 | hashed, tolerance 1e-5 | all pairs (ms)");
    for (const int side : {13, 41, 129, 408}) {
        const std::vector<float> places = gridTriangles(side);
        VertexLists lists;
        give([&](const float* at) { lists.add({at[0], at[1], at[2], 1}, 3); }, places);
        std::size_t unique = 0;
        const double exact = milliseconds([&] { unique = collapse(lists, 0).count; });
        const double near = milliseconds([&] { unique = collapse(lists, 1e-5F).count; });
        std::printf("%zu | %zu | %.3f | %.3f", lists.count(), unique, exact, near);
        if (side < 200)
            std::printf(" | %.1f\n", milliseconds([&] { unique = allPairs(places, 1e-5F); }));
        else
            std::puts(" | -");
    }
}

void locations() {
    GLSLProgram program;
    if (!program.CreateFromText({{"p.vert", "void main() { gl_Position = aVertex; }\n"},
                                 {"p.frag",
                                  "uniform float uA, uB, uC, uD, uE, uF, uG, uH; out vec4 c;\n"
                                  "void main() { c = vec4(uA + uB, uC + uD, uE + uF, uG + uH); }\n"}}))
        std::exit(3);
    program.Use();
    constexpr int kCalls = 100000;
    const double asked = milliseconds([&] {
        for (int i = 0; i < kCalls; ++i)
            glUniform1f(glGetUniformLocation(program.Id(), "uF"), static_cast<float>(i & 7));
    });
    const double known = milliseconds([&, location = glGetUniformLocation(program.Id(), "uF")] {
        for (int i = 0; i < kCalls; ++i) glUniform1f(location, static_cast<float>(i & 7));
    });
    const double classic = milliseconds([&] {
        for (int i = 0; i < kCalls; ++i) program.SetUniform("uF", static_cast<float>(i & 7));
    });
    std::printf("\nns per uniform: asked by name %.0f, location known %.0f, GLSLProgram::SetUniform %.0f\n",
                asked * 1e6 / kCalls, known * 1e6 / kCalls, classic * 1e6 / kCalls);
}

}  // namespace

int main() {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    openCompatibilityContext();
    std::printf("%s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    GLuint framebuffer = 0;
    GLuint pixels = 0;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(1, &pixels);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, pixels);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 64, 64);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
    glViewport(0, 0, 64, 64);
    // One program for all paths; in a compatibility profile gl_Vertex and attribute 0 are the same.
    GLSLProgram program;
    if (!program.CreateFromText(
            {{"s.vert",
              "#version 410\nlayout(location = 0) in vec4 aVertex; void main() { gl_Position = aVertex; }\n"},
             {"s.frag", "#version 410\nout vec4 c; void main() { c = vec4(1.); }\n"}}))
        return 3;
    program.Use();
    grid();
    collapsing();
    locations();
    submission();
}
