#include "gpu/object/texture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/number.h"
#include "gpu/context/errors.h"
#include "gpu/context/es_functions.h"
#include "gpu/format/gl_names.h"

namespace glibra::gpu {

GLenum glTarget(TextureShape shape) {
    constexpr std::array<GLenum, kTextureShapes> kTargets{GL_TEXTURE_1D,
                                                          GL_TEXTURE_2D,
                                                          GL_TEXTURE_3D,
                                                          GL_TEXTURE_CUBE_MAP,
                                                          GL_TEXTURE_1D_ARRAY,
                                                          GL_TEXTURE_2D_ARRAY,
                                                          GL_TEXTURE_CUBE_MAP_ARRAY,
                                                          GL_TEXTURE_RECTANGLE,
                                                          GL_TEXTURE_2D_MULTISAMPLE,
                                                          GL_TEXTURE_2D_MULTISAMPLE_ARRAY};
    // ES has no textures of one dimension; those have one row there.
    if (shape == TextureShape::texture1D && isEs()) return GL_TEXTURE_2D;
    return kTargets.at(static_cast<std::size_t>(shape));
}

TextureShape shapeOfLayer(TextureShape shape) {
    if (shape == TextureShape::texture1D || shape == TextureShape::array1D) return TextureShape::texture1D;
    if (shape == TextureShape::rectangle) return shape;
    return isMultisampled(shape) ? TextureShape::multisampled : TextureShape::texture2D;
}

TextureSize sizeOfLevel(TextureShape shape, TextureSize size, int level) {
    const auto smaller = [&](int side) { return std::max(1, side >> std::min(level, 30)); };
    return {smaller(size.width), smaller(size.height), isArray(shape) ? size.depth : smaller(size.depth)};
}

int mostLevels(TextureShape shape, TextureSize size) {
    if (isMultisampled(shape) || shape == TextureShape::rectangle) return 1;
    const int depth = shape == TextureShape::texture3D ? size.depth : 1;
    return static_cast<int>(
        std::bit_width(static_cast<unsigned>(std::max({1, size.width, size.height, depth}))));
}

std::string describe(TextureShape shape, TexelFormat format, TextureSize size) {
    std::string text = "a " + std::to_string(size.width);
    if (shapeOfLayer(shape) != TextureShape::texture1D) text += " x " + std::to_string(size.height);
    if (shape == TextureShape::texture3D) text += " x " + std::to_string(size.depth);
    if (isArray(shape))
        text += ", " + std::to_string(isCube(shape) ? size.depth / 6 : size.depth) + " layers";
    return text + (isCube(shape) ? " cube map (" : " texture (") + std::string(name(format)) + ")";
}

std::uint64_t texelCount(TextureShape shape, TextureSize size) {
    const auto count = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                       static_cast<std::uint64_t>(size.depth);
    return shape == TextureShape::cube ? 6 * count : count;
}

namespace {

/// The sizes by which GL stores a level. The layers of a 1D array are its second one.
struct Sides {
    int count = 2;
    GLsizei width = 1, height = 1, depth = 1;
};

Sides sidesOf(TextureShape shape, TextureSize size) {
    if (shape == TextureShape::texture1D) return {1, size.width};
    if (shape == TextureShape::array1D) return {2, size.width, size.depth};
    if (shape == TextureShape::texture3D || isArray(shape)) return {3, size.width, size.height, size.depth};
    return {2, size.width, size.height};
}

/// Allocates one level by the calls of GL 4.1.
void allocateLevel(TextureShape shape, TexelFormat format, TextureSize size, int level) {
    const GLenum target = glTarget(shape);
    const auto inside = static_cast<GLint>(internalFormat(format));
    const auto [layout, type] = nativeTransfer(format);
    const auto [count, width, height, depth] = sidesOf(shape, size);
    if (shape == TextureShape::cube)
        for (GLenum face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, inside, width, height, 0, layout, type,
                         nullptr);
    else if (count == 1)
        glTexImage1D(target, level, inside, width, 0, layout, type, nullptr);
    else if (count == 2)
        glTexImage2D(target, level, inside, width, height, 0, layout, type, nullptr);
    else
        glTexImage3D(target, level, inside, width, height, depth, 0, layout, type, nullptr);
}

/// Allocates all samples. Their positions are those of renderbuffers, which such textures are drawn together
/// with.
void allocateSamples(const Capabilities& capabilities, const TextureLayout& layout) {
    const GLenum target = glTarget(layout.shape);
    const GLenum inside = internalFormat(layout.format);
    const auto& [width, height, depth] = layout.size;
    const bool hasStorage = capabilities.atLeast(4, 3);
    if (isArray(layout.shape)) {
        const auto store = hasStorage ? glTexStorage3DMultisample : glTexImage3DMultisample;
        return store(target, layout.samples, inside, width, height, depth, GL_TRUE);
    }
    const auto store = hasStorage ? glTexStorage2DMultisample : glTexImage2DMultisample;
    store(target, layout.samples, inside, width, height, GL_TRUE);
}

}  // namespace

int largestSide(const Capabilities& capabilities, TextureShape shape) {
    if (shape == TextureShape::rectangle) return capabilities.maxRectangleSide;
    if (shape == TextureShape::texture3D) return capabilities.max3DTextureSide;
    // GL has one limit for 1D and 2D.
    return isCube(shape) ? capabilities.maxCubeSide : capabilities.max2DTextureSide;
}

void allocate(const Capabilities& capabilities, const TextureLayout& layout) {
    if (isMultisampled(layout.shape)) return allocateSamples(capabilities, layout);
    if (!capabilities.atLeast(4, 2) && !capabilities.isEs) {
        for (int level = 0; level < layout.levels; ++level)
            allocateLevel(layout.shape, layout.format, sizeOfLevel(layout.shape, layout.size, level), level);
        return;
    }
    const GLenum target = glTarget(layout.shape);
    const GLenum inside = internalFormat(layout.format);
    const auto [count, width, height, depth] = sidesOf(layout.shape, layout.size);
    if (count == 1)
        glTexStorage1D(target, layout.levels, inside, width);
    else if (count == 2)
        glTexStorage2D(target, layout.levels, inside, width, height);
    else
        glTexStorage3D(target, layout.levels, inside, width, height, depth);
}

void fillLevel(TextureShape shape, TextureSize size, int level, Transfer transfer, const std::byte* data,
               std::size_t faceBytes) {
    const auto [format, type] = transfer;
    const GLenum target = glTarget(shape);
    const auto [count, width, height, depth] = sidesOf(shape, size);
    if (shape == TextureShape::cube)
        for (GLenum i = 0; i < 6; ++i)
            glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, level, 0, 0, width, height, format, type,
                            data + i * faceBytes);
    else if (count == 1)
        glTexSubImage1D(target, level, 0, width, format, type, data);
    else if (count == 2)
        glTexSubImage2D(target, level, 0, 0, width, height, format, type, data);
    else
        glTexSubImage3D(target, level, 0, 0, 0, width, height, depth, format, type, data);
}

namespace {

/// Replaces floats of a format from -1 to 1 by the nearest values that it can hold. Drivers give the least
/// stored number as less than -1, and round the others twice.
void toWholeSteps(std::vector<std::byte>& texels, const base::TexelFormatRow& row) {
    const int bits = row.bytes * 8 / row.components;
    const double largest = std::ldexp(1, bits - 1) - 1;
    for (std::size_t at = 0; at < texels.size(); at += sizeof(float)) {
        float value = 0;
        std::memcpy(&value, texels.data() + at, sizeof value);
        const double steps = std::max(std::round(static_cast<double>(value) * largest), -largest);
        value = static_cast<float>(steps / largest);
        std::memcpy(texels.data() + at, &value, sizeof value);
    }
}

}  // namespace

Result<Texture> Texture::make(const Capabilities& capabilities, TextureLayout layout) {
    TextureSize& size = layout.size;
    const TextureShape shape = layout.shape;
    if (shapeOfLayer(shape) == TextureShape::texture1D) size.height = 1;
    if (shape != TextureShape::texture3D && !isArray(shape)) size.depth = 1;
    if (!isMultisampled(shape)) layout.samples = 1;
    const std::string what = describe(shape, layout.format, size);
    const int largest = largestSide(capabilities, shape);
    if (size.width < 1 || size.height < 1 || size.depth < 1)
        return diagnose("gpu-E04", what + " has no texels");
    if (isCube(shape) && size.width != size.height) return diagnose("gpu-E04", what + " is not square");
    if (shape == TextureShape::texture3D && hasDepth(layout.format))
        return diagnose("gpu-E04", what + ": depth formats need 1D, 2D, array or cube textures");
    const bool isDeep = isArray(shape) ? size.depth > capabilities.maxArrayLayers : size.depth > largest;
    if (size.width > largest || size.height > largest || isDeep)
        return diagnose(
            "gpu-E04",
            what + " is too large; this driver's limit is " + std::to_string(largest) + " per side" +
                (isArray(shape) ? " and " + std::to_string(capabilities.maxArrayLayers) + " layers" : ""));
    const int most = mostLevels(shape, size);
    if (layout.levels < 1 || layout.levels > most)
        return diagnose("gpu-E04", what + " has 1 to " + std::to_string(most) + " levels, not " +
                                       std::to_string(layout.levels));
    if (isMultisampled(shape)) {
        const int samples = useOf(capabilities, layout.format).samples;
        if (samples < 2)
            return diagnose("gpu-E04", what + ": this driver has no multisampled textures of that format");
        layout.samples = std::clamp(layout.samples, 2, samples);
    }

    Texture texture;
    texture.name_ = Name<glDeleteTextures>(glGenTextures);
    texture.shape_ = shape;
    texture.format_ = layout.format;
    texture.size_ = size;
    texture.levels_ = layout.levels;
    clearErrors();
    texture.bind(kWorkUnit);
    const GLenum target = glTarget(shape);
    allocate(capabilities, layout);
    if (isMultisampled(shape)) {
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
    if (!made || !layout.isFilled) return made;
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
        needed != texels.data.size() || isMultisampled(shape_))
        return {diagnose("gpu-E03", describe(shape_, format_, size) + " takes " + std::to_string(needed) +
                                        " bytes of texels, not " + std::to_string(texels.data.size()))};
    clearErrors();
    bind(kWorkUnit);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const Transfer given{glFormat(texels.components, format_), glType(texels.type)};
    const Transfer native = nativeTransfer(format_);
    if (isEs() && (given.format != native.format || given.type != native.type)) {
        const std::vector<std::byte> taken = forEs(texels.data, {texels.components, texels.type}, format_);
        fillLevel(shape_, size, level, native, taken.data(), taken.size() / 6);
    } else {
        fillLevel(shape_, size, level, given, texels.data.data(), texels.data.size() / 6);
    }
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return {allocationError(code, describe(shape_, format_, size))};
    return {};
}

void Texture::generateMipmaps() {
    bind(kWorkUnit);
    glGenerateMipmap(glTarget(shape_));
}

Result<std::vector<std::byte>> Texture::read(int level, int components, TexelType type) const {
    const TextureSize size = sizeOfLevel(shape_, size_, level);
    if (level < 0 || level >= levels_ || components < 1 || components > 4 || isMultisampled(shape_))
        return diagnose("gpu-E03", describe(shape_, format_, size) + " cannot be read as level " +
                                       std::to_string(level) + " with " + std::to_string(components) +
                                       " components");
    std::vector<std::byte> texels(texelCount(shape_, size) * static_cast<std::size_t>(components) *
                                  bytesOf(type));
    clearErrors();
    bind(kWorkUnit);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const GLenum format = glFormat(components, format_);
    if (isEs())
        readLayers(*this, level, format, glType(type), texels);
    else if (shape_ == TextureShape::cube)
        for (GLenum face = 0; face < 6; ++face)
            glGetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, format, glType(type),
                          texels.data() + face * (texels.size() / 6));
    else
        glGetTexImage(glTarget(shape_), level, format, glType(type), texels.data());
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return allocationError(code, "reading " + describe(shape_, format_, size));
    if (type == TexelType::f32 && base::rowOf(format_).kind == base::TexelClass::signedNormalized)
        toWholeSteps(texels, base::rowOf(format_));
    return texels;
}

int Texture::layers(int level) const {
    if (shape_ == TextureShape::cube) return 6;
    return sizeOfLevel(shape_, size_, level).depth;
}

Result<Texture> Texture::view(std::optional<int> level, std::optional<int> layer) const {
    const std::string what = "a part of " + describe(shape_, format_, size_);
    if ((layer && shape_ == TextureShape::texture3D) || level.value_or(0) >= levels_ ||
        level.value_or(0) < 0 || layer.value_or(0) >= layers() || layer.value_or(0) < 0)
        return diagnose("gpu-E03", what + " cannot be read alone");
    Texture part;
    part.name_ = Name<glDeleteTextures>(glGenTextures);
    part.shape_ = layer ? shapeOfLayer(shape_) : shape_;
    part.format_ = format_;
    part.size_ = sizeOfLevel(shape_, size_, level.value_or(0));
    if (layer) part.size_.depth = 1;
    part.levels_ = level ? 1 : levels_;
    part.samples_ = samples_;
    clearErrors();
    const bool isLayered = isArray(shape_) || isCube(shape_);
    glTextureView(part.id(), glTarget(part.shape_), id(), internalFormat(format_),
                  static_cast<GLuint>(level.value_or(0)), static_cast<GLuint>(part.levels_),
                  static_cast<GLuint>(layer.value_or(0)),
                  isLayered && !layer ? static_cast<GLuint>(layers()) : 1U);
    if (const GLenum code = takeError(); code != GL_NO_ERROR) return allocationError(code, what);
    part.bind(kWorkUnit);
    if (!isMultisampled(part.shape_))
        glTexParameteri(glTarget(part.shape_), GL_TEXTURE_MAX_LEVEL, part.levels_ - 1);
    return part;
}

void Texture::copyLayer(const Texture& from, int level, int layer) {
    glCopyImageSubData(from.id(), glTarget(from.shape()), level, 0, 0, layer, id(), glTarget(shape_), 0, 0, 0,
                       0, size_.width, size_.height, 1);
}

void Texture::showLevels(int first, int count) const {
    if (isMultisampled(shape_)) return;
    bind(kWorkUnit);
    glTexParameteri(glTarget(shape_), GL_TEXTURE_BASE_LEVEL, first);
    glTexParameteri(glTarget(shape_), GL_TEXTURE_MAX_LEVEL, first + count - 1);
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(glTarget(shape_), id());
}

void Texture::bindImage(int unit, int level, std::optional<int> layer, GLenum access,
                        std::optional<TexelFormat> as) const {
    const bool fits = as && base::bytesPerTexel(*as) == base::bytesPerTexel(format_);
    glBindImageTexture(static_cast<GLuint>(unit), id(), level, layer ? GL_FALSE : GL_TRUE, layer.value_or(0),
                       access, internalFormat(fits ? *as : format_));
}

namespace {

GLint glWrap(Wrap wrap) {
    constexpr std::array<GLint, 4> kWraps{GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT,
                                          GL_CLAMP_TO_BORDER};
    return kWraps.at(static_cast<std::size_t>(wrap));
}

GLint glFilter(base::Filter filter) {
    constexpr std::array<GLint, 6> kFilters{GL_NEAREST,
                                            GL_LINEAR,
                                            GL_NEAREST_MIPMAP_NEAREST,
                                            GL_LINEAR_MIPMAP_NEAREST,
                                            GL_NEAREST_MIPMAP_LINEAR,
                                            GL_LINEAR_MIPMAP_LINEAR};
    return kFilters.at(static_cast<std::size_t>(filter));
}

}  // namespace

bool isNearest(base::Filter filter) {
    return filter == base::Filter::nearest || filter == base::Filter::nearestMipmapNearest ||
           filter == base::Filter::nearestMipmapLinear;
}

Sampler::Sampler(const SamplerState& state, std::optional<base::Comparison> compare) {
    const GLuint name = id();
    constexpr std::array<GLenum, 3> kAxes{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        // ES has no borders; shaders read them (glsl/es/additions.h).
        const bool isEdge = isEs() && state.wrap[i] == Wrap::clampToBorder;
        glSamplerParameteri(name, kAxes[i], isEdge ? GL_CLAMP_TO_EDGE : glWrap(state.wrap[i]));
    }
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, glFilter(state.filter));
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, isNearest(state.filter) ? GL_NEAREST : GL_LINEAR);
    if (state.anisotropy > 1)
        glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(state.anisotropy));
    if (state.border != std::array<double, 4>{}) {
        std::array<float, 4> border{};
        std::ranges::transform(state.border, border.begin(), base::toFloat);
        glSamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, border.data());
    }
    if (!compare) return;
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_FUNC, static_cast<GLint>(glFunction(*compare)));
}

}  // namespace glibra::gpu
