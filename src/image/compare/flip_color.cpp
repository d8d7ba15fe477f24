#include "image/compare/flip_color.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "image/compare/lanes.h"

namespace glibra::image {
namespace {

// Linear RGB to XYZ for sRGB's primaries and D65, with the fractions of the authors, and the inverse.
constexpr float kToXyz[3][3] = {
    {10135552.F / 24577794.F, 8788810.F / 24577794.F, 4435075.F / 24577794.F},
    {2613072.F / 12288897.F, 8788810.F / 12288897.F, 887015.F / 12288897.F},
    {1425312.F / 73733382.F, 8788810.F / 73733382.F, 70074185.F / 73733382.F},
};
constexpr float kToRgb[3][3] = {
    {3.241003275F, -1.537398934F, -0.498615861F},
    {-0.969224334F, 1.875930071F, 0.041554224F},
    {0.055639423F, -0.204011202F, 1.057148933F},
};
constexpr float kWhite[3] = {0.950428545F, 1.F, 1.088900371F};
constexpr float kInverseWhite[3] = {1.052156925F, 1.F, 0.918357670F};

inline Lanes row(const float (&matrix)[3], Lanes x, Lanes y, Lanes z) {
    return matrix[0] * x + matrix[1] * y + matrix[2] * z;
}

/// log2 of positive normal numbers: the exponent, plus the series of artanh for the mantissa. Relative error
/// below 2e-7.
inline Lanes log2Of(Lanes x) {
    constexpr std::int32_t kRootHalf = 0x3f3504f3;  // moves the mantissa to sqrt(1/2)..sqrt(2)
    const auto bits = std::bit_cast<IntLanes>(x);
    const IntLanes exponent = (bits - kRootHalf) >> 23;
    const auto mantissa = std::bit_cast<Lanes>(bits - (exponent << 23));
    const Lanes s = (mantissa - 1) / (mantissa + 1), s2 = s * s;
    const Lanes series =
        s *
        (2.885390082F + s2 * (0.961796694F + s2 * (0.577078016F + s2 * (0.412198583F + s2 * 0.320598898F))));
    return __builtin_convertvector(exponent, Lanes) + series;
}

/// 2^x for x in -126..127 by the series of exp. Relative error below 2e-7.
inline Lanes exp2Of(Lanes x) {
    constexpr float kRound = 12582912.F;  // 1.5 * 2^23: adding and subtracting it rounds
    const Lanes whole = (x + kRound) - kRound;
    const Lanes f = (x - whole) * 0.69314718F;
    const Lanes series =
        1 + f * (1 + f * (0.5F + f * (0.16666667F +
                                      f * (0.041666668F +
                                           f * (0.008333334F + f * (0.0013888889F + f * 0.0001984127F))))));
    return series * std::bit_cast<Lanes>((__builtin_convertvector(whole, IntLanes) + 127) << 23);
}

/// x^y for x in 0..10^4 and y in 0..2.4; 0 for x up to 1e-15.
inline Lanes power(Lanes x, Lanes y) {
    const Lanes least = allLanes(1e-15F);
    const Lanes result = exp2Of(y * log2Of(larger(x, least)));
    return x > least ? result : allLanes(0);
}

/// Cube root of positive normal numbers: a third of the exponent, then two Halley iterations, each of which
/// triples the digits. Relative error below 2e-7.
inline Lanes cubeRoot(Lanes x) {
    constexpr float kTwoThirdsOfOne =
        709921077.F;  // 2/3 of the bits of 1, minus the mean error of the first guess
    const Lanes third = __builtin_convertvector(std::bit_cast<IntLanes>(x), Lanes) * (1.F / 3.F);
    auto root = std::bit_cast<Lanes>(__builtin_convertvector(third + kTwoThirdsOfOne, IntLanes));
    for (int i = 0; i < 2; ++i) {
        const Lanes cube = root * root * root;
        root = root * ((cube + (x + x)) / ((cube + cube) + x));
    }
    return root;
}

/// CIE 1976: the cube root, and a straight line near black.
inline Lanes labCurve(Lanes t) {
    constexpr float kDelta = 6.F / 29.F;
    const Lanes cube = allLanes(kDelta * kDelta * kDelta);
    const Lanes curve = cubeRoot(larger(t, cube));
    const Lanes line = t * (1 / (3 * kDelta * kDelta)) + 4.F / 29.F;
    return t > cube ? curve : line;
}

struct Lab {
    Lanes l, a, b;
};

/// Filtered YCxCz to L*a*b*, limited to the colours of a screen, with Hunt's adjustment of a* and b*: the eye
/// sees chroma better in brighter colours.
inline Lab toHuntLab(const FilteredRow& in, std::size_t at) {
    const Lanes y = (loadLanes(in.y + at) + 16) * (1.F / 116);
    const Lanes x = (y + loadLanes(in.cx + at) * (1.F / 500)) * kWhite[0];
    const Lanes z = (y - (loadLanes(in.cz1 + at) + loadLanes(in.cz2 + at)) * (1.F / 200)) * kWhite[2];
    Lanes rgb[3], lab[3];
    for (int c = 0; c < 3; ++c) rgb[c] = smaller(larger(row(kToRgb[c], x, y, z), allLanes(0)), allLanes(1));
    for (int c = 0; c < 3; ++c) lab[c] = labCurve(row(kToXyz[c], rgb[0], rgb[1], rgb[2]) * kInverseWhite[c]);
    const Lanes l = 116 * lab[1] - 16;
    return {l, 0.01F * l * (500 * (lab[0] - lab[1])), 0.01F * l * (200 * (lab[1] - lab[2]))};
}

// Section 4 of the paper: exponents of the colour and of the feature difference, and which share of the
// largest colour difference is mapped to which share of the range.
constexpr float kColorPower = 0.7F, kColorShare = 0.4F, kRangeShare = 0.95F;

/// The colour difference of pure green and pure blue, the largest one, after the exponent (0.7).
float largestColorDifference() {
    const auto huntLab = [](double r, double g, double b) {
        double f[3];
        for (int c = 0; c < 3; ++c) {
            const double t = (static_cast<double>(kToXyz[c][0]) * r + static_cast<double>(kToXyz[c][1]) * g +
                              static_cast<double>(kToXyz[c][2]) * b) *
                             static_cast<double>(kInverseWhite[c]);
            constexpr double kDelta = 6. / 29;
            f[c] = t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4. / 29;
        }
        const double l = 116 * f[1] - 16;
        return std::array<double, 3>{l, .01 * l * 500 * (f[0] - f[1]), .01 * l * 200 * (f[1] - f[2])};
    };
    const auto green = huntLab(0, 1, 0), blue = huntLab(0, 0, 1);
    return static_cast<float>(std::pow(
        std::abs(green[0] - blue[0]) + std::hypot(green[1] - blue[1], green[2] - blue[2]), kColorPower));
}

/// HyAB distances (city block in lightness, Euclidean in chroma), compressed to 0..1.
inline Lanes colorDifferences(const Lab& a, const Lab& b, float largest) {
    const float knee = kColorShare * largest;
    const Lanes da = a.a - b.a, db = a.b - b.b;
    const Lanes d = power(absolute(a.l - b.l) + squareRoot(da * da + db * db), allLanes(kColorPower));
    const Lanes below = d * (kRangeShare / knee);
    const Lanes above = kRangeShare + (d - knee) * ((1 - kRangeShare) / (largest - knee));
    return d < knee ? below : above;
}

/// Section 4.2: by how much an edge or a point is stronger in one picture than in the other, to the power
/// 1/2.
inline Lanes featureDifferences(const FilteredRow& a, const FilteredRow& b, std::size_t at) {
    constexpr float kRootHalf = 0.70710678F;
    constexpr float kScale =
        1.F / 116.F;  // the achromatic plane has 0..116, but features are defined for 0..1
    const auto strength = [at](const float* first, const float* second) {
        const Lanes x = loadLanes(first + at), y = loadLanes(second + at);
        return squareRoot(x * x + y * y);
    };
    const Lanes edges = absolute(strength(a.dx, a.dy) - strength(b.dx, b.dy));
    const Lanes points = absolute(strength(a.ddx, a.ddy) - strength(b.ddx, b.ddy));
    return squareRoot(kRootHalf * kScale * larger(edges, points));
}

}  // namespace

float linearOf(float srgb) {
    return srgb <= 0.04045F ? srgb / 12.92F : power(allLanes((srgb + 0.055F) / 1.055F), allLanes(2.4F))[0];
}

void toOpponent(float* r, float* g, float* b, std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Lanes red = loadLanes(r + i), green = loadLanes(g + i), blue = loadLanes(b + i);
        const Lanes x = row(kToXyz[0], red, green, blue) * kInverseWhite[0];
        const Lanes y = row(kToXyz[1], red, green, blue) * kInverseWhite[1];
        const Lanes z = row(kToXyz[2], red, green, blue) * kInverseWhite[2];
        store(116 * y - 16, r + i);
        store(500 * (x - y), g + i);
        store(200 * (y - z), b + i);
    }
}

void flipErrors(const FilteredRow& reference, const FilteredRow& test, std::size_t count, float* errors) {
    static const float largest = largestColorDifference();
    for (std::size_t at = 0; at < count; at += kLanes) {
        const Lanes color = colorDifferences(toHuntLab(reference, at), toHuntLab(test, at), largest);
        store(power(color, 1 - featureDifferences(reference, test, at)), errors + at);
    }
}

}  // namespace glibra::image
