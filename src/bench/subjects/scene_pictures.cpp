#include "bench/subjects/scene_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>
#include <system_error>

#include "base/own_library.h"
#include "bench/core/device.h"
#include "gpu/context/call_counter.h"
#include "image/compare/flip.h"
#include "render/gpu_times.h"
#include "render/scene_renderer.h"
#include "system/places.h"

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

namespace fs = std::filesystem;

const std::map<std::string, std::vector<std::string>>& finestLevels() {
    static const std::map<std::string, std::vector<std::string>> table{
        {"tessellation/adaptive_spheres", {"uDetail=60"}},
        {"tessellation/bezier_curve", {"uOuter1=50"}},
        {"tessellation/bezier_surface", {"uOuter02=50", "uOuter13=50", "uInner0=50", "uInner1=50"}},
        {"tessellation/octant", {"uOuter0=50", "uOuter1=50", "uOuter2=50", "uInner=50"}},
        {"tessellation/pn_triangles", {"uOuter=20", "uInner=20"}},
        {"tessellation/spheres", {"uDetail=200"}}};
    return table;
}

/// Empty if there is none.
fs::path library() {
    for (const fs::path& each : system::foldersIn("GLIBRA_PATH"))
        if (base::isLibrary(each)) return each;
    std::error_code failure;
    if (fs::path found = base::libraryAbove(fs::current_path(failure)); !found.empty()) return found;
    return base::ownLibrary();
}

/// The smallest and largest values around each component of a picture.
struct Ranges {
    std::vector<std::uint8_t> low, high;
};

Ranges rangesOf(const image::Image& picture) {
    Ranges ranges;
    for (const std::byte each : picture.data) ranges.low.push_back(std::to_integer<std::uint8_t>(each));
    ranges.high = ranges.low;
    return ranges;
}

/// Minima and maxima over every value and those `step` components before and after it, within runs of `run`
/// components.
void spreadExtremes(std::vector<std::uint8_t>& values, std::size_t step, std::size_t run, bool wantsLargest) {
    const std::vector<std::uint8_t> before = values;
    const auto pick = [&](std::uint8_t a, std::uint8_t b) {
        return wantsLargest ? std::max(a, b) : std::min(a, b);
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t inRun = i % run;
        if (inRun >= step) values[i] = pick(values[i], before[i - step]);
        if (inRun + step < run) values[i] = pick(values[i], before[i + step]);
    }
}

/// Extends the neighbourhood by one pixel in every direction.
void grow(Ranges& ranges, const image::Image& picture) {
    const auto pixel = static_cast<std::size_t>(picture.components);
    const std::size_t row = pixel * static_cast<std::size_t>(picture.width);
    for (const bool wantsLargest : {false, true}) {
        std::vector<std::uint8_t>& values = wantsLargest ? ranges.high : ranges.low;
        spreadExtremes(values, pixel, row, wantsLargest);
        spreadExtremes(values, row, values.size(), wantsLargest);
    }
}

/// The number of pixels with values outside the ranges.
std::size_t outside(const image::Image& picture, const Ranges& ranges) {
    constexpr int kTolerance = 8;
    const auto components = static_cast<std::size_t>(picture.components);
    std::size_t pixels = 0;
    for (std::size_t first = 0; first < picture.data.size(); first += components) {
        bool isOutside = false;
        for (std::size_t i = first; i < first + components; ++i) {
            const int value = std::to_integer<int>(picture.data[i]);
            isOutside =
                isOutside || value < ranges.low[i] - kTolerance || value > ranges.high[i] + kTolerance;
        }
        pixels += isOutside ? 1 : 0;
    }
    return pixels;
}

/// The cheapest value whose error stays below a step of eight bits.
std::string enough(const Curve& curve, const SceneSweep& sweep) {
    const auto found = std::ranges::find_if(curve.points, [](const Point& each) { return each.error < 1; });
    const Point& finest = curve.points.back();
    if (found == curve.points.end())
        return fmt::format("{}: no value is within 1/255 of the reference, in the mean", curve.name);
    if (&*found == &finest && !sweep.reference)
        return fmt::format("{}: no value but the last one is within 1/255 of it, in the mean", curve.name);
    const std::string text =
        fmt::format("{}: {} = {} is within 1/255 of the {}, in the mean, in {}", curve.name, sweep.name,
                    found->label, sweep.reference ? "reference" : "finest", secondsText(found->time->median));
    return &*found == &finest ? text : text + " instead of " + secondsText(finest.time->median);
}

}  // namespace

std::vector<ShippedScene> shippedScenes() {
    const fs::path root = library();
    std::vector<ShippedScene> scenes;
    std::error_code failure;
    if (!root.empty())
        for (fs::recursive_directory_iterator at(root / "glib", failure), end; at != end;
             at.increment(failure)) {
            if (failure) break;
            const fs::path& path = at->path();
            if (path.extension() != ".glib") continue;
            ShippedScene scene{
                path.parent_path().filename().generic_string() + "/" + path.stem().generic_string(),
                path,
                {}};
            if (const auto finest = finestLevels().find(scene.name); finest != finestLevels().end())
                scene.finest = finest->second;
            scenes.push_back(std::move(scene));
        }
    if (scenes.empty())
        throw Failed({diagnose(
            "bench-E05",
            "cannot find the scenes of the library: no folder with 'glib' and 'shaders' in GLIBRA_PATH, "
            "above the current folder or above the program")});
    std::ranges::sort(scenes, {}, &ShippedScene::name);
    return scenes;
}

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

DrawnScene drawnScene(Bench& bench, const std::filesystem::path& scene, const RenderOptions& options,
                      double enough) {
    constexpr double kColorAndDepth = 8;
    const auto draw = [&] { return scenePicture(bench.context(), scene, options); };
    DrawnScene drawn;
    const gpu::CallCounter counter;
    drawn.picture = need(draw());
    drawn.bytes = static_cast<double>(counter.counts().bytesUploaded) +
                  kColorAndDepth * drawn.picture.width * drawn.picture.height * std::max(1, options.samples);
    drawn.time = bench.time([&] { (void)draw(); }, enough);
    return drawn;
}

std::vector<std::string> forEachScene(Bench& bench, std::size_t stride,
                                      const std::function<void(const ShippedScene&)>& visit) {
    (void)bench.context();
    const std::vector<ShippedScene> scenes = shippedScenes();
    std::vector<std::string> failures;
    std::size_t visits = 0;
    for (std::size_t i = 0; i < scenes.size(); i += stride) try {
            ++visits;
            visit(scenes[i]);
        } catch (const Failed& failed) {
            failures.push_back(
                fmt::format("{} cannot be drawn: {}", scenes[i].name, toString(failed.diagnostics.front())));
        }
    if (failures.size() == visits)
        throw Failed(
            {diagnose("bench-E05", "none of the scenes of the library can be drawn: " + failures.front())});
    return failures;
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

image::Image sampledPicture(gpu::Context& context, const std::filesystem::path& scene, RenderOptions options,
                            int side) {
    constexpr int kOneTile = 1 << 14;  // larger than any picture here
    options.tileSize = kOneTile;
    options.floatPixels = true;
    options.samples = 1;
    render::Stats stats;
    render::SceneRenderer loaded = need(render::SceneRenderer::load(context, scene, options, stats));
    std::vector<double> sums;
    image::Image picture;
    const auto passes = static_cast<std::size_t>(std::ranges::count_if(
        loaded.plan().passes,
        [&loaded](const plan::PlannedPass& pass) { return !loaded.plan().passOf(pass).isWindow; }));
    const std::vector<std::vector<glm::dvec2>> orders = sampleOrders(passes, side);
    for (std::size_t i = 0; i < orders.front().size(); ++i) {
        std::vector<glm::dvec2> textures;
        for (std::size_t pass = 1; pass < orders.size(); ++pass) textures.push_back(orders[pass][i]);
        loaded.setShift(orders.front()[i], std::move(textures));
        image::Image sample = need(loaded.draw(0, stats));
        const std::vector<float> values = limitedComponents(sample);
        sums.resize(values.size());
        for (std::size_t k = 0; k < values.size(); ++k) sums[k] += static_cast<double>(values[k]);
        picture = std::move(sample);
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

int displacement(const image::Image& a, const image::Image& b, int most) {
    const std::size_t allowed = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height) / 1000;
    Ranges aroundA = rangesOf(a), aroundB = rangesOf(b);
    for (int radius = 0; radius <= most; ++radius) {
        if (outside(a, aroundB) <= allowed && outside(b, aroundA) <= allowed) return radius;
        grow(aroundA, a);
        grow(aroundB, b);
    }
    return most + 1;
}

std::vector<Figure> measureSweep(Bench& bench, const SceneSweep& sweep) {
    Curve curve{.name = sweep.curve.empty() ? sweep.scene.filename().generic_string() : sweep.curve};
    std::vector<image::Image> pictures;
    for (const double value : sweep.values) {
        RenderOptions options = sweep.options;
        options.set.push_back(fmt::format("{}={}", sweep.name, value));
        options.skip = false;  // nothing is kept from one drawing to the next
        render::Stats stats;
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::load(bench.context(), sweep.scene, options, stats);
        bench.report(loaded.diagnostics);
        if (!loaded) return {};
        const double time = options.time;
        Result<image::Image> picture = loaded->draw(time, stats);
        bench.report(picture.diagnostics);
        if (!picture) return {};
        pictures.push_back(std::move(*picture));
        const Timing timing = bench.time([&] {
            if (time > 0 && loaded->runsSteps()) (void)loaded->draw(0, stats);  // the steps run again
            (void)loaded->draw(time, stats);
        });
        curve.points.push_back({value, fmt::format("{}", value), 0, timing});
    }
    const image::Image& reference = sweep.reference ? *sweep.reference : pictures.back();
    for (std::size_t i = 0; i < pictures.size(); ++i)
        curve.points[i].error = pictureError(reference, pictures[i]).rootMeanSquare * kByte;
    Curve fitted = curve;
    if (!sweep.reference) fitted.points.pop_back();  // the finest is the reference itself
    Figure figure{
        .name = "sweep",
        .title = fmt::format("{}: {}", sweep.scene.filename().generic_string(), sweep.name),
        .settingName = sweep.name,
        .errorName = "root mean square of the difference",
        .errorUnit = "1/255",
        .reference = sweep.reference
                         ? "a picture that is none of these"
                         : fmt::format("the picture with {} = {}, so that point has no error of its own",
                                       sweep.name, curve.points.back().label),
        .findings = {orderSentence(fitted, sweep.name), enough(curve, sweep)}};
    figure.curves.push_back(std::move(curve));
    return {std::move(figure)};
}

}  // namespace glibra::bench
