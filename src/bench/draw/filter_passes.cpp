#include "bench/draw/filter_passes.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <utility>

#include "bench/draw/offscreen.h"

namespace glibra::bench {
namespace {

constexpr std::string_view kFilterHead = R"(
in vec2 vPlace;
uniform sampler2D uPicture;
out vec4 fColor;
vec4 at(ivec2 place) {
    return texelFetch(uPicture, clamp(place, ivec2(0), textureSize(uPicture, 0) - 1), 0);
}
)";

/// "const float kWeight[n] = float[](...);" of weights 0..radius.
std::string weightTable(std::string_view name, const std::vector<double>& values) {
    std::string list;
    for (const double value : values) list += fmt::format("{}{:.9e}", list.empty() ? "" : ", ", value);
    return fmt::format("const float {}[{}] = float[]({});\n", name, values.size(), list);
}

std::string body(std::string_view declarations, std::string_view statements) {
    return fmt::format("{}{}void main() {{\n    ivec2 p = ivec2(gl_FragCoord.xy);\n{}}}\n", kFilterHead,
                       declarations, statements);
}

}  // namespace

std::string directBlur(const std::vector<double>& weights) {
    return body(weightTable("kWeight", weights), fmt::format(R"(    vec4 sum = vec4(0.);
    for (int y = -{0}; y <= {0}; ++y)
        for (int x = -{0}; x <= {0}; ++x)
            sum += kWeight[abs(x)] * kWeight[abs(y)] * at(p + ivec2(x, y));
    fColor = sum;
)",
                                                             weights.size() - 1));
}

std::string blurAlong(const std::vector<double>& weights, bool isVertical) {
    return body(weightTable("kWeight", weights),
                fmt::format(R"(    vec4 sum = vec4(0.);
    for (int i = -{0}; i <= {0}; ++i)
        sum += kWeight[abs(i)] * at(p + ivec2({1}));
    fColor = sum;
)",
                            weights.size() - 1, isVertical ? "0, i" : "i, 0"));
}

std::string pairedBlurAlong(const std::vector<double>& weights, bool isVertical) {
    // Pairs the pixels i and i + 1 for odd i; with an odd radius the outermost pixel is single.
    std::vector<double> places, together;
    for (std::size_t i = 1; i < weights.size(); i += 2) {
        const double next = i + 1 < weights.size() ? weights[i + 1] : 0;
        together.push_back(weights[i] + next);
        places.push_back(static_cast<double>(i) + next / together.back());
    }
    const std::string_view along = isVertical ? "vec2(0., kPlace[i])" : "vec2(kPlace[i], 0.)";
    return body(weightTable("kPlace", places) + weightTable("kTogether", together),
                fmt::format(R"(    vec2 texel = 1. / vec2(textureSize(uPicture, 0));
    vec4 sum = {:.9e} * at(p);
    for (int i = 0; i < {}; ++i)
        sum += kTogether[i] * (texture(uPicture, (gl_FragCoord.xy + {}) * texel) +
                               texture(uPicture, (gl_FragCoord.xy - {}) * texel));
    fColor = sum;
)",
                            weights.front(), places.size(), along, along));
}

std::string directSobel() {
    return body("", R"(    float across = 0.;
    float up = 0.;
    for (int i = -1; i <= 1; ++i) {
        float weight = i == 0 ? 2. : 1.;
        across += weight * (at(p + ivec2(1, i)).r - at(p + ivec2(-1, i)).r);
        up += weight * (at(p + ivec2(i, 1)).r - at(p + ivec2(i, -1)).r);
    }
    fColor = vec4(length(vec2(across, up)), 0., 0., 1.);
)");
}

std::string sobelColumns(double scale, double bias) {
    return body("", fmt::format(R"(    float below = at(p - ivec2(0, 1)).r;
    float above = at(p + ivec2(0, 1)).r;
    vec2 column = vec2(below + 2. * at(p).r + above, above - below);
    fColor = vec4(column * {:.9e} + {:.9e}, 0., 1.);
)",
                                scale, bias));
}

std::string sobelRows(double scale, double bias) {
    return body("", fmt::format(R"(    vec2 left = (at(p - ivec2(1, 0)).rg - {1:.9e}) / {0:.9e};
    vec2 middle = (at(p).rg - {1:.9e}) / {0:.9e};
    vec2 right = (at(p + ivec2(1, 0)).rg - {1:.9e}) / {0:.9e};
    fColor = vec4(length(vec2(right.x - left.x, left.y + 2. * middle.y + right.y)), 0., 0., 1.);
)",
                                scale, bias));
}

Result<FilterChain> FilterChain::create(const gpu::Capabilities& capabilities, const Plane& picture,
                                        const std::vector<std::string>& fragments, gpu::TexelFormat between) {
    const std::vector<std::uint8_t> bytes = bytesOf(picture);
    Result<gpu::Texture> uploaded = gpu::Texture::create(
        capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
        {picture.width, picture.height, 1}, {std::as_bytes(std::span(bytes)), 1, gpu::TexelType::u8});
    if (!uploaded) return std::move(uploaded.diagnostics);
    FilterChain chain(std::move(*uploaded));
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        Result<gpu::Program> built = program(capabilities, kWholeTarget, fragments[i]);
        if (!built) return std::move(built.diagnostics);
        setInt(*built, "uPicture", 0);
        const bool isLast = i + 1 == fragments.size();
        Result<gpu::Texture> texture = gpu::Texture::create(capabilities, gpu::TextureShape::texture2D,
                                                            isLast ? gpu::TexelFormat::rgba32f : between,
                                                            {picture.width, picture.height, 1});
        if (!texture) return std::move(texture.diagnostics);
        chain.between_.push_back(std::make_unique<const gpu::Texture>(std::move(*texture)));
        const std::array<const gpu::Texture*, 1> color{chain.between_.back().get()};
        Result<gpu::Target> target = gpu::Target::textures(capabilities, color);
        if (!target) return std::move(target.diagnostics);
        chain.passes_.push_back({std::move(*built), std::move(*target)});
    }
    return chain;
}

void FilterChain::draw() const {
    linear_.bind(0);
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        passes_[i].target.bind();
        (i == 0 ? picture_ : *between_[i - 1]).bind(0);
        drawWhole(passes_[i].program);
    }
    glBindSampler(0, 0);
}

Result<Plane> FilterChain::result(const gpu::Capabilities& capabilities) const {
    const Result<std::vector<float>> topFirst = readFloats(capabilities, passes_.back().target, 1);
    if (!topFirst) return topFirst.diagnostics;
    Plane plane{passes_.back().target.width(), passes_.back().target.height(), {}};
    for (int y = plane.height - 1; y >= 0; --y)
        for (int x = 0; x < plane.width; ++x)
            plane.values.push_back(
                (*topFirst)[static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.width) +
                            static_cast<std::size_t>(x)]);
    return plane;
}

double FilterChain::bytesBetween() const {
    double bytes = 0;
    for (std::size_t i = 0; i + 1 < between_.size(); ++i)
        bytes += static_cast<double>(between_[i]->size().width) * between_[i]->size().height *
                 static_cast<double>(gpu::bytesPerTexel(between_[i]->format()));
    return bytes;
}

}  // namespace glibra::bench
