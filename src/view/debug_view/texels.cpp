#include "view/debug_view/texels.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "base/texel_format.h"
#include "scene/textures.h"

namespace glibra::view {
namespace {

/// In the order of scene::TextureTarget.
constexpr std::array<const char*, 8> kTargetWords{"1D",       "2D",       "3D",         "cube",
                                                  "1D array", "2D array", "cube array", "rectangle"};

/// The component that an output channel (0 to 2) shows; nothing: it is black.
std::optional<std::size_t> componentOf(const render::Content& content, Channels channels,
                                       std::size_t output) {
    const auto count = static_cast<std::size_t>(content.components);
    std::size_t component = channels == Channels::rgb ? output : static_cast<std::size_t>(channels) - 1;
    if (count == 1 && channels == Channels::rgb) component = 0;
    return component < count ? std::optional(component) : std::nullopt;
}

bool hasNan(std::span<const double> texel) {
    return std::any_of(texel.begin(), texel.end(), [](double each) { return std::isnan(each); });
}
bool hasInfinity(std::span<const double> texel) {
    return std::any_of(texel.begin(), texel.end(), [](double each) { return std::isinf(each); });
}

}  // namespace

TexelImage colorTexels(const gpu::Target& picture) {
    picture.readable().bindForReading();
    if (glCheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return {};
    TexelImage image{picture.width(), picture.height(), {}};
    image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_FLOAT, image.rgba.data());
    return image;
}

render::Content contentOf(const gpu::Target& picture, bool isDepth) {
    render::Content content;
    content.name = "picture";
    content.width = picture.width();
    content.height = picture.height();
    content.components = isDepth ? 1 : 4;
    std::vector<float> texels(content.size() * static_cast<std::size_t>(content.components));
    picture.readable().bindForReading();
    glReadPixels(0, 0, content.width, content.height, isDepth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT,
                 texels.data());
    content.values.assign(texels.begin(), texels.end());
    return content;
}

std::vector<std::uint8_t> screenBytes(const render::Content& content, const TexelDisplay& display) {
    const auto width = static_cast<std::size_t>(std::max(1, content.width));
    const std::size_t texels = width * static_cast<std::size_t>(std::max(0, content.height));
    std::vector<std::uint8_t> bytes(4 * texels, 255);
    const double extent = display.high - display.low;
    const double scale = extent != 0 ? 1 / extent : 0;
    for (std::size_t i = 0; i < texels; ++i) {
        const std::span<const double> texel = content.at(i);
        std::uint8_t* out = bytes.data() + 4 * i;
        const bool isNan = hasNan(texel);
        if (isNan || hasInfinity(texel)) {
            const bool isBright = (i % width + i / width) % 2 == 0;
            const std::uint8_t level = isBright ? 255 : 128;
            out[0] = isNan ? level : 0;
            out[1] = isNan ? 0 : level;
            out[2] = level;
            continue;
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto from = componentOf(content, display.channels, channel);
            out[channel] = from ? asByte((texel[*from] - display.low) * scale) : 0;
        }
    }
    return bytes;
}

std::pair<double, double> rangeOf(const render::Content& content, Channels channels) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < content.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto from = componentOf(content, channels, channel);
            if (!from || !std::isfinite(content.at(i)[*from])) continue;
            low = std::min(low, content.at(i)[*from]);
            high = std::max(high, content.at(i)[*from]);
        }
    return low <= high ? std::pair(low, high) : std::pair(0.0, 1.0);
}

NonFiniteTexels countNonFinite(const render::Content& content) {
    NonFiniteTexels count;
    for (std::size_t i = 0; i < content.size(); ++i) {
        const std::span<const double> texel = content.at(i);
        if (hasNan(texel))
            ++count.nan;
        else if (hasInfinity(texel))
            ++count.infinite;
    }
    return count;
}

std::string textureKey(const scene::Scene& scene, scene::TextureIndex texture) {
    const std::string& name = scene.textures[texture].name;
    return name.empty() ? fmt::format("#{}", texture.position()) : name;
}

std::string textureTitle(const scene::Scene& scene, scene::TextureIndex texture) {
    const scene::Texture& of = scene.textures[texture];
    std::string what;
    if (const auto* picture = std::get_if<scene::PictureSource>(&of.source)) {
        what = scene.files[picture->files.front()].name;
    } else if (const auto* empty = std::get_if<scene::EmptySource>(&of.source); empty && !of.name.empty()) {
        what = fmt::format("{}", empty->width);
        if (scene::sideCount(of.target) > 1) what += fmt::format(" x {}", empty->height);
        if (empty->depth > 1) what += fmt::format(" x {}", empty->depth);
        what += fmt::format(", {}", base::name(empty->format));
        if (of.samples > 1) what += fmt::format(", {} samples", of.samples);
    } else {
        what = empty ? "target" : "noise";
    }
    const char* target = kTargetWords.at(static_cast<std::size_t>(of.target));
    std::string title = of.name.empty() ? fmt::format("unit {} / {}: {}", of.unit, target, what)
                                        : fmt::format("{}: {}, {}", of.name, target, what);
    // Built-in noise textures are not made by a statement, so they have no line.
    if (!std::holds_alternative<scene::NoiseSource>(of.source))
        title += fmt::format(", line {}", of.place.line);
    return title;
}

}  // namespace glibra::view
