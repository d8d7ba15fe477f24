#include "geometry/shapes/teapot_patches.h"

namespace glibra::geometry {
namespace {

/// A control point of a profile that is turned around the z axis. `pull` is the distance of the two inner
/// control points of a quarter circle from its ends, .56 of the radius except at the knob.
struct ProfilePoint {
    double radius = 0, z = 0;
    double pull = .56;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr Profile kBottom{{{0, 0}, {1.425, 0}, {1.5, .075}, {1.5, .15}}};
constexpr Profile kLowerBody{{{1.5, .15}, {1.5, .225}, {2, .45}, {2, .9}}};
constexpr Profile kUpperBody{{{2, .9}, {2, 1.35}, {1.75, 1.875}, {1.5, 2.4}}};
constexpr Profile kRim{{{1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125}, {1.4, 2.4}}};
constexpr Profile kLid{{{1.3, 2.4}, {1.3, 2.55}, {.4, 2.55}, {.2, 2.7}}};
constexpr Profile kKnob{{{.2, 2.7}, {0, 2.85}, {.8, 3.15, .5625}, {0, 3.15}}};

/// One cross-section of handle or spout: half of a closed curve, through y <= 0, with both ends in the plane
/// y = 0.
struct Section {
    double x0 = 0, z0 = 0;  ///< the first two control points
    double x1 = 0, z1 = 0;  ///< the last two
    double width = 0;       ///< |y| of the inner two; the outer two are at y = 0
};
using Sections = std::array<Section, 4>;

constexpr Sections kUpperHandle{{{-1.6, 2.025, -1.5, 2.25, .3},
                                 {-2.3, 2.025, -2.5, 2.25, .3},
                                 {-2.7, 2.025, -3, 2.25, .3},
                                 {-2.7, 1.8, -3, 1.8, .3}}};
constexpr Sections kLowerHandle{{{-2.7, 1.8, -3, 1.8, .3},
                                 {-2.7, 1.575, -3, 1.35, .3},
                                 {-2.5, 1.125, -2.65, .9375, .3},
                                 {-2, .9, -1.9, .6, .3}}};
constexpr Sections kLowerSpout{{{1.7, 1.425, 1.7, .6, .66},
                                {2.6, 1.425, 3.1, .825, .66},
                                {2.3, 2.1, 2.4, 2.025, .25},
                                {2.7, 2.4, 3.3, 2.4, .25}}};
constexpr Sections kUpperSpout{{{2.7, 2.4, 3.3, 2.4, .25},
                                {2.8, 2.475, 3.525, 2.49375, .25},
                                {2.9, 2.475, 3.45, 2.5125, .15},
                                {2.8, 2.4, 3.2, 2.4, .15}}};

/// A quarter of the turned profile, counter-clockwise from above, beginning `quarter` quarter turns after +x.
Patch turned(const Profile& profile, int quarter) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto [radius, z, pull] = profile[row];
        const double off = pull * radius;
        patch[row] = {{{radius, 0, z}, {radius, off, z}, {off, radius, z}, {0, radius, z}}};
        for (glm::dvec3& point : patch[row])
            for (int turn = 0; turn < quarter; ++turn) point = {-point.y, point.x, point.z};
    }
    return patch;
}

Patch nearHalf(const Sections& sections) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto [x0, z0, x1, z1, width] = sections[row];
        patch[row] = {{{x0, 0, z0}, {x0, -width, z0}, {x1, -width, z1}, {x1, 0, z1}}};
    }
    return patch;
}

/// The other half, y >= 0, which continues where the near half ends.
Patch farHalf(const Sections& sections) {
    Patch patch = nearHalf(sections);
    for (auto& row : patch) {
        row = {row[3], row[2], row[1], row[0]};
        for (glm::dvec3& point : row) point.y = -point.y;
    }
    return patch;
}

}  // namespace

std::array<Patch, 32> teapotPatches() {
    std::array<Patch, 32> patches;
    std::size_t next = 0;
    for (const Profile& profile : {kRim, kUpperBody, kLowerBody, kKnob, kLid, kBottom})
        // The published order goes clockwise from the quarter between +x and -y.
        for (int quarter = 3; quarter >= 0; --quarter) patches[next++] = turned(profile, quarter);
    for (const Sections& sections : {kUpperHandle, kLowerHandle, kLowerSpout, kUpperSpout}) {
        patches[next++] = nearHalf(sections);
        patches[next++] = farHalf(sections);
    }
    return patches;
}

}  // namespace glibra::geometry
