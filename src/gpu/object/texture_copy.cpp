// Textures are cleared, copied and resolved, mostly by framebuffers that they are attached to.

#include "gpu/object/texture_copy.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "gpu/context/errors.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/readback.h"

namespace glibra::gpu {
namespace {

/// Calls `with` for a framebuffer with that layer of that texture attached, for drawing or reading.
template <class Use>
void withAttached(GLenum framebufferTarget, const Texture& texture, int level, int layer, Use&& use) {
    const Name<glDeleteFramebuffers> framebuffer(glGenFramebuffers);
    glBindFramebuffer(framebufferTarget, framebuffer.get());
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

bool haveOneLayout(const Texture& one, const Texture& other) {
    return one.shape() == other.shape() && one.format() == other.format() && one.size() == other.size() &&
           one.levels() == other.levels() && one.samples() == other.samples();
}

void copyAsDriver(const Texture& from, const Texture& to) {
    const GLenum target = glTarget(from.shape());
    for (int level = 0; level < from.levels(); ++level) {
        const TextureSize size = sizeOfLevel(from.shape(), from.size(), level);
        glCopyImageSubData(from.id(), target, level, 0, 0, 0, to.id(), target, level, 0, 0, 0, size.width,
                           size.height, from.layers(level));
    }
}

/// Draws all layers of a level; samples are averaged.
void blitLevel(const Texture& from, const Texture& to, int level) {
    const TextureSize size = sizeOfLevel(from.shape(), from.size(), level);
    for (int layer = 0; layer < from.layers(level); ++layer)
        withAttached(GL_READ_FRAMEBUFFER, from, level, layer, [&] {
            withAttached(GL_DRAW_FRAMEBUFFER, to, level, layer, [&] {
                glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height,
                                  maskOf(from.format()), GL_NEAREST);
            });
        });
}

void copyDrawn(const Texture& from, const Texture& to) {
    const FramebufferBindings bindings;
    for (int level = 0; level < from.levels(); ++level) blitLevel(from, to, level);
}

/// How shaders see texels of that many bytes as plain bits.
struct BitsRow {
    std::size_t bytes;
    TexelFormat format;
    const char* word;
};
constexpr std::array kBits = std::to_array<BitsRow>({{1, TexelFormat::r8ui, "r8ui"},
                                                     {2, TexelFormat::r16ui, "r16ui"},
                                                     {4, TexelFormat::r32ui, "r32ui"},
                                                     {8, TexelFormat::rg32ui, "rg32ui"},
                                                     {16, TexelFormat::rgba32ui, "rgba32ui"}});
const BitsRow* rowOfBits(std::size_t bytes) {
    const auto found = std::ranges::find_if(kBits, [&](const BitsRow& each) { return each.bytes == bytes; });
    return found == kBits.end() ? nullptr : &*found;
}

}  // namespace

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
        settleClears(capabilities);
        return;
    }
    if (isMultisampled(shape_)) return;
    if (capabilities.atLeast(4, 4)) {
        const auto [layout, type] = nativeTransfer(format_);
        for (int level = 0; level < levels_; ++level) glClearTexImage(id(), level, layout, type, nullptr);
        return;
    }
    bind(kWorkUnit);
    for (int level = 0; level < levels_; ++level) {
        const TextureSize size = sizeOfLevel(shape_, size_, level);
        const std::vector<std::byte> zeros(texelCount(shape_, size) * bytesPerTexel(format_));
        fillLevel(shape_, size, level, nativeTransfer(format_), zeros.data(), zeros.size() / 6);
    }
}

std::uint64_t bytesOf(const Texture& texture) {
    std::uint64_t texels = 0;
    for (int level = 0; level < texture.levels(); ++level)
        texels += texelCount(texture.shape(), sizeOfLevel(texture.shape(), texture.size(), level));
    return texels * bytesPerTexel(texture.format()) * static_cast<std::uint64_t>(texture.samples());
}

Diagnostics copyTexture(const Capabilities& capabilities, const Texture& from, Texture& to) {
    if (!haveOneLayout(from, to))
        return {diagnose("gpu-E03", describe(from.shape(), from.format(), from.size()) +
                                        " cannot be copied to " +
                                        describe(to.shape(), to.format(), to.size()))};
    if (capabilities.atLeast(4, 3)) {
        copyAsDriver(from, to);
        return {};
    }
    clearErrors();
    copyDrawn(from, to);
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return {allocationError(code, "copying " + describe(from.shape(), from.format(), from.size()))};
    return {};
}

bool TextureCopier::copyBy(Way way, const Capabilities& capabilities, const Texture& from, Texture& to) {
    if (way == Way::asDriver) {
        if (capabilities.atLeast(4, 3)) copyAsDriver(from, to);
        return capabilities.atLeast(4, 3);
    }
    const FormatUse use = useOf(capabilities, from.format());
    if (way == Way::drawn) {
        // Other numbers than integers may not arrive bit for bit.
        if (!use.color || !isInteger(from.format())) return false;
        const bool cuts = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
        if (cuts) glDisable(GL_SCISSOR_TEST);
        copyDrawn(from, to);
        if (cuts) glEnable(GL_SCISSOR_TEST);
        return true;
    }
    if (!capabilities.compute || !use.image || from.shape() != TextureShape::texture2D) return false;
    const std::size_t bytes = bytesPerTexel(from.format());
    const Program* program = programFor(capabilities, bytes);
    if (program == nullptr) return false;
    const TexelFormat bits = rowOfBits(bytes)->format;
    program->use();
    finishShaderWrites();
    for (int level = 0; level < from.levels(); ++level) {
        from.bindImage(0, level, {}, GL_READ_ONLY, bits);
        to.bindImage(1, level, {}, GL_WRITE_ONLY, bits);
        const TextureSize size = sizeOfLevel(from.shape(), from.size(), level);
        dispatch(
            {static_cast<GLuint>((size.width + 15) / 16), static_cast<GLuint>((size.height + 15) / 16), 1});
    }
    finishShaderWrites();
    return true;
}

const Program* TextureCopier::programFor(const Capabilities& capabilities, std::size_t texelBytes) {
    const BitsRow* row = rowOfBits(texelBytes);
    if (row == nullptr) return nullptr;
    const auto [known, isNew] = programs_.try_emplace(texelBytes);
    if (isNew) {
        const std::string text =
            std::string("#version 430 core\nlayout(local_size_x = 16, local_size_y = 16) in;\n") +
            "layout(binding = 0, " + row->word + ") readonly uniform uimage2D uFrom;\n" +
            "layout(binding = 1, " + row->word + ") writeonly uniform uimage2D uTo;\n" +
            "void main() {\n    ivec2 at = ivec2(gl_GlobalInvocationID.xy);\n" +
            "    if (all(lessThan(at, imageSize(uTo)))) imageStore(uTo, at, imageLoad(uFrom, at));\n}\n";
        const std::array<StageSource, 1> stages{{{GL_COMPUTE_SHADER, text}}};
        known->second = buildProgram(capabilities, {.stages = stages}).program;
    }
    return known->second ? &*known->second : nullptr;
}

TextureCopier::Way TextureCopier::fastest(const Capabilities& capabilities, const Texture& from,
                                          Texture& to) {
    using Clock = std::chrono::steady_clock;
    constexpr int kRounds = 3;
    Way best = Way::asDriver;
    Clock::duration least{};
    for (const Way way : {Way::asDriver, Way::drawn, Way::computed}) {
        if (!copyBy(way, capabilities, from, to)) continue;
        glFinish();
        const Clock::time_point start = Clock::now();
        for (int i = 0; i < kRounds; ++i) copyBy(way, capabilities, from, to);
        glFinish();
        const Clock::duration taken = Clock::now() - start;
        // The others bind more, so they have to be clearly faster.
        if (way != Way::asDriver && taken * 5 > least * 4) continue;
        best = way;
        least = taken;
    }
    return best;
}

bool TextureCopier::copy(const Capabilities& capabilities, const Texture& from, Texture& to,
                         Diagnostics& problems) {
    constexpr std::uint64_t kLarge = 1 << 20;
    constexpr int kUnmeasured = 8;  // large copies, which take less time than measuring
    const bool isMeasured = !capabilities.isSoftware && capabilities.atLeast(4, 3) &&
                            haveOneLayout(from, to) && from.samples() == 1 && bytesOf(from) >= kLarge &&
                            ++large_[from.format()] > kUnmeasured;
    if (!isMeasured) {
        append(problems, copyTexture(capabilities, from, to));
        return false;
    }
    const auto [known, isNew] = chosen_.try_emplace(from.format(), Way::asDriver);
    if (isNew) {
        known->second = fastest(capabilities, from, to);
        return true;
    }
    if (!copyBy(known->second, capabilities, from, to)) copyAsDriver(from, to);
    return known->second == Way::computed;
}

void readLayers(const Texture& texture, int level, GLenum format, GLenum type, std::span<std::byte> texels) {
    const FramebufferBindings bindings;
    const TextureSize size = sizeOfLevel(texture.shape(), texture.size(), level);
    const int layers = texture.layers(level);
    const std::size_t bytes = texels.size() / static_cast<std::size_t>(layers);
    for (int layer = 0; layer < layers; ++layer)
        withAttached(GL_READ_FRAMEBUFFER, texture, level, layer, [&] {
            readBound({0, 0, size.width, size.height}, format, type,
                      texels.data() + static_cast<std::size_t>(layer) * bytes);
        });
}

void resolveSamples(const Texture& from, const Texture& to) {
    const FramebufferBindings bindings;
    blitLevel(from, to, 0);
}

}  // namespace glibra::gpu
