#include "bench/core/device.h"

#include <cstring>

#include "gpu/context/errors.h"
#include "gpu/object/readback.h"
#include "gpu/object/timer.h"

namespace glibra::bench {
namespace {

constexpr std::string_view kVersion = "#version 410 core\n";
constexpr std::string_view kWholeTarget =
    "out vec2 vPlace;\n"
    "void main() {\n"
    "    vPlace = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.;\n"
    "    gl_Position = vec4(vPlace * 2. - 1., 0., 1.);\n"
    "}\n";

constexpr int kColumns = 64;  ///< of ShaderValues

gpu::Program built(const gpu::Capabilities& capabilities, std::span<const gpu::StageSource> stages,
                   std::vector<std::string> captured) {
    std::vector<std::string> texts;
    for (const gpu::StageSource& stage : stages)
        texts.push_back(stage.text.find("#version") == std::string_view::npos
                            ? std::string(kVersion) + std::string(stage.text)
                            : std::string(stage.text));
    std::vector<gpu::StageSource> sources;
    for (std::size_t i = 0; i < texts.size(); ++i) sources.push_back({stages[i].stage, texts[i]});
    gpu::BuildOutcome outcome =
        gpu::buildProgram(capabilities, {.stages = sources, .captured = std::move(captured)});
    if (outcome.program) return std::move(*outcome.program);
    std::string log;
    for (const gpu::StageLog& stage : outcome.stages)
        if (!stage.compiled) log += stage.log;
    throw Failed({diagnose("gpu-E02", fmt::format("the driver rejects a shader program of the benchmarks: {}",
                                                  log + outcome.linkLog))});
}

/// Reads the inputs of a value, whose place is a pixel of the results; these are read back from the top row.
std::string givenText(int inputsPerValue, int rows, std::string_view glsl) {
    return fmt::format(R"(uniform sampler2D uInputs;
ivec2 place;
vec4 given(int k) {{ return texelFetch(uInputs, ivec2(place.x * {} + k, {} - place.y), 0); }}
{}
)",
                       inputsPerValue, rows - 1, glsl);
}

Shader valuesShader(Bench& bench, std::string_view given, int rows, GLenum stage) {
    if (stage == GL_FRAGMENT_SHADER)
        return {bench, fmt::format(R"({}out vec4 fColor;
void main() {{
    place = ivec2(gl_FragCoord.xy);
    fColor = value();
}}
)",
                                   given)};
    return {bench,
            fmt::format(R"({0}flat out vec4 vResult;
void main() {{
    place = ivec2(gl_VertexID % {1}, gl_VertexID / {1});
    vResult = value();
    gl_Position = vec4((vec2(place) + .5) * 2. / vec2({1}, {2}) - 1., 0., 1.);
}}
)",
                        given, kColumns, rows),
            "flat in vec4 vResult;\nout vec4 fColor;\nvoid main() { fColor = vResult; }\n"};
}

int rowsOf(std::size_t count) {
    return (static_cast<int>(count) + kColumns - 1) / kColumns;
}

/// The inputs, and zeros up to the end of the last row.
std::vector<float> padded(std::span<const Four> inputs, int inputsPerValue, int rows) {
    std::vector<float> texels(static_cast<std::size_t>(4 * kColumns * inputsPerValue * rows));
    std::memcpy(texels.data(), inputs.data(), inputs.size_bytes());
    return texels;
}

}  // namespace

std::string halfFloatSentence(Bench& bench) {
    const Canvas canvas(bench, 1, 1, gpu::TexelFormat::rgba16f);
    canvas.bind();
    // Half floats above 1 are 4 / 4096 apart.
    Shader(bench, "out vec4 fColor;\nvoid main() { fColor = vec4(1. + 3. / 4096.); }\n").draw();
    return canvas.pixels(1).front() == 1 ? "this driver cuts half floats off"
                                         : "this driver rounds half floats to the nearest";
}

Shader::Shader(Bench& bench, std::span<const gpu::StageSource> stages, std::vector<std::string> captured)
    : program_(
          std::make_shared<const gpu::Program>(built(bench.capabilities(), stages, std::move(captured)))),
      capabilities_(&bench.capabilities()) {}

Shader::Shader(Bench& bench, std::string_view vertex, std::string_view fragment)
    : Shader(bench, std::array{gpu::StageSource{GL_VERTEX_SHADER, vertex},
                               gpu::StageSource{GL_FRAGMENT_SHADER, fragment}}) {}

Shader::Shader(Bench& bench, std::string_view fragment) : Shader(bench, kWholeTarget, fragment) {}

GLint Shader::location(const char* name) const {
    use();
    return glGetUniformLocation(id(), name);
}

void Shader::draw(GLenum primitive, int count, int first) const {
    const gpu::VertexArray none{{}};
    use();
    none.bind();
    glDrawArrays(primitive, first, count);
}

Captured Shader::capture(GLenum primitive, int count, GLenum captures, int floatsPerVertex,
                         int mostVertices) const {
    // Nothing is rasterised, but drawing without any target is an error.
    const gpu::Target target = need(gpu::Target::window(*capabilities_, 1, 1, gpu::TexelFormat::rgba8));
    target.bind();
    const auto floatsEach = static_cast<std::size_t>(floatsPerVertex);
    const gpu::Buffer buffer = need(gpu::Buffer::create(
        floatsEach * sizeof(float) * static_cast<std::size_t>(mostVertices), GL_STREAM_READ));
    const gpu::Query made(GL_PRIMITIVES_GENERATED), written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    gpu::clearErrors();
    const gpu::VertexArray none{{}};
    none.bind();
    use();  // before the feedback starts, which forbids it
    buffer.bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    made.begin();
    written.begin();
    glBeginTransformFeedback(captures);
    glDrawArrays(primitive, 0, count);
    glEndTransformFeedback();
    written.end();
    made.end();
    glDisable(GL_RASTERIZER_DISCARD);

    const std::uint64_t generated = made.result(), kept = written.result();
    const std::size_t verticesEach = captures == GL_TRIANGLES ? 3 : captures == GL_LINES ? 2 : 1;
    Captured result{std::vector<float>(kept * verticesEach * floatsEach), static_cast<int>(kept)};
    buffer.read(0, std::as_writable_bytes(std::span(result.values)));
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    if (const GLenum code = gpu::takeError(); code != GL_NO_ERROR)
        throw Failed({gpu::allocationError(code, "capturing vertices")});
    if (generated != kept)
        throw Failed(
            {diagnose("gpu-E03", fmt::format("{} primitives were drawn, but the buffer has room for {}",
                                             generated, kept))});
    return result;
}

Canvas::Canvas(Bench& bench, int width, int height, gpu::TexelFormat format, int samples,
               gpu::TexelFormat depth)
    : target_(std::make_shared<const gpu::Target>(
          need(gpu::Target::window(bench.capabilities(), width, height, format, samples, depth)))),
      capabilities_(&bench.capabilities()) {}

void Canvas::clear(const std::array<float, 4>& rgba, float depth) const {
    target_->bind();
    target_->clearColor(0, rgba);
    target_->clearDepth(depth);
}

std::vector<float> pixelsOf(const gpu::Capabilities& capabilities, const gpu::Target& target,
                            int components) {
    target.resolve();
    const gpu::PixelRectangle whole{0, 0, target.width(), target.height()};
    const gpu::PixelLayout layout{components, gpu::TexelType::f32};
    std::vector<float> values(gpu::byteCount(whole, layout) / sizeof(float));
    check(gpu::readPixels(capabilities, target.readable(), 0, whole, layout,
                          std::as_writable_bytes(std::span(values))));
    return values;
}

std::vector<float> Canvas::pixels(int components) const {
    return pixelsOf(*capabilities_, *target_, components);
}

double Canvas::bytes() const {
    return static_cast<double>(gpu::bytesPerTexel(target_->format())) * samples() * width() * height();
}

double Texels::bytes() const {
    const gpu::TextureSize size = texture_->size();
    return static_cast<double>(gpu::bytesPerTexel(texture_->format())) * size.width * size.height *
           size.depth;
}

Vertices::Vertices(const std::vector<Values>& attributes, std::span<const std::uint32_t> indices)
    : isIndexed_(!indices.empty()) {
    std::vector<gpu::AttributeSource> sources;
    for (const Values& each : attributes) {
        buffers_.push_back(need(gpu::Buffer::create(std::as_bytes(each.values))));
        sources.push_back({.location = static_cast<GLuint>(sources.size()), .components = each.components});
        count_ = static_cast<int>(each.values.size()) / each.components;
    }
    if (isIndexed_) {
        buffers_.push_back(need(gpu::Buffer::create(std::as_bytes(indices))));
        count_ = static_cast<int>(indices.size());
    }
    for (std::size_t i = 0; i < sources.size(); ++i) sources[i].buffer = &buffers_[i];
    array_.emplace(sources, isIndexed_ ? &buffers_.back() : nullptr);
}

Vertices::Vertices(const geometry::Mesh& mesh, bool withNormals)
    : Vertices(withNormals ? std::vector<Values>{{mesh.attribute(geometry::kPosition)->values},
                                                 {mesh.attribute(geometry::kNormal)->values}}
                           : std::vector<Values>{{mesh.attribute(geometry::kPosition)->values}},
               mesh.indices) {}

void Vertices::draw(const Shader& shader, GLenum primitive) const {
    shader.use();
    array_->bind();
    if (isIndexed_)
        glDrawElements(primitive, count_, GL_UNSIGNED_INT, nullptr);
    else
        glDrawArrays(primitive, 0, count_);
}

double Vertices::bytes() const {
    double sum = 0;
    for (const gpu::Buffer& each : buffers_) sum += static_cast<double>(each.size());
    return sum;
}

ShaderValues::ShaderValues(Bench& bench, std::string_view glsl, std::span<const Four> inputs,
                           int inputsPerValue, GLenum stage)
    : count_(inputs.size() / static_cast<std::size_t>(inputsPerValue)),
      inputs_(bench, gpu::TexelFormat::rgba32f, {kColumns * inputsPerValue, rowsOf(count_), 1},
              padded(inputs, inputsPerValue, rowsOf(count_)), 4),
      canvas_(bench, kColumns, rowsOf(count_), gpu::TexelFormat::rgba32f),
      shader_(valuesShader(bench, givenText(inputsPerValue, rowsOf(count_), glsl), rowsOf(count_), stage)),
      byPoints_(stage == GL_VERTEX_SHADER) {
    inputs_.sampledBy({.filter = base::Filter::nearest, .border = {}});
}

void ShaderValues::compute() const {
    canvas_.bind();
    inputs_.bind(0);
    shader_.set("uInputs", 0);
    if (byPoints_)
        shader_.draw(GL_POINTS, kColumns * canvas_.height());
    else
        shader_.draw();
}

std::vector<Four> ShaderValues::values() const {
    compute();
    const std::vector<float> floats = canvas_.pixels();
    std::vector<Four> values(count_);
    std::memcpy(values.data(), floats.data(), count_ * sizeof(Four));
    return values;
}

namespace {

Numbers numbersOf(const ShaderValues& values) {
    Numbers results;
    const int parts = values.shader().has("uHalf") ? 2 : 1;
    for (int part = 0; part < parts; ++part) {
        values.shader().set("uHalf", part);
        const std::vector<Four> found = values.values();
        results.resize(found.size(), glm::dvec4(0));
        for (std::size_t i = 0; i < found.size(); ++i) results[i] += glm::dvec4(found[i]);
    }
    return results;
}

Point pointOf(Bench& bench, const Computation& way, const ComputedCase& given, int inputsPerValue) {
    Point point{given.setting, given.label};
    if (way.onCpu) {
        Numbers results(given.inputs.size() / static_cast<std::size_t>(inputsPerValue), glm::dvec4(0));
        way.onCpu(given, results);
        point.error = given.error(results);
        point.time = bench.time([&] { way.onCpu(given, results); });
        point.memory = way.bytes;
        return point;
    }
    const ShaderValues values(bench, way.glsl, given.inputs, inputsPerValue);
    if (way.uniforms) way.uniforms(values.shader(), given);
    point.error = given.error(numbersOf(values));
    point.time = bench.timeDrawing([&] { values.compute(); });
    point.memory = values.bytes();
    return point;
}

}  // namespace

void addComputed(Figure& figure, Bench& bench, const std::vector<Computation>& ways,
                 const std::vector<ComputedCase>& cases, int inputsPerValue) {
    for (const Computation& way : ways)
        bench.attempt([&] {
            for (const ComputedCase& each : cases)
                figure.add(way.name, pointOf(bench, way, each, inputsPerValue)).isForScenes = way.isForScenes;
        });
}

}  // namespace glibra::bench
