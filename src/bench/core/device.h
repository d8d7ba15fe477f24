#pragma once
// What subjects draw with, as handles to the objects of `gpu` that pictures of scenes are made of: programs
// with uniforms by name, canvases with their pixels, textures, meshes. Whatever the driver refuses throws
// Failed. Copies of a handle share the object.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "bench/core/bench.h"
#include "geometry/mesh.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/texture.h"

namespace glibra::bench {

// Pictures as numbers: what each pixel shall be, and how far a picture is from that.

inline constexpr double kByte = 255;  ///< errors of pictures are in steps of a byte

/// value(x, y) at the centre of each pixel, rows from the top. Places run from (0, 0) at the lower left
/// corner of the picture to (1, 1) at the upper right one.
template <class Value>
auto overPixels(int width, int height, const Value& value) {
    std::vector<decltype(value(0., 0.))> values;
    values.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            values.push_back(value((column + .5) / width, 1 - (row + .5) / height));
    return values;
}

/// The root of the mean square of the differences. Where either is NaN, nothing is compared.
template <class A, class B>
double rootMeanSquare(const A& values, const B& wanted) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double difference = static_cast<double>(values[i]) - static_cast<double>(wanted[i]);
        if (std::isnan(difference)) continue;
        sum += difference * difference;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

template <class A, class B>
double largestDifference(const A& values, const B& wanted) {
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        largest =
            std::max(largest, std::abs(static_cast<double>(values[i]) - static_cast<double>(wanted[i])));
    return largest;
}

/// The formats of colours that subjects compare, coarsest first.
struct NamedFormat {
    const char* name;
    gpu::TexelFormat format;
};
inline constexpr NamedFormat kColorFormats[] = {{"8 bit", gpu::TexelFormat::rgba8},
                                                {"16 bit", gpu::TexelFormat::rgba16},
                                                {"half float", gpu::TexelFormat::rgba16f},
                                                {"float", gpu::TexelFormat::rgba32f}};

/// What the driver makes of a float between two half floats when it draws into rgba16f, for the findings of
/// figures whose errors rest on it.
std::string halfFloatSentence(Bench& bench);

/// The captured outputs of a draw.
struct Captured {
    std::vector<float> values;  ///< vertex after vertex; the outputs of each in the order of their names
    int primitives = 0;
};

class Shader {
  public:
    /// Each source without a #version gets `#version 410 core` as its first line. `captured` names the
    /// outputs of the last stage before rasterisation that capture() reads. gpu-E02 with the driver's log if
    /// it does not build.
    Shader(Bench& bench, std::span<const gpu::StageSource> stages, std::vector<std::string> captured = {});
    Shader(Bench& bench, std::string_view vertex, std::string_view fragment);
    /// Covers the target with one triangle, which gives `in vec2 vPlace`: (0, 0) at the lower left corner of
    /// the target, (1, 1) at the upper right one.
    Shader(Bench& bench, std::string_view fragment);

    /// Sets a uniform by its name: an int (or the texture unit of a sampler), a double, vector or matrix
    /// rounded to float, or several vec2. Names that are not active are ignored.
    template <class Value>
    const Shader& set(const char* name, const Value& value) const {
        upload(location(name), value);
        return *this;
    }
    /// A uniform whose type in GLSL is double, dvec2 or dmat4.
    template <class Value>
    const Shader& setDouble(const char* name, const Value& value) const {
        uploadDouble(location(name), value);
        return *this;
    }
    [[nodiscard]] bool has(const char* name) const { return location(name) >= 0; }
    [[nodiscard]] GLuint id() const { return program_->id(); }
    void use() const { program_->use(); }

    /// Draws vertices without buffers; the vertex shader works from gl_VertexID.
    void draw(GLenum primitive = GL_TRIANGLES, int count = 3, int first = 0) const;

    /// Draws `count` vertices without buffers and without rasterising, and returns the captured outputs of
    /// the program, `floatsPerVertex` each. `captures` is the primitive in the buffer: GL_POINTS, GL_LINES or
    /// GL_TRIANGLES. The buffer has room for `mostVertices`; further vertices are lost (gpu-E03).
    [[nodiscard]] Captured capture(GLenum primitive, int count, GLenum captures, int floatsPerVertex,
                                   int mostVertices) const;

  private:
    static void upload(GLint at, int value) { glUniform1i(at, value); }
    static void upload(GLint at, double value) { glUniform1f(at, static_cast<float>(value)); }
    static void upload(GLint at, const glm::vec2& value) { glUniform2fv(at, 1, &value.x); }
    static void upload(GLint at, const glm::vec3& value) { glUniform3fv(at, 1, &value.x); }
    static void upload(GLint at, const glm::vec4& value) { glUniform4fv(at, 1, &value.x); }
    static void upload(GLint at, const glm::mat3& value) { glUniformMatrix3fv(at, 1, GL_FALSE, &value[0].x); }
    static void upload(GLint at, const glm::mat4& value) { glUniformMatrix4fv(at, 1, GL_FALSE, &value[0].x); }
    static void upload(GLint at, const std::vector<glm::vec2>& values) {
        glUniform2fv(at, static_cast<GLsizei>(values.size()), &values.front().x);
    }
    static void uploadDouble(GLint at, double value) { glUniform1d(at, value); }
    static void uploadDouble(GLint at, const glm::dvec2& value) { glUniform2dv(at, 1, &value.x); }
    static void uploadDouble(GLint at, const glm::dmat4& value) {
        glUniformMatrix4dv(at, 1, GL_FALSE, &value[0].x);
    }

    [[nodiscard]] GLint location(const char* name) const;
    std::shared_ptr<const gpu::Program> program_;
    const gpu::Capabilities* capabilities_;
};

/// A substitute for a window.
class Canvas {
  public:
    Canvas(Bench& bench, int width, int height, gpu::TexelFormat format, int samples = 1,
           gpu::TexelFormat depth = gpu::TexelFormat::depth24);
    void bind() const { target_->bind(); }
    /// Binds it, and clears colour and depth.
    void clear(const std::array<float, 4>& rgba = {}, float depth = 1) const;
    /// `components` (1 to 4) floats per pixel, rows from top to bottom, after resolving the samples. Waits
    /// for the drawing. Byte formats give 0..1.
    [[nodiscard]] std::vector<float> pixels(int components = 4) const;
    [[nodiscard]] int width() const { return target_->width(); }
    [[nodiscard]] int height() const { return target_->height(); }
    [[nodiscard]] int samples() const { return target_->samples(); }
    /// Bytes of the colours.
    [[nodiscard]] double bytes() const;

  private:
    std::shared_ptr<const gpu::Target> target_;
    const gpu::Capabilities* capabilities_;
};

/// Reads the first `components` floats of every pixel.
std::vector<float> pixelsOf(const gpu::Capabilities& capabilities, const gpu::Target& target, int components);

/// The texels of a level, from the span of their components.
template <class Component>
gpu::Texels texelsOf(std::span<const Component> values, int components) {
    return {std::as_bytes(values), components,
            std::is_same_v<Component, float>           ? gpu::TexelType::f32
            : std::is_same_v<Component, std::uint16_t> ? gpu::TexelType::u16
                                                       : gpu::TexelType::u8};
}

class Texels {
  public:
    /// One level; 3D if its depth is not 1. It is read linearly and does not repeat.
    template <class Component>
    Texels(Bench& bench, gpu::TexelFormat format, gpu::TextureSize size, const std::vector<Component>& values,
           int components = 1)
        : Texels(need(gpu::Texture::create(
              bench.capabilities(),
              size.depth > 1 ? gpu::TextureShape::texture3D : gpu::TextureShape::texture2D, format, size,
              texelsOf(std::span(values), components)))) {}
    explicit Texels(gpu::Texture texture) : texture_(std::make_shared<gpu::Texture>(std::move(texture))) {
        sampledBy(
            {.wrap = {gpu::Wrap::clampToEdge, gpu::Wrap::clampToEdge, gpu::Wrap::clampToEdge}, .border = {}});
    }
    /// Sets how it is read.
    const Texels& sampledBy(const gpu::SamplerState& state) {
        sampler_ = std::make_shared<const gpu::Sampler>(state);
        return *this;
    }
    void bind(int unit) const {
        texture_->bind(unit);
        sampler_->bind(unit);
    }
    [[nodiscard]] gpu::Texture& texture() const { return *texture_; }
    [[nodiscard]] double bytes() const;

  private:
    std::shared_ptr<gpu::Texture> texture_;
    std::shared_ptr<const gpu::Sampler> sampler_;
};

/// Vertices, and indices if there are any, on the device. Attributes have the locations 0, 1 ...
class Vertices {
  public:
    struct Values {
        std::span<const float> values;
        int components = 3;
    };
    explicit Vertices(const std::vector<Values>& attributes, std::span<const std::uint32_t> indices = {});
    /// The positions of a mesh, and its normals if `withNormals`.
    explicit Vertices(const geometry::Mesh& mesh, bool withNormals);
    void draw(const Shader& shader, GLenum primitive = GL_TRIANGLES) const;
    [[nodiscard]] double bytes() const;

  private:
    std::vector<gpu::Buffer> buffers_;  ///< the last one: the indices, if there are any
    std::optional<gpu::VertexArray> array_;
    int count_ = 0;
    bool isIndexed_ = false;
};

using Four = glm::vec4;

/// Evaluates a GLSL function for many inputs, in the driver's arithmetic.
class ShaderValues {
  public:
    /// `glsl` defines `vec4 value()` in GLSL 4.10, which reads its inputs as given(0), given(1) ... `inputs`
    /// holds `inputsPerValue` vectors per value. Each value is a pixel of the fragment stage, or a vertex.
    ShaderValues(Bench& bench, std::string_view glsl, std::span<const Four> inputs, int inputsPerValue = 1,
                 GLenum stage = GL_FRAGMENT_SHADER);

    /// Draws.
    void compute() const;
    /// Draws. The results, one vector per value.
    [[nodiscard]] std::vector<Four> values() const;
    /// Bytes of the inputs and the results.
    [[nodiscard]] double bytes() const { return inputs_.bytes() + canvas_.bytes(); }
    /// The program, for setting uniforms of `glsl`.
    [[nodiscard]] const Shader& shader() const { return shader_; }

  private:
    std::size_t count_;
    Texels inputs_;
    Canvas canvas_;
    Shader shader_;
    bool byPoints_;
};

// Sweeps over numbers that are computed on the CPU or in a shader: one result for each input.

using Numbers = std::vector<glm::dvec4>;

/// One setting of a sweep: what is computed from, and how wrong results are.
struct ComputedCase {
    double setting = 0;
    std::string label{};
    std::function<double(const Numbers& results)> error{};
    std::vector<Four> inputs{Four(0)};
};

/// A way to compute the results of a case: on the CPU, or in a shader.
struct Computation {
    std::string name;
    std::function<void(const ComputedCase& given, Numbers& results)> onCpu{};
    double bytes = 0;         ///< that the CPU works on
    bool isForScenes = true;  ///< as Curve has it
    std::string glsl{};       ///< as ShaderValues takes it
    std::function<void(const Shader& shader, const ComputedCase& given)> uniforms{};
};

/// Adds a curve for each way, with a point for each case. A result has `inputsPerValue` inputs. A shader with
/// a uniform uHalf gives its doubles in two parts. A way that the driver refuses is reported, and the others
/// are measured all the same.
void addComputed(Figure& figure, Bench& bench, const std::vector<Computation>& ways,
                 const std::vector<ComputedCase>& cases, int inputsPerValue = 1);

}  // namespace glibra::bench
