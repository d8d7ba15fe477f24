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
#include <utility>
#include <vector>

#include "render/scene_renderer.h"
#include "scene_text.h"
#include "skip_runs.h"

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

TEST(Budget, KnowsTheMatricesByTheNamesOfBooks) {
    const auto scene = [](const std::string& position, const std::string& values = {}) {
        return "Camera eye LookAt 2 2 4 0 0 0 0 1 0 Perspective 40 .1 100\nVertex inline\n#version 330\n"
               "uniform mat4 mvp, projection, view, model; in vec3 aPos;\nvoid main() { gl_Position = " +
               position +
               "; }\nEndVertex\nFragment inline\n#version 330\nout vec4 f; void main() { f = vec4(1); }\n"
               "EndFragment\nProgram P " +
               values + "\nTranslate .3 .1 0\nSphere 1\n";
    };
    const std::string identity = "mvp [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]";
    for (const char* each : {"mvp * vec4(aPos, 1.)", "projection * view * model * vec4(aPos, 1.)"}) {
        const Result<Picture> seen = tryPicture(scene(each), {}, bounded(.25));
        ASSERT_TRUE(seen) << text(seen.diagnostics);
        EXPECT_FALSE(has(seen.diagnostics, "draw-N05")) << text(seen.diagnostics);
    }
    EXPECT_TRUE(
        has(tryPicture(scene("mvp * vec4(aPos, 1.)", identity), {}, bounded(.25)).diagnostics, "draw-N05"));
    EXPECT_TRUE(has(tryPicture("Let mvp [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]\n" + scene("mvp * vec4(aPos, 1.)"),
                               {}, bounded(.25))
                        .diagnostics,
                    "draw-N05"));
    // Set in another moment than the first, and by a tag that is computed.
    const std::string later = scene("mvp * vec4(aPos, 1.)") + "Repeat (time > .5 ? 1 : 0)\nSet " + identity +
                              "\nSphere 1\nEndRepeat\n";
    RenderOptions second = bounded(.25);
    second.time = 1;
    EXPECT_TRUE(has(tryPicture(later, {}, second).diagnostics, "draw-N05"));
    EXPECT_FALSE(has(tryPicture(later, {}, bounded(.25)).diagnostics, "draw-N05"));
    EXPECT_TRUE(has(
        tryPicture("Let one 1\n" + scene("mvp * vec4(aPos, 1.)", "mvp [(one) 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]"),
                   {}, bounded(.25))
            .diagnostics,
        "draw-N05"));
    // The camera does not look there, but the matrix of the second moment shows it.
    const std::string away =
        "Camera eye LookAt 0 0 4 0 0 8 0 1 0 Perspective 40 .1 100\n" + later.substr(later.find('\n') + 1);
    RenderOptions moment;
    moment.width = moment.height = 64;
    EXPECT_EQ(countPixels(picture(away, {}, moment), {255, 255, 255}), 0);
    moment.time = 1;
    EXPECT_GT(countPixels(picture(away, {}, moment), {255, 255, 255}), 100);
    RenderOptions given = bounded(.25);
    given.set = {"mvp=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1"};
    EXPECT_TRUE(has(tryPicture(scene("mvp * vec4(aPos, 1.)"), {}, given).diagnostics, "draw-N05"));
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

/// The parabola's patch in another form: what its vertex stage places, its control stage (or none) and the
/// statements that draw it.
struct CurveForm {
    const char* name;
    std::string draws;
    std::string place = "vec4(0.)";
    std::string levels = "gl_TessLevelOuter[0] = 1.;\n    gl_TessLevelOuter[1] = uPieces;\n";
    std::string curvature = "1.";
};

Result<Picture> drawForm(const CurveForm& form, const RenderOptions& options) {
    std::map<std::string, std::string> files = kCurve;
    files["a.vert"] = "#version 400\nout float vBend;\nvoid main() { gl_Position = " + form.place +
                      "; vBend = " + form.curvature + "; }\n";
    files["a.tcs"] =
        "#version 400\nlayout(vertices = 2) out;\nuniform float uPieces;\nin float vBend[];\n"
        "out float tcBend[];\n"
        "void set(float level) { gl_TessLevelOuter[0] = 1.; gl_TessLevelOuter[1] = level; }\nvoid main() {\n"
        "    tcBend[gl_InvocationID] = vBend[gl_InvocationID];\n    " +
        form.levels + "}\n";
    const std::string bend = form.levels.empty() ? "vBend" : "tcBend";
    files["a.tes"] =
        "#version 400\nlayout(isolines, equal_spacing) in;\nuniform mat4 uModelViewProjectionMatrix;\n"
        "in float " +
        bend +
        "[];\nvoid main() {\n    float t = 2. * gl_TessCoord.x - 1.;\n"
        "    gl_Position = uModelViewProjectionMatrix * vec4(t, " +
        bend + "[0] * (t * t + 9.) - 9., 0., 1.);\n}\n";  // without bend it is out of sight
    const bool isSet = form.levels.find("uPieces") != std::string::npos;
    const std::string text =
        std::string("Background 0\nOrtho -1.2 1.2 -.4 1.4\nLookAt 0 0 4 0 0 0 0 1 0\nVertex a.vert\n") +
        (form.levels.empty() ? "" : "TessControl a.tcs\n") +
        "TessEvaluation a.tes\nFragment a.frag\nProgram P" + (isSet ? " uPieces <1 4 60>" : "") +
        "\nNumPatchVertices 2\n" + form.draws;
    return tryPicture(text, files, options);
}

// A parabola of 2 x 1 units with 4 pieces is 200 / 4^2 = 12.5 pixels from its chords, however its patch is
// drawn; what the finest pieces of the driver are off is added.
TEST(Budget, MeasuresPatchesInEveryFormInWhichTheyAreDrawn) {
    const std::string last = "gl_InstanceID == 2 ? 1. : 0.";
    const std::vector<CurveForm> forms{
        {"list", "glBegin patches\nglVertex 0 0 0\nglVertex 1 0 0\nglEnd\n", "aVertex"},
        {"in order", "Vertices patches 2\n"},
        {"by indices", "Buffer idx uint [0 1]\nVertices patches indices idx\n"},
        {"some of the indices", "Buffer idx uint [0 1 5 6]\nVertices patches 2 indices idx\n"},
        {"number in a buffer", "Buffer n uint [2]\nVertices patches from n\n"},
        {"the last instance", "Instances 3\nVertices patches 2\n", "vec4(0.)", CurveForm{}.levels, last},
        {"the last instance by indices", "Buffer idx uint [0 1]\nInstances 3\nVertices patches indices idx\n",
         "vec4(0.)", CurveForm{}.levels, last},
        {"instances in a buffer", "Buffer k uint [3]\nInstances from k\nVertices patches 2\n", "vec4(0.)",
         CurveForm{}.levels, last},
        {"levels in a loop", "Vertices patches 2\n", "vec4(0.)",
         "gl_TessLevelOuter[0] = 1.;\n    for (int i = 1; i < 2; ++i) gl_TessLevelOuter[i] = uPieces;\n"},
        {"one of many", "Vertices patches 600\n", "vec4(0.)", CurveForm{}.levels,
         "gl_VertexID / 2 == 203 ? 1. : 0."},
    };
    for (const CurveForm& form : forms) {
        RenderOptions options = bounded(.25);
        const Result<Picture> stated = drawForm(form, options);
        ASSERT_TRUE(stated) << form.name << text(stated.diagnostics);
        EXPECT_NE(text(stated.diagnostics).find("uPieces 4, as the scene states, is up to 12.6 px off"),
                  std::string::npos)
            << form.name << text(stated.diagnostics);
        options.overrideCounts = true;
        const Result<Picture> chosen = drawForm(form, options);
        ASSERT_TRUE(chosen) << form.name;
        EXPECT_FALSE(has(chosen.diagnostics, "draw-N03")) << form.name << text(chosen.diagnostics);
        EXPECT_EQ(pixelsBesideTheParabola(*chosen, .25), 0) << form.name;
    }
}

TEST(Budget, MeasuresLevelsHoweverTheyAreWritten) {
    const std::vector<CurveForm> forms{
        {"constants", "", "", "gl_TessLevelOuter[0] = 1.; gl_TessLevelOuter[1] = 4.;\n"},
        {"a function", "", "", "set(uPieces);\n"},
        {"a loop", "", "", "for (int i = 0; i < 2; ++i) gl_TessLevelOuter[i] = i == 0 ? 1. : uPieces;\n"},
        {"after a barrier", "", "", "barrier();\n    if (gl_InvocationID == 0) set(4.);\n"},
        {"by a statement", "TessLevels 1 4 1 1 1 1\n", "", ""},
    };
    for (CurveForm form : forms) {
        form.place = "vec4(0.)";
        form.draws += "Vertices patches 2\n";
        for (const bool overrides : {false, true}) {
            RenderOptions options = bounded(.25);
            options.overrideCounts = overrides;
            const Result<Picture> seen = drawForm(form, options);
            ASSERT_TRUE(seen) << form.name << text(seen.diagnostics);
            EXPECT_TRUE(has(seen.diagnostics, "draw-N03")) << form.name << text(seen.diagnostics);
            EXPECT_NE(text(seen.diagnostics).find("12.6 px off"), std::string::npos)
                << form.name << text(seen.diagnostics);
        }
    }
}

TEST(Budget, SaysWhereTessellationCannotBeMeasured) {
    const CurveForm form{"", "Vertices patches 2\n", "vec4(0.)",
                         "barrier();\n    if (gl_InvocationID > 0) return;\n    set(4.);\n"};
    EXPECT_TRUE(has(drawForm(form, bounded(.25)).diagnostics, "draw-N05"));
    EXPECT_FALSE(has(drawForm(form, bounded(0)).diagnostics, "draw-N05"));
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

/// A torus that turns and comes nearer with time.
std::string movingTorus(const std::string& time) {
    return "Background 0\nPerspective 40\nLookAt 0 .8 5 0 0 0 0 1 0\nColor 1 1 1\n"
           "Translate 0 0 " +
           time + "\nRotate (30 * " + time + ") 0 1 0\nTorus .8 .3 6 8\n";
}

TEST(Budget, ASceneThatMovesIsChosenForEachPicture) {
    RenderOptions options = bounded(.25);
    const std::string moving = movingTorus("(time)");
    for (const double time : {0., 1.5, 2.5}) {
        const std::string still = movingTorus("(" + std::to_string(time) + ")");
        options.time = time;
        options.overrideCounts = false;
        const Result<Picture> stated = tryPicture(moving, {}, options);
        ASSERT_TRUE(stated) << text(stated.diagnostics);
        EXPECT_TRUE(has(stated.diagnostics, "draw-N03")) << time;
        options.overrideCounts = true;
        const Result<Picture> chosen = tryPicture(moving, {}, options);
        ASSERT_TRUE(chosen) << text(chosen.diagnostics);
        EXPECT_FALSE(has(chosen.diagnostics, "draw-N03")) << time;
        EXPECT_EQ(chosen->data, picture(still, {}, options).data) << time;
        EXPECT_NE(chosen->data, stated->data) << time;
    }
}

TEST(Budget, EachFrameOfAFilmIsThePictureOfItsTime) {
    const SceneFolder folder(movingTorus("(time)"), {});
    RenderOptions options = bounded(.25);
    options.overrideCounts = true;
    RenderOptions film = options;
    film.lastTime = 3;
    render::Stats stats;
    Result<render::SceneRenderer> renderer =
        render::SceneRenderer::load(sharedContext(), folder / "scene.glib", film, stats);
    ASSERT_TRUE(renderer) << text(renderer.diagnostics);
    for (const double time : {0., 1.5, 3., 1.5}) {
        const Result<image::Image> frame = renderer->draw(time, stats);
        ASSERT_TRUE(frame) << text(frame.diagnostics);
        options.time = time;
        render::Stats alone;
        Result<render::SceneRenderer> one =
            render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, alone);
        ASSERT_TRUE(one);
        EXPECT_EQ(frame->data, one->draw(time, alone)->data) << time;
    }
}

/// A rectangle over the whole picture, whose fragment stage has this main; `vX` is in pixels.
Result<Picture> painted(const std::string& main, const std::string& more, const RenderOptions& options) {
    return tryPicture("Background 0\nOrtho 0 100 -10 10 -1 1\nVertex a.vert\nFragment a.frag\n" + more +
                          "Program P\nTranslate 50 0 0\nQuadXY 0 100\n",
                      {{"a.vert",
                        "#version 330 core\nout float vX;\nvoid main() {\n    vX = aVertex.x + 50.;\n"
                        "    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
                       {"a.frag", "#version 430 core\nin float vX;\nout vec4 fColor;\n" + main}},
                      options);
}

RenderOptions stripOptions(double maxError) {
    RenderOptions options;
    options.width = 100;
    options.height = 20;
    options.maxError = maxError;
    return options;
}

/// Where the edge of a picture lies that is black on its left, in pixels.
double edgeOf(const Picture& picture) {
    double white = 0;
    for (int x = 0; x < picture.width; ++x) white += pixel(picture, x, 10)[0] / 255.;
    return picture.width - white;
}

TEST(Budget, EdgesThatAFragmentStagePaintsOrCutsLieWithinTheBound) {
    for (const char* main : {"void main() { fColor = vec4(vec3(step(AT, vX)), 1.); }\n",
                             "void main() { if (vX < AT) discard; fColor = vec4(1.); }\n",
                             "void main() { fColor = vX < AT ? vec4(0., 0., 0., 1.) : vec4(1.); }\n",
                             "void main() { fColor = vec4(vec3(1e4 * (vX - AT)), 1.); }\n",
                             "void main() { fColor = vec4(vec3(floor(vX - AT + 1.)), 1.); }\n"})
        for (const char* at : {"50.05", "50.3", "50.4", "50.6", "50.95"}) {
            std::string text = main;
            text.replace(text.find("AT"), 2, at);
            const Result<Picture> seen = painted(text, "", stripOptions(.25));
            ASSERT_TRUE(seen) << test::text(seen.diagnostics);
            EXPECT_FALSE(has(seen.diagnostics, "draw-W07"));
            EXPECT_NEAR(edgeOf(*seen), std::stod(at), .26) << text;
        }
    // With one sample per pixel half a pixel is all that is promised.
    const Result<Picture> coarse =
        painted("void main() { if (vX < 50.4) discard; fColor = vec4(1.); }\n", "", stripOptions(.5));
    EXPECT_NEAR(edgeOf(*coarse), 50.4, .5);
    EXPECT_EQ(edgeOf(*coarse), 50);
}

TEST(Budget, SaysWhereAFragmentStageRunsOncePerPixel) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "no storage blocks";
    const std::string main =
        "layout(std430) buffer Count { uint uCount; };\n"
        "void main() { atomicAdd(uCount, 1u); if (vX < 50.4) discard; fColor = vec4(1.); }\n";
    const Result<Picture> seen = painted(main, "Buffer Count 1\n", stripOptions(.25));
    ASSERT_TRUE(seen) << text(seen.diagnostics);
    EXPECT_TRUE(has(seen.diagnostics, "draw-W07")) << text(seen.diagnostics);
    EXPECT_FALSE(has(painted(main, "Buffer Count 1\n", stripOptions(.5)).diagnostics, "draw-W07"));
}

TEST(Budget, StraightLinesTakeOneCellWhereNothingElseIsComputedOnThem) {
    const std::string program =
        "Ortho -2 2 -2 2\nLookAt 1 2 4 0 0 0 0 1 0\nVertex a.vert\nFragment a.frag\nProgram P\n";
    const auto chosen = [&](const std::string& shape, const std::string& color) {
        const SceneFolder folder(
            program + shape,
            {{"a.vert", "#version 330 core\nout vec3 vC;\nvoid main() {\n    vC = " + color +
                            ";\n    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
             {"a.frag",
              "#version 330 core\nin vec3 vC;\nout vec4 fColor;\nvoid main() { fColor = vec4(vC, 1.); }\n"}});
        const RenderOptions options = bounded(.25);
        render::Stats stats;
        const Result<render::SceneRenderer> made =
            render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
        for (const budget::Decision& each : stats.decisions)
            if (shape.starts_with(each.what)) return each.why;
        return std::string();
    };
    for (const auto& [shape, one] :
         {std::pair("Cylinder", ", 1 stacks"), {"Cone", ", 1 stacks"}, {"DiskXY", ", 1 rings"}}) {
        const std::string plain = chosen(std::string(shape) + "\n", "vec3(1.)");
        EXPECT_NE(plain.find(one), std::string::npos) << shape << ": " << plain;
        // Stripes along them: with one cell they would be gone, although each half of it agrees.
        const std::string striped =
            chosen(std::string(shape) + "\n", "vec3(.5 + .5 * cos(40. * length(aVertex.xyz)))");
        EXPECT_EQ(striped.find(one), std::string::npos) << shape << ": " << striped;
    }
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
