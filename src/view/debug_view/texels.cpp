#include "view/debug_view/texels.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <cmath>

#include "gpu/object/framebuffer.h"
#include "gpu/object/name.h"

namespace glibra::view {
namespace {

TexelImage readBound(int width, int height) {
    TexelImage image{width, height, {}};
    if (glCheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return {};
    image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, image.rgba.data());
    return image;
}

std::uint8_t asByte(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.F, 1.F) * 255));
}

const char* word(scene::TextureTarget target) {
    switch (target) {
        case scene::TextureTarget::texture1D:
            return "1D";
        case scene::TextureTarget::texture2D:
            return "2D";
        case scene::TextureTarget::texture3D:
            return "3D";
        case scene::TextureTarget::texture2DArray:
            return "2D array";
        case scene::TextureTarget::cube:
            break;
    }
    return "cube";
}

}  // namespace

int sliceCount(const gpu::Texture& texture) {
    return texture.layers();
}

TexelImage texelsOf(const gpu::Texture& texture, int slice) {
    slice = std::clamp(slice, 0, sliceCount(texture) - 1);
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    const gpu::Name<gpu::deleteFramebuffer> framebuffer(name);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name);
    gpu::attachTexture(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, {&texture, 0, slice});
    const gpu::TextureSize size = texture.size();
    TexelImage image = readBound(size.width, size.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return image;
}

TexelImage colorTexels(const gpu::Target& picture) {
    picture.readable().bindForReading();
    return readBound(picture.width(), picture.height());
}

TexelImage depthTexels(const gpu::Target& picture) {
    picture.readable().bindForReading();
    std::vector<float> depth(static_cast<std::size_t>(picture.width()) *
                             static_cast<std::size_t>(picture.height()));
    glReadPixels(0, 0, picture.width(), picture.height(), GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    TexelImage image{picture.width(), picture.height(), {}};
    image.rgba.reserve(4 * depth.size());
    for (const float each : depth) image.rgba.insert(image.rgba.end(), {each, each, each, 1});
    return image;
}

std::vector<std::uint8_t> screenBytes(const TexelImage& image, const TexelDisplay& display) {
    std::vector<std::uint8_t> bytes(image.rgba.size());
    const auto width = static_cast<std::size_t>(std::max(1, image.width));
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
        const float* texel = image.rgba.data() + i;
        std::uint8_t* out = bytes.data() + i;
        out[3] = 255;
        const bool isNan = std::any_of(texel, texel + 4, [](float each) { return std::isnan(each); });
        const bool isInfinite = std::any_of(texel, texel + 4, [](float each) { return std::isinf(each); });
        if (isNan || isInfinite) {
            const bool isBright = (i / 4 % width + i / 4 / width) % 2 == 0;
            const std::uint8_t level = isBright ? 255 : 128;
            out[0] = isNan ? level : 0;
            out[1] = isNan ? 0 : level;
            out[2] = level;
            continue;
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::size_t from =
                display.channels == Channels::rgb ? channel : static_cast<std::size_t>(display.channels) - 1;
            out[channel] = asByte(texel[from] * display.gain);
        }
    }
    return bytes;
}

NonFiniteTexels countNonFinite(const TexelImage& image) {
    NonFiniteTexels count;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        const float* texel = image.rgba.data() + i;
        if (std::any_of(texel, texel + 4, [](float each) { return std::isnan(each); }))
            ++count.nan;
        else if (std::any_of(texel, texel + 4, [](float each) { return std::isinf(each); }))
            ++count.infinite;
    }
    return count;
}

std::string textureTitle(const scene::Scene& scene, scene::TextureIndex texture) {
    const scene::Texture& of = scene.textures[texture];
    std::string what;
    if (const auto* picture = std::get_if<scene::PictureSource>(&of.source))
        what = scene.files[picture->files.front()].name;
    else if (std::holds_alternative<scene::NoiseSource>(of.source))
        what = "noise";
    else
        what = "target";
    std::string title = fmt::format("unit {} / {}: {}", of.unit, word(of.target), what);
    // Built-in noise textures are not made by a statement, so they have no line.
    if (!std::holds_alternative<scene::NoiseSource>(of.source))
        title += fmt::format(", line {}", of.place.line);
    return title;
}

}  // namespace glibra::view
