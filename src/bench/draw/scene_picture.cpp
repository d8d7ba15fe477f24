#include "bench/draw/scene_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "gpu/context/call_counter.h"
#include "image/compare/flip.h"
#include "render/gpu_times.h"
#include "render/scene_renderer.h"

namespace glibra::bench {
namespace {

/// Components limited to 0..1; NaN becomes 0.
std::vector<float> limitedComponents(const image::Image& picture) {
    std::vector<float> values;
    if (picture.type == image::Component::u8) {
        for (const std::byte each : picture.data)
            values.push_back(static_cast<float>(std::to_integer<int>(each)) / 255.F);
        return values;
    }
    values.resize(picture.data.size() / sizeof(float));
    std::memcpy(values.data(), picture.data.data(), values.size() * sizeof(float));
    for (float& value : values) value = value > 0 ? std::min(value, 1.F) : 0.F;
    return values;
}

}  // namespace

Result<image::Image> scenePicture(gpu::Context& context, const std::filesystem::path& scene,
                                  const RenderOptions& options) {
    render::Stats stats;
    Result<render::SceneRenderer> loaded = render::SceneRenderer::load(context, scene, options, stats);
    if (!loaded) return std::move(loaded.diagnostics);
    Result<image::Image> picture = loaded->draw(0, stats);
    picture.diagnostics.insert(picture.diagnostics.begin(), loaded.diagnostics.begin(),
                               loaded.diagnostics.end());
    return picture;
}

std::optional<std::vector<render::Stats::GpuTime>> sceneGpuTimes(gpu::Context& context,
                                                                 const std::filesystem::path& scene,
                                                                 const RenderOptions& options) {
    render::GpuTimes times(context.capabilities());
    if (!times.measures()) return std::nullopt;
    RenderOptions whole = options;
    whole.skip = false;  // nothing is kept from the first drawing
    render::Stats stats;
    Result<render::SceneRenderer> loaded = render::SceneRenderer::load(context, scene, whole, stats);
    if (!loaded || !loaded->draw(0, stats)) return std::nullopt;
    loaded->measureGpu(times);
    if (!loaded->draw(0, stats)) return std::nullopt;
    return times.finish();
}

double scenePictureBytes(gpu::Context& context, const std::filesystem::path& scene,
                         const RenderOptions& options) {
    constexpr double kColorAndDepth = 8;
    const gpu::CallCounter counter;
    const Result<image::Image> picture = scenePicture(context, scene, options);
    if (!picture) return std::numeric_limits<double>::quiet_NaN();
    const double pixels = static_cast<double>(picture->width) * picture->height;
    return static_cast<double>(counter.counts().bytesUploaded) +
           kColorAndDepth * pixels * std::max(1, options.samples);
}

namespace {

/// Sample positions for the window, then for each pass into a texture: the places of a square of side x side,
/// in pixels from its middle. Each pass has its own order, the same in every run, so that no two passes move
/// together.
std::vector<std::vector<glm::dvec2>> sampleOrders(std::size_t passes, int side) {
    std::vector<glm::dvec2> places;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) places.emplace_back((x + .5) / side - .5, (y + .5) / side - .5);
    std::mt19937 random(1);
    std::vector<std::vector<glm::dvec2>> orders{places};
    while (orders.size() <= passes) {
        for (std::size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[random() % i]);
        orders.push_back(places);
    }
    return orders;
}

}  // namespace

Result<image::Image> sampledPicture(gpu::Context& context, const std::filesystem::path& scene,
                                    RenderOptions options, int side) {
    constexpr int kOneTile = 1 << 14;  // larger than any picture here
    options.tileSize = kOneTile;
    options.floatPixels = true;
    options.samples = 1;
    render::Stats stats;
    Result<render::SceneRenderer> loaded = render::SceneRenderer::load(context, scene, options, stats);
    if (!loaded) return std::move(loaded.diagnostics);
    std::vector<double> sums;
    image::Image picture;
    const auto passes = static_cast<std::size_t>(std::ranges::count_if(
        loaded->plan().passes,
        [&loaded](const plan::PlannedPass& pass) { return !loaded->plan().passOf(pass).isWindow; }));
    const std::vector<std::vector<glm::dvec2>> orders = sampleOrders(passes, side);
    for (std::size_t i = 0; i < orders.front().size(); ++i) {
        std::vector<glm::dvec2> textures;
        for (std::size_t pass = 1; pass < orders.size(); ++pass) textures.push_back(orders[pass][i]);
        loaded->setShift(orders.front()[i], std::move(textures));
        Result<image::Image> sample = loaded->draw(0, stats);
        if (!sample) return sample;
        const std::vector<float> values = limitedComponents(*sample);
        sums.resize(values.size());
        for (std::size_t k = 0; k < values.size(); ++k) sums[k] += static_cast<double>(values[k]);
        picture = std::move(*sample);
    }
    std::vector<float> means;
    means.reserve(sums.size());
    for (const double sum : sums) means.push_back(static_cast<float>(sum / (side * side)));
    std::memcpy(picture.data.data(), means.data(), means.size() * sizeof(float));
    return picture;
}

PictureError pictureError(const image::Image& reference, const image::Image& picture) {
    constexpr float kVisible = 8.F / 255;
    const std::vector<float> wanted = limitedComponents(reference), got = limitedComponents(picture);
    double sum = 0;
    std::size_t differing = 0;
    for (std::size_t pixel = 0; 3 * pixel < wanted.size(); ++pixel) {
        float largest = 0;
        for (std::size_t k = 3 * pixel; k < 3 * pixel + 3; ++k) {
            const float difference = std::abs(got[k] - wanted[k]);
            largest = std::max(largest, difference);
            sum += static_cast<double>(difference) * static_cast<double>(difference);
        }
        if (largest > kVisible) ++differing;
    }
    const auto count = static_cast<double>(wanted.size());
    return {.rootMeanSquare = std::sqrt(sum / count),
            .differing = 3 * static_cast<double>(differing) / count,
            .flip = image::flip(reference, picture).mean};
}

}  // namespace glibra::bench
