// Point clouds: a regular cloud shows rows like a field of corn, a jittered one does not (NM40). The number
// of points per column of the picture has the same spectrum as the positions of the points.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "support.h"

namespace glibra::stress {
namespace {

constexpr int kCloudColumns = 601;
constexpr int kPoints = 20;  // along each axis

/// The number of points in each column of the picture.
std::vector<double> columns(const std::string& projection, const std::string& cloud) {
    const FloatPicture picture =
        draw(fmt::format("WindowSize {0} {0}\nBackground 0\n{1}\nVertex v.vert\nFragment f.frag\nProgram "
                         "P\n{2} {3} {3} {3}\n",
                         kCloudColumns, projection, cloud, kPoints),
             {{"v.vert",
               "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
              {"f.frag", addingFragment("1., 0., 0.")}});
    std::vector<double> sums(kCloudColumns, 0.);
    for (int x = 0; x < picture.width; ++x)
        for (int y = 0; y < picture.height; ++y)
            sums[static_cast<std::size_t>(x)] += static_cast<double>(picture.at(x, y)[0]);
    return sums;
}

/// The amplitude of the wave with this period in pixels, relative to the number of points.
double share(const std::vector<double>& sums, double period) {
    std::complex<double> wave = 0;
    double all = 0;
    for (std::size_t x = 0; x < sums.size(); ++x) {
        wave += sums[x] * std::polar(1., -2 * std::numbers::pi * static_cast<double>(x) / period);
        all += sums[x];
    }
    return std::abs(wave) / all;
}

TEST(PointClouds, FormRowsUnlessTheyAreJittered) {
    const std::string along = "Ortho -1.5 1.5 -1.5 1.5\nLookAt 0 0 5 0 0 0 0 1 0";
    const std::vector<double> regular = columns(along, "PointCloud");
    const std::vector<double> jittered = columns(along, "JitterCloud");
    double all = 0;
    for (const double each : regular) all += each;
    EXPECT_EQ(all, kPoints * kPoints * kPoints);
    // The positions of the rows give the distance between them.
    std::vector<int> rows;
    for (int x = 0; x < kCloudColumns; ++x)
        if (regular[static_cast<std::size_t>(x)] > 0) rows.push_back(x);
    ASSERT_EQ(rows.size(), static_cast<std::size_t>(kPoints));
    const double period = static_cast<double>(rows.back() - rows.front()) / (kPoints - 1);
    for (int harmonic = 1; harmonic <= 2; ++harmonic) {
        // Jitter is uniform over a cell, so only random amplitudes of about 1 / sqrt(N) remain. The limit is
        // twelve times that.
        EXPECT_LT(share(jittered, period / harmonic), 12 / std::sqrt(all)) << harmonic;
        EXPECT_GT(share(regular, period / harmonic), .5) << harmonic;
    }
}

TEST(PointClouds, HaveNoMoireInPerspectiveOnceJittered) {
    const std::string near = "Perspective 60 .1 100\nLookAt 0 0 2.6 0 0 0 0 1 0";
    const auto highest = [](const std::vector<double>& sums) {
        double most = 0;
        for (double period = 1.5; period < 6; period *= 1.002) most = std::max(most, share(sums, period));
        return most;
    };
    EXPECT_GT(highest(columns(near, "PointCloud")), 3 * highest(columns(near, "JitterCloud")));
}

}  // namespace
}  // namespace glibra::stress
