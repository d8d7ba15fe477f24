// How the stages between a vertex and a pixel change values: transfer functions before and after
// interpolation (NM26), normals in bytes, coarse height fields, clip planes of any length, and discarded
// fragments (exercises' accuracy table 18, 21, 33, 35).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support.h"

namespace glibra::stress {
namespace {

TEST(TransferFunctions, OfTheInterpolatedValueAreNotTheInterpolatedColours) {
    constexpr int kColumns = 100;
    const std::string ramp = shipped("common/rainbow.glsl");
    const Files files{
        {"v.vert", "#version 330 core\nout float vValue;\nout vec3 vColor;\n" + ramp +
                       "void main() { vValue = .5 * aVertex.x + .5; vColor = rainbow(vValue); gl_Position = "
                       "uModelViewProjectionMatrix * aVertex; }\n"},
        {"f.frag",
         "#version 330 core\nin float vValue;\nin vec3 vColor;\nuniform bool uAfter;\nout vec4 "
         "fColor;\n" +
             ramp + "void main() { fColor = vec4(uAfter ? rainbow(vValue) : vColor, 1.); }\n"}};
    for (const bool after : {false, true}) {
        const FloatPicture picture =
            draw(fmt::format("WindowSize {0} {0}\n{1}Program P uAfter {2}\nQuadXY 0 1 1 1\n", kColumns,
                             kFlatView, after ? 1 : 0),
                 files);
        ASSERT_EQ(picture.width, kColumns);
        for (int x = 0; x < kColumns; ++x) {
            const double t = (x + .5) / kColumns;
            const std::array<double, 3> mixed{t, 0, 1 - t};
            const std::array<double, 3> exact{std::clamp(4 * t - 2, 0., 1.),
                                              std::clamp(2 - std::abs(4 * t - 2), 0., 1.),
                                              std::clamp(2 - 4 * t, 0., 1.)};
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(static_cast<double>(picture.at(x, 50)[k]), (after ? exact : mixed)[k], 1e-5) << x;
        }
    }
}

TEST(NormalsInBytes, TiltByHalfAStepUnlessTheyAreFloats) {
    for (const auto& [format, step] :
         {std::pair("RGBA8", 1 / 255.), std::pair("RGBA16F", 0.), std::pair("RGBA32F", 0.)}) {
        Files files = shaded("2. * texture(uTex, vST.st).rgb - 1.", "uniform sampler2D uTex;\n");
        files["encode.frag"] =
            "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(.5 * vec3(0., 0., 1.) + .5, "
            "1.); "
            "}\n";
        const FloatPicture picture = draw(
            fmt::format(
                "WindowSize 4 4\nTexture2D 7 4 4 {}\nBackground 0\nOrtho -1 1 -1 1\nLookAt 0 0 5 0 0 0 0 "
                "1 0\nRenderToTexture 7\nVertex v.vert\nFragment encode.frag\nProgram E\nQuadXY 0 1\n"
                "RenderToTexture\nFragment f.frag\nProgram P uTex 7\nQuadXY 0 1\n",
                format),
            files);
        ASSERT_EQ(picture.width, 4);
        for (int i = 0; i < 16; ++i) {
            const auto n = picture.at(i % 4, i / 4);
            // One half lies in the middle between two bytes.
            EXPECT_NEAR(std::abs(static_cast<double>(n[0])), step, 1e-6) << format;
            EXPECT_NEAR(std::abs(static_cast<double>(n[1])), step, 1e-6) << format;
            EXPECT_EQ(n[2], 1.F) << format;
        }
    }
}

TEST(HeightFields, ComeCloserWithTheSquareOfTheGrid) {
    const Files files{
        {"v.vert",
         "#version 330 core\nout vec2 vXY;\nout float vHeight;\n"
         "void main() { vXY = aVertex.xy; vHeight = sin(3. * vXY.x) * cos(2. * vXY.y); gl_Position = "
         "uModelViewProjectionMatrix * aVertex; }\n"},
        {"f.frag",
         "#version 330 core\nin vec2 vXY;\nin float vHeight;\nout vec4 fColor;\nvoid main() {\n"
         "  fColor = vec4(vHeight - sin(3. * vXY.x) * cos(2. * vXY.y), 1., 0., 1.);\n}\n"}};
    std::vector<double> errors;
    for (const int cells : {8, 16, 32, 64}) {
        const FloatPicture picture =
            draw(fmt::format("WindowSize 256 256\n{}Program P\nQuadXY 0 1 {} {}\n", kFlatView, cells, cells),
                 files);
        ASSERT_EQ(picture.sum(1), 256 * 256);
        double squares = 0;
        double most = 0;
        for (std::size_t i = 0; i < picture.values.size(); i += 3) {
            const auto off = static_cast<double>(picture.values[i]);
            squares += off * off;
            most = std::max(most, std::abs(off));
        }
        // The distance of a chord from its curve is 1/8 of the second derivative times its length squared.
        const double cell = 2. / cells;
        EXPECT_LT(most, cell * cell / 8 * (9 + 2 * 6 + 4)) << cells;
        errors.push_back(std::sqrt(squares / (256 * 256)));
    }
    for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(errors[i - 1] / errors[i], 4, .25) << i;
}

TEST(ClipPlanes, CutTheSameWhateverTheirLength) {
    constexpr int kSide = 128;
    const Files files{{"v.vert",
                       "#version 330 core\nuniform float uLength;\nvoid main() {\n"
                       "  gl_ClipDistance[0] = uLength * dot(vec4(.3, .7, .1, -.05), aVertex);\n"
                       "  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
                      {"f.frag", addingFragment("1., 0., 0.")}};
    for (const double length : {1., 64., 0x1p-20, 100., 1e-3, 1e6}) {
        const FloatPicture picture =
            draw(fmt::format("WindowSize {0} {0}\n{1}Program P uLength {2}\nQuadXY 0 .8 3 3\n", kSide,
                             kFlatView, number(length)),
                 files);
        ASSERT_EQ(picture.width, kSide);
        std::size_t wrong = 0;
        for (int row = 0; row < kSide; ++row)
            for (int column = 0; column < kSide; ++column) {
                const double x = 2 * (column + .5) / kSide - 1;
                const double y = 1 - 2 * (row + .5) / kSide;
                const double plane = .3 * x + .7 * y - .05;
                if (std::abs(plane) < 1e-4) continue;
                const bool isIn = plane > 0 && std::abs(x) < .8 && std::abs(y) < .8;
                wrong += picture.at(column, row)[0] == (isIn ? 1.F : 0.F) ? 0 : 1;
            }
        EXPECT_EQ(wrong, 0U) << length;
    }
}

TEST(DiscardedFragments, LeaveWhatGeometryWouldHaveLeft) {
    // A red sheet in front of a green one. 20 of its 64 columns are kept.
    const std::string behind = "Fragment green.frag\nProgram G\nQuadXY 0 1\n";
    const auto drawn = [&](const std::string& fragment, const std::string& sheet) {
        return draw(
            "WindowSize 64 64\n" + kFlatView + "Program P\n" + sheet + behind,
            {{"v.vert",
              "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
             {"f.frag", "#version 330 core\nout vec4 fColor;\nvoid main() { " + fragment + " }\n"},
             {"green.frag",
              "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(0., 1., 0., 1.); }\n"}});
    };
    const std::string whole = "QuadXY .5 1\n";
    const FloatPicture discarded =
        drawn("if (gl_FragCoord.x > 20.) discard; fColor = vec4(1., 0., 0., 1.);", whole);
    const FloatPicture cut =
        drawn("fColor = vec4(1., 0., 0., 1.);",
              "PushMatrix\nTranslate -.6875 0 0\nScale .3125 1 1\n" + whole + "PopMatrix\n");
    EXPECT_EQ(discarded.sum(0), 20 * 64);
    EXPECT_EQ(discarded.sum(1), 44 * 64);
    EXPECT_EQ(discarded.values, cut.values);
    // A transparent sheet, in contrast, hides the sheet behind it.
    const FloatPicture clear = drawn("fColor = vec4(1., 0., 0., gl_FragCoord.x > 20. ? 0. : 1.);", whole);
    EXPECT_EQ(clear.sum(1), 0);
}

}  // namespace
}  // namespace glibra::stress
