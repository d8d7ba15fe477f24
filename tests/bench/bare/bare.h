#pragma once
// What the bare programs share: programs, meshes, and one PNG. No code of glibra.
//
// A bare program draws the picture of one scene as somebody would who writes for that picture alone: it knows
// sizes and places, checks nothing that cannot go wrong, and makes each GL call once. Its shaders are the
// scene's own files, so that the driver has the same work. Matrices are computed in double and rounded once.

#include <glad/gl.h>

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>
#include <vector>

namespace bare {

[[noreturn]] void fail(const std::string& what);

/// Links files of the folder `shaders`; the ending of a name says which stage it is. Lines `#include "file"`
/// are replaced by that file.
GLuint link(const std::string& shaders, std::initializer_list<const char*> files);
GLint locationOf(GLuint program, const char* uniform);
void set(GLuint program, const char* uniform, int value);
void set(GLuint program, const char* uniform, float value);
void set(GLuint program, const char* uniform, const glm::dvec3& value);
void set(GLuint program, const char* uniform, const glm::dvec4& value);
void set(GLuint program, const char* uniform, const glm::dmat4& value);
void set(GLuint program, GLint location, const glm::dmat4& value);

struct Vertex {
    glm::vec3 position, normal;
};
struct Shape {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};
Shape box(double side);
Shape skyBox(double side);
Shape plane(double half);
Shape pyramid(double base, double height);
Shape torus(double ring, double tube, int sides, int rings);
Shape sphere(double radius, int slices, int stacks);
Shape cylinder(double radius, double height, int slices);

/// A shape on the device. The program's inputs are vertPos and, if it has it, vertNormal.
struct Mesh {
    GLuint array = 0;
    GLsizei count = 0;
    void draw(GLsizei instances = 1) const;
};
Mesh upload(const Shape& shape, GLuint program);

glm::dmat4 translation(const glm::dvec3& by);
glm::dmat4 rotation(double degrees, const glm::dvec3& axis);
glm::dmat4 lookAt(const glm::dvec3& eye, const glm::dvec3& centre);
glm::dmat4 perspective(double degrees, double aspect, double near, double far);

GLuint texture2D(GLenum format, int width, int height, GLenum filter);
/// A framebuffer of these textures, bound; without a depth texture it gets a depth buffer.
GLuint framebuffer(std::initializer_list<GLuint> colors, GLuint depthTexture, int width, int height);
/// Draws one triangle over the whole target; the vertex stage is fill.vert of this folder.
void fill();

/// What replaces the window: 8-bit colour and a depth buffer.
class Window {
  public:
    Window(int width, int height);
    /// Binds it, sets the viewport, and clears it with that colour.
    void begin(const glm::vec3& background) const;
    /// Reads the pixels and writes the file.
    void write(const char* file) const;

  private:
    int width_, height_;
    GLuint framebuffer_ = 0;
};

/// What main() got.
struct Arguments {
    const char* file;     ///< of the picture
    std::string shaders;  ///< shaders/modern of the repository
    std::string fill;     ///< the folder of fill.vert
    std::string textures;
    int size = 0, steps = 0;  ///< 0: as the subject has them
};
void shadowMap(const Arguments& arguments);
void cubes(const Arguments& arguments);
void life(const Arguments& arguments);
void particles(const Arguments& arguments);
void deferred(const Arguments& arguments);
void water(const Arguments& arguments);
void rayTracer(const Arguments& arguments);

}  // namespace bare
