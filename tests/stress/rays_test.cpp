// Tracing rays against closed forms (exercises' accuracy table 38, 41, 43): the offset of secondary rays,
// faces found by comparing normals, and the depth of recursion with a stack of one's own.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "support.h"

namespace glibra::stress {
namespace {

/// Fills a square window with a fragment shader that defines `vec3 value(vec2 place)`, place in 0..1.
FloatPicture filled(int side, const std::string& glsl, const std::string& tags) {
    return draw(fmt::format(R"(WindowSize {0} {0}
Camera eye LookAt 0 0 1  0 0 0  0 1 0  Perspective 50 .1 10
Fragment inline
#version 330 core
in vec2 vST;
out vec4 fColor;
{1}
void main() {{ fColor = vec4(value(vST), 1.); }}
EndFragment
Program Value {2}
Fill window with Value
)",
                            side, glsl, tags));
}

/// Place of the centre of a pixel, 0..1, as vST.
glm::dvec2 centreOfPixel(int column, int row, int side) {
    return {(column + .5) / side, (side - row - .5) / side};
}

TEST(RayOffset, EndsSelfHitsAndMissesContactsAsInTheory) {
    // A lit point of a sphere never shadows itself: a ray to the light leaves a convex body. In floats the
    // point lies beside the surface by about the rounding of the distance, so that a ray may hit the sphere
    // at a distance of that size. An occluder that rises from the ground with the slope m is missed where it
    // is nearer than the offset e: on a strip of the width e / m.
    constexpr int kSide = 400;
    constexpr double kSlope = .1;
    const std::string glsl = R"(uniform float uOffset, uScale;
const vec3 kLight = normalize(vec3(.4, .7, .6));
// The nearer distance beyond `least`, or -1.
float sphere(vec3 o, vec3 d, float least) {
    float b = dot(o, d), c = dot(o, o) - uScale * uScale, q = b * b - c;
    if (q < 0.) return -1.;
    float near = -b - sqrt(q), far = -b + sqrt(q);
    return near > least ? near : far > least ? far : -1.;
}
vec3 value(vec2 place) {
    vec3 o = vec3((2. * place - 1.) * uScale, 8. * uScale), d = vec3(0., 0., -1.);
    float t = sphere(o, d, 0.);
    vec3 p = o + t * d;
    float isSelf = t > 0. && dot(p, kLight) > .05 * uScale && sphere(p, kLight, uOffset) > 0. ? 1. : 0.;
    float isLit = t > 0. && dot(p, kLight) > .05 * uScale ? 1. : 0.;
    // The ground from x = 0 to uScale, light from above, the height of the occluder above it.
    float height = .1 * place.x * uScale;
    return vec3(isSelf, isLit, height > uOffset ? 0. : 1.);
})";
    for (const double scale : {1e-3, 1., 1e3}) {
        double before = 1;
        for (const double offset : {0., 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
            const auto traced = [&](double absolute) {
                return filled(kSide, glsl,
                              fmt::format("uOffset ({}) uScale ({})", number(absolute), number(scale)));
            };
            const FloatPicture picture = traced(offset * scale);
            ASSERT_EQ(picture.width, kSide);
            const double self = picture.sum(0) / picture.sum(1);
            const double missed = picture.sum(2) / (kSide * kSide);
            std::printf(
                "scale %g, offset %g of it: %.5f of the lit points shadow themselves, %.4f of the "
                "contact is missed\n",
                scale, offset, self, missed);
            EXPECT_LE(self, before + .002);
            EXPECT_NEAR(missed, std::min(1., offset / kSlope), 1.5 / kSide);
            if (offset == 0) {
                EXPECT_GT(self, .02);
            }
            // Rounding is 8 * 2^-24 in the place and, over the least cosine of .05, 20 times that along the
            // ray.
            if (offset >= 1e-4) {
                EXPECT_EQ(self, 0);
            }
            before = self;
        }
        // An offset of .001 whatever the scale is too small for a large scene.
        const FloatPicture fixed =
            filled(kSide, glsl, fmt::format("uOffset .001 uScale ({})", number(1e4 * scale)));
        const double self = fixed.sum(0) / fixed.sum(1);
        std::printf("scale %g, offset .001: %.5f of the lit points shadow themselves\n", 1e4 * scale, self);
        if (scale < 1) {
            EXPECT_EQ(self, 0);
        }
        if (scale > 1) {
            EXPECT_GT(self, .02);
        }
    }
}

TEST(BoxFaces, AreFoundByTheLargestComponentAndByEqualNormalsOnlyWithoutATurn) {
    // Rays from the middle of a box leave through the face of the largest component in the box's own axes.
    constexpr int kSide = 200;
    const std::string glsl = R"(uniform float uAngle;
uniform bool uCompares;
vec3 value(vec2 place) {
    float c = cos(uAngle), s = sin(uAngle);
    mat3 turn = mat3(1., 0., 0., 0., c, s, 0., -s, c) * mat3(c, s, 0., -s, c, 0., 0., 0., 1.);
    float z = 2. * place.y - 1., around = 6.28318530718 * place.x;
    vec3 d = vec3(sqrt(1. - z * z) * vec2(cos(around), sin(around)), z);
    vec3 own = transpose(turn) * d, size = abs(own);
    int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    if (!uCompares) return vec3(2 * axis + (own[axis] > 0. ? 1 : 0), 0., 0.);
    vec3 normal = vec3(0.);
    normal[axis] = own[axis] > 0. ? 1. : -1.;
    normal = turn * normal;
    for (int face = 0; face < 6; ++face) {
        vec3 known = vec3(0.);
        known[face / 2] = face % 2 == 1 ? 1. : -1.;
        if (normal == known) return vec3(face, 0., 0.);
    }
    return vec3(-1., 0., 0.);
})";
    for (const double angle : {0., 1e-7, 1e-5, 1e-3, .1})
        for (const bool compares : {false, true}) {
            const FloatPicture picture =
                filled(kSide, glsl,
                       fmt::format("uAngle ({}) uCompares {}", number(angle), compares ? "true" : "false"));
            ASSERT_EQ(picture.width, kSide);
            const double c = std::cos(angle), s = std::sin(angle);
            const glm::dmat3 turn =
                glm::dmat3(1, 0, 0, 0, c, s, 0, -s, c) * glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1);
            int wrong = 0, none = 0;
            for (int row = 0; row < kSide; ++row)
                for (int column = 0; column < kSide; ++column) {
                    const glm::dvec2 place = centreOfPixel(column, row, kSide);
                    const double z = 2 * place.y - 1, around = 2 * std::numbers::pi * place.x;
                    const glm::dvec3 d(std::sqrt(1 - z * z) * std::cos(around),
                                       std::sqrt(1 - z * z) * std::sin(around), z);
                    const glm::dvec3 own = glm::transpose(turn) * d, size = glm::abs(own);
                    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
                    double second = 0;
                    for (int i = 0; i < 3; ++i)
                        if (i != axis) second = std::max(second, size[i]);
                    if (size[axis] - second < 1e-5) continue;  // floats may decide otherwise
                    const int face = static_cast<int>(picture.at(column, row)[0]);
                    none += face == -1 ? 1 : 0;
                    wrong += face == 2 * axis + (own[axis] > 0 ? 1 : 0) ? 0 : 1;
                }
            const double share = static_cast<double>(wrong) / (kSide * kSide);
            std::printf("turned by %g, %s: %.4f of the rays find no face\n", angle,
                        compares ? "equal normals" : "largest component", share);
            EXPECT_EQ(wrong, none);
            if (!compares || angle == 0) {
                EXPECT_EQ(wrong, 0) << angle;
            } else {
                EXPECT_GT(share, .6) << angle;
            }
        }
}

TEST(RecursionDepth, LeavesTheTailOfAGeometricSeries) {
    // Inside a closed box whose walls emit 1 and pass on .5 of the light from the mirrored direction and .3
    // of that along the normal, every ray sees 1 / (1 - .8) = 5. To the depth d the tree of rays gives 1 + .8
    // + ... + .8^d: the error is .8^(d + 1) * 5. The stack needs d + 1 entries; a shorter one loses the rays
    // that do not fit, and what they would have brought.
    constexpr int kSide = 8, kMostDepth = 12;
    const std::string glsl = R"(uniform int uDepth, uStack;
vec3 value(vec2 place) {
    vec3 origins[16], directions[16];
    float weights[16];
    int depths[16];
    origins[0] = vec3(.1, -.2, .3);
    directions[0] = normalize(vec3(2. * place - 1., .7));
    weights[0] = 1.;
    depths[0] = 0;
    float sum = 0.;
    int count = 1, lost = 0, most = 1;
    while (count > 0) {
        --count;
        vec3 o = origins[count], d = directions[count];
        float weight = weights[count];
        int depth = depths[count];
        // The walls are at +-1.
        vec3 t = (sign(d) - o) / d;
        if (d.x == 0.) t.x = 1e9;
        if (d.y == 0.) t.y = 1e9;
        if (d.z == 0.) t.z = 1e9;
        float nearest = min(t.x, min(t.y, t.z));
        vec3 n = t.x == nearest ? vec3(-sign(d.x), 0., 0.) : t.y == nearest ? vec3(0., -sign(d.y), 0.)
                                                                            : vec3(0., 0., -sign(d.z));
        vec3 p = clamp(o + nearest * d, -1., 1.) + 1e-4 * n;
        sum += weight;
        if (depth == uDepth) continue;
        for (int branch = 0; branch < 2; ++branch) {
            if (count == uStack) {
                ++lost;
                continue;
            }
            origins[count] = p;
            directions[count] = branch == 0 ? reflect(d, n) : n;
            weights[count] = weight * (branch == 0 ? .5 : .3);
            depths[count] = depth + 1;
            ++count;
            most = max(most, count);
        }
    }
    return vec3(sum, lost, most);
})";
    /// The same tree without rays.
    struct Tree {
        double sum = 0;
        int lost = 0;
        int most = 1;
    };
    const auto treeOf = [](int depth, int stack) {
        Tree tree;
        std::vector<std::pair<double, int>> open{{1., 0}};
        while (!open.empty()) {
            const auto [weight, at] = open.back();
            open.pop_back();
            tree.sum += weight;
            if (at == depth) continue;
            for (const double share : {.5, .3})
                if (static_cast<int>(open.size()) == stack)
                    ++tree.lost;
                else
                    open.emplace_back(weight * share, at + 1);
            tree.most = std::max(tree.most, static_cast<int>(open.size()));
        }
        return tree;
    };
    for (int depth = 0; depth <= kMostDepth; ++depth) {
        const FloatPicture picture = filled(kSide, glsl, fmt::format("uDepth {} uStack 16", depth));
        ASSERT_EQ(picture.width, kSide);
        const double error = 5 * std::pow(.8, depth + 1);
        const std::size_t wrong = picture.count([&](const auto& found) {
            return std::abs(5 - static_cast<double>(found[0]) - error) > 5e-4 || found[1] != 0 ||
                   found[2] != static_cast<float>(depth + 1);
        });
        EXPECT_EQ(wrong, 0U) << depth;
        std::printf("depth %d: short of the limit by %.4f of 5, stack of %d\n", depth, error,
                    static_cast<int>(picture.at(0, 0)[2]));
    }
    for (const int stack : {2, 4, 8}) {
        const Tree tree = treeOf(10, stack);
        const FloatPicture picture = filled(kSide, glsl, fmt::format("uDepth 10 uStack {}", stack));
        ASSERT_EQ(picture.width, kSide);
        const auto found = picture.at(0, 0);
        std::printf("a stack of %d at depth 10 loses %g rays: %.4f in place of %.4f\n", stack,
                    static_cast<double>(found[1]), static_cast<double>(found[0]), 5 - 5 * std::pow(.8, 11));
        EXPECT_NEAR(static_cast<double>(found[0]), tree.sum, 5e-4);
        EXPECT_EQ(static_cast<int>(found[1]), tree.lost);
        EXPECT_EQ(static_cast<int>(found[2]), tree.most);
        EXPECT_GT(tree.lost, 0);
    }
}

}  // namespace
}  // namespace glibra::stress
