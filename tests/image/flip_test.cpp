// FLIP: against a direct evaluation of the definition in double, and against results of the authors' program.

#include "image/compare/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "image/image.h"
#include "support.h"

namespace glibra::image {
namespace {

constexpr double kPi = std::numbers::pi;

using Triple = std::array<double, 3>;

/// Planes of doubles; the edge pixels continue beyond the edge.
struct Field {
    int width, height;
    std::vector<Triple> values;

    [[nodiscard]] const Triple& at(int x, int y) const {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

Triple multiply(const double (&m)[3][3], const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

/// Linear RGB to XYZ relative to the white point, for sRGB's primaries and D65, with the fractions of the
/// definition.
Triple toXyz(const Triple& rgb) {
    constexpr double kMatrix[3][3] = {{10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794},
                                      {2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897},
                                      {1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382}};
    Triple xyz = multiply(kMatrix, rgb);
    const Triple white = multiply(kMatrix, {1, 1, 1});
    for (std::size_t i = 0; i < 3; ++i) xyz[i] /= white[i];
    return xyz;
}

/// The inverse of toXyz, by Cramer's rule.
Triple toRgb(const Triple& xyz) {
    const Triple r = toXyz({1, 0, 0}), g = toXyz({0, 1, 0}), b = toXyz({0, 0, 1});
    const auto determinant = [](const Triple& p, const Triple& q, const Triple& s) {
        return p[0] * (q[1] * s[2] - q[2] * s[1]) - q[0] * (p[1] * s[2] - p[2] * s[1]) +
               s[0] * (p[1] * q[2] - p[2] * q[1]);
    };
    const double d = determinant(r, g, b);
    return {determinant(xyz, g, b) / d, determinant(r, xyz, b) / d, determinant(r, g, xyz) / d};
}

Triple toYCxCz(const Triple& rgb) {
    const Triple t = toXyz(rgb);
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

/// L*a*b* with Hunt's adjustment of a* and b*.
Triple toHuntLab(const Triple& rgb) {
    Triple t = toXyz(rgb);
    for (double& each : t) {
        const double delta = 6. / 29;
        each = each > delta * delta * delta ? std::cbrt(each) : each / (3 * delta * delta) + 4. / 29;
    }
    const double l = 116 * t[1] - 16;
    return {l, .01 * l * 500 * (t[0] - t[1]), .01 * l * 200 * (t[1] - t[2])};
}

double hyab(const Triple& a, const Triple& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Field fieldOf(const Image& image) {
    Field field{image.width, image.height, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto pixel = testing::pixelAt(image, x, y);
            Triple rgb{};
            for (std::size_t c = 0; c < 3; ++c) {
                const double v = pixel[c] / 255.;
                rgb[c] = v <= .04045 ? v / 12.92 : std::pow((v + .055) / 1.055, 2.4);
            }
            field.values.push_back(toYCxCz(rgb));
        }
    return field;
}

/// The two-dimensional contrast sensitivity filter of one of the three planes at (x, y), not normalized.
double contrastWeight(std::size_t plane, int x, int y, double ppd) {
    constexpr double kA1[] = {1, 1, 34.1}, kB1[] = {.0047, .0053, .04};
    constexpr double kA2[] = {0, 0, 13.5}, kB2[] = {1e-5, 1e-5, .025};
    const double d2 = (x * x + y * y) / (ppd * ppd);
    const auto part = [d2](double a, double b) {
        return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * d2 / b);
    };
    return part(kA1[plane], kB1[plane]) + part(kA2[plane], kB2[plane]);
}

/// The picture as the eye sees it, limited to the colours of a screen, as L*a*b* with Hunt's adjustment.
Triple seen(const Field& field, int x, int y, double ppd) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(.04 / (2 * kPi * kPi)) * ppd));
    Triple sum{}, weights{};
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx)
            for (std::size_t c = 0; c < 3; ++c) {
                const double w = contrastWeight(c, dx, dy, ppd);
                sum[c] += w * field.at(x + dx, y + dy)[c];
                weights[c] += w;
            }
    for (std::size_t c = 0; c < 3; ++c) sum[c] /= weights[c];
    const double luma = (sum[0] + 16) / 116;
    Triple rgb = toRgb({luma + sum[1] / 500, luma, luma - sum[2] / 200});
    for (double& each : rgb) each = std::clamp(each, 0., 1.);
    return toHuntLab(rgb);
}

/// Strength of edges and of points, by two-dimensional derivatives of a Gaussian.
std::array<double, 2> features(const Field& field, int x, int y, double ppd) {
    const double deviation = .5 * .082 * ppd;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    // Per filter: weighted sums with the positive and with the negative weights, and the sums of these
    // weights.
    std::array<std::array<double, 4>, 4> sums{};
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx) {
            const double g = std::exp(-(dx * dx + dy * dy) / (2 * deviation * deviation));
            const double scale = deviation * deviation;
            const double filters[] = {-dx * g, -dy * g, (dx * dx / scale - 1) * g, (dy * dy / scale - 1) * g};
            const double value = (field.at(x + dx, y + dy)[0] + 16) / 116;
            for (std::size_t f = 0; f < 4; ++f) {
                const std::size_t negative = filters[f] < 0 ? 2 : 0;
                sums[f][negative] += filters[f] * value;
                sums[f][negative + 1] += std::abs(filters[f]);
            }
        }
    std::array<double, 4> results{};
    for (std::size_t f = 0; f < 4; ++f) results[f] = sums[f][0] / sums[f][1] + sums[f][2] / sums[f][3];
    return {std::hypot(results[0], results[1]), std::hypot(results[2], results[3])};
}

double errorAt(const Field& a, const Field& b, int x, int y, double ppd) {
    const double largest = std::pow(hyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), .7);
    const double knee = .4 * largest;
    const double color = std::pow(hyab(seen(a, x, y, ppd), seen(b, x, y, ppd)), .7);
    const double mapped =
        color < knee ? color * .95 / knee : .95 + (color - knee) / (largest - knee) * (1 - .95);
    const auto first = features(a, x, y, ppd), second = features(b, x, y, ppd);
    const double feature =
        std::sqrt(std::max(std::abs(first[0] - second[0]), std::abs(first[1] - second[1])) / std::sqrt(2.));
    return std::pow(mapped, 1 - feature);
}

struct Pair {
    const char* name;
    Image reference, test;
};

/// 96 x 80 pixels: noise; a smooth picture with a change of colour; a disc moved by one pixel; saturated
/// squares.
std::vector<Pair> pairs(int width = 96, int height = 80) {
    const Image empty{width, height, 3, Component::u8, {}};
    std::vector<Pair> all{{"noise", testing::noisyImage(width, height, 3, Component::u8),
                           testing::noisyImage(width, height, 3, Component::u8, 77)},
                          {"smooth", empty, empty},
                          {"disc", empty, empty},
                          {"squares", empty, empty}};
    constexpr int kDisc[] = {230, 120, 40}, kGround[] = {20, 30, 90};
    const auto put = [](Image& image, int value) { image.data.push_back(static_cast<std::byte>(value)); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const int smooth = c == 0   ? 255 * x / width
                                   : c == 1 ? 255 * y / height
                                            : 128 + 60 * (x + y) / (width + height);
                const int change = c == 0 ? 9 : c == 1 ? 0 : -5 + x % 11;
                put(all[1].reference, smooth);
                put(all[1].test, std::min(255, smooth + change));
                const auto inDisc = [&](int shift) {
                    const int dx = 2 * x - width + 2 * shift, dy = 2 * y - height;
                    return 4 * (dx * dx + dy * dy) < width * width;
                };
                put(all[2].reference, inDisc(0) ? kDisc[c] : kGround[c]);
                put(all[2].test, inDisc(1) ? kDisc[c] : kGround[c]);
                put(all[3].reference, ((x / 8 + y / 8) % 8 >> c & 1) * 255);
                put(all[3].test, ((x / 8 + 3 * (y / 8) + 1) % 8 >> c & 1) * 255);
            }
    return all;
}

float errorOf(const FlipResult& result, int x, int y) {
    return result.errors[static_cast<std::size_t>(y) * static_cast<std::size_t>(result.width) +
                         static_cast<std::size_t>(x)];
}

TEST(Flip, IsWithinATenThousandthOfADirectEvaluationInDouble) {
    for (const double ppd : {FlipOptions{}.pixelsPerDegree, 30.})
        for (const Pair& pair : pairs(48, 40)) {
            const FlipResult result = flip(pair.reference, pair.test, {.pixelsPerDegree = ppd});
            const Field a = fieldOf(pair.reference), b = fieldOf(pair.test);
            double sum = 0, worst = 0;
            for (int y = 0; y < a.height; ++y)
                for (int x = 0; x < a.width; ++x) {
                    const double exact = errorAt(a, b, x, y, ppd);
                    sum += exact;
                    const double got = static_cast<double>(errorOf(result, x, y));
                    worst = std::max(worst, std::abs(got - exact));
                }
            EXPECT_NEAR(result.mean, sum / (a.width * a.height), 2e-6) << pair.name << ' ' << ppd;
            EXPECT_LT(worst, 1e-4) << pair.name << ' ' << ppd;
        }
}

// From FLIP.h of https://github.com/NVlabs/flip, commit 1eb247c of 2025-09-01, compiled with g++ 12 -O3:
// FLIP::evaluate() on the pictures of pairs(), converted by sRGBToLinearRGB(), default parameters; and with
// PPD = 30.
TEST(Flip, AgreesWithTheAuthorsProgram) {
    struct Figures {
        double mean, largest, middle, meanAt30;
    };
    constexpr Figures kFigures[] = {{0.442946656, 0.9688059, 0.3351261, 0.739640041},
                                    {0.110338959, 0.1764956, 0.1131862, 0.114958971},
                                    {0.047168184, 0.6191473, 0, 0.037132438},
                                    {0.946327518, 0.9991065, 0.9594740, 0.973490874}};
    const auto all = pairs();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const FlipResult result = flip(all[i].reference, all[i].test);
        EXPECT_NEAR(result.mean, kFigures[i].mean, 1e-6) << all[i].name;
        EXPECT_NEAR(result.largest, kFigures[i].largest, 1e-5) << all[i].name;
        EXPECT_NEAR(static_cast<double>(result.errors[40 * 96 + 48]), kFigures[i].middle, 1e-5)
            << all[i].name;
        EXPECT_NEAR(flip(all[i].reference, all[i].test, {.pixelsPerDegree = 30}).mean, kFigures[i].meanAt30,
                    1e-6)
            << all[i].name;
    }
}

TEST(Flip, EqualPicturesHaveNoError) {
    const Image image = testing::noisyImage(200, 90, 3, Component::u8);
    const FlipResult result = flip(image, image);
    EXPECT_EQ(result.mean, 0);
    EXPECT_EQ(result.largest, 0);
    EXPECT_EQ(result.errors.size(), 200U * 90);
}

TEST(Flip, IsTheSameForAnyNumberOfThreadsAndAcrossTiles) {
    const Image a = testing::noisyImage(300, 150, 3, Component::u8);
    Image b = a;
    b.data[3 * (std::size_t{300} * 66 + 130)] ^= std::byte{0x80};  // near the corner where four tiles meet
    const FlipResult one = flip(a, b, {.threads = 1}), four = flip(a, b, {.threads = 4});
    EXPECT_EQ(one.errors, four.errors);
    EXPECT_GT(one.mean, 0);
    // Only pixels within the reach of the filters differ, on all sides.
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 300; ++x) {
            const float error = errorOf(one, x, y);
            const int distance = std::max(std::abs(x - 130), std::abs(y - 66));
            if (distance > 10) {
                EXPECT_EQ(error, 0) << x << ' ' << y;
            } else if (distance < 4) {
                EXPECT_GT(error, 0) << x << ' ' << y;
            }
        }
}

TEST(Flip, PictureTypesAndComponentsAreEqualInValue) {
    const Image a = testing::noisyImage(40, 30, 3, Component::u8);
    const Image b = testing::noisyImage(40, 30, 3, Component::u8, 5);
    const double mean = flip(a, b).mean;
    EXPECT_NEAR(flip(withType(a, Component::u16), b).mean, mean, 1e-6);
    EXPECT_NEAR(flip(withType(a, Component::f32), withType(b, Component::f32)).mean, mean, 1e-6);
    EXPECT_EQ(flip(withComponents(a, 4), b).mean, mean);
    const Image grey = withComponents(a, 1);
    EXPECT_EQ(flip(grey, withComponents(b, 1)).mean,
              flip(withComponents(grey, 3), withComponents(withComponents(b, 1), 3)).mean);
}

TEST(Flip, AlphaIsSeenOverBlackAndWhite) {
    const Image opaque{20, 20, 4, Component::u8, std::vector<std::byte>(1600, std::byte{255})};
    Image clear = opaque;
    for (std::size_t i = 3; i < clear.data.size(); i += 4) clear.data[i] = std::byte{0};
    EXPECT_GT(flip(opaque, clear).mean, .5) << "white over black is black";
    Image black = opaque;
    for (std::size_t i = 0; i < black.data.size(); ++i)
        if (i % 4 != 3) black.data[i] = std::byte{0};
    EXPECT_NEAR(flip(opaque, clear).mean, flip(opaque, black).mean, 1e-6);
    EXPECT_GT(flip(black, clear).mean, .5) << "black over white is white";
    EXPECT_EQ(flip(clear, clear).mean, 0);
}

TEST(Flip, NanAgainstANumberIsAnErrorOfOne) {
    const Image a{30, 30, 3, Component::f32, std::vector<std::byte>(std::size_t{30} * 30 * 12)};
    Image b = a;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(&b.data[12 * (std::size_t{7} * 30 + 4)], &nan, 4);
    const FlipResult result = flip(a, b);
    EXPECT_EQ(result.largest, 1);
    EXPECT_EQ(result.x, 4);
    EXPECT_EQ(result.y, 7);
    EXPECT_EQ(flip(b, b).mean, 0);
}

TEST(Flip, PicturesOfOtherSizesDifferByOne) {
    const Image a = testing::noisyImage(4, 5, 3, Component::u8);
    EXPECT_EQ(flip(a, testing::noisyImage(5, 4, 3, Component::u8)).mean, 1);
    EXPECT_EQ(flip({}, {}).mean, 1);
    EXPECT_EQ(flip(a, a).mean, 0) << "smaller than the filters";
}

}  // namespace
}  // namespace glibra::image
