// How alike two pictures are when colours, model and camera are free: pictures that are computed here, in the
// order in which a person puts them.

#include "classroom/likeness.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "classroom/cut_objects.h"
#include "classroom/pattern_points.h"

namespace glibra::classroom {
namespace {

using Rgb = std::array<double, 3>;
/// How much of the second colour there is at a place of a surface, 0 to 1.
using SurfacePattern = std::function<double(double s, double t)>;

double partIn(double value, double period) {
    return value / period - std::floor(value / period);
}
SurfacePattern dotsOf(double period) {
    return [=](double s, double t) {
        const double e = std::hypot(partIn(s, period) - .5, partIn(t, period) - .5);
        return std::clamp((.4 - e) * 20, 0., 1.);
    };
}
SurfacePattern checkerOf(double side) {
    return [=](double s, double t) {
        return (static_cast<int>(std::floor(s / side)) + static_cast<int>(std::floor(t / side))) % 2 != 0
                   ? 1.
                   : 0.;
    };
}
SurfacePattern stripesOf(double period) {
    return [=](double s, double) { return partIn(s, period) < .5 ? 1. : 0.; };
}
/// Smooth random values on a grid, cut to two colours.
SurfacePattern stainsOf(double period, std::uint32_t seed) {
    const auto random = [seed](int x, int y) {
        std::uint32_t h =
            static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U + seed;
        h = (h ^ (h >> 13U)) * 1274126177U;
        return static_cast<double>((h ^ (h >> 16U)) & 0xFFFFU) / 65535;
    };
    return [=](double s, double t) {
        const double x = s / period, y = t / period;
        const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
        const auto smooth = [](double v) { return v * v * (3 - 2 * v); };
        const double u = smooth(x - left), v = smooth(y - top);
        const double value = (random(left, top) * (1 - u) + random(left + 1, top) * u) * (1 - v) +
                             (random(left, top + 1) * (1 - u) + random(left + 1, top + 1) * u) * v;
        return std::clamp((value - .45) * 10, 0., 1.);
    };
}
SurfacePattern plain() {
    return [](double, double) { return 0.; };
}

enum class Model { ball, can, tile };

struct Shown {
    SurfacePattern pattern;
    Rgb ground{1, .5, 0}, spot{1, 1, 1};
    Model model = Model::ball;
    double x = 100, y = 100, radius = 70, turned = 0;  ///< pixels, radians
    double ambient = .3;
    int detail = 1;  ///< pixels per unit of `x`, `y` and `radius`
};

/// A picture of 200 x 200 units.
image::Image draw(const Shown& shown) {
    image::Image made{200 * shown.detail, 200 * shown.detail, 3, image::Component::u8, {}};
    for (int row = 0; row < made.height; ++row)
        for (int column = 0; column < made.width; ++column) {
            const double dx = ((column + .5) / shown.detail - shown.x) / shown.radius,
                         dy = ((row + .5) / shown.detail - shown.y) / shown.radius;
            const double u = dx * std::cos(shown.turned) - dy * std::sin(shown.turned);
            const double v = dx * std::sin(shown.turned) + dy * std::cos(shown.turned);
            double light = 1, s = u, t = v;
            bool isInside = std::max(std::abs(u), std::abs(v)) < .9;
            if (shown.model == Model::ball) {
                isInside = u * u + v * v < 1;
                const double z = std::sqrt(std::max(0., 1 - u * u - v * v));
                light = z;
                s = std::atan2(u, z);
                t = std::asin(std::clamp(v, -1., 1.));
            } else if (shown.model == Model::can) {
                isInside = std::abs(u) < .7 && std::abs(v) < 1;
                light = std::sqrt(std::max(0., 1 - u * u / .49));
                s = std::asin(std::clamp(u / .7, -1., 1.)) * .7;
            }
            const double part = shown.pattern(s, t), shade = shown.ambient + (1 - shown.ambient) * light;
            for (std::size_t k = 0; k < 3; ++k) {
                const double value = isInside ? shade * (shown.ground[k] * (1 - part) + shown.spot[k] * part)
                                              : std::array{.06, .09, .12}[k];
                made.data.push_back(static_cast<std::byte>(std::lround(255 * value)));
            }
        }
    return made;
}

constexpr double kPeriod = .4;

/// Variants of one picture, in the order in which a person puts them: the same in other colours; the same
/// from elsewhere, or on something else; another size; another pattern; no pattern.
std::vector<std::pair<std::string, Shown>> variantsOf(const std::function<SurfacePattern(double)>& pattern) {
    const SurfacePattern same = pattern(kPeriod);
    const Rgb blue{.1, .2, .7}, yellow{.9, .9, .1}, white{1, 1, 1}, green{.1, .4, .1};
    return {{"a colours", {.pattern = same, .ground = blue, .spot = yellow}},
            {"a inverted", {.pattern = same, .ground = white, .spot = green}},
            {"a unlit", {.pattern = same, .ambient = 1}},
            {"b shifted", {.pattern = same, .ground = blue, .x = 80, .y = 118}},
            {"b smaller", {.pattern = same, .ground = green, .radius = 40}},
            {"b turned", {.pattern = same, .turned = .6}},
            {"b can", {.pattern = same, .ground = blue, .spot = white, .model = Model::can}},
            {"b tile", {.pattern = same, .ground = green, .spot = yellow, .model = Model::tile}},
            {"e plain", {.pattern = plain()}},
            {"e one colour", {.pattern = plain(), .ambient = 1}}};
}

struct Assignment {
    const char* name;
    std::function<SurfacePattern(double)> pattern;
};
const std::vector<Assignment>& assignments() {
    static const std::vector<Assignment> all{{"dots", dotsOf},
                                             {"checker", [](double size) { return checkerOf(size * .7); }},
                                             {"stripes", stripesOf},
                                             {"stains", [](double size) { return stainsOf(size * .6, 7); }}};
    return all;
}

TEST(Likeness, OrdersVariantsOfSeveralAssignmentsAsAPersonDoes) {
    for (const Assignment& each : assignments()) {
        const image::Image reference = draw({.pattern = each.pattern(kPeriod)});
        std::map<char, std::pair<double, double>> range;
        std::string figures;
        const auto take = [&](const std::string& name, const Shown& shown) {
            const double value = likeness(reference, draw(shown));
            figures += fmt::format("{:.3f} {}\n", value, name);
            auto [known, isNew] = range.try_emplace(name[0], value, value);
            known->second.first = std::min(known->second.first, value);
            known->second.second = std::max(known->second.second, value);
        };
        for (const auto& [name, shown] : variantsOf(each.pattern)) take(name, shown);
        for (const Assignment& other : assignments())
            if (std::string(other.name) != each.name)
                take(std::string("d ") + other.name, {.pattern = other.pattern(kPeriod)});
        for (const double size : {kPeriod / 2, kPeriod * 1.8})
            take("c other size", {.pattern = each.pattern(size)});
        EXPECT_GT(range['a'].first, .85) << each.name << "\n" << figures;
        EXPECT_GT(range['a'].first, range['b'].second - .1) << each.name << "\n" << figures;
        EXPECT_GT(range['b'].first, range['d'].second) << each.name << "\n" << figures;
        EXPECT_GT(range['c'].first, range['d'].second - .05) << each.name << "\n" << figures;
        // The checkerboard has the grid of the dots, turned by half a right angle.
        EXPECT_LT(range['d'].second, .55) << each.name << "\n" << figures;
        EXPECT_LT(range['e'].second, .35) << each.name << "\n" << figures;
        EXPECT_LT(range['c'].second, .85) << "the size is wrong: " << each.name << "\n" << figures;
    }
}

TEST(Likeness, OfAPictureToItselfIsOneAndItDoesNotDependOnTheOrder) {
    const image::Image dots = draw({.pattern = dotsOf(kPeriod)}), checker = draw({.pattern = checkerOf(.3)});
    EXPECT_DOUBLE_EQ(likeness(dots, dots), 1);
    // Colours that go on over the whole picture have no object that could be found again.
    image::Image ramp{64, 48, 3, image::Component::u8, {}};
    for (int i = 0; i < 64 * 48 * 3; ++i) ramp.data.push_back(static_cast<std::byte>(i % 192 + i / 768));
    EXPECT_DOUBLE_EQ(likeness(ramp, ramp), 1);
    EXPECT_NEAR(likeness(dots, checker), likeness(checker, dots), .02);
    const image::Image small = draw({.pattern = dotsOf(kPeriod), .radius = 30});
    EXPECT_NEAR(likeness(dots, small), likeness(small, dots), .02);
    EXPECT_GT(likeness(dots, small), .7) << "what is small has less detail, and the same pattern";
}

TEST(Likeness, FinerDotsOnATileAreLookedAtMoreClosely) {
    const image::Image dots = draw({.pattern = dotsOf(kPeriod), .detail = 3});
    const auto finer = [&](double times) {
        return likeness(dots, draw({.pattern = dotsOf(kPeriod / times),
                                    .ground = {.1, .2, .7},
                                    .model = Model::tile,
                                    .radius = 95,
                                    .detail = 3}));
    };
    EXPECT_GT(finer(2.2), .45);
    EXPECT_GT(finer(2.6), .4);
}

TEST(Likeness, DotsRepeatThemselvesAndStainsDoNot) {
    const auto repeats = [](const SurfacePattern& pattern, Model model) {
        const Colors colors = colorsOf(draw({.pattern = pattern, .model = model, .detail = 3}));
        return repetition(
            findPatternPoints(toneScalesOf(cutOut(colors, findObjects(colors).value(), kSide))));
    };
    for (const Model model : {Model::ball, Model::can, Model::tile}) {
        EXPECT_GT(repeats(dotsOf(kPeriod), model), .9);
        for (const std::uint32_t seed : {1U, 2U, 3U, 4U})
            EXPECT_LT(repeats(stainsOf(kPeriod * .7, seed), model), .88) << seed;
    }
    EXPECT_EQ(repetition({}), 0);
}

TEST(Likeness, ACloserLookIsWhereMostOfTheObjectsIs) {
    const Colors colors = colorsOf(draw({.pattern = plain(), .model = Model::tile, .x = 60, .radius = 40}));
    const Objects all = findObjects(colors).value(), near = closer(colors, all);
    EXPECT_EQ(near.longerSide(), all.longerSide() / 2);
    EXPECT_NEAR((near.left + near.right) / 2.0, 60, 2);
    EXPECT_NEAR((near.top + near.bottom) / 2.0, 100, 2);
}

TEST(Likeness, ReactionsAreTheSameFromNearAndFromFar) {
    const auto reactionAt = [](double radius, double ambient) {
        const Shown one{.pattern = dotsOf(kPeriod), .radius = radius, .ambient = ambient};
        Shown other = one;
        other.pattern = dotsOf(kPeriod * 1.5);
        return reaction(draw(one), draw(other)).mean;
    };
    const double near = reactionAt(90, .3);
    EXPECT_GT(near, .02);
    for (const double radius : {70, 45, 30}) EXPECT_NEAR(reactionAt(radius, .3) / near, 1, .4) << radius;
    const image::Image dots = draw({.pattern = dotsOf(kPeriod)});
    const image::Image nothing = draw({.pattern = dotsOf(kPeriod), .x = 900});
    EXPECT_EQ(reaction(dots, dots).mean, 0);
    EXPECT_EQ(reaction(dots, dots).strength, 0);
    EXPECT_EQ(reaction(nothing, nothing).mean, 0);
    EXPECT_GT(reaction(dots, nothing).mean, .02);
    EXPECT_EQ(reaction(dots, image::Image{3, 2, 3, image::Component::u8, std::vector<std::byte>(18)}).mean, 1)
        << "pictures of two sizes";
}

TEST(Likeness, OfSomethingToNothingIsZero) {
    const image::Image dots = draw({.pattern = dotsOf(kPeriod)});
    const image::Image nothing = draw({.pattern = dotsOf(kPeriod), .x = 900});
    EXPECT_FALSE(showsNothing(dots));
    EXPECT_TRUE(showsNothing(nothing));
    EXPECT_EQ(likeness(dots, nothing), 0);
    EXPECT_EQ(likeness(nothing, dots), 0);
    EXPECT_EQ(likeness(nothing, nothing), 1);
    image::Image stray = nothing;
    for (std::size_t i = 0; i < 9; ++i) stray.data[30'000 + i] = std::byte{255};
    EXPECT_TRUE(showsNothing(stray)) << "three pixels are no object";
}

TEST(Likeness, OfPlainObjectsIsThatOfTheirOutlines) {
    const auto ball = [](double radius, Model model, Rgb color) {
        return draw({.pattern = plain(), .ground = color, .model = model, .radius = radius, .ambient = 1});
    };
    const image::Image one = ball(70, Model::ball, {1, .5, 0});
    EXPECT_GT(likeness(one, ball(40, Model::ball, {.2, .3, .9})), .95);
    EXPECT_GT(likeness(one, ball(70, Model::tile, {1, .5, 0})), .5);
}

TEST(Likeness, StaysBetweenZeroAndOneWhateverThePicturesAre) {
    std::vector<image::Image> all{draw({.pattern = dotsOf(kPeriod)}), draw({.pattern = stainsOf(.02, 3)})};
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 300}, {3, 3}, {7, 200}})
        for (const int components : {1, 3, 4}) {
            image::Image made{width, height, components, image::Component::u8, {}};
            for (int i = 0; i < width * height * components; ++i)
                made.data.push_back(static_cast<std::byte>(i * 37 % 251));
            all.push_back(std::move(made));
        }
    image::Image floats{40, 40, 3, image::Component::f32, {}};
    const std::vector<float> values{
        0,   1,     std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity(), 1e30F,
        .5F, 1e-30F};
    floats.data.resize(std::size_t{40} * 40 * 3 * sizeof(float));
    for (std::size_t i = 0; i < std::size_t{40} * 40 * 3; ++i)
        std::memcpy(floats.data.data() + i * sizeof(float), &values[i * i % values.size()], sizeof(float));
    all.push_back(std::move(floats));
    for (const image::Image& a : all)
        for (const image::Image* b : std::initializer_list<const image::Image*>{&all[0], &all[1], &a}) {
            const double value = likeness(a, *b);
            EXPECT_TRUE(value >= 0 && value <= 1) << a.width << " x " << a.height << ", " << b->width;
        }
}

}  // namespace
}  // namespace glibra::classroom
