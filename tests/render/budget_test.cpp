// RenderOptions::maxError in pictures: compares outlines with rays, and checks what it must not change.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <random>
#include <string>

#include "scene_text.h"

namespace glibra::test {
namespace {

constexpr int kPictureWidth = 480, kPictureHeight = 360;
constexpr double kFieldOfView = 40;

/// An ellipsoid in front of an eye; rays give its exact outline.
struct View {
    glm::dvec3 eye, up, axes;

    [[nodiscard]] std::string scene() const {
        const auto text = [](const glm::dvec3& v) {
            return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
        };
        return "Background 0\nPerspective " + std::to_string(kFieldOfView) + "\nLookAt " + text(eye) +
               " 0 0 0 " + text(up) + "\nColor 1 1 1\nScale " + text(axes) + "\nSphere\n";
    }
    /// True if the ray through that place of the picture (pixels from the lower left) meets the ellipsoid.
    [[nodiscard]] bool covers(const glm::dvec2& place) const {
        const glm::dmat4 clipFromModel =
            glm::perspective(glm::radians(kFieldOfView), double(kPictureWidth) / kPictureHeight, .1, 1000.) *
            glm::lookAt(eye, glm::dvec3(0), up) * glm::scale(glm::dmat4(1), axes);
        static thread_local glm::dmat4 known, inverse;
        if (known != clipFromModel) {
            known = clipFromModel;
            inverse = glm::inverse(clipFromModel);
        }
        const auto unproject = [&](double depth) {
            const glm::dvec4 at =
                inverse * glm::dvec4(place / glm::dvec2(kPictureWidth, kPictureHeight) * 2. - 1., depth, 1);
            return glm::dvec3(at) / at.w;
        };
        const glm::dvec3 from = unproject(-1), along = glm::normalize(unproject(.9) - from);
        return glm::length(glm::cross(from, along)) < 1;
    }
};

/// The number of pixels that contradict the ray through their centre although the outline is further away
/// than `bound`.
int pixelsBeyond(const View& view, const Picture& picture, double bound) {
    int count = 0;
    for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x) {
            const glm::dvec2 middle(x + .5, kPictureHeight - y - .5);
            const bool isDrawn = pixel(picture, x, y) != std::array<int, 3>{0, 0, 0};
            if (isDrawn == view.covers(middle)) continue;
            bool isNear = false;
            for (int i = 0; i < 32 && !isNear; ++i) {
                const double angle = i * 3.14159265 / 16;
                isNear =
                    view.covers(middle + bound * glm::dvec2(std::cos(angle), std::sin(angle))) == isDrawn;
            }
            count += isNear ? 0 : 1;
        }
    return count;
}

RenderOptions bounded(double maxError) {
    RenderOptions options;
    options.width = kPictureWidth;
    options.height = kPictureHeight;
    options.samples = 1;
    options.maxError = maxError;
    return options;
}

TEST(Budget, OutlinesLieWithinTheBoundInEveryView) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> distance(2, 7), size(.4, 1.2);
    const auto direction = [&] {
        return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    };
    int seen = 0;
    for (int i = 0; i < 12; ++i) {
        const View view{
            distance(random) * direction(), direction(), {size(random), size(random), size(random)}};
        for (const double bound : {2., .5, .15}) {
            const Picture picture = test::picture(view.scene(), {}, bounded(bound));
            // The driver's rasteriser snaps vertices to a grid of 1/256 pixel.
            EXPECT_EQ(pixelsBeyond(view, picture, bound + .01), 0) << view.scene() << bound;
            seen += countPixels(picture, {255, 255, 255}) > 1000 ? 1 : 0;
        }
        // A bound that is eight times larger gives a visible error, so the counts are not much finer than
        // necessary.
        EXPECT_GT(pixelsBeyond(view, test::picture(view.scene(), {}, bounded(2)), .25), 0) << view.scene();
    }
    EXPECT_EQ(seen, 36);
}

TEST(Budget, TouchesNothingOfASceneThatStatesItsNumbers) {
    const std::string scene =
        "LookAt 1 2 4 0 0 0 0 1 0\nSphere 1 20 10\nTranslate 1 0 0\nTorus .6 .2 9 14\nQuadXY 0 1 3 3\n"
        "Cone .5 1 12 4\nDiskXY 1 .2 7 2\nBox 1 1 1\nWireSphere .7 9 9\n";
    RenderOptions plain;
    plain.width = plain.height = 200;
    plain.samples = 1;
    RenderOptions budget = plain;
    budget.maxError = .01;
    const Result<Picture> kept = tryPicture(scene, {}, budget);
    ASSERT_TRUE(kept) << text(kept.diagnostics);
    EXPECT_EQ(kept->data, picture(scene, {}, plain).data);
    EXPECT_TRUE(has(kept.diagnostics, "draw-N03"));
    budget.overrideCounts = true;
    EXPECT_NE(picture(scene, {}, budget).data, picture(scene, {}, plain).data);
}

TEST(Budget, TheEyeDoesNotMoveWithTheCounts) {
    // Without LookAt the vertices of the scene decide where the eye is.
    const auto moved = [](double maxError) {
        const Result<Picture> seen =
            tryPicture("Rotate 20 1 2 3\nSphere\nTorus 1.2 .3\n", {}, bounded(maxError));
        for (const Diagnostic& each : seen.diagnostics)
            if (each.id == "draw-N01") return each.text;
        return std::string("not moved");
    };
    EXPECT_EQ(moved(30), moved(0));
    EXPECT_EQ(moved(.1), moved(0));
    EXPECT_NE(moved(0), "not moved");
}

TEST(Budget, TakesSamplesUnlessTheyAreStated) {
    const std::string scene = "LookAt 0 0 4 0 0 0 0 1 0\nBackground 0\nColor 1 1 1\nSphere 1 200 200\n";
    RenderOptions options = bounded(.25);
    const auto isSmooth = [&](int samples) {
        options.samples = samples;
        const Picture seen = picture(scene, {}, options);
        return countPixels(seen, {0, 0, 0}) + countPixels(seen, {255, 255, 255}) <
               kPictureWidth * kPictureHeight;
    };
    EXPECT_TRUE(isSmooth(0));
    EXPECT_FALSE(isSmooth(1));
}

TEST(Budget, SaysThatTheDriverHasTooFewSamples) {
    RenderOptions options = bounded(1e-3);
    options.samples = 0;
    const Result<Picture> seen = tryPicture("LookAt 0 0 4 0 0 0 0 1 0\nBox\n", {}, options);
    ASSERT_TRUE(seen);
    EXPECT_TRUE(has(seen.diagnostics, "draw-W07"));
    options.strict = true;
    EXPECT_FALSE(tryPicture("LookAt 0 0 4 0 0 0 0 1 0\nBox\n", {}, options));
}

/// A single patch that tessellation turns into a parabola, drawn as a thick white line.
const std::map<std::string, std::string> kCurve{
    {"a.vert", "#version 400\nvoid main() { gl_Position = aVertex; }\n"},
    {"a.tcs",
     "#version 400\nlayout(vertices = 2) out;\nuniform float uPieces;\nvoid main() {\n"
     "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
     "    gl_TessLevelOuter[0] = 1.;\n    gl_TessLevelOuter[1] = uPieces;\n}\n"},
    {"a.tes",
     "#version 400\nlayout(isolines, equal_spacing) in;\nuniform mat4 uModelViewProjectionMatrix;\n"
     "void main() {\n    float t = 2. * gl_TessCoord.x - 1.;\n"
     "    gl_Position = uModelViewProjectionMatrix * vec4(t, t * t, 0., 1.);\n}\n"},
    {"a.frag", "#version 400\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n"}};

std::string curve(const std::string& pieces) {
    return "Background 0\nOrtho -1.2 1.2 -.4 1.4\nLookAt 0 0 4 0 0 0 0 1 0\nVertex a.vert\n"
           "TessControl a.tcs\nTessEvaluation a.tes\nFragment a.frag\nProgram P uPieces " +
           pieces + "\nNumPatchVertices 2\nglBegin gl_patches\nglVertex 0 0 0\nglVertex 1 0 0\nglEnd\n";
}

/// The pixels of the curve that are further from the parabola than the bound plus half the line's width.
int pixelsBesideTheParabola(const Picture& picture, double bound) {
    int count = 0;
    for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x) {
            if (pixel(picture, x, y)[0] == 0) continue;
            double nearest = 1e9;
            for (int i = -1000; i <= 1000; ++i) {
                const double t = i / 1000.;
                nearest = std::min(nearest, std::hypot((t + 1.2) / 2.4 * kPictureWidth - x - .5,
                                                       (1.4 - t * t) / 1.8 * kPictureHeight - y - .5));
            }
            count += nearest > bound + .75 ? 1 : 0;
        }
    return count;
}

TEST(Budget, TakesTheLowestTessellationLevelThatKeepsTheBound) {
    RenderOptions options = bounded(.25);
    EXPECT_GT(pixelsBesideTheParabola(picture(curve("<1 4 60>"), kCurve, options), .25), 0);
    options.overrideCounts = true;
    const Picture chosen = picture(curve("<1 4 60>"), kCurve, options);
    EXPECT_EQ(pixelsBesideTheParabola(chosen, .25), 0);
    // A parabola of 2 x 1 units and n pieces rises by 200 / n^2 pixels over its chords: 29 are enough.
    const auto isLike = [&](int pieces) {
        RenderOptions plain = bounded(0);
        plain.set = {"uPieces=" + std::to_string(pieces)};
        return picture(curve("<1 4 60>"), kCurve, plain).data == chosen.data;
    };
    bool isNearLeast = false;
    for (int pieces = 28; pieces <= 36; ++pieces) isNearLeast = isNearLeast || isLike(pieces);
    EXPECT_TRUE(isNearLeast);
    EXPECT_FALSE(isLike(20));
}

TEST(Budget, LevelsOfTheCommandLineStay) {
    RenderOptions options = bounded(.25), plain = bounded(0);
    options.overrideCounts = true;
    options.set = plain.set = {"uPieces=3"};
    EXPECT_EQ(picture(curve("<1 4 60>"), kCurve, options).data,
              picture(curve("<1 4 60>"), kCurve, plain).data);
}

TEST(Budget, SaysWhichStatedLevelsAreTooLow) {
    const Result<Picture> seen = tryPicture(curve("3"), kCurve, bounded(.25));
    ASSERT_TRUE(seen);
    EXPECT_TRUE(has(seen.diagnostics, "draw-N03"));
    EXPECT_NE(text(seen.diagnostics).find("uPieces 3"), std::string::npos) << text(seen.diagnostics);
    EXPECT_FALSE(has(tryPicture(curve("40"), kCurve, bounded(.25)).diagnostics, "draw-N03"));
}

/// Stripes that noise distorts.
const std::map<std::string, std::string> kStripes{
    {"a.vert",
     "#version 330 core\nout vec3 vPlace;\nvoid main() { vPlace = aVertex.xyz; gl_Position = "
     "uModelViewProjectionMatrix * aVertex; }\n"},
    {"a.frag",
     "#version 330 core\nuniform float uScale;\nin vec3 vPlace;\nout vec4 fColor;\nvoid main() {\n"
     "    vec4 n = texture(Noise3, uScale * vPlace + vec3(.1, .2, .3));\n"
     "    fColor = vec4(vec3(step(fract(8. * (n.r + n.g + n.b + n.a)), .5)), 1.);\n}\n"}};

TEST(Budget, TakesLargerNoiseWhereAProgramStretchesIt) {
    const std::string scene =
        "Ortho -1 1 -1 1\nLookAt 0 0 4 0 0 0 0 1 0\nVertex a.vert\nFragment a.frag\nProgram P uScale ";
    // The shares of pixels that differ from a much finer picture.
    const std::string shown = ".3\nQuadXY 0 1\n";
    const Picture fine = picture("Noise3D 300\n" + scene + shown, kStripes, bounded(0));
    const auto differing = [&](double maxError) {
        const Picture seen = picture(scene + shown, kStripes, bounded(maxError));
        int count = 0;
        for (std::size_t i = 0; i < seen.data.size(); i += 3) count += seen.data[i] != fine.data[i] ? 1 : 0;
        return static_cast<double>(count) / (kPictureWidth * kPictureHeight);
    };
    const double exact = differing(0);
    EXPECT_LT(differing(.25), exact / 3);
    EXPECT_GT(differing(100), exact);
}

}  // namespace
}  // namespace glibra::test
