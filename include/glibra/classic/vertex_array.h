#pragma once
// VertexArray, a class of the appendix of "Graphics Shaders". docs/classic.md has what the book leaves open.

#include <glibra/export.h>

#include <cstddef>
#include <cstdio>
#include <memory>

// Topologies, as headers of OpenGL define them; those of a core profile lack the last three.
#ifndef GL_POINTS
#define GL_POINTS 0x0000
#define GL_LINES 0x0001
#define GL_LINE_LOOP 0x0002
#define GL_LINE_STRIP 0x0003
#define GL_TRIANGLES 0x0004
#define GL_TRIANGLE_STRIP 0x0005
#define GL_TRIANGLE_FAN 0x0006
#endif
#ifndef GL_LINES_ADJACENCY
#define GL_LINES_ADJACENCY 0x000A
#define GL_LINE_STRIP_ADJACENCY 0x000B
#define GL_TRIANGLES_ADJACENCY 0x000C
#define GL_TRIANGLE_STRIP_ADJACENCY 0x000D
#endif
#ifndef GL_PATCHES
#define GL_PATCHES 0x000E
#endif
#ifndef GL_QUADS
#define GL_QUADS 0x0007
#endif
#ifndef GL_QUAD_STRIP
#define GL_QUAD_STRIP 0x0008
#endif
#ifndef GL_POLYGON
#define GL_POLYGON 0x0009
#endif

namespace glibra::classic {

/// Vertices that are given between glBegin() and glEnd() as in old OpenGL, and drawn from buffers with the
/// program that is in use, in a core profile too. A program reads them by the names of gstap.h (aVertex,
/// aNormal, aColor, aTexCoord0) and by the names given to Attribute(). It makes no GL object before the first
/// draw, and has to end while the context of that draw is current.
class GLIBRA_API VertexArray {
  public:
    VertexArray();
    ~VertexArray();
    VertexArray(VertexArray&&) noexcept;
    VertexArray& operator=(VertexArray&&) noexcept;

    /// Vertices at the same place with equal attributes become one; call it before the first draw.
    void CollapseCommonVertices(bool isOn);
    /// How far each coordinate of the same place may be off; 0, the default: not at all.
    void SetTol(float tolerance);
    /// True, the default: the vertices are copied to the device once. False: at each draw.
    void UseBufferObjects(bool isOn);
    void SetVerbose(bool isOn);
    /// The size of the patches of later glBegin(GL_PATCHES).
    void NumPatchVertices(int count);

    // The functions of old OpenGL. They are defined here because some headers of OpenGL have macros of these
    // names.
    void glBegin(unsigned int topology) { Begin(topology); }
    void glEnd() { End(); }
    void glVertex2f(float x, float y) { Vertex(x, y, 0, 1, 3); }
    void glVertex3f(float x, float y, float z) { Vertex(x, y, z, 1, 3); }
    void glVertex4f(float x, float y, float z, float w) { Vertex(x, y, z, w, 4); }
    void glVertex2fv(const float* v) { Vertex(v[0], v[1], 0, 1, 3); }
    void glVertex3fv(const float* v) { Vertex(v[0], v[1], v[2], 1, 3); }
    void glVertex4fv(const float* v) { Vertex(v[0], v[1], v[2], v[3], 4); }
    void glColor3f(float r, float g, float b) { Color(r, g, b, 1, 3); }
    void glColor4f(float r, float g, float b, float a) { Color(r, g, b, a, 4); }
    void glColor3fv(const float* v) { Color(v[0], v[1], v[2], 1, 3); }
    void glColor4fv(const float* v) { Color(v[0], v[1], v[2], v[3], 4); }
    void glNormal3f(float x, float y, float z) { Normal(x, y, z); }
    void glNormal3fv(const float* v) { Normal(v[0], v[1], v[2]); }
    void glTexCoord2f(float s, float t) { TexCoord(s, t); }
    void glTexCoord2fv(const float* v) { TexCoord(v[0], v[1]); }

    /// A value of a variable `in float name` (vec2, vec3, vec4) of the vertex shader, for the vertices from
    /// now on.
    void Attribute(const char* name, float x);
    void Attribute(const char* name, float x, float y);
    void Attribute(const char* name, float x, float y, float z);
    void Attribute(const char* name, float x, float y, float z, float w);
    /// Ends the strip, loop, fan or polygon; the next vertex begins another one of the same list.
    void RestartPrimitive();

    void Draw();
    /// Draws all `count` times; gl_InstanceID counts.
    void DrawInstanced(int count);
    /// Draws what CommandBuffer() says, each list as often as its command does.
    void DrawIndirect();
    /// Each list, from glBegin() to glEnd(), counts from 0. Its command has `count` instances from now on;
    /// else it has one.
    void SetInstances(std::size_t list, int count);
    /// GL's name of the buffer that DrawIndirect() reads, for a program that is in use: one command of
    /// glDrawElementsIndirect, five 32-bit numbers, for each list. A shader may write the second one, the
    /// number of instances. 0 if nothing can be drawn.
    [[nodiscard]] unsigned int CommandBuffer();

    /// Removes all vertices and lists.
    void Clear();
    [[nodiscard]] std::size_t NumVertices() const;  ///< as they were given
    [[nodiscard]] std::size_t NumUnique() const;    ///< after they were collapsed
    /// Writes all unique vertices with their attributes, and the indices of each list.
    void Print(const char* label = "", std::FILE* file = stderr) const;
    void Print(std::FILE* file) const;

  private:
    void Begin(unsigned int topology);
    void End();
    void Vertex(float x, float y, float z, float w, int components);
    void Color(float r, float g, float b, float a, int components);
    void Normal(float x, float y, float z);
    void TexCoord(float s, float t);

    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::classic
