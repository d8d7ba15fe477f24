#include "view/debug_view/bound_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "view/debug_view/debug_program.h"

namespace glibra::view {
namespace {

constexpr std::array<GLenum, 5> kSwitches{GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_CULL_FACE,
                                          GL_FRAMEBUFFER_SRGB};

void turn(GLenum what, GLboolean on) {
    on != GL_FALSE ? glEnable(what) : glDisable(what);
}

GLint integerOf(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

/// Of an attachment of the framebuffer that is bound for drawing; `unknown` if the driver does not say.
GLint attached(GLenum point, GLenum what, GLint unknown = 0) {
    GLint value = unknown;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, point, what, &value);
    return value;
}

/// GL_INT, GL_UNSIGNED_INT, or another type for what is read as floats.
GLenum componentType(int output) {
    return static_cast<GLenum>(attached(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(output),
                                        GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, GL_FLOAT));
}

template <class T>
std::vector<double> readAs(const gpu::PixelRectangle& pixels, int components, GLenum format, GLenum type,
                           int kept) {
    const auto count = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    std::vector<T> values(count * static_cast<std::size_t>(components));
    glReadPixels(pixels.x, pixels.y, pixels.width, pixels.height, format, type, values.data());
    std::vector<double> result;
    result.reserve(count * static_cast<std::size_t>(kept));
    for (std::size_t at = 0; at < values.size(); at += static_cast<std::size_t>(components))
        result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(at),
                      values.begin() + static_cast<std::ptrdiff_t>(at) + kept);
    return result;
}

/// A copy of the framebuffer that is bound for reading.
struct Copy {
    std::optional<gpu::Renderbuffer> storage;
    std::optional<gpu::Framebuffer> framebuffer;

    /// Binds the copy for reading. False if the driver cannot make it.
    bool make(const gpu::Capabilities& capabilities, base::TexelFormat format, const BoundPart& part,
              int width, int height, GLenum filter) {
        const bool isColor = part.kind == FrameTarget::Kind::color;
        auto made = gpu::Renderbuffer::create(capabilities, width, height, format);
        if (!made) return false;
        storage = std::move(made.value);
        const std::array<gpu::Attachment, 1> own{&*storage};
        auto bound = isColor ? gpu::Framebuffer::create(own) : gpu::Framebuffer::create({}, &*storage);
        if (!bound) return false;
        framebuffer = std::move(bound.value);
        framebuffer->bindForDrawing();
        glBlitFramebuffer(0, 0, part.width, part.height, 0, 0, width, height,
                          isColor ? GL_COLOR_BUFFER_BIT : GL_DEPTH_BUFFER_BIT, filter);
        framebuffer->bindForReading();
        return true;
    }
};

/// The first texture that the pass draws into; none: the window, or a depth buffer that no texture holds.
gpu::TexturePart firstPart(const render::LiveScene& scene, const scene::Pass& pass) {
    scene::TextureView view;
    if (!pass.targets.empty()) {
        const scene::TargetPart part = pass.parts.empty() ? scene::TargetPart{} : pass.parts.front();
        view = {.texture = pass.targets.front(), .level = part.level, .layer = part.layer};
    } else if (pass.depth) {
        view = *pass.depth;
    }
    const gpu::Texture* texture = !pass.isWindow && view.texture ? scene.texture(view.texture) : nullptr;
    return {texture, view.level.value_or(0), view.layer};
}

}  // namespace

KeptState::KeptState() {
    for (std::size_t i = 0; i < kSwitches.size(); ++i) switches_.at(i) = glIsEnabled(kSwitches.at(i));
    for (std::size_t i = 0; i < kOutputs; ++i) {
        outputs_.at(i).blends = glIsEnabledi(GL_BLEND, static_cast<GLuint>(i));
        glGetBooleani_v(GL_COLOR_WRITEMASK, static_cast<GLuint>(i), outputs_.at(i).mask.data());
    }
    glGetIntegerv(GL_SCISSOR_BOX, scissor_.data());
    draw_ = integerOf(GL_DRAW_FRAMEBUFFER_BINDING);
    read_ = integerOf(GL_READ_FRAMEBUFFER_BINDING);
    program_ = integerOf(GL_CURRENT_PROGRAM);
    vertices_ = integerOf(GL_VERTEX_ARRAY_BINDING);
    renderbuffer_ = integerOf(GL_RENDERBUFFER_BINDING);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    depthFunction_ = integerOf(GL_DEPTH_FUNC);
    stencilFront_ = integerOf(GL_STENCIL_WRITEMASK);
    stencilBack_ = integerOf(GL_STENCIL_BACK_WRITEMASK);
}

KeptState::~KeptState() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbuffer_));
    glUseProgram(static_cast<GLuint>(program_));
    glBindVertexArray(static_cast<GLuint>(vertices_));
    for (std::size_t i = 0; i < kSwitches.size(); ++i) turn(kSwitches.at(i), switches_.at(i));
    for (std::size_t i = 0; i < kOutputs; ++i) {
        const Output& each = outputs_.at(i);
        const auto index = static_cast<GLuint>(i);
        each.blends != GL_FALSE ? glEnablei(GL_BLEND, index) : glDisablei(GL_BLEND, index);
        glColorMaski(index, each.mask[0], each.mask[1], each.mask[2], each.mask[3]);
    }
    glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
    glDepthMask(depthMask_);
    glDepthFunc(static_cast<GLenum>(depthFunction_));
    glStencilMaskSeparate(GL_FRONT, static_cast<GLuint>(stencilFront_));
    glStencilMaskSeparate(GL_BACK, static_cast<GLuint>(stencilBack_));
}

BoundLayer::BoundLayer(const std::optional<LayerOfPass>& layer) {
    if (!layer) return;
    whole_ = static_cast<GLuint>(integerOf(GL_DRAW_FRAMEBUFFER_BINDING));
    struct TextureAt {
        GLenum point;
        GLuint name;
        GLint level;
    };
    std::vector<TextureAt> textures;
    const auto look = [&](GLenum point) {
        if (attached(point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return;
        textures.push_back({point,
                            static_cast<GLuint>(attached(point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)),
                            attached(point, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL)});
    };
    look(GL_DEPTH_ATTACHMENT);
    look(GL_STENCIL_ATTACHMENT);
    for (GLenum i = 0; i < base::kRasterTargets; ++i) look(GL_COLOR_ATTACHMENT0 + i);
    glGenFramebuffers(1, &layer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, layer_);
    const GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(layer->layer);
    for (const auto& [point, name, level] : textures)
        if (layer->shape == gpu::TextureShape::cube)
            glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, point, face, name, level);
        else
            glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, point, name, level, layer->layer);
}

BoundLayer::~BoundLayer() {
    if (layer_ == 0) return;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, whole_);
    glDeleteFramebuffers(1, &layer_);
}

std::optional<render::Content> readBound(const gpu::Capabilities& capabilities, const BoundPart& part,
                                         int mostSide, const std::optional<gpu::PixelRectangle>& only) {
    const KeptState kept;
    const BoundLayer layer(part.layer);
    using Kind = FrameTarget::Kind;
    const bool isColor = part.kind == Kind::color;
    const GLenum type = isColor ? componentType(part.output) : GL_FLOAT;
    const bool isInteger = type == GL_INT || type == GL_UNSIGNED_INT;
    const bool hasSamples = integerOf(GL_SAMPLES) > 1;
    const auto bound = static_cast<GLuint>(integerOf(GL_DRAW_FRAMEBUFFER_BINDING));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, bound);
    if (isColor) glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(part.output));
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    render::Content content;
    content.width = part.width;
    content.height = part.height;
    Copy single, small;
    if (hasSamples && (!part.format || part.kind == Kind::stencil ||
                       !single.make(capabilities, *part.format, part, part.width, part.height, GL_NEAREST)))
        return std::nullopt;
    const int longest = std::max(part.width, part.height);
    if (mostSide > 0 && longest > mostSide) {
        content.width = std::max(1, part.width * mostSide / longest);
        content.height = std::max(1, part.height * mostSide / longest);
        const base::TexelFormat colors = type == GL_INT ? base::TexelFormat::rgba32i
                                         : isInteger    ? base::TexelFormat::rgba32ui
                                                        : base::TexelFormat::rgba32f;
        if ((!isColor && !part.format) ||
            !small.make(capabilities, isColor ? colors : *part.format, part, content.width, content.height,
                        isColor && !isInteger ? GL_LINEAR : GL_NEAREST))
            return std::nullopt;
    }
    gpu::PixelRectangle pixels{0, 0, content.width, content.height};
    if (only) pixels = *only;
    content.width = pixels.width;
    content.height = pixels.height;
    content.components = !isColor                                       ? 1
                         : part.format && !base::hasDepth(*part.format) ? base::rowOf(*part.format).components
                                                                        : 4;
    constexpr int kRead = 4;
    if (part.kind == Kind::depth)
        content.values = readAs<float>(pixels, 1, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
    else if (part.kind == Kind::stencil)
        content.values = readAs<std::uint32_t>(pixels, 1, GL_STENCIL_INDEX, GL_UNSIGNED_INT, 1);
    else if (type == GL_INT)
        content.values = readAs<std::int32_t>(pixels, kRead, GL_RGBA_INTEGER, GL_INT, content.components);
    else if (isInteger)
        content.values =
            readAs<std::uint32_t>(pixels, kRead, GL_RGBA_INTEGER, GL_UNSIGNED_INT, content.components);
    else
        content.values = readAs<float>(pixels, kRead, GL_RGBA, GL_FLOAT, content.components);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, bound);
    if (isColor) glReadBuffer(GL_COLOR_ATTACHMENT0);
    return content;
}

std::optional<render::Content> readTexture(const gpu::Capabilities& capabilities, const gpu::Texture& texture,
                                           const scene::TextureView& view, int mostSide) {
    const KeptState kept;
    const int level = view.level.value_or(0);
    gpu::TexturePart part{&texture, level, view.layer};
    if (part.isLayered()) part.layer = 0;
    const bool isDepth = base::hasDepth(texture.format());
    const std::array<gpu::Attachment, 1> colors{part};
    const Result<gpu::Framebuffer> made =
        isDepth ? gpu::Framebuffer::create({}, part) : gpu::Framebuffer::create(colors);
    if (!made) return std::nullopt;
    made->bindForDrawing();
    return readBound(capabilities,
                     {isDepth ? FrameTarget::Kind::depth : FrameTarget::Kind::color, 0, texture.format(),
                      part.size().width, part.size().height},
                     mostSide);
}

gpu::TextureSize sizeOf(const render::LiveScene& scene, const scene::Pass& pass, int width, int height) {
    const gpu::TexturePart part = firstPart(scene, pass);
    return part.texture == nullptr ? gpu::TextureSize{width, height, 1} : part.size();
}

int layersOf(const render::LiveScene& scene, const scene::Pass& pass) {
    const gpu::TexturePart part = firstPart(scene, pass);
    return part.texture != nullptr && part.isLayered() ? part.texture->layers(part.level) : 1;
}

std::string layerName(const render::LiveScene& scene, const scene::Pass& pass, int layer) {
    constexpr std::array<const char*, 6> kFaces{"+x", "-x", "+y", "-y", "+z", "-z"};
    const gpu::Texture* texture = firstPart(scene, pass).texture;
    const auto face = static_cast<std::size_t>(layer) % kFaces.size();
    if (texture != nullptr && texture->shape() == gpu::TextureShape::cube)
        return fmt::format("face {}", kFaces.at(face));
    if (texture != nullptr && texture->shape() == gpu::TextureShape::cubeArray)
        return fmt::format("cube {}, face {}", static_cast<std::size_t>(layer) / kFaces.size(),
                           kFaces.at(face));
    return fmt::format("layer {}", layer);
}

std::optional<LayerOfPass> layerOf(const render::LiveScene& scene, const scene::Pass& pass, int layer) {
    const int layers = layersOf(scene, pass);
    if (layers == 1) return std::nullopt;
    return LayerOfPass{firstPart(scene, pass).texture->shape(), std::clamp(layer, 0, layers - 1)};
}

BoundPart partOf(const render::LiveScene& scene, const FrameTarget& target, const gpu::TextureSize& size,
                 const std::optional<LayerOfPass>& layer) {
    const gpu::Texture* texture = target.view.texture ? scene.texture(target.view.texture) : nullptr;
    BoundPart part{target.kind, target.output, std::nullopt, size.width, size.height, layer};
    if (texture != nullptr) part.format = texture->format();
    return part;
}

std::optional<BesideTarget> BesideTarget::make(const gpu::Capabilities& capabilities,
                                               const render::LiveScene& scene, const scene::Pass& pass,
                                               const gpu::TextureSize& size, int layer) {
    const KeptState kept;
    const int samples = std::max(1, integerOf(GL_SAMPLES));
    const int layers = layersOf(scene, pass);
    // Attaching by name is for the depth buffers that no texture of the scene holds.
    struct Depth {
        GLenum point;
        GLint type = GL_NONE, name = 0;
    };
    std::array<Depth, 2> depths{{{GL_DEPTH_ATTACHMENT}, {GL_STENCIL_ATTACHMENT}}};
    for (Depth& each : depths) {
        each.type = attached(each.point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
        if (each.type != GL_NONE) each.name = attached(each.point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
    }
    BesideTarget made;
    made.width_ = size.width;
    made.height_ = size.height;
    const gpu::Texture* texture = pass.depth ? scene.texture(pass.depth->texture) : nullptr;
    if (layers > 1) {
        // All layers of a framebuffer have one shape; 3D textures are drawn with depth of an array.
        gpu::TextureShape shape = (texture != nullptr ? texture : firstPart(scene, pass).texture)->shape();
        if (shape == gpu::TextureShape::texture3D) shape = gpu::TextureShape::array2D;
        const int depth = shape == gpu::TextureShape::cube ? 1 : layers;
        auto color = gpu::Texture::create(
            capabilities, {shape, base::TexelFormat::rgba32f, {size.width, size.height, depth}, 1, samples});
        if (!color) return std::nullopt;
        made.layers_ = std::move(*color);
        const std::array<gpu::Attachment, 1> one{
            gpu::TexturePart{&*made.layers_, 0, std::clamp(layer, 0, layers - 1)}};
        auto read = gpu::Framebuffer::create(one);
        if (!read) return std::nullopt;
        made.layer_ = std::move(read.value);
    } else {
        auto color = gpu::Renderbuffer::create(capabilities, size.width, size.height,
                                               base::TexelFormat::rgba32f, samples);
        if (!color) return std::nullopt;
        made.color_ = std::move(*color);
    }
    gpu::Attachment color = &made.color_, depth = gpu::kNothing;
    if (made.layers_) color = gpu::TexturePart{&*made.layers_};
    if (texture != nullptr)
        depth = gpu::TexturePart{texture, pass.depth->level.value_or(0), pass.depth->layer};
    auto framebuffer = gpu::Framebuffer::create({&color, 1}, depth);
    if (!framebuffer) return std::nullopt;
    made.framebuffer_ = std::move(framebuffer.value);
    made.framebuffer_->bindForDrawing();
    for (const Depth& each : depths) {
        if (each.type == GL_RENDERBUFFER)
            glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, each.point, GL_RENDERBUFFER,
                                      static_cast<GLuint>(each.name));
        else if (each.type == GL_TEXTURE && texture == nullptr && layers > 1)
            glFramebufferTexture(GL_DRAW_FRAMEBUFFER, each.point, static_cast<GLuint>(each.name), 0);
    }
    const bool isOther = texture == nullptr && depths[0].type == GL_TEXTURE && layers == 1;
    if (isOther || glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return std::nullopt;
    return made;
}

void BesideTarget::bind(int output) const {
    framebuffer_->bindForDrawing();
    writeOnly(output);
}

void BesideTarget::clear() const {
    const KeptState kept;
    bind(0);
    glDisable(GL_SCISSOR_TEST);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    constexpr std::array<float, 4> kZero{};
    glClearBufferfv(GL_COLOR, 0, kZero.data());
}

render::Content BesideTarget::read(const gpu::Capabilities& capabilities,
                                   const std::optional<gpu::PixelRectangle>& only) const {
    const KeptState kept;
    if (layer_)
        layer_->bindForDrawing();
    else
        bind(0);
    return readBound(capabilities, {FrameTarget::Kind::color, 0, base::TexelFormat::rgba32f, width_, height_},
                     0, only)
        .value_or(render::Content{});
}

}  // namespace glibra::view
