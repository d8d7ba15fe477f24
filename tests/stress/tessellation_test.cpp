// Tessellation levels at and beyond the edges of their range, and cracks between patches (exercises' accuracy
// table 22, 23, 25; NM13). Vertices are counted: in point mode each one is a point that adds 1 to a pixel.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "support.h"

namespace glibra::stress {
namespace {

enum class Spacing { equal, even, odd };

const char* word(Spacing spacing) {
    return spacing == Spacing::equal  ? "equal_spacing"
           : spacing == Spacing::even ? "fractional_even_spacing"
                                      : "fractional_odd_spacing";
}

/// The number of segments of an edge with this positive level, for a maximum of 64 (GL 4.6, 11.2.2).
int segments(double level, Spacing spacing) {
    if (spacing == Spacing::equal) return static_cast<int>(std::ceil(std::clamp(level, 1., 64.)));
    if (spacing == Spacing::even) return 2 * static_cast<int>(std::ceil(std::clamp(level, 2., 64.) / 2));
    return 2 * static_cast<int>(std::ceil((std::clamp(level, 1., 63.) - 1) / 2)) + 1;
}

/// The number of distinct vertices of a subdivided quad with `outer` and `inner` segments.
int quadVertices(int outer, int inner, Spacing spacing) {
    if (outer == 1 && inner == 1) return 4;
    // An inside of one segment counts as slightly more than one.
    if (inner == 1) inner = spacing == Spacing::odd ? 3 : 2;
    return 4 * outer + (inner - 1) * (inner - 1);
}
int triangleVertices(int outer, int inner, Spacing spacing) {
    if (outer == 1 && inner == 1) return 3;
    if (inner == 1) inner = spacing == Spacing::odd ? 3 : 2;
    int vertices = 3 * outer;
    for (int ring = inner - 2; ring >= 0; ring -= 2) vertices += ring == 0 ? 1 : 3 * ring;
    return vertices;
}

/// The number of points of one tessellated patch. Levels are passed as bits, since scenes cannot write NaN.
double pointsOf(const std::string& domain, Spacing spacing, float outer, float inner) {
    const std::string scene = fmt::format(
        "WindowSize 64 64\nBackground 0\nVertex v.vert\nTessControl c.tesc\nTessEvaluation e.tese\nFragment "
        "f.frag\n"
        "Program P uOuter {} uInner {}\nNumPatchVertices 1\nglBegin patches\nglVertex 0 0 0\nglEnd\n",
        std::bit_cast<std::int32_t>(outer), std::bit_cast<std::int32_t>(inner));
    const Files files{
        {"v.vert", "#version 400 core\nvoid main() { gl_Position = aVertex; }\n"},
        {"c.tesc",
         "#version 400 core\nlayout(vertices = 1) out;\nuniform int uOuter;\nuniform int uInner;\nvoid "
         "main() {\n"
         "  for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = intBitsToFloat(uOuter);\n"
         "  for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = intBitsToFloat(uInner);\n}\n"},
        {"e.tese", fmt::format("#version 400 core\nlayout({}, {}, point_mode) in;\n"
                               "void main() {{ gl_Position = vec4(1.8 * gl_TessCoord.xy - .9, 0., 1.); }}\n",
                               domain, word(spacing))},
        {"f.frag", addingFragment("1., 0., 0.")}};
    const FloatPicture picture = draw(scene, files);
    EXPECT_EQ(picture.nonFinite(), 0U);
    return picture.sum(0);
}

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(TessellationLevels, ThatAreNaNOrNotPositiveOutsideDiscardThePatch) {
    for (const Spacing spacing : {Spacing::equal, Spacing::even, Spacing::odd})
        for (const char* domain : {"quads", "triangles", "isolines"})
            for (const float level : {kNaN, -kNaN, 0.F, -0.F, -1.F, -kInfinite})
                EXPECT_EQ(pointsOf(domain, spacing, level, 3), 0)
                    << domain << " " << word(spacing) << " " << level;
}

TEST(TessellationLevels, AreRoundedAndLimitedByTheRules) {
    for (const Spacing spacing : {Spacing::equal, Spacing::even, Spacing::odd})
        for (const float level : {1e-30F, .5F, 1.F, 1.0001F, 1.01F, 2.F, 2.5F, 3.F, 7.F, 62.5F, 63.F, 63.9F,
                                  64.F, 64.5F, 1e9F, kInfinite}) {
            const int n = segments(static_cast<double>(level), spacing);
            const std::string what = fmt::format("{} {}", word(spacing), level);
            EXPECT_EQ(pointsOf("quads", spacing, level, level), quadVertices(n, n, spacing)) << what;
            EXPECT_EQ(pointsOf("triangles", spacing, level, level), triangleVertices(n, n, spacing)) << what;
            // Isolines are always equally spaced.
            EXPECT_EQ(pointsOf("isolines", spacing, level, level),
                      segments(static_cast<double>(level), Spacing::equal) * (n + 1))
                << what;
        }
}

TEST(TessellationLevels, OfTheInsideAloneAreLimitedToo) {
    for (const Spacing spacing : {Spacing::equal, Spacing::even, Spacing::odd})
        for (const float level : {kNaN, 0.F, -5.F, 1.F, 1.0001F, 64.5F, 1e9F}) {
            const int outer = segments(3, spacing);
            const int inner = segments(std::isnan(level) ? 1 : static_cast<double>(level), spacing);
            EXPECT_EQ(pointsOf("quads", spacing, 3, level), quadVertices(outer, inner, spacing))
                << word(spacing) << " " << level;
            EXPECT_EQ(pointsOf("triangles", spacing, 3, level), triangleVertices(outer, inner, spacing))
                << word(spacing) << " " << level;
        }
}

/// 64 x 64 cells. In cell (a, b) a patch of level a and one of level b share a curved edge, which has the
/// larger of the two levels. Front faces add 1 and back faces subtract 1. In a sheet without cracks or
/// overlaps every pixel ends at exactly 1, folded or not, since the boundary winds around it once.
FloatPicture pairsOfLevels(Spacing spacing, bool opposed) {
    std::string scene =
        "WindowSize 1024 1024\nBackground 0\nVertex v.vert\nTessControl c.tesc\nTessEvaluation "
        "e.tese\nFragment "
        "f.frag\nProgram P\nNumPatchVertices 1\nglBegin patches\n";
    for (int a = 1; a <= 64; ++a)
        for (int b = 1; b <= 64; ++b)
            scene += fmt::format("glVertex {} {} 0\nglVertex {} {} 1\n", a, b, a, b);
    scene += "glEnd\n";
    const Files files{
        {"v.vert", "#version 400 core\nvoid main() { gl_Position = aVertex; }\n"},
        {"c.tesc",
         "#version 400 core\nlayout(vertices = 1) out;\nvoid main() {\n  vec4 p = gl_in[0].gl_Position;\n"
         "  gl_out[gl_InvocationID].gl_Position = p;\n  float own = p.z == 0. ? p.x : p.y;\n"
         "  for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = own;\n"
         // The inner level does not affect the edge; a low one makes the picture cheap.
         "  gl_TessLevelInner[0] = gl_TessLevelInner[1] = min(own, 6.);\n"
         // Edge 2 is u = 1, edge 0 is u = 0.
         "  gl_TessLevelOuter[p.z == 0. || " +
             std::string(opposed ? "true" : "false") + " ? 2 : 0] = max(p.x, p.y);\n}\n"},
        {"e.tese", fmt::format("#version 400 core\nlayout(quads, {}, ccw) in;\nvoid main() {{\n  vec4 p = "
                               "gl_in[0].gl_Position;\n"
                               "  float u = gl_TessCoord.x;\n  float v = gl_TessCoord.y;\n"
                               "  if ({} && p.z == 1.) {{ u = 1. - u; v = 1. - v; }}\n"
                               "  float edge = .5 + .3 * sin(9. * v + p.x) * v * (1. - v);\n"
                               "  vec2 place = vec2(p.z == 0. ? mix(0., edge, u) : mix(edge, 1., u), v);\n"
                               "  gl_Position = vec4((p.xy - 1. + place) / 32. - 1., 0., 1.);\n}}\n",
                               word(spacing), opposed ? "true" : "false")},
        {"f.frag", addingFragment("gl_FrontFacing ? 1. : -1., 1., 0.")}};
    return draw(scene, files);
}

TEST(TessellatedEdges, HaveNoCracksForAnyPairOfLevels) {
    for (const Spacing spacing : {Spacing::equal, Spacing::even, Spacing::odd})
        for (const bool opposed : {false, true}) {
            const FloatPicture picture = pairsOfLevels(spacing, opposed);
            ASSERT_EQ(picture.width, 1024);
            const std::size_t uncovered = picture.count([](const auto& rgb) { return rgb[1] == 0; });
            const std::size_t notOnce = picture.count([](const auto& rgb) { return rgb[0] != 1; });
            EXPECT_EQ(uncovered, 0U) << word(spacing) << (opposed ? " opposed" : "");
            EXPECT_EQ(notOnce, 0U) << word(spacing) << (opposed ? " opposed" : "");
        }
}

TEST(TessellatedEdges, OfAClosedMeshStayClosedHoweverManyVerticesItBecomes) {
    // 7,080 patches of 331 vertices are 36 times as many vertices as 16 bits can number. Front and back faces
    // cover each pixel equally often, as in any closed mesh.
    const Files files{{"v.vert", "#version 400 core\nvoid main() { gl_Position = aVertex; }\n"},
                      {"c.tesc",
                       "#version 400 core\nlayout(vertices = 3) out;\nuniform float uLevel;\nvoid main() {\n"
                       "  gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
                       "  for (int i = 0; i < 3; ++i) gl_TessLevelOuter[i] = uLevel;\n  gl_TessLevelInner[0] "
                       "= uLevel;\n}\n"},
                      {"e.tese",
                       "#version 400 core\nlayout(triangles) in;\nvoid main() {\n  vec4 p = gl_TessCoord.x * "
                       "gl_in[0].gl_Position "
                       "+ gl_TessCoord.y * gl_in[1].gl_Position\n + gl_TessCoord.z * gl_in[2].gl_Position;\n"
                       "  gl_Position = uModelViewProjectionMatrix * p;\n}\n"},
                      {"f.frag", addingFragment("gl_FrontFacing ? 1. : 0., gl_FrontFacing ? 0. : 1., 0.")}};
    const FloatPicture picture = draw(
        "WindowSize 400 400\nBackground 0\nPerspective 45\nLookAt 1 2 3 0 0 0 0 1 0\nVertex "
        "v.vert\nTessControl "
        "c.tesc\nTessEvaluation e.tese\nFragment f.frag\nProgram P uLevel 20.\nSphere 1 60 60\n",
        files);
    // The two sides of an edge add in a different order, so a few pixels may be missed.
    const std::size_t covered = picture.count([](const auto& rgb) { return rgb[0] == 1 && rgb[1] == 1; });
    const std::size_t other = picture.count([](const auto& rgb) { return rgb[0] != rgb[1] || rgb[0] > 1; });
    EXPECT_LT(other, 20U);
    // The outline of the sphere is a circle.
    const double radius =
        200 * std::tan(std::asin(1 / std::sqrt(14.))) / std::tan(22.5 * 3.14159265358979 / 180);
    EXPECT_NEAR(static_cast<double>(covered), 3.14159265358979 * radius * radius,
                .005 * static_cast<double>(covered));
}

/// Quads whose tessellation stages read the patch's number. Red counts points; green adds the mean of the
/// numbers in the two stages.
FloatPicture numberedPatches(int patches, int level, bool translated = true) {
    std::string scene =
        "WindowSize 64 64\nBackground 0\nVertex v.vert\nTessControl c.tesc\nTessEvaluation e.tese\nFragment "
        "f.frag\n" +
        fmt::format("Program P uLevel {}\nNumPatchVertices 1\nglBegin patches\n", level);
    for (int i = 0; i < patches; ++i) scene += "glVertex 0 0 0\n";
    const Files files{
        {"v.vert", "#version 400 core\nin vec4 aVertex;\nvoid main() { gl_Position = aVertex; }\n"},
        {"c.tesc",
         "#version 400 core\nlayout(vertices = 1) out;\nuniform float uLevel;\nout float tcNumber[];\nvoid "
         "main() {\n  for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uLevel;\n"
         "  gl_TessLevelInner[0] = gl_TessLevelInner[1] = uLevel;\n"
         "  tcNumber[gl_InvocationID] = float(gl_PrimitiveID);\n}\n"},
        {"e.tese",
         "#version 400 core\nlayout(quads, point_mode) in;\nin float tcNumber[];\nflat out float vNumber;\n"
         "void main() {\n  vNumber = .5 * (float(gl_PrimitiveID) + tcNumber[0]);\n"
         "  gl_Position = vec4(1.8 * gl_TessCoord.xy - .9, 0., 1.);\n}\n"},
        {"f.frag", addingFragment("1., vNumber, 0.", "flat in float vNumber;\n")}};
    RenderOptions options;
    options.shim = translated;
    return draw(scene + "glEnd\n", files, options);
}

TEST(TessellatedPatches, HaveTheirNumberWithinTheWholeDraw) {
    // 100 patches have 400 vertices at level 1 and 422,500 at level 64: more than llvmpipe processes at once.
    for (const int level : {1, 64})
        for (const int patches : {1, 15, 16, 100}) {
            const FloatPicture picture = numberedPatches(patches, level);
            const double points = (level + 1.) * (level + 1);
            EXPECT_EQ(picture.sum(0), points * patches) << level << " " << patches;
            EXPECT_EQ(picture.sum(1), points * patches * (patches - 1) / 2) << level << " " << patches;
        }
}

TEST(TessellatedPatches, DrawnInPartsAreThoseOfOneDraw) {
    // Shaders that are not translated get all patches in one draw.
    EXPECT_EQ(numberedPatches(60, 8).values, numberedPatches(60, 8, false).values);
}

TEST(TessellatedEdges, OfUnequalLevelsDoCrack) {
    // With different levels on both sides of the shared edge, the same picture must show cracks.
    const std::string scene =
        "WindowSize 256 256\nBackground 0\nVertex v.vert\nTessControl c.tesc\nTessEvaluation "
        "e.tese\nFragment f.frag\n"
        "Program P\nNumPatchVertices 1\nglBegin patches\nglVertex 3 8 0\nglVertex 3 8 1\nglEnd\n";
    const Files files{
        {"v.vert", "#version 400 core\nvoid main() { gl_Position = aVertex; }\n"},
        {"c.tesc",
         "#version 400 core\nlayout(vertices = 1) out;\nvoid main() {\n  vec4 p = gl_in[0].gl_Position;\n"
         "  gl_out[gl_InvocationID].gl_Position = p;\n  float own = p.z == 0. ? p.x : p.y;\n"
         "  for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = own;\n"
         "  gl_TessLevelInner[0] = gl_TessLevelInner[1] = own;\n}\n"},
        {"e.tese",
         "#version 400 core\nlayout(quads) in;\nvoid main() {\n  vec4 p = gl_in[0].gl_Position;\n"
         "  float u = gl_TessCoord.x;\n  float v = gl_TessCoord.y;\n  float edge = .5 + .3 * sin(9. * v) * v "
         "* (1. - v);\n"
         "  gl_Position = vec4(2. * vec2(p.z == 0. ? mix(0., edge, u) : mix(edge, 1., u), v) - 1., 0., "
         "1.);\n}\n"},
        {"f.frag", addingFragment("1., 0., 0.")}};
    const FloatPicture picture = draw(scene, files);
    EXPECT_GT(picture.count([](const auto& rgb) { return rgb[0] != 1; }), 20U);
}

}  // namespace
}  // namespace glibra::stress
