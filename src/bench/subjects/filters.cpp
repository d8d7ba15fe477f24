#include "bench/subjects/filters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <ranges>

#include "base/text.h"
namespace glibra::bench {
namespace {

/// 0..255, computed from the place (finaliser of MurmurHash3 by Austin Appleby).
std::uint32_t grain(int x, int y) {
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U;
    h = (h ^ (h >> 16)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13)) * 0xC2B2AE35U;
    return (h ^ (h >> 16)) & 255U;
}

int level(int x, int y, int side) {
    const int cell = side / 8;
    const int half = side / 2;
    if (x < half && y < half) return (x / cell + y / cell) % 2 == 0 ? 230 : 25;  // a board
    if (x >= half && y < half) return 255 * (x - half) / half;                   // a ramp
    if (x < half) return x % 5 == 0 || y % 7 == 0 ? 200 : 60;                    // thin lines
    return static_cast<int>(grain(x, y));
}

template <class Value>
Plane filled(int width, int height, const Value& value) {
    Plane plane{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) plane.values.push_back(value(x, y));
    return plane;
}

constexpr std::string_view kFilterHead = R"(in vec2 vPlace;
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

std::string pass(std::string_view declarations, std::string_view statements) {
    return fmt::format("{}{}void main() {{\n    ivec2 p = ivec2(gl_FragCoord.xy);\n{}}}\n", kFilterHead,
                       declarations, statements);
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
            double squares = 0;
            shift = 0;
            const auto count = static_cast<double>(drawn.values.size());
            for (std::size_t i = 0; i < drawn.values.size(); ++i) {
                const double difference = drawn.values[i] - each.wanted.values[i];
                squares += difference * difference;
                shift += kByte * difference / count;
            }
            figure.add(method.name, {1. * each.setting, each.label, kByte * std::sqrt(squares / count), time,
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

double Plane::at(int x, int y) const {
    const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
}

Plane testPicture(int side) {
    return filled(side, side, [&](int x, int y) { return level(x, y, side) / 255.0; });
}

std::vector<double> gaussianWeights(int radius) {
    std::vector<double> weights;
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        const double t = 2.0 * i / radius;
        weights.push_back(std::exp(-t * t / 2));
        sum += (i == 0 ? 1 : 2) * weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

Plane blurred(const Plane& plane, const std::vector<double>& weights) {
    const int radius = static_cast<int>(weights.size()) - 1;
    return filled(plane.width, plane.height, [&](int x, int y) {
        double sum = 0;
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                sum += weights[static_cast<std::size_t>(std::abs(dx))] *
                       weights[static_cast<std::size_t>(std::abs(dy))] * plane.at(x + dx, y + dy);
        return sum;
    });
}

Plane sobel(const Plane& plane) {
    return filled(plane.width, plane.height, [&](int x, int y) {
        double across = 0, up = 0;
        for (int i = -1; i <= 1; ++i) {
            const int weight = i == 0 ? 2 : 1;
            across += weight * (plane.at(x + 1, y + i) - plane.at(x - 1, y + i));
            up += weight * (plane.at(x + i, y + 1) - plane.at(x + i, y - 1));
        }
        return std::hypot(across, up);
    });
}

Passes directBlur(const std::vector<double>& weights) {
    return {pass(weightTable("kWeight", weights), fmt::format(R"(    vec4 sum = vec4(0.);
    for (int y = -{0}; y <= {0}; ++y)
        for (int x = -{0}; x <= {0}; ++x)
            sum += kWeight[abs(x)] * kWeight[abs(y)] * at(p + ivec2(x, y));
    fColor = sum;
)",
                                                              weights.size() - 1))};
}

Passes separableBlur(const std::vector<double>& weights) {
    Passes passes;
    for (const std::string_view place : {"i, 0", "0, i"})
        passes.push_back(pass(weightTable("kWeight", weights), fmt::format(R"(    vec4 sum = vec4(0.);
    for (int i = -{0}; i <= {0}; ++i)
        sum += kWeight[abs(i)] * at(p + ivec2({1}));
    fColor = sum;
)",
                                                                           weights.size() - 1, place)));
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
    for (const std::string_view along : {"vec2(kPlace[i], 0.)", "vec2(0., kPlace[i])"})
        passes.push_back(pass(weightTable("kPlace", places) + weightTable("kTogether", together),
                              fmt::format(R"(    vec2 texel = 1. / vec2(textureSize(uPicture, 0));
    vec4 sum = {:.9e} * at(p);
    for (int i = 0; i < {}; ++i)
        sum += kTogether[i] * (texture(uPicture, (gl_FragCoord.xy + {}) * texel) +
                               texture(uPicture, (gl_FragCoord.xy - {}) * texel));
    fColor = sum;
)",
                                          weights.front(), places.size(), along, along)));
    return passes;
}

Passes directSobel() {
    return {pass("", R"(    float across = 0.;
    float up = 0.;
    for (int i = -1; i <= 1; ++i) {
        float weight = i == 0 ? 2. : 1.;
        across += weight * (at(p + ivec2(1, i)).r - at(p + ivec2(-1, i)).r);
        up += weight * (at(p + ivec2(i, 1)).r - at(p + ivec2(i, -1)).r);
    }
    fColor = vec4(length(vec2(across, up)), 0., 0., 1.);
)")};
}

Passes separableSobel(double scale, double bias) {
    return {pass("", fmt::format(R"(    float below = at(p - ivec2(0, 1)).r;
    float above = at(p + ivec2(0, 1)).r;
    vec2 column = vec2(below + 2. * at(p).r + above, above - below);
    fColor = vec4(column * {:.9e} + {:.9e}, 0., 1.);
)",
                                 scale, bias)),
            pass("", fmt::format(R"(    vec2 left = (at(p - ivec2(1, 0)).rg - {1:.9e}) / {0:.9e};
    vec2 middle = (at(p).rg - {1:.9e}) / {0:.9e};
    vec2 right = (at(p + ivec2(1, 0)).rg - {1:.9e}) / {0:.9e};
    fColor = vec4(length(vec2(right.x - left.x, left.y + 2. * middle.y + right.y)), 0., 0., 1.);
)",
                                 scale, bias))};
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
