#pragma once
// A frame of a scene as a bare program would draw it: the calls that put pixels into the target, and before
// each of them only what is different from the call before. What the frame is made of (programs, vertex
// arrays, textures) was made by glibra in the same context; how often and in which state it is drawn is noted
// once.

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bench {

/// The loader of GL functions for the context whose frames are noted.
void* notingLoader(const char* name);

/// All that decides what a draw or a clear does. Names of GL objects and values as GL has them.
struct State {
    GLint program = 0, vertexArray = 0, framebuffer = 0;
    std::array<GLint, 4> viewport{};
    std::map<GLenum, bool> enabled;
    std::array<GLint, 4> blending{};
    std::array<GLint, 3> depthAndCulling{};  ///< function, cull face, front face
    bool writesDepth = true;
    struct Texture {
        GLenum target;
        GLint name, sampler;
        friend bool operator==(const Texture&, const Texture&) = default;
    };
    std::map<GLint, Texture> textures;  ///< by unit
    struct Uniform {
        GLenum type;
        std::array<float, 16> numbers{};
        std::array<GLint, 4> integers{};
        friend bool operator==(const Uniform&, const Uniform&) = default;
    };
    std::map<GLint, Uniform> uniforms;  ///< of the program, by location
    friend bool operator==(const State&, const State&) = default;
};

/// A call that draws or clears.
struct Call {
    enum class Kind { elements, arrays, clearFloats, clearIntegers, clearBoth } kind;
    GLenum mode = 0;  ///< or the buffer to clear
    GLint first = 0;  ///< or the number of the buffer to clear
    GLsizei count = 0;
    GLenum type = 0;
    const void* offset = nullptr;
    std::array<float, 4> floats{};
    GLint stencil = 0;
    State state{};
};

using Calls = std::vector<std::function<void()>>;

class BareFrame {
  public:
    /// From begin() to end() the calls of notingLoader()'s functions are noted.
    static void begin();
    static BareFrame end();

    /// Sets the whole state, after others have drawn in the context.
    void prepare(const std::string& value, int width, int height);
    /// Draws the frame with another value of the uniform that prepare() named, and reads it as RGBA, the
    /// lower row first.
    void draw(float value, std::span<std::byte> pixels) const;
    /// True if a program has the uniform.
    [[nodiscard]] bool hasValue() const;

  private:
    struct Step {
        Call call;
        Calls changes{};                                           ///< of the state since the call before
        GLint location = -1;                                       ///< of the value
        std::vector<std::pair<GLint, State::Uniform>> uniforms{};  ///< that differ from those set before
    };
    static Calls change(const State& from, const State& to);

    std::vector<Call> calls_;
    std::vector<Step> steps_;
    int width_ = 0, height_ = 0;
};

}  // namespace bench
