#include "gpu/object/texture.h"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "base/number.h"
#include "gpu/context/errors.h"
#include "gpu/object/framebuffer.h"
#include "gpu/state/raster_tracker.h"

namespace glibra::gpu {
namespace {

// Uploads and queries use this unit and replace its binding; every draw binds its own textures.
constexpr GLenum kWorkUnit = GL_TEXTURE0;

int largestSide(const Capabilities& capabilities, TextureShape shape) {
    switch (shape) {
        case TextureShape::texture1D:
            return capabilities.max1DTextureSide;
        case TextureShape::texture2D:
        case TextureShape::array2D:
        case TextureShape::multisampled:
            return capabilities.max2DTextureSide;
        case TextureShape::texture3D:
            return capabilities.max3DTextureSide;
        case TextureShape::cube:
            break;
    }
    return capabilities.maxCubeSide;
}

/// "a 256 x 128 texture (rgba8)".
std::string describe(TextureShape shape, TexelFormat format, TextureSize size) {
    std::string text = "a " + std::to_string(size.width);
    if (shape != TextureShape::texture1D) text += " x " + std::to_string(size.height);
    if (shape == TextureShape::texture3D) text += " x " + std::to_string(size.depth);
    if (shape == TextureShape::array2D) text += ", " + std::to_string(size.depth) + " layers";
    return text + (shape == TextureShape::cube ? " cube map (" : " texture (") + std::string(name(format)) +
           ")";
}

std::uint64_t texelCount(TextureShape shape, TextureSize size) {
    const auto count = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                       static_cast<std::uint64_t>(size.depth);
    return shape == TextureShape::cube ? 6 * count : count;
}

/// Allocates one level by the calls of GL 4.1.
void allocateLevel(TextureShape shape, TexelFormat format, TextureSize size, int level) {
    const GLenum target = glTarget(shape);
    const auto inside = static_cast<GLint>(internalFormat(format));
    const auto [layout, type] = nativeTransfer(format);
    switch (shape) {
        case TextureShape::texture1D:
            glTexImage1D(target, level, inside, size.width, 0, layout, type, nullptr);
            break;
        case TextureShape::texture2D:
            glTexImage2D(target, level, inside, size.width, size.height, 0, layout, type, nullptr);
            break;
        case TextureShape::texture3D:
        case TextureShape::array2D:
            glTexImage3D(target, level, inside, size.width, size.height, size.depth, 0, layout, type,
                         nullptr);
            break;
        case TextureShape::cube:
            for (GLenum face = 0; face < 6; ++face)
                glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, inside, size.width, size.height, 0,
                             layout, type, nullptr);
            break;
        case TextureShape::multisampled:
            break;
    }
}

/// Allocates the texels of the bound texture; from GL 4.2 on as immutable storage.
void allocate(const Capabilities& capabilities, const TextureLayout& layout) {
    const GLenum target = glTarget(layout.shape);
    const GLenum inside = internalFormat(layout.format);
    const auto& [width, height, depth] = layout.size;
    if (layout.shape == TextureShape::multisampled) {
        // The sample positions are those of renderbuffers, which such textures are drawn together with.
        if (capabilities.atLeast(4, 3))
            glTexStorage2DMultisample(target, layout.samples, inside, width, height, GL_TRUE);
        else
            glTexImage2DMultisample(target, layout.samples, inside, width, height, GL_TRUE);
        return;
    }
    if (!capabilities.atLeast(4, 2)) {
        for (int level = 0; level < layout.levels; ++level)
            allocateLevel(layout.shape, layout.format, sizeOfLevel(layout.shape, layout.size, level), level);
        return;
    }
    switch (layout.shape) {
        case TextureShape::texture1D:
            glTexStorage1D(target, layout.levels, inside, width);
            break;
        case TextureShape::texture3D:
        case TextureShape::array2D:
            glTexStorage3D(target, layout.levels, inside, width, height, depth);
            break;
        default:
            glTexStorage2D(target, layout.levels, inside, width, height);
            break;
    }
}

/// Fills a level of the bound texture. `faceBytes`: bytes of one face of a cube map.
void fillLevel(TextureShape shape, TextureSize size, int level, Transfer transfer, const std::byte* data,
               std::size_t faceBytes) {
    const auto [format, type] = transfer;
    switch (shape) {
        case TextureShape::texture1D:
            glTexSubImage1D(GL_TEXTURE_1D, level, 0, size.width, format, type, data);
            break;
        case TextureShape::texture2D:
            glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, size.width, size.height, format, type, data);
            break;
        case TextureShape::texture3D:
        case TextureShape::array2D:
            glTexSubImage3D(glTarget(shape), level, 0, 0, 0, size.width, size.height, size.depth, format,
                            type, data);
            break;
        case TextureShape::cube:
            for (GLenum i = 0; i < 6; ++i)
                glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, level, 0, 0, size.width, size.height,
                                format, type, data + i * faceBytes);
            break;
        case TextureShape::multisampled:
            break;
    }
}

GLint glWrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::clampToEdge:
            return GL_CLAMP_TO_EDGE;
        case Wrap::clampToBorder:
            return GL_CLAMP_TO_BORDER;
        case Wrap::mirroredRepeat:
            break;
    }
    return GL_MIRRORED_REPEAT;
}

GLint glFilter(base::Filter filter) {
    switch (filter) {
        case base::Filter::nearest:
            return GL_NEAREST;
        case base::Filter::linear:
            return GL_LINEAR;
        case base::Filter::nearestMipmapNearest:
            return GL_NEAREST_MIPMAP_NEAREST;
        case base::Filter::linearMipmapNearest:
            return GL_LINEAR_MIPMAP_NEAREST;
        case base::Filter::nearestMipmapLinear:
            return GL_NEAREST_MIPMAP_LINEAR;
        case base::Filter::linearMipmapLinear:
            break;
    }
    return GL_LINEAR_MIPMAP_LINEAR;
}

bool isNearest(base::Filter filter) {
    return filter == base::Filter::nearest || filter == base::Filter::nearestMipmapNearest ||
           filter == base::Filter::nearestMipmapLinear;
}

/// Calls `with` for a framebuffer with that layer of that texture attached, for drawing or reading.
template <class Use>
void withAttached(GLenum framebufferTarget, const Texture& texture, int level, int layer, Use&& use) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    const Name<deleteFramebuffer> framebuffer(name);
    glBindFramebuffer(framebufferTarget, name);
    attachTexture(framebufferTarget, attachmentPoint(texture.format(), 0), {&texture, level, layer});
    use();
}

/// Puts back the framebuffers that were bound.
class FramebufferBindings {
  public:
    FramebufferBindings() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    }
    FramebufferBindings(const FramebufferBindings&) = delete;
    FramebufferBindings& operator=(const FramebufferBindings&) = delete;
    ~FramebufferBindings() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }

  private:
    GLint drawn_ = 0, read_ = 0;
};

/// Clears colour 0, or depth and stencil, of the bound framebuffer to zero.
void clearAttached(TexelFormat format) {
    constexpr std::array<GLfloat, 4> kZeros{};
    constexpr std::array<GLint, 4> kIntegers{};
    constexpr std::array<GLuint, 4> kUnsigned{};
    switch (rowOf(format).kind) {
        case base::TexelClass::integer:
            return glClearBufferiv(GL_COLOR, 0, kIntegers.data());
        case base::TexelClass::unsignedInteger:
            return glClearBufferuiv(GL_COLOR, 0, kUnsigned.data());
        case base::TexelClass::depth:
            return glClearBufferfv(GL_DEPTH, 0, kZeros.data());
        case base::TexelClass::depthStencil:
            return glClearBufferfi(GL_DEPTH_STENCIL, 0, 0, 0);
        default:
            return glClearBufferfv(GL_COLOR, 0, kZeros.data());
    }
}

GLbitfield maskOf(TexelFormat format) {
    if (hasStencil(format)) return GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    return hasDepth(format) ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT;
}

}  // namespace

GLenum glTarget(TextureShape shape) {
    switch (shape) {
        case TextureShape::texture1D:
            return GL_TEXTURE_1D;
        case TextureShape::texture2D:
            return GL_TEXTURE_2D;
        case TextureShape::texture3D:
            return GL_TEXTURE_3D;
        case TextureShape::array2D:
            return GL_TEXTURE_2D_ARRAY;
        case TextureShape::multisampled:
            return GL_TEXTURE_2D_MULTISAMPLE;
        case TextureShape::cube:
            break;
    }
    return GL_TEXTURE_CUBE_MAP;
}

TextureSize sizeOfLevel(TextureShape shape, TextureSize size, int level) {
    const auto smaller = [&](int side) { return std::max(1, side >> std::min(level, 30)); };
    return {smaller(size.width), smaller(size.height),
            shape == TextureShape::array2D ? size.depth : smaller(size.depth)};
}

int mostLevels(TextureShape shape, TextureSize size) {
    if (shape == TextureShape::multisampled) return 1;
    const int depth = shape == TextureShape::texture3D ? size.depth : 1;
    return static_cast<int>(
        std::bit_width(static_cast<unsigned>(std::max({1, size.width, size.height, depth}))));
}

Result<Texture> Texture::make(const Capabilities& capabilities, TextureLayout layout) {
    TextureSize& size = layout.size;
    const TextureShape shape = layout.shape;
    if (shape == TextureShape::texture1D) size.height = 1;
    if (shape != TextureShape::texture3D && shape != TextureShape::array2D) size.depth = 1;
    if (shape != TextureShape::multisampled) layout.samples = 1;
    const std::string what = describe(shape, layout.format, size);
    const int largest = largestSide(capabilities, shape);
    if (size.width < 1 || size.height < 1 || size.depth < 1)
        return diagnose("gpu-E04", what + " has no texels");
    if (shape == TextureShape::cube && size.width != size.height)
        return diagnose("gpu-E04", what + " is not square");
    if (shape == TextureShape::texture3D && hasDepth(layout.format))
        return diagnose("gpu-E04", what + ": depth formats need 1D, 2D, array or cube textures");
    const bool isDeep =
        shape == TextureShape::array2D ? size.depth > capabilities.maxArrayLayers : size.depth > largest;
    if (size.width > largest || size.height > largest || isDeep)
        return diagnose("gpu-E04",
                        what + " is too large; this driver's limit is " + std::to_string(largest) +
                            " per side" +
                            (shape == TextureShape::array2D
                                 ? " and " + std::to_string(capabilities.maxArrayLayers) + " layers"
                                 : ""));
    const int most = mostLevels(shape, size);
    if (layout.levels < 1 || layout.levels > most)
        return diagnose("gpu-E04", what + " has 1 to " + std::to_string(most) + " levels, not " +
                                       std::to_string(layout.levels));
    if (shape == TextureShape::multisampled) {
        const int samples = useOf(capabilities, layout.format).samples;
        if (samples < 2)
            return diagnose("gpu-E04", what + ": this driver has no multisampled textures of that format");
        layout.samples = std::clamp(layout.samples, 2, samples);
    }

    Texture texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    texture.shape_ = shape;
    texture.format_ = layout.format;
    texture.size_ = size;
    texture.levels_ = layout.levels;
    clearErrors();
    glActiveTexture(kWorkUnit);
    const GLenum target = glTarget(shape);
    glBindTexture(target, name);
    allocate(capabilities, layout);
    if (shape == TextureShape::multisampled) {
        GLint samples = 0;
        glGetTexLevelParameteriv(target, 0, GL_TEXTURE_SAMPLES, &samples);
        texture.samples_ = std::max(1, samples);
    } else {
        // A texture is complete only if all levels up to this one exist; the sampler sets the filtering.
        glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, layout.levels - 1);
    }
    if (const GLenum code = takeError(); code != GL_NO_ERROR) return allocationError(code, what);
    return texture;
}

Result<Texture> Texture::create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                TextureSize size, const Texels& texels) {
    Result<Texture> made = make(capabilities, {shape, format, size});
    if (!made) return made;
    Diagnostics problems = made->upload(0, texels);
    if (!problems.empty()) return problems;
    return made;
}

Result<Texture> Texture::create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                TextureSize size) {
    return create(capabilities, {shape, format, size});
}

Result<Texture> Texture::create(const Capabilities& capabilities, const TextureLayout& layout) {
    Result<Texture> made = make(capabilities, layout);
    if (!made) return made;
    clearErrors();
    made->clear(capabilities);
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return allocationError(code, describe(made->shape_, made->format_, made->size_));
    return made;
}

Diagnostics Texture::upload(int level, const Texels& texels) {
    const TextureSize size = sizeOfLevel(shape_, size_, level);
    const std::uint64_t needed =
        texelCount(shape_, size) * static_cast<std::uint64_t>(texels.components) * bytesOf(texels.type);
    if (level < 0 || level >= levels_ || texels.components < 1 || texels.components > 4 ||
        needed != texels.data.size() || shape_ == TextureShape::multisampled)
        return {diagnose("gpu-E03", describe(shape_, format_, size) + " takes " + std::to_string(needed) +
                                        " bytes of texels, not " + std::to_string(texels.data.size()))};
    clearErrors();
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    fillLevel(shape_, size, level, {glFormat(texels.components, format_), glType(texels.type)},
              texels.data.data(), texels.data.size() / 6);
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return {allocationError(code, describe(shape_, format_, size))};
    return {};
}

void Texture::clear(const Capabilities& capabilities) {
    const FormatUse use = useOf(capabilities, format_);
    if (use.color || use.depth) {
        // A framebuffer clears layer by layer in every version, and reads no memory.
        const FramebufferBindings bindings;
        for (int level = 0; level < levels_; ++level)
            for (int layer = 0; layer < layers(level); ++layer)
                withAttached(GL_DRAW_FRAMEBUFFER, *this, level, layer, [&] {
                    glDrawBuffer(hasDepth(format_) ? GL_NONE : GL_COLOR_ATTACHMENT0);
                    clearAttached(format_);
                });
        return;
    }
    if (shape_ == TextureShape::multisampled) return;
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    for (int level = 0; level < levels_; ++level) {
        const TextureSize size = sizeOfLevel(shape_, size_, level);
        const std::vector<std::byte> zeros(texelCount(shape_, size) * bytesPerTexel(format_));
        fillLevel(shape_, size, level, nativeTransfer(format_), zeros.data(), zeros.size() / 6);
    }
}

void Texture::generateMipmaps() {
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    glGenerateMipmap(glTarget(shape_));
}

Result<std::vector<std::byte>> Texture::read(int level, int components, TexelType type) const {
    const TextureSize size = sizeOfLevel(shape_, size_, level);
    if (level < 0 || level >= levels_ || components < 1 || components > 4 ||
        shape_ == TextureShape::multisampled)
        return diagnose("gpu-E03", describe(shape_, format_, size) + " cannot be read as level " +
                                       std::to_string(level) + " with " + std::to_string(components) +
                                       " components");
    std::vector<std::byte> texels(texelCount(shape_, size) * static_cast<std::size_t>(components) *
                                  bytesOf(type));
    clearErrors();
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const GLenum format = glFormat(components, format_);
    if (shape_ == TextureShape::cube)
        for (GLenum face = 0; face < 6; ++face)
            glGetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, format, glType(type),
                          texels.data() + face * (texels.size() / 6));
    else
        glGetTexImage(glTarget(shape_), level, format, glType(type), texels.data());
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return allocationError(code, "reading " + describe(shape_, format_, size));
    return texels;
}

int Texture::layers(int level) const {
    if (shape_ == TextureShape::cube) return 6;
    return sizeOfLevel(shape_, size_, level).depth;
}

void Texture::setSwizzle(const std::array<GLint, 4>& components) {
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    glTexParameteriv(glTarget(shape_), GL_TEXTURE_SWIZZLE_RGBA, components.data());
}

Result<Texture> Texture::view(std::optional<int> level, std::optional<int> layer) const {
    const std::string what = "a part of " + describe(shape_, format_, size_);
    if ((layer && shape_ == TextureShape::texture3D) || level.value_or(0) >= levels_ ||
        level.value_or(0) < 0 || layer.value_or(0) >= layers() || layer.value_or(0) < 0)
        return diagnose("gpu-E03", what + " cannot be read alone");
    Texture part;
    GLuint name = 0;
    glGenTextures(1, &name);
    part.name_ = Name<deleteTexture>(name);
    part.shape_ = layer && (shape_ == TextureShape::cube || shape_ == TextureShape::array2D)
                      ? TextureShape::texture2D
                      : shape_;
    part.format_ = format_;
    part.size_ = sizeOfLevel(shape_, size_, level.value_or(0));
    if (layer) part.size_.depth = 1;
    part.levels_ = level ? 1 : levels_;
    part.samples_ = samples_;
    clearErrors();
    const bool isLayered = shape_ == TextureShape::array2D || shape_ == TextureShape::cube;
    glTextureView(name, glTarget(part.shape_), id(), internalFormat(format_),
                  static_cast<GLuint>(level.value_or(0)), static_cast<GLuint>(part.levels_),
                  static_cast<GLuint>(layer.value_or(0)),
                  isLayered && !layer ? static_cast<GLuint>(layers()) : 1U);
    if (const GLenum code = takeError(); code != GL_NO_ERROR) return allocationError(code, what);
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(part.shape_), name);
    if (part.shape_ != TextureShape::multisampled)
        glTexParameteri(glTarget(part.shape_), GL_TEXTURE_MAX_LEVEL, part.levels_ - 1);
    return part;
}

void Texture::showLevels(int first, int count) const {
    if (shape_ == TextureShape::multisampled) return;
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    glTexParameteri(glTarget(shape_), GL_TEXTURE_BASE_LEVEL, first);
    glTexParameteri(glTarget(shape_), GL_TEXTURE_MAX_LEVEL, first + count - 1);
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(glTarget(shape_), id());
}

void Texture::bindImage(int unit, int level, std::optional<int> layer, GLenum access) const {
    glBindImageTexture(static_cast<GLuint>(unit), id(), level, layer ? GL_FALSE : GL_TRUE, layer.value_or(0),
                       access, internalFormat(format_));
}

Diagnostics copyTexture(const Capabilities& capabilities, const Texture& from, Texture& to) {
    if (from.shape() != to.shape() || from.format() != to.format() || from.size() != to.size() ||
        from.levels() != to.levels() || from.samples() != to.samples())
        return {diagnose("gpu-E03", describe(from.shape(), from.format(), from.size()) +
                                        " cannot be copied to " +
                                        describe(to.shape(), to.format(), to.size()))};
    clearErrors();
    const FramebufferBindings bindings;
    for (int level = 0; level < from.levels(); ++level) {
        const TextureSize size = sizeOfLevel(from.shape(), from.size(), level);
        if (capabilities.atLeast(4, 3)) {
            const GLenum target = glTarget(from.shape());
            glCopyImageSubData(from.id(), target, level, 0, 0, 0, to.id(), target, level, 0, 0, 0, size.width,
                               size.height, from.layers(level));
            continue;
        }
        for (int layer = 0; layer < from.layers(level); ++layer)
            withAttached(GL_READ_FRAMEBUFFER, from, level, layer, [&] {
                withAttached(GL_DRAW_FRAMEBUFFER, to, level, layer, [&] {
                    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height,
                                      maskOf(from.format()), GL_NEAREST);
                });
            });
    }
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return {allocationError(code, "copying " + describe(from.shape(), from.format(), from.size()))};
    return {};
}

void resolveSamples(const Texture& from, const Texture& to) {
    const FramebufferBindings bindings;
    const auto [width, height, depth] = from.size();
    withAttached(GL_READ_FRAMEBUFFER, from, 0, 0, [&] {
        withAttached(GL_DRAW_FRAMEBUFFER, to, 0, 0, [&, w = width, h = height] {
            glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        });
    });
}

Sampler::Sampler(const SamplerState& state, std::optional<base::Comparison> compare) {
    GLuint name = 0;
    glGenSamplers(1, &name);
    name_ = Name<deleteSampler>(name);
    constexpr std::array<GLenum, 3> kAxes{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    for (std::size_t i = 0; i < kAxes.size(); ++i) glSamplerParameteri(name, kAxes[i], glWrap(state.wrap[i]));
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, glFilter(state.filter));
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, isNearest(state.filter) ? GL_NEAREST : GL_LINEAR);
    if (state.anisotropy > 1)
        glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(state.anisotropy));
    if (state.border != std::array<double, 4>{}) {
        std::array<float, 4> border{};
        std::transform(state.border.begin(), state.border.end(), border.begin(), base::toFloat);
        glSamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, border.data());
    }
    if (!compare) return;
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_FUNC, static_cast<GLint>(glFunction(*compare)));
}

}  // namespace glibra::gpu
