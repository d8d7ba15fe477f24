#include "bench/subjects/builtin_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/draw/offscreen.h"

namespace glibra::bench {
namespace {

constexpr long double kSmallestNormal = 0x1p-126L;

constexpr std::string_view kInputs = "uniform sampler2D uA;\nuniform sampler2D uB;\n";

/// A float, vec2 or vec3 as the first components of a vec4.
std::string asVec4(const BuiltinFunction& function) {
    switch (function.components) {
        case 1:
            return fmt::format("vec4({}, 0., 0., 0.)", function.expression);
        case 2:
            return fmt::format("vec4({}, 0., 0.)", function.expression);
        default:
            return fmt::format("vec4({}, 0.)", function.expression);
    }
}

/// The statement that reads the arguments at `place` and evaluates the function.
std::string evaluation(const BuiltinFunction& function, std::string_view result) {
    return fmt::format(
        "    vec4 a = texelFetch(uA, place, 0);\n    vec4 b = texelFetch(uB, place, 0);\n    {} = {};\n",
        result, asVec4(function));
}

Result<gpu::Program> build(const gpu::Capabilities& capabilities, const BuiltinFunction& function,
                           PrecisionStage stage, int side) {
    if (stage == PrecisionStage::fragment)
        return program(capabilities, kWholeTarget,
                       fmt::format("{}out vec4 fResult;\nvoid main() {{\n    ivec2 place = "
                                   "ivec2(gl_FragCoord.xy);\n{}}}\n",
                                   kInputs, evaluation(function, "fResult")));
    return program(capabilities,
                   fmt::format("{0}flat out vec4 vResult;\nvoid main() {{\n"
                               "    ivec2 place = ivec2(gl_VertexID % {1}, gl_VertexID / {1});\n{2}"
                               "    gl_Position = vec4((vec2(place) + .5) * {3} - 1., 0., 1.);\n}}\n",
                               kInputs, side, evaluation(function, "vResult"), 2.0 / side),
                   "flat in vec4 vResult;\nout vec4 fResult;\nvoid main() {\n    fResult = vResult;\n}\n");
}

Result<gpu::Texture> argumentTexture(const gpu::Capabilities& capabilities, const ArgumentSweep& sweep,
                                     std::size_t first, int side) {
    std::vector<float> texels;
    const auto count = static_cast<std::uint32_t>(side) * static_cast<std::uint32_t>(side);
    texels.reserve(std::size_t{4} * count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::array<float, 8> arguments = argumentsOf(sweep, i);
        texels.insert(texels.end(), arguments.begin() + static_cast<std::ptrdiff_t>(first),
                      arguments.begin() + static_cast<std::ptrdiff_t>(first) + 4);
    }
    return gpu::Texture::create(capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba32f,
                                {side, side, 1},
                                {std::as_bytes(std::span<const float>(texels)), 4, gpu::TexelType::f32});
}

/// The distance from the exact value. A result with a period has the distance to the nearest neighbour that
/// the rounding of the arguments could mean.
long double distanceOf(const BuiltinFunction& function, const Arguments& arguments, long double exact,
                       long double got) {
    const long double plain = std::fabs(got - exact);
    if (!function.period) return plain;
    const long double period = function.period(arguments);
    const long double quotient = arguments[0] / period;
    const bool atBorder = std::fabs(quotient - std::round(quotient)) < 4 * unitInLastPlace(quotient);
    return atBorder ? std::min({plain, std::fabs(got - exact - period), std::fabs(got - exact + period)})
                    : plain;
}

}  // namespace

PrecisionRun::PrecisionRun(gpu::Texture a, gpu::Texture b, gpu::Target target, gpu::Program program,
                           bool byPoints, int side)
    : a_(std::move(a)),
      b_(std::move(b)),
      target_(std::move(target)),
      program_(std::move(program)),
      byPoints_(byPoints),
      side_(side) {}

Result<PrecisionRun> PrecisionRun::create(const gpu::Capabilities& capabilities,
                                          const BuiltinFunction& function, const ArgumentSweep& sweep,
                                          PrecisionStage stage, int side) {
    Result<gpu::Texture> a = argumentTexture(capabilities, sweep, 0, side);
    if (!a) return std::move(a.diagnostics);
    Result<gpu::Texture> b = argumentTexture(capabilities, sweep, 4, side);
    if (!b) return std::move(b.diagnostics);
    Result<gpu::Target> target = gpu::Target::window(capabilities, side, side, gpu::TexelFormat::rgba32f);
    if (!target) return std::move(target.diagnostics);
    Result<gpu::Program> built = build(capabilities, function, stage, side);
    if (!built) return std::move(built.diagnostics);
    setInt(*built, "uA", 0);
    setInt(*built, "uB", 1);
    return PrecisionRun(std::move(*a), std::move(*b), std::move(*target), std::move(*built),
                        stage == PrecisionStage::vertex, side);
}

void PrecisionRun::draw() const {
    target_.bind();
    a_.bind(0);
    b_.bind(1);
    if (byPoints_)
        drawVertices(program_, GL_POINTS, side_ * side_);
    else
        drawWhole(program_);
}

Result<std::vector<float>> PrecisionRun::results(const gpu::Capabilities& capabilities) const {
    Result<std::vector<float>> topFirst = readFloats(capabilities, target_);
    if (!topFirst) return topFirst;
    std::vector<float> values(topFirst->size());
    const auto row = static_cast<std::ptrdiff_t>(4) * side_;
    for (int y = 0; y < side_; ++y)
        std::copy_n(topFirst->begin() + (side_ - 1 - y) * row, row, values.begin() + y * row);
    return values;
}

Precision judgePrecision(const BuiltinFunction& function, const ArgumentSweep& sweep,
                         const std::vector<float>& results) {
    Precision found;
    double sum = 0, timesTheBound = 0;
    std::size_t finite = 0;
    found.samples = results.size() / 4;
    for (std::size_t i = 0; i < found.samples; ++i) {
        const std::array<float, 8> given = argumentsOf(sweep, static_cast<std::uint32_t>(i));
        Arguments arguments{};
        std::copy(given.begin(), given.end(), arguments.begin());
        Values exact{};
        function.exact(arguments, exact);
        for (int c = 0; c < function.components; ++c) {
            const long double wanted = exact[static_cast<std::size_t>(c)];
            const float got = results[4 * i + static_cast<std::size_t>(c)];
            double ulps = std::numeric_limits<double>::infinity();
            if (!std::isfinite(got)) {
                ++found.notNumbers;
            } else {
                long double error = distanceOf(function, arguments, wanted, static_cast<long double>(got));
                if (std::fabs(wanted) < kSmallestNormal && got == 0) error = 0;
                ulps = static_cast<double>(error / unitInLastPlace(wanted));
                sum += ulps;
                ++finite;
                found.largestAbsolute = std::max(found.largestAbsolute, static_cast<double>(error));
            }
            if (ulps > found.largest) {
                found.largest = ulps;
                found.worst = given;
            }
            if (!function.allowed || ulps == 0) continue;
            const auto allowed =
                static_cast<double>(function.allowed(arguments, exact, c) / unitInLastPlace(wanted));
            timesTheBound = std::max(timesTheBound, ulps / allowed);
        }
    }
    found.mean = finite > 0 ? sum / static_cast<double>(finite) : 0;
    if (function.allowed) found.timesTheBound = timesTheBound;
    return found;
}

Result<std::vector<PrecisionRow>> precisionTable(const gpu::Capabilities& capabilities, int side) {
    std::vector<PrecisionRow> rows;
    for (const BuiltinFunction& function : builtinFunctions())
        for (const ArgumentSweep& sweep : function.sweeps) {
            PrecisionRow row{&function, &sweep, {}, {}};
            for (const PrecisionStage stage : {PrecisionStage::vertex, PrecisionStage::fragment}) {
                Result<PrecisionRun> run = PrecisionRun::create(capabilities, function, sweep, stage, side);
                if (!run) return std::move(run.diagnostics);
                run->draw();
                const Result<std::vector<float>> results = run->results(capabilities);
                if (!results) return results.diagnostics;
                (stage == PrecisionStage::vertex ? row.vertex : row.fragment) =
                    judgePrecision(function, sweep, *results);
            }
            rows.push_back(row);
        }
    return rows;
}

}  // namespace glibra::bench
