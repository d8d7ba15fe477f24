#include "gpu/object/target.h"

#include <string>
#include <utility>

namespace glibra::gpu {
namespace {

template <class T>
std::unique_ptr<const T> kept(T value) {
    return std::make_unique<const T>(std::move(value));
}

}  // namespace

Result<Target> Target::window(const Capabilities& capabilities, int width, int height, TexelFormat format,
                              int samples) {
    Target target;
    target.width_ = width;
    target.height_ = height;
    target.format_ = format;
    auto color = Renderbuffer::color(capabilities, width, height, format, samples);
    if (!color) return color.diagnostics;
    target.samples_ = color->samples();
    auto depth = Renderbuffer::depth(capabilities, width, height, target.samples_);
    if (!depth) return depth.diagnostics;
    target.depth_ = kept(std::move(*depth));
    target.storage_.push_back(kept(std::move(*color)));

    const std::array<ColorAttachment, 1> drawn{target.storage_.back().get()};
    auto framebuffer = Framebuffer::create(drawn, target.depth_.get());
    if (!framebuffer) return framebuffer.diagnostics;
    target.drawn_ = std::move(*framebuffer);
    if (target.samples_ == 1) return target;

    auto single = Renderbuffer::color(capabilities, width, height, format);
    if (!single) return single.diagnostics;
    target.storage_.push_back(kept(std::move(*single)));
    const std::array<ColorAttachment, 1> readable{target.storage_.back().get()};
    auto resolved = Framebuffer::create(readable, nullptr);
    if (!resolved) return resolved.diagnostics;
    target.resolved_ = std::move(*resolved);
    return target;
}

Result<Target> Target::textures(const Capabilities& capabilities, std::span<const Texture* const> textures,
                                int samples, SharedDepth depth) {
    if (textures.empty()) return diagnose("gpu-E05", "a render target needs at least one texture");
    if (textures.size() > static_cast<std::size_t>(capabilities.maxDrawBuffers))
        return diagnose("gpu-E04", std::to_string(textures.size()) +
                                       " colour targets; this driver's limit is " +
                                       std::to_string(capabilities.maxDrawBuffers));
    const TextureSize size = textures.front()->size();
    for (const Texture* each : textures)
        if (each->shape() != TextureShape::texture2D || each->size() != size)
            return diagnose("gpu-E05", "textures that are drawn into together must be 2D and of one size");

    Target target;
    target.width_ = size.width;
    target.height_ = size.height;
    target.format_ = textures.front()->format();
    std::vector<ColorAttachment> direct;
    std::vector<ColorAttachment> drawn;
    for (const Texture* each : textures) {
        direct.emplace_back(each);
        if (samples <= 1) continue;
        auto color = Renderbuffer::color(capabilities, size.width, size.height, each->format(), samples);
        if (!color) return color.diagnostics;
        target.samples_ = color->samples();
        target.storage_.push_back(kept(std::move(*color)));
        drawn.emplace_back(target.storage_.back().get());
    }
    if (!depth) {
        auto own = Renderbuffer::depth(capabilities, size.width, size.height, target.samples_);
        if (!own) return own.diagnostics;
        depth = kept(std::move(*own));
    }
    target.depth_ = std::move(depth);

    auto framebuffer = Framebuffer::create(drawn.empty() ? direct : drawn, target.depth_.get());
    if (!framebuffer) return framebuffer.diagnostics;
    target.drawn_ = std::move(*framebuffer);
    if (drawn.empty()) return target;
    auto resolved = Framebuffer::create(direct, nullptr);
    if (!resolved) return resolved.diagnostics;
    target.resolved_ = std::move(*resolved);
    return target;
}

void Target::bind() const {
    drawn_.bindForDrawing();
    glViewport(0, 0, width_, height_);
}

void Target::clearColor(int index, const std::array<float, 4>& rgba) const {
    glClearBufferfv(GL_COLOR, index, rgba.data());
}

void Target::clearDepth() const {
    constexpr GLfloat kFar = 1;
    glClearBufferfv(GL_DEPTH, 0, &kFar);
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

}  // namespace glibra::gpu
