#include <iterator>

#include "base/text.h"
#include "bench/subjects/filters.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// Decodes to linear light and encodes again, as expressions of a vec3 c.
struct ColorCurve {
    const char *name, *decode, *encode;
};
constexpr const char* kSrgbDecode = "mix(c / 12.92, pow((c + .055) / 1.055, vec3(2.4)), step(.04045, c))";
constexpr const char* kSrgbEncode =
    "mix(12.92 * c, 1.055 * pow(c, vec3(1. / 2.4)) - .055, step(.0031308, c))";
constexpr ColorCurve kColorCurves[] = {
    {"the curve of sRGB", kSrgbDecode, kSrgbEncode},
    {"power 2.2", "pow(c, vec3(2.2))", "pow(c, vec3(1. / 2.2))"},
    {"square and root", "c * c", "sqrt(c)"},
    {"decoded by the curve, encoded by power 2.2", kSrgbDecode, "pow(c, vec3(1. / 2.2))"}};

std::string colorPass(const char* expression) {
    return fmt::format(R"(uniform sampler2D uPicture;
out vec4 fColor;
void main() {{
    vec3 c = max(texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0).rgb, 0.);
    fColor = vec4({}, 1.);
}}
)",
                       expression);
}

/// Every byte, decoded into a texture, encoded again, and so on; all passes but the last, which writes
/// floats, write texels of one format.
Figure roundTripFigure(Bench& bench) {
    Figure figure{.name = "round-trips",
                  .title = "Bytes made linear and encoded again, by the curve and by the texels between",
                  .settingName = "round trips",
                  .errorName = "largest error of a byte",
                  .errorUnit = "1/255",
                  .reference = "the byte itself: a round trip changes nothing",
                  .alternatives = Alternatives::none};
    Plane ramp{256, 1, {}};
    for (int i = 0; i < 256; ++i) ramp.values.push_back(i / kByte);
    for (const ColorCurve& curve : kColorCurves)
        for (const auto& [format, texels] : kColorFormats) {
            const std::string name = fmt::format("{}, {}", curve.name, format);
            Passes passes;
            for (int trips = 1; trips <= bench.pick(4, 16); trips *= 2) {
                while (std::ssize(passes) < 2 * trips) {
                    passes.push_back(colorPass(curve.decode));
                    passes.push_back(colorPass(curve.encode));
                }
                const FilterChain chain(bench, ramp, passes, texels);
                const Timing time = bench.timeDrawing([&] { chain.draw(); });
                const Plane back = chain.result();
                figure.add(name,
                           {1. * trips, base::counted(trips, "round trip"),
                            kByte * largestDifference(back.values, ramp.values), time, chain.bytesBetween()});
            }
            const Point &once = figure.curves.back().points.front(),
                        &last = figure.curves.back().points.back();
            if (last.error < .5)
                figure.note("{}: every byte comes back after {}", name, last.label);
            else
                figure.note("{}: bytes are off by up to {} after {}, {} after {}", name,
                            numberText(once.error), once.label, numberText(last.error), last.label);
        }
    figure.findings.push_back(halfFloatSentence(bench));
    return figure;
}

}  // namespace

std::vector<Figure> measureColors(Bench& bench) {
    return {roundTripFigure(bench)};
}

}  // namespace glibra::bench
