#include "bare.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <sstream>

#include "png_file.h"

namespace bare {
namespace {

std::string textOf(const std::string& folder, const std::string& name) {
    std::ifstream file(folder + "/" + name);
    if (!file) fail("cannot read " + folder + "/" + name);
    std::string text;
    for (std::string line; std::getline(file, line);)
        text += line.starts_with("#include \"") ? textOf(folder, line.substr(10, line.rfind('"') - 10))
                                                : line + "\n";
    return text;
}

GLenum stageOf(const std::string& name) {
    if (name.ends_with(".vert")) return GL_VERTEX_SHADER;
    return name.ends_with(".frag") ? GL_FRAGMENT_SHADER : GL_COMPUTE_SHADER;
}

}  // namespace

void fail(const std::string& what) {
    std::fprintf(stderr, "bare: %s\n", what.c_str());
    std::exit(1);
}

GLuint link(const std::string& shaders, std::initializer_list<const char*> files) {
    const GLuint program = glCreateProgram();
    for (const char* each : files) {
        const std::string name(each);
        std::string text = name.starts_with('/') ? textOf("", name) : textOf(shaders, name);
        const GLuint shader = glCreateShader(stageOf(name));
        const char* source = text.c_str();
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) fail(std::string(*files.begin()) + " does not link");
    return program;
}

GLint locationOf(GLuint program, const char* uniform) {
    return glGetUniformLocation(program, uniform);
}
void set(GLuint program, const char* uniform, int value) {
    glProgramUniform1i(program, locationOf(program, uniform), value);
}
void set(GLuint program, const char* uniform, float value) {
    glProgramUniform1f(program, locationOf(program, uniform), value);
}
void set(GLuint program, const char* uniform, const glm::dvec3& value) {
    glProgramUniform3fv(program, locationOf(program, uniform), 1, glm::value_ptr(glm::vec3(value)));
}
void set(GLuint program, const char* uniform, const glm::dvec4& value) {
    glProgramUniform4fv(program, locationOf(program, uniform), 1, glm::value_ptr(glm::vec4(value)));
}
void set(GLuint program, const char* uniform, const glm::dmat4& value) {
    set(program, locationOf(program, uniform), value);
}
void set(GLuint program, GLint location, const glm::dmat4& value) {
    glProgramUniformMatrix4fv(program, location, 1, GL_FALSE, glm::value_ptr(glm::mat4(value)));
}

Mesh upload(const Shape& shape, GLuint program) {
    Mesh mesh;
    mesh.count = static_cast<GLsizei>(shape.indices.size());
    glGenVertexArrays(1, &mesh.array);
    glBindVertexArray(mesh.array);
    GLuint buffers[2]{};
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.vertices.size() * sizeof(Vertex)),
                 shape.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(shape.indices.size() * sizeof(std::uint32_t)), shape.indices.data(),
                 GL_STATIC_DRAW);
    const auto connect = [&](const char* input, std::size_t offset) {
        const GLint location = glGetAttribLocation(program, input);
        if (location < 0) return;
        const auto at = static_cast<GLuint>(location);
        glVertexAttribPointer(at, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr)
        glEnableVertexAttribArray(at);
    };
    connect("vertPos", 0);
    connect("vertNormal", offsetof(Vertex, normal));
    return mesh;
}

void Mesh::draw(GLsizei instances) const {
    glBindVertexArray(array);
    glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr, instances);
}

glm::dmat4 translation(const glm::dvec3& by) {
    glm::dmat4 matrix(1);
    matrix[3] = glm::dvec4(by, 1);
    return matrix;
}

glm::dmat4 rotation(double degrees, const glm::dvec3& axis) {
    // Rodrigues' formula, column by column.
    const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 a = glm::normalize(axis);
    const glm::dmat3 cross(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);
    return glm::dmat4(c * glm::dmat3(1) + s * cross + (1 - c) * glm::outerProduct(a, a));
}

glm::dmat4 lookAt(const glm::dvec3& eye, const glm::dvec3& centre) {
    const glm::dvec3 forward = glm::normalize(centre - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    glm::dmat4 matrix(1);
    for (int i = 0; i < 3; ++i) matrix[i] = glm::dvec4(right[i], up[i], -forward[i], 0);
    matrix[3] = glm::dvec4(-glm::dot(right, eye), -glm::dot(up, eye), glm::dot(forward, eye), 1);
    return matrix;
}

glm::dmat4 perspective(double degrees, double aspect, double near, double far) {
    const double scale = 1 / std::tan(degrees * 3.14159265358979323846 / 360);
    glm::dmat4 matrix(0);
    matrix[0][0] = scale / aspect;
    matrix[1][1] = scale;
    matrix[2][2] = (near + far) / (near - far);
    matrix[2][3] = -1;
    matrix[3][2] = 2 * near * far / (near - far);
    return matrix;
}

GLuint texture2D(GLenum format, int width, int height, GLenum filter) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

namespace {

void attachRenderbuffer(GLenum attachment, GLenum format, int width, int height) {
    GLuint storage = 0;
    glGenRenderbuffers(1, &storage);
    glBindRenderbuffer(GL_RENDERBUFFER, storage);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, storage);
}

}  // namespace

GLuint framebuffer(std::initializer_list<GLuint> colors, GLuint depthTexture, int width, int height) {
    GLuint made = 0;
    glGenFramebuffers(1, &made);
    glBindFramebuffer(GL_FRAMEBUFFER, made);
    std::vector<GLenum> outputs;
    for (const GLuint each : colors) {
        outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs.size()));
        glFramebufferTexture(GL_FRAMEBUFFER, outputs.back(), each, 0);
    }
    glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
    if (depthTexture != 0)
        glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depthTexture, 0);
    else
        attachRenderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height);
    return made;
}

void fill() {
    static GLuint array = 0;
    if (array == 0) glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Window::Window(int width, int height) : width_(width), height_(height) {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    attachRenderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height);
    attachRenderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height);
}

void Window::begin(const glm::vec3& background) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
    glClearColor(background.r, background.g, background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Window::write(const char* file) const {
    std::vector<std::uint8_t> pixels(std::size_t{4} * static_cast<std::size_t>(width_) *
                                     static_cast<std::size_t>(height_));
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    if (!writePng(file, pixels, static_cast<std::size_t>(width_), static_cast<std::size_t>(height_)))
        fail("cannot write the picture");
}

}  // namespace bare
