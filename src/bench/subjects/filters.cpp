#include "bench/subjects/filters.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <ranges>

#include "base/text.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
namespace {

/// "const float kWeight[n] = float[](...);" of weights 0..radius.
std::string weightTable(std::string_view name, const std::vector<double>& values) {
    std::string list;
    for (const double value : values) list += fmt::format("{}{:.9e}", list.empty() ? "" : ", ", value);
    return fmt::format("const float {}[{}] = float[]({});\n", name, values.size(), list);
}

/// shaders/filter.frag after definitions and tables.
std::string pass(std::string_view definitions) {
    return fmt::format("{}{}", definitions, bench_shaders::filter_frag());
}

/// A way to filter: its passes for a setting, and the format of the texels between them.
struct FilterMethod {
    std::string name;
    std::function<Passes(int setting)> passes;
    gpu::TexelFormat between = gpu::TexelFormat::rgba32f;
};

/// Pictures by setting, and what they shall become.
struct FilterCase {
    int setting;
    std::string label;
    Plane picture, wanted;
};

/// Adds a curve for each method, and gives the mean of the signed differences of its last point, in 255ths.
std::vector<double> addFilters(Figure& figure, Bench& bench, std::span<const FilterMethod> methods,
                               std::span<const FilterCase> cases) {
    std::vector<double> shifts;
    for (const FilterMethod& method : methods) {
        double shift = 0;
        for (const FilterCase& each : cases) {
            const FilterChain chain(bench, each.picture, method.passes(each.setting), method.between);
            const Timing time = bench.timeDrawing([&] { chain.draw(); });
            const Plane drawn = chain.result();
            shift = 0;
            for (std::size_t i = 0; i < drawn.values.size(); ++i)
                shift += kByte * (drawn.values[i] - each.wanted.values[i]) /
                         static_cast<double>(drawn.values.size());
            figure.add(method.name, {1. * each.setting, each.label,
                                     kByte * rootMeanSquare(drawn.values, each.wanted.values), time,
                                     chain.bytesBetween()});
        }
        shifts.push_back(shift);
    }
    return shifts;
}

Figure blurFigure(Bench& bench) {
    Figure figure{.name = "blur",
                  .title = "Gaussian blur: direct and separable, by the texels between the passes",
                  .settingName = "radius, pixels",
                  .errorName = "root mean square",
                  .errorUnit = "1/255",
                  .reference = "the sum over the square of pixels in double on the CPU",
                  .alternatives = Alternatives::setting};
    const Plane picture = testPicture(bench.pick(64, 256));
    std::vector<FilterCase> cases;
    for (int radius = 1; radius <= bench.pick(8, 16); radius *= 2)
        cases.push_back(
            {radius, fmt::format("radius {}", radius), picture, blurred(picture, gaussianWeights(radius))});
    const auto separable = [](int radius) { return separableBlur(gaussianWeights(radius)); };
    const auto paired = [](int radius) { return pairedBlur(gaussianWeights(radius)); };
    std::vector<FilterMethod> methods{
        {"direct", [](int radius) { return directBlur(gaussianWeights(radius)); }}};
    for (const NamedFormat& each : std::views::reverse(kColorFormats))
        methods.push_back({fmt::format("separable, {} between", each.name), separable, each.format});
    methods.push_back({"separable in pairs, float between", paired});
    methods.push_back({"separable in pairs, 8 bit between", paired, gpu::TexelFormat::rgba8});
    addFilters(figure, bench, methods, cases);
    const auto timeOf = [&](std::size_t curve) { return figure.last(curve).time->median; };
    const std::string& label = cases.back().label;
    figure.note("{}: separable takes {:.2f} of the time of direct, in pairs {:.2f}", label,
                timeOf(1) / timeOf(0), timeOf(5) / timeOf(0));
    for (std::size_t i = 1; i < figure.curves.size(); ++i)
        figure.note("{}: {} of a byte's step at {}", figure.curves[i].name, numberText(figure.last(i).error),
                    label);
    return figure;
}

Figure repeatedFigure(Bench& bench) {
    Figure figure{.name = "repeated",
                  .title = "Repeated blur of radius 2: the error from the texels between the passes",
                  .settingName = "blurs",
                  .errorName = "root mean square",
                  .errorUnit = "1/255",
                  .reference = "as many sums over the square of pixels in double on the CPU",
                  .alternatives = Alternatives::setting};
    const Plane picture = testPicture(bench.pick(64, 256));
    const int most = bench.pick(8, 32);
    std::vector<FilterCase> cases;
    Plane plane = picture;
    for (int count = 1, next = 1; count <= most; ++count) {
        plane = blurred(plane, gaussianWeights(2));
        if (count != next) continue;
        cases.push_back({count, base::counted(count, "blur"), picture, plane});
        next *= 2;
    }
    const auto passes = [](int count) {
        Passes all;
        for (int i = 0; i < count; ++i)
            for (std::string& each : separableBlur(gaussianWeights(2))) all.push_back(std::move(each));
        return all;
    };
    std::vector<FilterMethod> methods;
    for (const NamedFormat& each : std::views::reverse(kColorFormats))
        methods.push_back({fmt::format("{} between", each.name), passes, each.format});
    const std::vector<double> shifts = addFilters(figure, bench, methods, cases);
    for (std::size_t i = 0; i < shifts.size(); ++i)
        figure.note("{}: {} of a byte's step after 1 blur, {} after {}, of the mean {:+.2g}", methods[i].name,
                    numberText(figure.curves[i].points.front().error), numberText(figure.last(i).error), most,
                    shifts[i]);
    figure.findings.push_back(halfFloatSentence(bench));
    return figure;
}

Figure sobelFigure(Bench& bench) {
    Figure figure{.name = "sobel",
                  .title = "Sobel gradient: direct and separable, by the texels between the passes",
                  .settingName = "side of the picture, pixels",
                  .errorName = "root mean square of the gradient's length",
                  .errorUnit = "1/255",
                  .reference = "the 3 x 3 kernels in double on the CPU",
                  .alternatives = Alternatives::setting};
    std::vector<FilterMethod> methods{{"direct", [](int) { return directSobel(); }}};
    for (const NamedFormat& each : std::views::reverse(kColorFormats)) {
        // Normalised texels hold 0..1. The smoothed column is in 0..4, its difference in -1..1.
        const bool isFloat = gpu::isFloat(each.format);
        const double scale = isFloat ? 1 : 1. / 5, bias = isFloat ? 0 : 1. / 5;
        methods.push_back({fmt::format("separable, {} between", each.name),
                           [=](int) { return separableSobel(scale, bias); }, each.format});
    }
    std::vector<FilterCase> cases;
    for (int side = bench.pick(64, 128); side <= bench.pick(128, 1024); side *= 2) {
        const Plane picture = testPicture(side);
        cases.push_back({side, fmt::format("{0} x {0}", side), picture, sobel(picture)});
    }
    addFilters(figure, bench, methods, cases);
    const Point direct = figure.last(0);
    for (std::size_t i = 1; i < figure.curves.size(); ++i)
        figure.note("{}: {:.2f} of the time of direct, {} of a byte's step instead of {}",
                    figure.curves[i].name, figure.last(i).time->median / direct.time->median,
                    numberText(figure.last(i).error), numberText(direct.error));
    return figure;
}

std::vector<std::uint8_t> bytesOf(const Plane& plane) {
    std::vector<std::uint8_t> bytes;
    for (const double value : plane.values)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(value * kByte)));
    return bytes;
}

}  // namespace

Passes directBlur(const std::vector<double>& weights) {
    return {pass(fmt::format("#define BLUR\n#define RADIUS {}\n{}", weights.size() - 1,
                             weightTable("kWeight", weights)))};
}

Passes separableBlur(const std::vector<double>& weights) {
    Passes passes;
    for (const std::string_view along : {"ivec2(1, 0)", "ivec2(0, 1)"})
        passes.push_back(pass(fmt::format("#define BLUR_ALONG {}\n#define RADIUS {}\n{}", along,
                                          weights.size() - 1, weightTable("kWeight", weights))));
    return passes;
}

Passes pairedBlur(const std::vector<double>& weights) {
    // Pairs the pixels i and i + 1 for odd i; with an odd radius the outermost pixel is single.
    std::vector<double> places, together;
    for (std::size_t i = 1; i < weights.size(); i += 2) {
        const double next = i + 1 < weights.size() ? weights[i + 1] : 0;
        together.push_back(weights[i] + next);
        places.push_back(static_cast<double>(i) + next / together.back());
    }
    Passes passes;
    for (const std::string_view along : {"ivec2(1, 0)", "ivec2(0, 1)"})
        passes.push_back(
            pass(fmt::format("#define BLUR_PAIRS_ALONG {}\n#define MIDDLE {:.9e}\n#define PAIRS {}\n{}{}",
                             along, weights.front(), places.size(), weightTable("kPlace", places),
                             weightTable("kTogether", together))));
    return passes;
}

Passes directSobel() {
    return {pass("#define SOBEL\n")};
}

Passes separableSobel(double scale, double bias) {
    const std::string range = fmt::format("#define SCALE {:.9e}\n#define BIAS {:.9e}\n", scale, bias);
    return {pass("#define SOBEL_COLUMN\n" + range), pass("#define SOBEL_ROW\n" + range)};
}

FilterChain::FilterChain(Bench& bench, const Plane& picture, const Passes& passes, gpu::TexelFormat between)
    : capabilities_(bench.capabilities()),
      picture_(bench, gpu::TexelFormat::rgba8, {picture.width, picture.height, 1}, bytesOf(picture)) {
    for (const std::string& text : passes) {
        const bool isLast = &text == &passes.back();
        const Texels into(need(gpu::Texture::create(capabilities_, gpu::TextureShape::texture2D,
                                                    isLast ? gpu::TexelFormat::rgba32f : between,
                                                    {picture.width, picture.height, 1})));
        const gpu::Texture* const color = &into.texture();
        passes_.push_back(
            {Shader(bench, text), into, need(gpu::Target::textures(capabilities_, std::span(&color, 1)))});
        passes_.back().shader.set("uPicture", 0);
    }
}

void FilterChain::draw() const {
    const Texels* from = &picture_;
    for (const Pass& each : passes_) {
        each.target.bind();
        from->bind(0);
        each.shader.draw();
        from = &each.into;
    }
}

Plane FilterChain::result() const {
    const gpu::Target& last = passes_.back().target;
    const std::vector<float> topFirst = pixelsOf(capabilities_, last, 1);
    return filled(last.width(), last.height(), [&](int x, int y) {
        return topFirst[static_cast<std::size_t>((last.height() - 1 - y) * last.width() + x)];
    });
}

double FilterChain::bytesBetween() const {
    double bytes = 0;
    for (const Pass& each : passes_)
        if (&each != &passes_.back()) bytes += each.into.bytes();
    return bytes;
}

std::vector<Figure> measureFilters(Bench& bench) {
    return {blurFigure(bench), repeatedFigure(bench), sobelFigure(bench)};
}

}  // namespace glibra::bench
