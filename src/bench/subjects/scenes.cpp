#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// A way to draw a scene.
struct SceneWay {
    std::string_view name;
    int samples = 1;      ///< 0: as many as the bound needs
    double maxError = 0;  ///< pixels; 0: the counts of the scene and of the language
    bool overrideCounts = false;
};
constexpr std::array<SceneWay, 5> kWays{{{"1 sample", 1},
                                         {"2 samples", 2},
                                         {"4 samples", 4},
                                         {"--max-error 0.25", 0, .25},
                                         {"--max-error 0.25 --override-counts", 0, .25, true}}};
constexpr std::size_t kPlain = 0, kFourSamples = 2, kBudget = 3, kFreeBudget = 4;

/// The quality of the reference. A quick run takes every sixth scene.
struct Thoroughness {
    std::size_t stride = 1;
    int samplesASide = 8;
    double slow = .25;  ///< a picture that takes more seconds gets only 4 samples per side
    int finest = 32;    ///< meshes within 1 / finest of a pixel of their surfaces
};
Thoroughness thoroughness(const Bench& bench) {
    return bench.isQuick() ? Thoroughness{.stride = 6, .samplesASide = 4, .finest = 16} : Thoroughness{};
}

/// One scene drawn in each of the ways.
struct MeasuredScene {
    std::string name;
    int width = 0, height = 0;
    std::array<PictureError, kWays.size()> errors{};
    std::array<Point, kWays.size()> points{};  ///< without their errors
    std::string slowestWork{};                 ///< of the first way on the device
    int referenceSamples = 0;

    [[nodiscard]] double seconds(std::size_t way) const { return points[way].time->median; }
};

constexpr double kSecondsInMillisecond = 1e-3;

double secondsOf(const std::vector<render::Stats::GpuTime>& times) {
    double sum = 0;
    for (const render::Stats::GpuTime& each : times) sum += each.milliseconds * kSecondsInMillisecond;
    return sum;
}

/// "pass into window (line 12) 0.31 ms"; empty if nothing is drawn.
std::string slowestOf(const std::vector<render::Stats::GpuTime>& times) {
    const auto slowest = std::ranges::max_element(times, {}, &render::Stats::GpuTime::milliseconds);
    if (slowest == times.end()) return {};
    const std::string line = slowest->line > 0 ? fmt::format(" (line {})", slowest->line) : "";
    return fmt::format("{}{} {}", slowest->what, line,
                       secondsText(slowest->milliseconds * kSecondsInMillisecond));
}

MeasuredScene measureScene(Bench& bench, const ShippedScene& scene) {
    gpu::Context& context = bench.context();
    RenderOptions options;
    if (bench.isQuick()) options.width = options.height = 64;
    MeasuredScene measured{.name = scene.name};
    std::array<image::Image, kWays.size()> pictures;
    for (std::size_t i = 0; i < kWays.size(); ++i) {
        RenderOptions way = options;
        way.samples = kWays[i].samples;
        way.maxError = kWays[i].maxError;
        way.overrideCounts = kWays[i].overrideCounts;
        constexpr double kEnough = .15;  // seconds, for each of many scenes
        DrawnScene drawn = drawnScene(bench, scene.path, way, kEnough);
        pictures[i] = std::move(drawn.picture);
        measured.points[i] = {0, scene.name, 0, drawn.time, drawn.bytes};
        if (const auto times = sceneGpuTimes(context, scene.path, way)) {
            measured.points[i].gpuTime = secondsOf(*times);
            if (i == kPlain) measured.slowestWork = slowestOf(*times);
        }
    }
    measured.width = pictures.front().width;
    measured.height = pictures.front().height;
    const Thoroughness thorough = thoroughness(bench);
    const int side = measured.seconds(kPlain) < thorough.slow ? thorough.samplesASide : 4;
    RenderOptions best = options;
    best.set = scene.finest;
    best.maxError = 1. / thorough.finest;
    best.overrideCounts = true;
    const image::Image reference = sampledPicture(context, scene.path, best, side);
    measured.referenceSamples = side * side;
    for (std::size_t i = 0; i < kWays.size(); ++i) measured.errors[i] = pictureError(reference, pictures[i]);
    return measured;
}

/// Scenes by one measure of their error, largest first; one curve per way.
Figure ranked(std::vector<MeasuredScene> all, Figure figure, double PictureError::* error) {
    std::ranges::sort(all, std::ranges::greater(),
                      [&](const MeasuredScene& each) { return each.errors.front().*error; });
    for (std::size_t i = 0; i < kWays.size(); ++i)
        for (std::size_t rank = 0; rank < all.size(); ++rank) {
            Point point = all[rank].points[i];
            point.setting = static_cast<double>(rank + 1);
            point.error = all[rank].errors[i].*error;
            figure.add(kWays[i].name, std::move(point));
        }
    constexpr std::size_t kNamed = 10;
    for (const MeasuredScene& each : std::span(all).first(std::min(kNamed, all.size())))
        figure.note("{} ({} x {}): {}, with 4 samples {}; {} and {}", each.name, each.width, each.height,
                    numberText(each.errors[kPlain].*error), numberText(each.errors[kFourSamples].*error),
                    secondsText(each.seconds(kPlain)), secondsText(each.seconds(kFourSamples)));
    return figure;
}

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[values.size() / 2];
}

/// The gain and the cost of a way against one sample and the scene's own counts.
std::string comparison(const std::vector<MeasuredScene>& all, std::size_t way) {
    std::vector<double> better, longer;
    std::size_t faster = 0;
    for (const MeasuredScene& each : all) {
        const double ratio = each.seconds(way) / each.seconds(kPlain);
        if (each.errors[kPlain].rootMeanSquare > 0)
            better.push_back(each.errors[way].rootMeanSquare / each.errors[kPlain].rootMeanSquare);
        longer.push_back(ratio);
        if (ratio < 1) ++faster;
    }
    return fmt::format(
        "{}: {:.2f} of the error in {:.2f} of the time of one sample (medians over the scenes); {} of {} "
        "scenes are faster",
        kWays[way].name, medianOf(better), medianOf(longer), faster, all.size());
}

/// How long the scenes take, and what the ways gain.
std::vector<std::string> overall(const std::vector<MeasuredScene>& all) {
    std::vector<double> times;
    times.reserve(all.size());
    for (const MeasuredScene& each : all) times.push_back(each.seconds(kPlain));
    const auto slowest =
        std::ranges::max_element(all, {}, [](const MeasuredScene& each) { return each.seconds(kPlain); });
    return {
        fmt::format("{} scenes; half of the pictures take less than {} (parse, plan, upload, draw, read), "
                    "the longest takes {}: {}",
                    all.size(), secondsText(medianOf(times)), secondsText(slowest->seconds(kPlain)),
                    slowest->name),
        comparison(all, kFourSamples), comparison(all, kBudget), comparison(all, kFreeBudget)};
}

/// The GPU time of the pictures, and what takes the most of it in the slowest ones.
std::vector<std::string> onTheDevice(std::vector<MeasuredScene> all) {
    std::erase_if(all, [](const MeasuredScene& each) { return !each.points[kPlain].gpuTime; });
    if (all.empty()) return {"GPU time: not measured, the driver has no timer"};
    std::ranges::sort(all, std::ranges::greater(),
                      [](const MeasuredScene& each) { return *each.points[kPlain].gpuTime; });
    std::vector<std::string> findings{fmt::format("GPU time: half of the pictures take less than {}",
                                                  secondsText(*all[all.size() / 2].points[kPlain].gpuTime))};
    constexpr std::size_t kNamed = 5;
    for (std::size_t i = 0; i < std::min(kNamed, all.size()); ++i)
        findings.push_back(fmt::format("{}: GPU time {}, of which {}", all[i].name,
                                       secondsText(*all[i].points[kPlain].gpuTime), all[i].slowestWork));
    return findings;
}

/// Names the scenes whose reference has fewer samples than the others; empty if there are none.
std::string slowOnes(const std::vector<MeasuredScene>& all) {
    const int most = std::ranges::max_element(all, {}, &MeasuredScene::referenceSamples)->referenceSamples;
    std::vector<std::string> names;
    int fewest = most;
    for (const MeasuredScene& each : all)
        if (each.referenceSamples < most) {
            names.push_back(each.name);
            fewest = each.referenceSamples;
        }
    if (names.empty()) return {};
    return fmt::format("the reference has {} samples per pixel instead of {} for {}", fewest, most,
                       fmt::join(names, ", "));
}

}  // namespace

std::vector<Figure> measureScenes(Bench& bench) {
    std::vector<MeasuredScene> all;
    const Thoroughness thorough = thoroughness(bench);
    const std::vector<std::string> failures =
        forEachScene(bench, thorough.stride,
                     [&](const ShippedScene& scene) { all.push_back(measureScene(bench, scene)); });
    const std::string reference = fmt::format(
        "the mean of {} pictures shifted by parts of a pixel, passes into textures by parts of a texel, with "
        "the finest tessellation of the scene's sliders and meshes within 1/{} of a pixel of their surfaces",
        thorough.samplesASide * thorough.samplesASide, thorough.finest);
    const auto figure = [&](std::string name, std::string title, std::string error) {
        return Figure{.name = std::move(name),
                      .title = std::move(title),
                      .settingName = "rank of the scene",
                      .errorName = std::move(error),
                      .reference = reference,
                      .alternatives = Alternatives::setting};
    };
    std::vector<Figure> figures{
        ranked(all,
               figure("root-mean-square", "Shipped scenes: error of the picture, largest first",
                      "root mean square"),
               &PictureError::rootMeanSquare),
        ranked(all,
               figure("pixels", "Shipped scenes: pixels that are visibly off, largest share first",
                      "share of pixels off by more than 8/255"),
               &PictureError::differing),
        ranked(all,
               figure("flip", "Shipped scenes: difference that a person sees, largest first", "mean FLIP"),
               &PictureError::flip)};
    std::vector<std::string>& first = figures.front().findings;
    std::vector<std::string> summary = overall(all);
    std::ranges::move(onTheDevice(all), std::back_inserter(summary));
    first.insert(first.begin(), summary.begin(), summary.end());
    const std::string slow = slowOnes(all);
    if (!slow.empty()) first.push_back(slow);
    first.insert(first.end(), failures.begin(), failures.end());
    return figures;
}

namespace {

/// A black plane behind a white one, both tilted, 100 units away.
constexpr std::string_view kTwoPlanes = R"(WindowSize 256 256
Let near <.0001 .1 10.>
Let gap <.001 .1 10.>
Camera eye  LookAt 0 0 0  0 0 -1  0 1 0  Perspective 50 (near) 1000
Vertex plane.vert
Fragment black.frag
Program Black
Fragment white.frag
Program White
Group back
    Translate 0 0 (-100 - gap)
    Rotate 40 1 0 0
    QuadXY 0 400 1 1
EndGroup
Group front
    Translate 0 0 -100
    Rotate 40 1 0 0
    QuadXY 0 400 1 1
EndGroup
# The farther plane is drawn last: it wins where both have the same depth.
Pass window from eye
    Use White
    Draw front
    Use Black
    Draw back
EndPass
)";
constexpr std::string_view kPlaneVertex = R"(#version 330 core
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
)";
constexpr std::string_view kBlack = R"(#version 330 core
out vec4 fColor;
void main() { fColor = vec4(0., 0., 0., 1.); }
)";
constexpr std::string_view kWhite = R"(#version 330 core
out vec4 fColor;
void main() { fColor = vec4(1.); }
)";

}  // namespace

std::vector<Figure> measureNearFar(Bench& bench) {
    RenderOptions planes;
    planes.samples = 1;
    planes.sceneText = kTwoPlanes;
    planes.texts = {{"plane.vert", std::string(kPlaneVertex)},
                    {"black.frag", std::string(kBlack)},
                    {"white.frag", std::string(kWhite)}};
    Figure figure{.name = "planes",
                  .title = "Two planes of a scene, 100 units away, with far at 1000",
                  .settingName = "far / near",
                  .errorName = "pixels in which the nearer one does not win",
                  .reference = "the nearer plane, which must be visible in every pixel",
                  .alternatives = Alternatives::none,
                  .countsWrong = true};
    for (const double gap : {1., .1, .01}) {
        const std::string curve = fmt::format("gap of {} units", gap);
        double widest = 0;
        bool isClean = true;
        for (double ratio = 100; ratio <= 1e7; ratio *= 10) {
            RenderOptions options = planes;
            options.set = {fmt::format("near={}", 1000 / ratio), fmt::format("gap={}", gap)};
            const auto draw = [&] { return scenePicture(bench.context(), "planes.glib", options); };
            const image::Image picture = need(draw());
            const auto black = std::ranges::count(picture.data, std::byte{0});
            const double wrong = static_cast<double>(black) / static_cast<double>(picture.data.size());
            figure.add(curve,
                       {ratio, fmt::format("{:.0e}:1", ratio), wrong, bench.time([&] { (void)draw(); }, .2)});
            isClean = isClean && wrong == 0;
            if (isClean) widest = ratio;
        }
        if (widest > 0)
            figure.note("{}: no pixel is wrong up to far / near = {:.0e}", curve, widest);
        else
            figure.note("{}: pixels are wrong even with far / near = 100", curve);
    }
    return {std::move(figure)};
}

std::vector<Figure> measureShadows(Bench& bench) {
    (void)bench.context();
    const std::vector<ShippedScene> scenes = shippedScenes();
    const auto scene = std::ranges::find(scenes, "modern/shadow_map", &ShippedScene::name);
    if (scene == scenes.end()) throw Failed({diagnose("bench-E05", "the library has no modern/shadow_map")});
    SceneSweep sweep;
    sweep.scene = scene->path;
    sweep.name = "resolution";
    sweep.values = bench.pick(std::vector{64., 256., 1024.}, {64., 128., 256., 512., 1024., 2048.});
    sweep.options.width = sweep.options.height = bench.pick(128, 600);
    sweep.options.samples = 1;
    RenderOptions finest = sweep.options;
    finest.set = {"resolution=4096"};
    const image::Image reference = need(scenePicture(bench.context(), sweep.scene, finest));
    sweep.reference = &reference;
    Figure figure{.name = "offset",
                  .title = "Shadow maps by their resolution and their offset",
                  .settingName = sweep.name,
                  .errorName = "root mean square of the difference",
                  .errorUnit = "1/255",
                  .reference = "the picture with resolution = 4096 and the offset of the scene"};
    const std::pair<const char*, std::vector<std::string>> offsets[] = {
        {"the offset of the scene", {}},
        {"no offset: stripes of wrong shadow", {"factor=0", "units=0"}},
        {"an offset that detaches shadows", {"units=1000000"}}};
    for (const auto& [name, set] : offsets) {
        SceneSweep each = sweep;
        each.curve = name;
        each.options.set = set;
        for (Figure& one : measureSweep(bench, each)) {
            std::ranges::move(one.curves, std::back_inserter(figure.curves));
            std::ranges::move(one.findings, std::back_inserter(figure.findings));
        }
    }
    return {std::move(figure)};
}

}  // namespace glibra::bench
