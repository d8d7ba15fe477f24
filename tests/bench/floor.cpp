// The floor: the least that a program can do to draw one lit sphere into a PNG, without any code of glibra.
// EGL without a surface, one program, one draw, one readback, one file.
// Use: floor OUT.png [SIDE [FRAMES]]. With several frames, all are drawn and read back and the last one is
// written: the cost of an animation without its encoding.
//
// The sphere has 60 x 60 cells and the vertices of the language's Sphere: south pole at t = 0, seam at -x,
// one vertex per slice at each pole. Needs libEGL and libdeflate.

#define EGL_NO_X11
#include <EGL/egl.h>
#include <GL/glcorearb.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bare/context.h"
#include "bare/png_file.h"

namespace {

constexpr int kSide = 600;
constexpr int kSlices = 60;
constexpr int kStacks = 60;
constexpr double kPi = 3.14159265358979323846;

constexpr const char* kVertexShader = R"(#version 450 core
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 0) uniform mat4 uProjection;
layout(location = 1) uniform mat4 uModelView;
out vec3 vNormal;
out vec3 vPosition;
void main() {
    vec4 eye = uModelView * vec4(aPosition, 1);
    vNormal = mat3(uModelView) * aNormal;
    vPosition = eye.xyz;
    gl_Position = uProjection * eye;
}
)";

constexpr const char* kFragmentShader = R"(#version 450 core
in vec3 vNormal;
in vec3 vPosition;
out vec4 fColor;
layout(location = 2) uniform float uTimer;
const vec3 kLight = vec3(3, 5, 10);
const vec3 kOrange = vec3(1, .5, 0);
void main() {
    float diffuse = max(0., dot(normalize(vNormal), normalize(kLight - vPosition)));
    fColor = vec4((1. - .5 * uTimer) * (.2 + .8 * diffuse) * kOrange, 1);
}
)";

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "floor: %s\n", what);
    std::exit(1);
}

template <class Function>
void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(eglGetProcAddress(name));
    if (!function) fail(name);
}

struct Vertex {
    float position[3];
    float normal[3];
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> indices;
};

Mesh sphere() {
    Mesh mesh;
    mesh.vertices.reserve(std::size_t{kSlices + 1} * (kStacks - 1) + std::size_t{2} * kSlices);
    mesh.indices.reserve(std::size_t{6} * kSlices * (kStacks - 1));
    const auto add = [&](double cosineS, double sineS, double cosineT, double sineT) {
        const float x = static_cast<float>(-cosineS * cosineT);
        const float y = static_cast<float>(sineT);
        const float z = static_cast<float>(sineS * cosineT);
        mesh.vertices.push_back({{x, y, z}, {x, y, z}});
    };
    for (int i = 0; i < kSlices; ++i) add(1, 0, 0, -1);
    std::vector<double> cosine(kSlices + 1);
    std::vector<double> sine(kSlices + 1);
    for (int i = 0; i <= kSlices; ++i) {
        const double angle = 2 * kPi * (i % kSlices) / kSlices;
        cosine[static_cast<std::size_t>(i)] = std::cos(angle);
        sine[static_cast<std::size_t>(i)] = std::sin(angle);
    }
    for (int j = 1; j < kStacks; ++j) {
        const double f = kPi * (static_cast<double>(j) / kStacks - .5);
        const double cosineT = std::cos(f);
        const double sineT = std::sin(f);
        for (std::size_t i = 0; i <= kSlices; ++i) add(cosine[i], sine[i], cosineT, sineT);
    }
    for (int i = 0; i < kSlices; ++i) add(1, 0, 0, 1);

    const auto triangle = [&](int a, int b, int c) {
        for (const int each : {a, b, c}) mesh.indices.push_back(static_cast<std::uint16_t>(each));
    };
    const auto ring = [](int j, int i) { return kSlices + (j - 1) * (kSlices + 1) + i; };
    const int north = kSlices + (kStacks - 1) * (kSlices + 1);
    for (int i = 0; i < kSlices; ++i) triangle(i, ring(1, i + 1), ring(1, i));
    for (int j = 1; j < kStacks - 1; ++j)
        for (int i = 0; i < kSlices; ++i) {
            triangle(ring(j, i), ring(j, i + 1), ring(j + 1, i + 1));
            triangle(ring(j, i), ring(j + 1, i + 1), ring(j + 1, i));
        }
    for (int i = 0; i < kSlices; ++i) triangle(ring(kStacks - 1, i), ring(kStacks - 1, i + 1), north + i);
    return mesh;
}

/// Draws into an RGBA picture of `side` x `side` pixels, bottom row first; keeps the last of several frames.
std::vector<std::uint8_t> draw(const Mesh& mesh, int side, int frames) {
    PFNGLCREATESHADERPROC createShader;
    PFNGLSHADERSOURCEPROC shaderSource;
    PFNGLCOMPILESHADERPROC compileShader;
    PFNGLCREATEPROGRAMPROC createProgram;
    PFNGLATTACHSHADERPROC attachShader;
    PFNGLLINKPROGRAMPROC linkProgram;
    PFNGLGETPROGRAMIVPROC getProgramiv;
    PFNGLUSEPROGRAMPROC useProgram;
    PFNGLUNIFORMMATRIX4FVPROC uniformMatrix4fv;
    PFNGLUNIFORM1FPROC uniform1f;
    PFNGLGENVERTEXARRAYSPROC genVertexArrays;
    PFNGLBINDVERTEXARRAYPROC bindVertexArray;
    PFNGLGENBUFFERSPROC genBuffers;
    PFNGLBINDBUFFERPROC bindBuffer;
    PFNGLBUFFERDATAPROC bufferData;
    PFNGLVERTEXATTRIBPOINTERPROC vertexAttribPointer;
    PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray;
    PFNGLGENFRAMEBUFFERSPROC genFramebuffers;
    PFNGLBINDFRAMEBUFFERPROC bindFramebuffer;
    PFNGLGENRENDERBUFFERSPROC genRenderbuffers;
    PFNGLBINDRENDERBUFFERPROC bindRenderbuffer;
    PFNGLRENDERBUFFERSTORAGEPROC renderbufferStorage;
    PFNGLFRAMEBUFFERRENDERBUFFERPROC framebufferRenderbuffer;
    PFNGLVIEWPORTPROC viewport;
    PFNGLENABLEPROC enable;
    PFNGLCLEARCOLORPROC clearColor;
    PFNGLCLEARPROC clear;
    PFNGLDRAWELEMENTSPROC drawElements;
    PFNGLREADPIXELSPROC readPixels;
    load(createShader, "glCreateShader");
    load(shaderSource, "glShaderSource");
    load(compileShader, "glCompileShader");
    load(createProgram, "glCreateProgram");
    load(attachShader, "glAttachShader");
    load(linkProgram, "glLinkProgram");
    load(getProgramiv, "glGetProgramiv");
    load(useProgram, "glUseProgram");
    load(uniformMatrix4fv, "glUniformMatrix4fv");
    load(uniform1f, "glUniform1f");
    load(genVertexArrays, "glGenVertexArrays");
    load(bindVertexArray, "glBindVertexArray");
    load(genBuffers, "glGenBuffers");
    load(bindBuffer, "glBindBuffer");
    load(bufferData, "glBufferData");
    load(vertexAttribPointer, "glVertexAttribPointer");
    load(enableVertexAttribArray, "glEnableVertexAttribArray");
    load(genFramebuffers, "glGenFramebuffers");
    load(bindFramebuffer, "glBindFramebuffer");
    load(genRenderbuffers, "glGenRenderbuffers");
    load(bindRenderbuffer, "glBindRenderbuffer");
    load(renderbufferStorage, "glRenderbufferStorage");
    load(framebufferRenderbuffer, "glFramebufferRenderbuffer");
    load(viewport, "glViewport");
    load(enable, "glEnable");
    load(clearColor, "glClearColor");
    load(clear, "glClear");
    load(drawElements, "glDrawElements");
    load(readPixels, "glReadPixels");

    const GLuint program = createProgram();
    const auto addStage = [&](GLenum stage, const char* text) {
        const GLuint shader = createShader(stage);
        shaderSource(shader, 1, &text, nullptr);
        compileShader(shader);
        attachShader(program, shader);
    };
    addStage(GL_VERTEX_SHADER, kVertexShader);
    addStage(GL_FRAGMENT_SHADER, kFragmentShader);
    linkProgram(program);
    GLint linked = 0;
    getProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) fail("the program does not link");

    GLuint framebuffer = 0;
    GLuint storage[2]{};
    genFramebuffers(1, &framebuffer);
    bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    genRenderbuffers(2, storage);
    bindRenderbuffer(GL_RENDERBUFFER, storage[0]);
    renderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, side, side);
    framebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage[0]);
    bindRenderbuffer(GL_RENDERBUFFER, storage[1]);
    renderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, side, side);
    framebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, storage[1]);

    GLuint vertexArray = 0;
    GLuint buffers[2]{};
    genVertexArrays(1, &vertexArray);
    bindVertexArray(vertexArray);
    genBuffers(2, buffers);
    bindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
    bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    bufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint16_t)),
               mesh.indices.data(), GL_STATIC_DRAW);
    vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    vertexAttribPointer(
        1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
        reinterpret_cast<const void*>(offsetof(Vertex, normal)));  // NOLINT(performance-no-int-to-ptr)
    enableVertexAttribArray(0);
    enableVertexAttribArray(1);

    // 50 degrees, near .1, far 1000, square; the eye at (0, 0, 3).
    const float f = static_cast<float>(1 / std::tan(25 * kPi / 180));
    const float a = static_cast<float>((1000. + .1) / (.1 - 1000.));
    const float b = static_cast<float>(2 * 1000. * .1 / (.1 - 1000.));
    const float projection[16] = {f, 0, 0, 0, 0, f, 0, 0, 0, 0, a, -1, 0, 0, b, 0};
    const float modelView[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -3, 1};
    useProgram(program);
    uniformMatrix4fv(0, 1, GL_FALSE, projection);
    uniformMatrix4fv(1, 1, GL_FALSE, modelView);

    viewport(0, 0, side, side);
    enable(GL_DEPTH_TEST);
    clearColor(18 / 255.F, 27 / 255.F, 33 / 255.F, 1);
    std::vector<std::uint8_t> pixels(std::size_t{4} * static_cast<std::size_t>(side) *
                                     static_cast<std::size_t>(side));
    for (int frame = 0; frame < frames; ++frame) {
        // The language's Timer: 30 frames per second, 10 seconds per period.
        uniform1f(2, static_cast<float>(frame % 300) / 300.F);
        clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_SHORT, nullptr);
        readPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }
    return pixels;
}

}  // namespace

int main(int count, char** arguments) {
    const int side = count > 2 ? std::atoi(arguments[2]) : kSide;  // NOLINT(cert-err34-c)
    const int frames = count > 3 ? std::atoi(arguments[3]) : 1;    // NOLINT(cert-err34-c)
    if (count < 2 || count > 4 || side < 1 || frames < 1) fail("use: floor OUT.png [SIDE [FRAMES]]");
    bare::openContext();
    const auto pixels = static_cast<std::size_t>(side);
    if (!bare::writePng(arguments[1], draw(sphere(), side, frames), pixels, pixels))
        fail("cannot write the picture");
    return 0;
}
