#include "gpu/object/framebuffer.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "base/number.h"
#include "base/text.h"
#include "gpu/context/errors.h"

namespace glibra::gpu {
namespace {

const char* incompleteness(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "one of them cannot be drawn into";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "it has neither colour nor depth";
        case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
            return "their numbers of samples differ";
        case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
            return "some have layers and others have none";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "the driver does not support this combination of formats";
        default:
            break;
    }
    return "it is incomplete";
}

struct Attach {
    std::size_t index = 0;  ///< of the colour
    void operator()(const TexturePart& part) const {
        attachTexture(GL_DRAW_FRAMEBUFFER, attachmentPoint(part.texture->format(), index), part);
    }
    void operator()(const Texture* texture) const {
        if (texture) (*this)(TexturePart{texture});
    }
    void operator()(const Renderbuffer* buffer) const {
        if (buffer)
            glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, attachmentPoint(buffer->format(), index),
                                      GL_RENDERBUFFER, buffer->id());
    }
};

}  // namespace

GLenum attachmentPoint(TexelFormat format, std::size_t index) {
    if (hasStencil(format)) return GL_DEPTH_STENCIL_ATTACHMENT;
    return hasDepth(format) ? GL_DEPTH_ATTACHMENT : static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index);
}

void attachTexture(GLenum framebufferTarget, GLenum point, const TexturePart& part) {
    const Texture& texture = *part.texture;
    const int layer = part.layer.value_or(0);
    if (part.isLayered()) return glFramebufferTexture(framebufferTarget, point, texture.id(), part.level);
    if (texture.shape() == TextureShape::texture3D || isArray(texture.shape()))
        return glFramebufferTextureLayer(framebufferTarget, point, texture.id(), part.level, layer);
    if (texture.shape() == TextureShape::texture1D)
        return glFramebufferTexture1D(framebufferTarget, point, GL_TEXTURE_1D, texture.id(), part.level);
    const GLenum target = texture.shape() == TextureShape::cube
                              ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(layer)
                              : glTarget(texture.shape());
    glFramebufferTexture2D(framebufferTarget, point, target, texture.id(), part.level);
}

Result<Renderbuffer> Renderbuffer::create(const Capabilities& capabilities, int width, int height,
                                          TexelFormat format, int samples) {
    const int most = isInteger(format) ? capabilities.maxIntegerSamples : capabilities.maxSamples;
    const int used = std::clamp(samples, 1, std::max(1, most));
    std::string what = "a " + std::to_string(width) + " x " + std::to_string(height) + " target";
    if (used > 1) what += " of " + std::to_string(used) + " samples";
    const int widest = std::min(capabilities.maxRenderbufferSide, capabilities.maxViewportWidth);
    const int highest = std::min(capabilities.maxRenderbufferSide, capabilities.maxViewportHeight);
    if (width < 1 || height < 1) return diagnose("gpu-E04", what + " has no pixels");
    if (width > widest || height > highest)
        return diagnose("gpu-E04", what + " is too large; this driver's limit is " + std::to_string(widest) +
                                       " x " + std::to_string(highest));
    const auto bytes = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
                       bytesPerTexel(format) * static_cast<std::uint64_t>(used);
    what += " (" + base::readableBytes(bytes) + ")";

    Renderbuffer made;
    made.name_ = Name<glDeleteRenderbuffers>(glGenRenderbuffers);
    made.format_ = format;
    made.width_ = width;
    made.height_ = height;
    clearErrors();
    glBindRenderbuffer(GL_RENDERBUFFER, made.id());
    // 0 samples means not multisampled; some drivers make a multisampled buffer for 1.
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, used > 1 ? used : 0, internalFormat(format), width,
                                     height);
    if (const GLenum code = takeError(); code != GL_NO_ERROR) return allocationError(code, what);
    GLint given = 0;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
    made.samples_ = std::max(1, given);
    return made;
}

Result<Framebuffer> Framebuffer::create(std::span<const Attachment> colors, const Attachment& depth) {
    Framebuffer made;
    made.name_ = Name<glDeleteFramebuffers>(glGenFramebuffers);
    made.colorCount_ = static_cast<int>(colors.size());
    made.bindForDrawing();
    std::vector<GLenum> outputs;
    for (const Attachment& each : colors) {
        std::visit(Attach{outputs.size()}, each);
        outputs.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + outputs.size()));
    }
    std::visit(Attach{}, depth);
    if (outputs.empty())
        glDrawBuffer(GL_NONE);
    else
        glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return diagnose("gpu-E05", "cannot draw into these " + std::to_string(colors.size()) +
                                       " colour targets together: " + incompleteness(status));
    return made;
}

namespace {

template <class T>
std::unique_ptr<const T> kept(T value) {
    return std::make_unique<const T>(std::move(value));
}

std::optional<Diagnostic> countProblem(const Capabilities& capabilities, std::size_t colors) {
    if (colors <= static_cast<std::size_t>(capabilities.maxDrawBuffers)) return std::nullopt;
    return diagnose("gpu-E04", std::to_string(colors) + " colour targets; this driver's limit is " +
                                   std::to_string(capabilities.maxDrawBuffers));
}

}  // namespace

Result<Target> Target::window(const Capabilities& capabilities, int width, int height, TexelFormat format,
                              int samples, TexelFormat depthFormat) {
    Target target;
    target.width_ = width;
    target.height_ = height;
    target.format_ = format;
    auto color = Renderbuffer::create(capabilities, width, height, format, samples);
    if (!color) return color.diagnostics;
    target.samples_ = color->samples();
    auto depth = Renderbuffer::create(capabilities, width, height, depthFormat, target.samples_);
    if (!depth) return depth.diagnostics;
    target.depth_ = kept(std::move(*depth));
    target.storage_.push_back(kept(std::move(*color)));

    const std::array<Attachment, 1> drawn{target.storage_.back().get()};
    auto framebuffer = Framebuffer::create(drawn, target.depth_.get());
    if (!framebuffer) return framebuffer.diagnostics;
    target.drawn_ = std::move(*framebuffer);
    if (target.samples_ == 1) return target;

    auto single = Renderbuffer::create(capabilities, width, height, format);
    if (!single) return single.diagnostics;
    target.storage_.push_back(kept(std::move(*single)));
    const std::array<Attachment, 1> readable{target.storage_.back().get()};
    auto resolved = Framebuffer::create(readable);
    if (!resolved) return resolved.diagnostics;
    target.resolved_ = std::move(*resolved);
    return target;
}

Result<Target> Target::textures(const Capabilities& capabilities, std::span<const Texture* const> textures,
                                int samples, SharedDepth depth) {
    if (textures.empty()) return diagnose("gpu-E05", "a render target needs at least one texture");
    if (auto problem = countProblem(capabilities, textures.size())) return *std::move(problem);
    const TextureSize size = textures.front()->size();
    for (const Texture* each : textures)
        if (each->shape() != TextureShape::texture2D || each->size() != size)
            return diagnose("gpu-E05", "textures that are drawn into together must be 2D and of one size");

    Target target;
    target.width_ = size.width;
    target.height_ = size.height;
    target.format_ = textures.front()->format();
    std::vector<Attachment> direct;
    std::vector<Attachment> drawn;
    for (const Texture* each : textures) {
        direct.emplace_back(each);
        if (samples <= 1) continue;
        auto color = Renderbuffer::create(capabilities, size.width, size.height, each->format(), samples);
        if (!color) return color.diagnostics;
        target.samples_ = color->samples();
        target.storage_.push_back(kept(std::move(*color)));
        drawn.emplace_back(target.storage_.back().get());
    }
    if (!depth) {
        auto own = Renderbuffer::create(capabilities, size.width, size.height, TexelFormat::depth24,
                                        target.samples_);
        if (!own) return own.diagnostics;
        depth = kept(std::move(*own));
    }
    target.depth_ = std::move(depth);

    auto framebuffer = Framebuffer::create(drawn.empty() ? direct : drawn, target.depth_.get());
    if (!framebuffer) return framebuffer.diagnostics;
    target.drawn_ = std::move(*framebuffer);
    if (drawn.empty()) return target;
    auto resolved = Framebuffer::create(direct);
    if (!resolved) return resolved.diagnostics;
    target.resolved_ = std::move(*resolved);
    return target;
}

Result<Target> Target::parts(const Capabilities& capabilities, std::span<const TexturePart> colors,
                             const std::optional<TexturePart>& depth, SharedDepth implicitDepth,
                             std::optional<TexelFormat> implicitFormat) {
    if (colors.empty() && !depth) return diagnose("gpu-E05", "a render target needs at least one texture");
    if (auto problem = countProblem(capabilities, colors.size())) return *std::move(problem);
    std::vector<TexturePart> all(colors.begin(), colors.end());
    if (depth) all.push_back(*depth);
    const TexturePart& first = all.front();
    const TextureSize size = first.size();
    for (const TexturePart& each : all)
        if (each.size().width != size.width || each.size().height != size.height ||
            each.isLayered() != first.isLayered() ||
            (each.isLayered() && each.texture->layers(each.level) != first.texture->layers(first.level)) ||
            each.texture->samples() != first.texture->samples())
            return diagnose(
                "gpu-E05",
                "textures that are drawn into together must have the same size, layers and samples");
    for (const TexturePart& each : colors) {
        const TexelFormat format = each.texture->format();
        if (hasDepth(format) || !useOf(capabilities, format).color)
            return diagnose("gpu-E05", "this driver cannot draw colours into " + std::string(name(format)));
    }
    if (depth && !useOf(capabilities, depth->texture->format()).depth)
        return diagnose("gpu-E05",
                        "this driver cannot draw depth into " + std::string(name(depth->texture->format())));

    Target target;
    target.width_ = size.width;
    target.height_ = size.height;
    target.samples_ = first.texture->samples();
    target.format_ = first.texture->format();
    std::vector<Attachment> attachments;
    for (const TexturePart& each : colors) {
        attachments.emplace_back(each);
        target.formats_.push_back(each.texture->format());
    }
    Attachment depthAttachment = kNothing;
    if (depth) {
        depthAttachment = *depth;
    } else if (implicitFormat && first.isLayered()) {
        // 3D textures hold no depth; all other shapes are drawn with depth of their own shape.
        const TextureShape drawn = first.texture->shape();
        const TextureShape shape = drawn == TextureShape::texture3D ? TextureShape::array2D : drawn;
        const int layers = shape == TextureShape::cube ? 1 : first.texture->layers(first.level);
        auto own = Texture::create(
            capabilities,
            {shape, *implicitFormat, {size.width, size.height, layers}, 1, first.texture->samples()});
        if (!own) return own.diagnostics;
        target.layeredDepth_ = kept(std::move(*own));
        depthAttachment = TexturePart{target.layeredDepth_.get()};
    } else if (implicitFormat) {
        if (!implicitDepth) {
            auto own =
                Renderbuffer::create(capabilities, size.width, size.height, *implicitFormat, target.samples_);
            if (!own) return own.diagnostics;
            implicitDepth = kept(std::move(*own));
        }
        target.depth_ = std::move(implicitDepth);
        depthAttachment = target.depth_.get();
    }
    auto framebuffer = Framebuffer::create(attachments, depthAttachment);
    if (!framebuffer) return framebuffer.diagnostics;
    target.drawn_ = std::move(*framebuffer);
    return target;
}

void Target::bind() const {
    drawn_.bindForDrawing();
    glViewport(0, 0, width_, height_);
}

void Target::clearColor(int index, const std::array<float, 4>& rgba) const {
    glClearBufferfv(GL_COLOR, index, rgba.data());
}

void Target::clearColorOfAnyFormat(int index, const std::array<double, 4>& rgba) const {
    const auto position = static_cast<std::size_t>(index);
    const TexelFormat format = position < formats_.size() ? formats_[position] : format_;
    const auto converted = [&](auto convert) {
        return std::array{convert(rgba[0]), convert(rgba[1]), convert(rgba[2]), convert(rgba[3])};
    };
    if (rowOf(format).kind == base::TexelClass::integer)
        return glClearBufferiv(GL_COLOR, index, converted(base::toInt).data());
    if (rowOf(format).kind == base::TexelClass::unsignedInteger)
        return glClearBufferuiv(GL_COLOR, index, converted(base::toUnsigned).data());
    clearColor(index, converted(base::toFloat));
}

void Target::clearDepth(float depth) const {
    glClearBufferfv(GL_DEPTH, 0, &depth);
}

void Target::clearStencil(int value) const {
    glClearBufferiv(GL_STENCIL, 0, &value);
}

bool Target::hasSrgb() const {
    return std::ranges::find(formats_, TexelFormat::srgb8_alpha8) != formats_.end();
}

void Target::resolve() const {
    if (!resolved_) return;
    drawn_.bindForReading();
    resolved_->bindForDrawing();
    for (int i = 0; i < resolved_->colorCount(); ++i) {
        const auto point = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i);
        glReadBuffer(point);
        glDrawBuffer(point);
        glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
}

namespace {

constexpr std::size_t kWord = 16;    ///< bytes of an element
constexpr std::size_t kGroup = 256;  ///< invocations
constexpr const char* kClearing = R"(#version 430 core
layout(local_size_x = 256) in;
layout(std430, binding = 0) writeonly buffer Words { uvec4 words[]; };
void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 256u + gl_LocalInvocationID.x;
    if (i < uint(words.length())) words[i] = uvec4(0u);
}
)";

/// Puts back the program in use and the first storage buffer, unless they had been deleted and lived only as
/// long as they were bound.
class ComputeState {
  public:
    ComputeState() {
        glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
        glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &generic_);
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &first_);
    }
    ComputeState(const ComputeState&) = delete;
    ComputeState& operator=(const ComputeState&) = delete;
    ~ComputeState() {
        const auto name = [](GLint kept, auto exists) {
            return exists(static_cast<GLuint>(kept)) == GL_TRUE ? static_cast<GLuint>(kept) : 0U;
        };
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, name(first_, glIsBuffer));
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, name(generic_, glIsBuffer));
        glUseProgram(name(program_, glIsProgram));
    }

  private:
    GLint program_ = 0, generic_ = 0, first_ = 0;
};

}  // namespace

void BufferClearer::clear(const Capabilities& capabilities, Buffer& buffer) {
    if (capabilities.isSoftware || buffer.size() < kLarge || !clearByShader(capabilities, buffer))
        buffer.clear(capabilities);
}

bool BufferClearer::clearByShader(const Capabilities& capabilities, Buffer& buffer) {
    const std::uint64_t words = buffer.size() / kWord;
    if (!capabilities.compute || std::cmp_greater(buffer.size(), capabilities.maxStorageBlockBytes))
        return false;
    if (!program_) {
        const std::array<StageSource, 1> stages{{{GL_COMPUTE_SHADER, kClearing}}};
        program_ = ProgramBuild(capabilities, {.stages = stages}).finish().program;
        if (!program_) return false;
    }
    const std::uint64_t groups = (words + kGroup - 1) / kGroup;
    const std::uint64_t columns =
        std::min<std::uint64_t>(groups, static_cast<std::uint64_t>(capabilities.maxComputeGroups[0]));
    const std::uint64_t rows = columns == 0 ? 0 : (groups + columns - 1) / columns;
    const ComputeState state;
    finishShaderWrites();
    program_->use();
    buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    dispatch({static_cast<GLuint>(columns), static_cast<GLuint>(rows), 1});
    finishShaderWrites();
    const std::array<std::byte, kWord> zeros{};
    buffer.update(words * kWord, std::span(zeros).first(buffer.size() - words * kWord));
    return true;
}

}  // namespace glibra::gpu
