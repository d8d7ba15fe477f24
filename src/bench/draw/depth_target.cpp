#include "bench/draw/depth_target.h"

#include <algorithm>
#include <array>

#include "bench/draw/offscreen.h"
#include "gpu/context/errors.h"
#include "gpu/object/buffer.h"
#include "gpu/object/readback.h"

namespace glibra::bench {
namespace {

// Eye space; z is the distance. uProjection: clip z = x * distance + y.
constexpr std::string_view kDepthVertex =
    "layout(location = 0) in vec3 aPosition;\n"
    "uniform vec2 uProjection;\n"
    "void main() {\n"
    "    gl_Position = vec4(aPosition.xy, uProjection.x * aPosition.z + uProjection.y, aPosition.z);\n"
    "}\n";
constexpr std::string_view kDepthFragment =
    "uniform float uBrightness;\n"
    "out vec4 fColor;\n"
    "void main() { fColor = vec4(uBrightness); }\n";

constexpr float kBackBrightness = .5F, kFrontBrightness = 1;

/// Clip z as a factor and a constant of the distance, in double.
std::array<double, 2> projection(const DepthKind& kind, double near, double far) {
    const double span = far - near;
    if (kind.isZeroToOne)
        return kind.isReversed ? std::array{-near / span, far * near / span}
                               : std::array{far / span, -far * near / span};
    const std::array usual{(far + near) / span, -2 * far * near / span};
    return kind.isReversed ? std::array{-usual[0], -usual[1]} : usual;
}

void push(std::vector<float>& vertices, double x, double y, double distance) {
    for (const double each : {x * distance, y * distance, distance})
        vertices.push_back(static_cast<float>(each));
}

}  // namespace

Result<DepthTarget> DepthTarget::create(const gpu::Capabilities& capabilities, GLenum depthFormat, int side) {
    Result<gpu::Program> built = program(capabilities, kDepthVertex, kDepthFragment);
    if (!built) return std::move(built.diagnostics);
    DepthTarget target(std::move(*built));
    target.capabilities_ = &capabilities;
    target.side_ = side;
    Result<gpu::Renderbuffer> color =
        gpu::Renderbuffer::create(capabilities, side, side, gpu::TexelFormat::rgba8);
    if (!color) return std::move(color.diagnostics);
    target.color_ = std::move(*color);
    const std::array<gpu::Attachment, 1> colors{&target.color_};
    Result<gpu::Framebuffer> framebuffer = gpu::Framebuffer::create(colors);
    if (!framebuffer) return std::move(framebuffer.diagnostics);
    target.framebuffer_ = std::move(*framebuffer);

    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    target.depth_ = gpu::Name<glDeleteRenderbuffers>(name);
    gpu::clearErrors();
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, depthFormat, side, side);
    target.framebuffer_.bindForDrawing();
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name);
    if (const GLenum code = gpu::takeError(); code != GL_NO_ERROR)
        return gpu::allocationError(code, "a depth buffer");
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return diagnose("gpu-E05", "the driver cannot draw with a depth buffer of this format");
    return target;
}

void DepthTarget::begin(const DepthKind& kind, double near, double far) const {
    framebuffer_.bindForDrawing();
    glViewport(0, 0, side_, side_);
    const std::array<float, 4> nothing{};
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    const float farthest = kind.isReversed ? 0 : 1;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(kind.isReversed ? GL_GREATER : GL_LESS);
    if (kind.isZeroToOne) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    const std::array<double, 2> clip = projection(kind, near, far);
    setFloats(program_, "uProjection", {static_cast<float>(clip[0]), static_cast<float>(clip[1])});
}

Diagnostics DepthTarget::draw(GLenum primitive, std::span<const float> vertices, float brightness) const {
    Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(vertices), GL_STREAM_DRAW);
    if (!buffer) return std::move(buffer.diagnostics);
    const std::array<gpu::AttributeSource, 1> sources{{{.buffer = &*buffer, .components = 3}}};
    const gpu::VertexArray array{sources};
    setFloats(program_, "uBrightness", {brightness});
    array.bind();
    glDrawArrays(primitive, 0, static_cast<GLsizei>(vertices.size() / 3));
    return {};
}

void DepthTarget::end() {
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    // Only a kind that needs the function has called it, and only if the driver has it.
    if (glClipControl) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

Result<std::vector<std::byte>> DepthTarget::picture() const {
    return gpu::readPixels(*capabilities_, framebuffer_, 0, {0, 0, side_, side_}, {4, gpu::TexelType::u8});
}

Result<std::vector<bool>> DepthTarget::resolvePairs(const DepthKind& kind, double near, double far,
                                                    std::span<const DepthPair> pairs) {
    std::vector<float> back, front;
    const auto side = static_cast<std::size_t>(side_);
    const auto middle = [this](std::size_t pixel) {
        return (static_cast<double>(pixel) + .5) * 2 / side_ - 1;
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::size_t row = i / side;
        const double x = middle(i % side), y = middle(row);
        push(back, x, y, pairs[i].back);
        push(front, x, y, pairs[i].front);
    }
    begin(kind, near, far);
    Diagnostics problems = draw(GL_POINTS, back, kBackBrightness);
    append(problems, draw(GL_POINTS, front, kFrontBrightness));
    end();
    if (!problems.empty()) return problems;
    Result<std::vector<std::byte>> pixels = picture();
    if (!pixels) return std::move(pixels.diagnostics);
    std::vector<bool> isResolved;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::size_t row = side - 1 - i / side;  // pictures start at the top
        isResolved.push_back((*pixels)[(row * side + i % side) * 4] == std::byte{255});
    }
    return isResolved;
}

Result<double> DepthTarget::fighting(const DepthKind& kind, double near, double far, double distance,
                                     double gap) {
    const auto plane = [&](double scale, double width, double height) {
        std::vector<float> vertices;
        // Two triangles as a strip. On a plane, 1 / distance is linear over the picture.
        for (const double y : {-height, height})
            for (const double x : {-width, width}) push(vertices, x, y, distance * scale / (1 - .2 * y));
        return vertices;
    };
    begin(kind, near, far);
    Diagnostics problems = draw(GL_TRIANGLE_STRIP, plane(1 + gap, 1.7, 1.3), kBackBrightness);
    append(problems, draw(GL_TRIANGLE_STRIP, plane(1, 1, 1), kFrontBrightness));
    end();
    if (!problems.empty()) return problems;
    Result<std::vector<std::byte>> pixels = picture();
    if (!pixels) return std::move(pixels.diagnostics);
    double wrong = 0;
    for (std::size_t i = 0; i < pixels->size(); i += 4)
        if ((*pixels)[i] != std::byte{255}) ++wrong;
    return wrong * 4 / static_cast<double>(pixels->size());
}

Diagnostics DepthTarget::drawLayers(const DepthKind& kind, int layers) {
    begin(kind, 1, layers + 2);
    Diagnostics problems;
    for (int layer = layers; layer > 0; --layer) {
        std::vector<float> vertices;
        for (const double y : {-1., 1.})
            for (const double x : {-1., 1.}) push(vertices, x, y, layer + .5);
        append(problems, draw(GL_TRIANGLE_STRIP, vertices, 1 / static_cast<float>(layer)));
    }
    glFinish();
    end();
    return problems;
}

std::vector<DepthKind> usableKinds(const gpu::Capabilities& capabilities) {
    std::vector<DepthKind> usable;
    for (const DepthKind& kind : depthKinds())
        if (!kind.isZeroToOne || capabilities.atLeast(4, 5)) usable.push_back(kind);
    return usable;
}

}  // namespace glibra::bench
