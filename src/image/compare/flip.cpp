#include "image/compare/flip.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <span>

#include "base/parallel.h"
#include "image/bytes.h"
#include "image/compare/alike.h"

namespace glibra::image {
namespace {

/// Weights 0..radius of a filter that is symmetric (w[-k] = w[k]) or antisymmetric (w[-k] = -w[k]).
using HalfFilter = std::vector<float>;

/// All filters for one viewing distance. Two-dimensional filters are products of these (the blue-yellow
/// filter is the sum of two such products).
struct FlipFilters {
    explicit FlipFilters(double pixelsPerDegree);

    HalfFilter achromatic, redGreen, blueYellow1, blueYellow2;  ///< contrast sensitivity, symmetric
    HalfFilter gauss, edge, point;  ///< feature detection; edge (first derivative) is antisymmetric
    std::size_t radius = 0;         ///< radius of the widest filter
};

/// The filters of one pass over its input: symmetric ones, then at most one antisymmetric one. All have equal
/// length.
struct FilterOutput {
    std::span<const float> weights;
    float* to;
};

constexpr double kPi = std::numbers::pi;

/// Values that are computed together: enough independent sums to keep the processor busy.
constexpr std::size_t kFilterChunk = 2 * kLanes;

/// Drops the ends of a filter that are too small to change a float result.
HalfFilter narrowed(const std::vector<double>& weights) {
    double largest = 0;
    for (const double each : weights) largest = std::max(largest, std::abs(each));
    std::size_t count = weights.size();
    while (count > 1 && std::abs(weights[count - 1]) < 1e-8 * largest) --count;
    HalfFilter result;
    for (std::size_t k = 0; k < count; ++k) result.push_back(static_cast<float>(weights[k]));
    return result;
}

/// The sum over both sides.
double sumOf(const std::vector<double>& half) {
    double sum = half[0];
    for (std::size_t k = 1; k < half.size(); ++k) sum += 2 * half[k];
    return sum;
}

/// exp(-pi^2 x^2 / b) at k pixels, x in degrees: the Gaussian of the contrast sensitivity in the space domain
/// (Andersson et al. 2020, equation 4).
std::vector<double> gaussian(double b, std::size_t radius, double pixelsPerDegree) {
    std::vector<double> half;
    for (std::size_t k = 0; k <= radius; ++k) {
        const double x = static_cast<double>(k) / pixelsPerDegree;
        half.push_back(std::exp(-kPi * kPi * x * x / b));
    }
    return half;
}

std::vector<double> scaled(std::vector<double> half, double factor) {
    for (double& each : half) each *= factor;
    return half;
}

/// Pads filters with zeros to equal lengths.
void widen(std::initializer_list<HalfFilter*> filters) {
    std::size_t count = 0;
    for (const HalfFilter* each : filters) count = std::max(count, each->size());
    for (HalfFilter* each : filters) each->resize(count);
}

template <std::size_t Even, std::size_t Odd>
void filterChunk(const float* in, std::ptrdiff_t step, std::size_t taps,
                 const std::array<FilterOutput, Even + Odd>& outputs, std::size_t at) {
    Lanes low[Even + Odd] = {}, high[Even + Odd] = {};
    const Lanes centerLow = loadLanes(in), centerHigh = loadLanes(in + kLanes);
    for (std::size_t o = 0; o < Even; ++o) {
        low[o] = outputs[o].weights[0] * centerLow;
        high[o] = outputs[o].weights[0] * centerHigh;
    }
    for (std::size_t k = 1; k < taps; ++k) {
        const float* after = in + static_cast<std::ptrdiff_t>(k) * step;
        const float* before = in - static_cast<std::ptrdiff_t>(k) * step;
        const Lanes afterLow = loadLanes(after), afterHigh = loadLanes(after + kLanes);
        const Lanes beforeLow = loadLanes(before), beforeHigh = loadLanes(before + kLanes);
        const Lanes sumLow = afterLow + beforeLow, sumHigh = afterHigh + beforeHigh;
        for (std::size_t o = 0; o < Even; ++o) {
            low[o] += outputs[o].weights[k] * sumLow;
            high[o] += outputs[o].weights[k] * sumHigh;
        }
        if constexpr (Odd > 0) {
            low[Even] += outputs[Even].weights[k] * (afterLow - beforeLow);
            high[Even] += outputs[Even].weights[k] * (afterHigh - beforeHigh);
        }
    }
    for (std::size_t o = 0; o < Even + Odd; ++o) {
        store(low[o], outputs[o].to + at);
        store(high[o], outputs[o].to + at + kLanes);
    }
}

template <std::size_t Even, std::size_t Odd>
void filter(const float* in, std::ptrdiff_t step, std::size_t count,
            const std::array<FilterOutput, Even + Odd>& outputs) {
    const std::size_t taps = outputs[0].weights.size();
    for (std::size_t x = 0; x < count; x += kFilterChunk)
        filterChunk<Even, Odd>(in + x, step, taps, outputs, x);
}

FlipFilters::FlipFilters(double pixelsPerDegree) {
    // Table 1 of the paper: amplitude and width of each Gaussian.
    constexpr double kAchromatic = 0.0047, kRedGreen = 0.0053;
    constexpr double kBlueYellowA1 = 34.1, kBlueYellowB1 = 0.04, kBlueYellowA2 = 13.5, kBlueYellowB2 = 0.025;
    // Three standard deviations of the widest Gaussian.
    const auto contrastRadius =
        static_cast<std::size_t>(std::ceil(3 * std::sqrt(kBlueYellowB1 / (2 * kPi * kPi)) * pixelsPerDegree));
    const auto y = gaussian(kAchromatic, contrastRadius, pixelsPerDegree);
    const auto cx = gaussian(kRedGreen, contrastRadius, pixelsPerDegree);
    achromatic = narrowed(scaled(y, 1 / sumOf(y)));
    redGreen = narrowed(scaled(cx, 1 / sumOf(cx)));
    // The two-dimensional filter has the factor a sqrt(pi / b), so each direction has its root. The sum of
    // both products is 1.
    const auto part = [&](double a, double b) {
        return scaled(gaussian(b, contrastRadius, pixelsPerDegree), std::sqrt(a * std::sqrt(kPi / b)));
    };
    const auto first = part(kBlueYellowA1, kBlueYellowB1), second = part(kBlueYellowA2, kBlueYellowB2);
    const double total = std::hypot(sumOf(first), sumOf(second));
    blueYellow1 = narrowed(scaled(first, 1 / total));
    blueYellow2 = narrowed(scaled(second, 1 / total));
    widen({&blueYellow1, &blueYellow2});

    // Section 4.2: features are 0.082 degrees wide; the negative and the positive weights of a derivative sum
    // to -1 and 1.
    constexpr double kFeatureWidth = 0.082;
    const double deviation = kFeatureWidth / 2 * pixelsPerDegree;
    const auto featureRadius = static_cast<std::size_t>(std::ceil(3 * deviation));
    std::vector<double> g, dg, ddg;
    for (std::size_t k = 0; k <= featureRadius; ++k) {
        const double x = static_cast<double>(k) / deviation;
        g.push_back(std::exp(-x * x / 2));
        dg.push_back(-static_cast<double>(k) * g.back());
        ddg.push_back((x * x - 1) * g.back());
    }
    double oneSide = 0, positive = 0, negative = ddg[0];
    for (std::size_t k = 1; k <= featureRadius; ++k) {
        oneSide -= dg[k];
        (ddg[k] > 0 ? positive : negative) += 2 * ddg[k];
    }
    for (double& each : ddg) each /= each > 0 ? positive : -negative;
    gauss = narrowed(scaled(g, 1 / sumOf(g)));
    edge = narrowed(scaled(dg, 1 / oneSide));
    point = narrowed(ddg);
    widen({&gauss, &edge, &point, &achromatic});
    radius = std::max({gauss.size(), blueYellow1.size(), redGreen.size()}) - 1;
}

/// out[x] = sum over k of weights[|k|] in[x + k step], for x in 0..count-1 (a multiple of 8). `step` is 1
/// along a row, and the length of a row down a column.
void filterSymmetric(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput out) {
    filter<1, 0>(in, step, count, {out});
}

void filterSymmetric(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput first,
                     FilterOutput second) {
    filter<2, 0>(in, step, count, {first, second});
}

/// The last weight sign(k) weights[|k|].
void filterBoth(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput symmetric,
                FilterOutput antisymmetric) {
    filter<1, 1>(in, step, count, {symmetric, antisymmetric});
}

void filterBoth(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput first,
                FilterOutput second, FilterOutput third, FilterOutput antisymmetric) {
    filter<3, 1>(in, step, count, {first, second, third, antisymmetric});
}

// The pixelwise steps of FLIP, over rows of planes, so that the compiler vectorises them.

/// Filtered planes of one row of one picture.
struct FilteredRow {
    const float *y, *cx, *cz1, *cz2;   ///< contrast sensitivity; Cz is the sum of two
    const float *dx, *dy, *ddx, *ddy;  ///< first and second derivatives of the achromatic plane
};

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

/// x^y for x in 0..10^4 and y in 0..1; 0 for x up to 1e-15.
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

/// Linear RGB in 0..1 to YCxCz, in place: an opponent space, linear in XYZ (D65), with the scale of L*a*b*.
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

/// The final error of each pixel, 0..1. `count` is a multiple of 8.
void flipErrors(const FilteredRow& reference, const FilteredRow& test, std::size_t count, float* errors) {
    static const float largest = largestColorDifference();
    for (std::size_t at = 0; at < count; at += kLanes) {
        const Lanes color = colorDifferences(toHuntLab(reference, at), toHuntLab(test, at), largest);
        store(power(color, 1 - featureDifferences(reference, test, at)), errors + at);
    }
}

// The planes of a tile fit into the second-level cache of a core.
constexpr int kTileWidth = 128, kTileHeight = 64;
constexpr std::size_t kTileColumns = kTileWidth;

/// Rows are padded to a multiple of this.
constexpr std::size_t kRowUnit = 8;
constexpr std::size_t roundedUp(std::size_t count) {
    return (count + kRowUnit - 1) / kRowUnit * kRowUnit;
}

/// The linear values of all integers of a type.
template <class Value>
const std::vector<float>& linearTable() {
    static const std::vector<float> table = [] {
        constexpr double kMost = std::numeric_limits<Value>::max();
        std::vector<float> values;
        for (std::size_t i = 0; i <= std::numeric_limits<Value>::max(); ++i)
            values.push_back(static_cast<float>(linearOfSrgb(static_cast<double>(i) / kMost)));
        return values;
    }();
    return table;
}

template <class Value>
float linearValue(const std::byte* row, std::size_t index) {
    if constexpr (std::is_integral_v<Value>) {
        return linearTable<Value>()[valueAt<Value>(row, index)];
    } else {
        const float value = valueAt<float>(row, index);
        return value > 0 ? linearOfSrgb(std::min(value, 1.F)) : 0.F;  // 0 for NaN
    }
}

/// Linear RGB of `count` pixels from column x; columns beyond the picture repeat its edge.
template <class Value>
void loadRow(const Image& image, int x, int y, std::size_t count, float* r, float* g, float* b) {
    const std::byte* row = image.row(std::clamp(y, 0, image.height - 1)).data();
    const auto components = static_cast<std::size_t>(image.components);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at =
            static_cast<std::size_t>(std::clamp(x + static_cast<int>(i), 0, image.width - 1)) * components;
        r[i] = linearValue<Value>(row, at);
        g[i] = linearValue<Value>(row, at + 1);
        b[i] = linearValue<Value>(row, at + 2);
    }
}

void loadRow(const Image& image, int x, int y, std::size_t count, float* r, float* g, float* b) {
    withZeroOf(image.type, [&](auto zero) { loadRow<decltype(zero)>(image, x, y, count, r, g, b); });
}

/// The part of one picture in a tile: the rows of the tile and `radius` rows above and below, filtered along
/// the rows.
class FilteredTile {
  public:
    explicit FilteredTile(const FlipFilters& filters)
        : filters_(filters), stride_(roundedUp(kTileColumns + 2 * filters.radius)) {
        for (auto& each : loaded_) each.resize(stride_);
        for (auto& each : along_) each.resize(kTileColumns * (kTileHeight + 2 * filters.radius));
        for (auto& each : done_) each.resize(kTileColumns);
    }

    void load(const Image& image, int left, int top, int height) {
        const int radius = static_cast<int>(filters_.radius);
        for (int y = 0; y < height + 2 * radius; ++y) {
            float *r = loaded_[0].data(), *g = loaded_[1].data(), *b = loaded_[2].data();
            loadRow(image, left - radius, top + y - radius, stride_, r, g, b);
            toOpponent(r, g, b, stride_);
            const std::size_t at = static_cast<std::size_t>(y) * kTileColumns;
            filterBoth(r + radius, 1, kTileColumns, {filters_.achromatic, &along_[luma][at]},
                       {filters_.gauss, &along_[smooth][at]}, {filters_.point, &along_[bend][at]},
                       {filters_.edge, &along_[slope][at]});
            filterSymmetric(g + radius, 1, kTileColumns, {filters_.redGreen, &along_[red][at]});
            filterSymmetric(b + radius, 1, kTileColumns, {filters_.blueYellow1, &along_[blue1][at]},
                            {filters_.blueYellow2, &along_[blue2][at]});
        }
    }

    /// A row of the tile, also filtered down the columns; valid until the next call.
    FilteredRow row(int y) {
        const std::size_t at = (static_cast<std::size_t>(y) + filters_.radius) * kTileColumns;
        const auto down = [&](int plane, const HalfFilter& weights, int result) {
            filterSymmetric(&along_[static_cast<std::size_t>(plane)][at], kTileColumns, kTileColumns,
                            {weights, done_[static_cast<std::size_t>(result)].data()});
            return done_[static_cast<std::size_t>(result)].data();
        };
        FilteredRow result{};
        result.y = down(luma, filters_.achromatic, 0);
        result.cx = down(red, filters_.redGreen, 1);
        result.cz1 = down(blue1, filters_.blueYellow1, 2);
        result.cz2 = down(blue2, filters_.blueYellow2, 3);
        result.dx = down(slope, filters_.gauss, 4);
        result.ddx = down(bend, filters_.gauss, 5);
        filterBoth(&along_[smooth][at], kTileColumns, kTileColumns, {filters_.point, done_[6].data()},
                   {filters_.edge, done_[7].data()});
        result.ddy = done_[6].data();
        result.dy = done_[7].data();
        return result;
    }

  private:
    enum Plane : std::uint8_t { luma, smooth, slope, bend, red, blue1, blue2, planeCount };

    const FlipFilters& filters_;
    std::size_t stride_;
    std::array<std::vector<float>, 3> loaded_;
    std::array<std::vector<float>, planeCount> along_;
    std::array<std::vector<float>, 8> done_;
};

/// True if the pictures have the same bytes in the tile and `radius` pixels around it, so that its errors are
/// 0.
bool sameAroundTile(const Image& a, const Image& b, int left, int top, int radius) {
    const int x = std::max(left - radius, 0), y = std::max(top - radius, 0);
    const int right = std::min(left + kTileWidth + radius, a.width);
    const int bottom = std::min(top + kTileHeight + radius, a.height);
    const std::size_t pixel = static_cast<std::size_t>(a.components) * bytesOf(a.type);
    const std::size_t from = static_cast<std::size_t>(x) * pixel;
    const std::size_t bytes = static_cast<std::size_t>(right - x) * pixel;
    for (int row = y; row < bottom; ++row)
        if (std::memcmp(a.row(row).data() + from, b.row(row).data() + from, bytes) != 0) return false;
    return true;
}

/// The errors of two opaque pictures of three or four components and one type.
std::vector<float> errorsOf(const Image& a, const Image& b, const FlipOptions& options) {
    const FlipFilters filters(options.pixelsPerDegree);
    std::vector<float> errors(static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height));
    const int columns = (a.width + kTileWidth - 1) / kTileWidth;
    const int tiles = columns * ((a.height + kTileHeight - 1) / kTileHeight);
    struct Tiles {
        FilteredTile first, second;
        std::array<float, kTileColumns> rowErrors{};
    };
    base::forEachIndex(
        static_cast<std::size_t>(tiles), options.threads,
        [&] { return Tiles{FilteredTile(filters), FilteredTile(filters)}; },
        [&](std::size_t index, Tiles& buffers) {
            auto& [first, second, rowErrors] = buffers;
            const int tile = static_cast<int>(index);
            const int left = tile % columns * kTileWidth, top = tile / columns * kTileHeight;
            if (sameAroundTile(a, b, left, top, static_cast<int>(filters.radius))) return;
            const int height = std::min(kTileHeight, a.height - top);
            first.load(a, left, top, height);
            second.load(b, left, top, height);
            const auto width = static_cast<std::size_t>(std::min(kTileWidth, a.width - left));
            for (int y = 0; y < height; ++y) {
                flipErrors(first.row(y), second.row(y), kTileColumns, rowErrors.data());
                std::copy_n(rowErrors.data(), width,
                            errors.data() +
                                static_cast<std::size_t>(top + y) * static_cast<std::size_t>(a.width) +
                                static_cast<std::size_t>(left));
            }
        });
    return errors;
}

/// The RGBA picture over a grey background, blended in sRGB as browsers do.
Image over(const Image& image, float background) {
    Image seen = withType(image, Component::f32);
    for (std::size_t at = 0; at < seen.data.size(); at += 16) {
        std::array<float, 4> pixel{};
        std::memcpy(pixel.data(), seen.data.data() + at, 16);
        const float alpha = std::clamp(pixel[3], 0.F, 1.F);
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = pixel[c] * alpha + background * (1 - alpha);
        pixel[3] = 1;
        std::memcpy(seen.data.data() + at, pixel.data(), 16);
    }
    return seen;
}

/// Sets the error to 1 where one of two float pictures is NaN and the other is not.
void markNan(const Image& a, const Image& b, std::vector<float>& errors) {
    const auto components = static_cast<std::size_t>(a.components);
    for (std::size_t i = 0; i < errors.size() * components; ++i)
        if (std::isnan(valueAt<float>(a.data.data(), i)) != std::isnan(valueAt<float>(b.data.data(), i)))
            errors[i / components] = 1;
}

std::vector<float> errorsOfAlike(const Image& a, const Image& b, const FlipOptions& options) {
    if (a.components < 3) return errorsOfAlike(withComponents(a, 4), withComponents(b, 4), options);
    std::vector<float> errors;
    if (!isTransparent(a) && !isTransparent(b)) {
        errors = errorsOf(a, b, options);
    } else {
        errors = errorsOf(over(a, 0), over(b, 0), options);
        const std::vector<float> white = errorsOf(over(a, 1), over(b, 1), options);
        for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = std::max(errors[i], white[i]);
    }
    if (a.type == Component::f32) markNan(a, b, errors);
    return errors;
}

}  // namespace

FlipResult flip(const Image& reference, const Image& test, const FlipOptions& options) {
    FlipResult result;
    if (!areComparable(reference, test)) {
        result.mean = result.largest = 1;
        return result;
    }
    result.width = reference.width;
    result.height = reference.height;
    result.errors = withAlike(reference, test,
                              [&](const Image& a, const Image& b) { return errorsOfAlike(a, b, options); });
    double sum = 0;
    for (const float each : result.errors) sum += static_cast<double>(each);
    result.mean = sum / static_cast<double>(result.errors.size());
    const auto worst = std::max_element(result.errors.begin(), result.errors.end());
    result.largest = static_cast<double>(*worst);
    const auto at = static_cast<int>(worst - result.errors.begin());
    result.x = at % result.width;
    result.y = at / result.width;
    return result;
}

}  // namespace glibra::image
