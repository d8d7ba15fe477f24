#include "view/debug_view/debug_program.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::DebugView;
using view::Session;

const std::string kPlainFragment =
    "#version 330\nin vec4 vST; out vec4 c;\nvoid main() { c = vec4(vST.st, 1., 1.); }\n";
const std::map<std::string, std::string> kPlain{{"a.vert", kPlainVertex}, {"a.frag", kPlainFragment}};

/// The numbers of a pixel; x and y count from the lower left.
std::array<float, 4> numbersAt(const Session& session, int x, int y) {
    const view::TexelImage& image = session.debugNumbers();
    if (x >= image.width || y >= image.height) return {-1, -1, -1, -1};
    const float* texel =
        image.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(x));
    return {texel[0], texel[1], texel[2], texel[3]};
}

void openView(Session& session, const SceneFolder& folder, DebugView kind) {
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.look().setDebugView(kind);
    ASSERT_TRUE(session.drawIfNeeded());
    ASSERT_TRUE(session.diagnostics().empty()) << text(session.diagnostics());
}

TEST(DebugView, OverdrawCountsFragmentsThatPassAndLayersAllOfThem) {
    // Four quads: the third is behind the others, and the last covers only the right half.
    const std::string quads = "QuadXY -.5 .8\nQuadXY -.2 .8\nQuadXY -.4 .8\nTranslate .5 0 .1\nQuadXY 0 .3\n";
    for (const std::string& program : {std::string(), kProgram}) {
        std::string scene = kHead;
        scene.append(program).append(quads);
        const SceneFolder folder(scene, kPlain);
        Session session(context(), {});
        openView(session, folder, DebugView::overdraw);
        EXPECT_EQ(numbersAt(session, 10, 20)[0], 2) << program;
        EXPECT_EQ(numbersAt(session, 30, 20)[0], 3) << program;
        EXPECT_EQ(numbersAt(session, 1, 1)[3], 0) << program;
        const auto two = view::colorOfCount(2);
        EXPECT_EQ(pixelOf(session, 10, 20), (std::array<int, 3>{two[0], two[1], two[2]}));
        session.look().setDebugView(DebugView::layers);
        session.drawIfNeeded();
        EXPECT_EQ(numbersAt(session, 10, 20)[0], 3) << program;
        EXPECT_EQ(numbersAt(session, 30, 20)[0], 4) << program;
        const view::ValueRange range = view::rangeOf(DebugView::layers, session.debugNumbers());
        EXPECT_EQ(range.lowest, 3);
        EXPECT_EQ(range.highest, 4);
    }
}

TEST(DebugView, OverdrawLeavesOutWhatTheFragmentStageDiscards) {
    const SceneFolder folder(
        kHead + kProgram + "QuadXY 0 1\nQuadXY .5 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nin vec4 vST; out vec4 c;\nvoid main() { if (vST.s < .5) discard; c = vST; }\n"}});
    Session session(context(), {});
    openView(session, folder, DebugView::layers);
    EXPECT_EQ(numbersAt(session, 5, 20)[3], 0);
    EXPECT_EQ(numbersAt(session, 35, 20)[0], 2);
}

TEST(DebugView, OverdrawCountsMeshesFromBuffers) {
    // The left half from two triangles with common corners, the lower half from a strip, both from one mesh.
    const SceneFolder folder(R"(WindowSize 40 40
Vertex inline
#version 410 core
in vec2 place;
void main() { gl_Position = vec4(place, 0, 1); }
EndVertex
Fragment inline
#version 410 core
out vec4 c;
void main() { c = vec4(1); }
EndFragment
Program P
Buffer left vec2 [-1 -1  0 -1  -1 1  0 1]
Buffer lower vec2 [-1 -1  1 -1  -1 0  1 0]
Buffer two uint [0 1 2  2 1 3]
Buffer strip uint [2 0 3 1 4294967295 3]
Attribute place left
Vertices triangles 6 indices two
Attribute place lower
Vertices triangle_strip 6 indices strip
)");
    Session session(context(), {});
    openView(session, folder, DebugView::layers);
    EXPECT_EQ(numbersAt(session, 10, 10)[0], 2);
    EXPECT_EQ(numbersAt(session, 10, 30)[0], 1);
    EXPECT_EQ(numbersAt(session, 30, 10)[0], 1);
    EXPECT_EQ(numbersAt(session, 30, 30)[3], 0);
}

TEST(DebugView, FacingShowsTheBackOfATurnedQuad) {
    const SceneFolder folder(kHead + kProgram +
                                 "PushMatrix\nTranslate -.5 0 0\nQuadXY 0 .4\nPopMatrix\nTranslate .5 0 0\n"
                                 "Rotate 180 0 1 0\nQuadXY 0 .4\n",
                             kPlain);
    Session session(context(), {});
    openView(session, folder, DebugView::facing);
    EXPECT_EQ(numbersAt(session, 10, 20), (std::array<float, 4>{1, 0, 0, 1}));
    EXPECT_EQ(numbersAt(session, 30, 20), (std::array<float, 4>{0, 0, 0, 1}));
    EXPECT_EQ(view::wordsOf(DebugView::facing, numbersAt(session, 30, 20).data()), "back");
    EXPECT_NE(pixelOf(session, 10, 20), pixelOf(session, 30, 20));
}

TEST(DebugView, FacingIncludesWhatAVertexStageTurns) {
    const SceneFolder folder(kHead + kProgram + "QuadXY 0 .4\n",
                             {{"a.vert",
                               "#version 330\nout vec4 vST;\nvoid main() { vST = aTexCoord0;\nvec4 p = "
                               "aVertex; p.x = -p.x;\n"
                               "gl_Position = uModelViewProjectionMatrix * p; }\n"},
                              {"a.frag", kPlainFragment}});
    Session session(context(), {});
    openView(session, folder, DebugView::facing);
    EXPECT_EQ(numbersAt(session, 20, 20)[0], 0);
}

TEST(DebugView, DepthIsTheWindowsAndTheDistanceFromTheEye) {
    const SceneFolder folder(
        "WindowSize 40 40\nPerspective 90 1 11\nLookAt 0 0 5 0 0 0 0 1 0\n" + kProgram + "QuadXY 0 1\n",
        kPlain);
    Session session(context(), {});
    openView(session, folder, DebugView::depth);
    // A plane at distance d between planes n and f has depth f (d - n) / (d (f - n)).
    const auto [depth, distance, blue, alpha] = numbersAt(session, 20, 20);
    EXPECT_NEAR(depth, 11 * (5 - 1.) / (5 * (11 - 1.)), 1e-6);
    EXPECT_NEAR(distance, 5, 1e-4);
    EXPECT_EQ(alpha, 1);
    EXPECT_EQ(numbersAt(session, 1, 1)[3], 0);
}

TEST(DebugView, DepthIsReversedAsInThePass) {
    const SceneFolder folder(
        "WindowSize 40 40\nCamera eye LookAt 0 0 0  0 0 -1  0 1 0  Perspective 90 .01 1e6\n" + kProgram +
            "Pass window reversed\nTranslate 0 0 -90000\nQuadXY 0 20000\nEndPass\n",
        kPlain);
    Session session(context(), {});
    openView(session, folder, DebugView::depth);
    const auto [depth, distance, blue, alpha] = numbersAt(session, 20, 20);
    EXPECT_NEAR(depth, .01 / 90000 - .01 / 1e6, 1e-12);
    EXPECT_NEAR(distance, 90000, 1);
    EXPECT_EQ(numbersAt(session, 1, 1)[3], 0);
}

TEST(DebugView, DepthIsWhatAFragmentStageWrites) {
    const SceneFolder folder(
        kHead + kProgram + "QuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); if (gl_FragCoord.x > 20.) gl_FragDepth = "
          ".125; }\n"}});
    Session session(context(), {});
    openView(session, folder, DebugView::depth);
    EXPECT_NEAR(numbersAt(session, 30, 20)[0], .125F, 1e-6F);
    EXPECT_NEAR(numbersAt(session, 10, 20)[0], .5F, 1e-6F);
}

TEST(DebugView, CoordinatesAreThoseOfTheMeshAlsoWhereNoStageReadsThem) {
    const std::map<std::string, std::string> files{
        {"a.vert", "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
        {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"}};
    for (const std::string& program : {std::string(), kProgram}) {
        const SceneFolder folder(kHead + program + "QuadXY 0 1\n", files);
        Session session(context(), {});
        openView(session, folder, DebugView::coordinates);
        const auto [s, t, p, alpha] = numbersAt(session, 10, 30);
        EXPECT_NEAR(s, 10.5 / 40, 1e-5) << program;
        EXPECT_NEAR(t, 30.5 / 40, 1e-5) << program;
        EXPECT_EQ(alpha, 1);
        EXPECT_NEAR(pixelOf(session, 10, 9)[0], 255 * 10.5 / 40, 1);
    }
}

const char* const kControl =
    "#version 400\nlayout(vertices = 4) out;\nvoid main() { gl_out[gl_InvocationID].gl_Position = "
    "gl_in[gl_InvocationID].gl_Position;\ngl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] "
    "= gl_TessLevelOuter[3] = 4.; gl_TessLevelInner[0] = gl_TessLevelInner[1] = 4.; }\n";
const char* const kPatch =
    "glBegin gl_patches\nglVertex -1. -1. 0.\nglVertex 1. -1. 0.\nglVertex 1. 1. 0.\nglVertex -1. 1. 0.\n"
    "glEnd\n";
const std::string kTessellated =
    "Vertex a.vert\nTessControl a.tcs\nTessEvaluation a.tes\nFragment a.frag\nProgram P\nNumPatchVertices "
    "4\n";
/// A tessellated square, moved towards the eye by .25.
const std::map<std::string, std::string> kMoved{
    {"a.vert", "#version 330\nvoid main() { gl_Position = aVertex; }\n"},
    {"a.tcs", kControl},
    {"a.tes",
     "#version 400\nlayout(quads, equal_spacing, ccw) in;\nout vec2 vST;\nvoid main() { vST = "
     "gl_TessCoord.xy;\n"
     "gl_Position = uModelViewProjectionMatrix * vec4(gl_TessCoord.xy * 2. - 1., .25, 1.); }\n"},
    {"a.frag", "#version 400\nin vec2 vST; out vec4 c;\nvoid main() { c = vec4(vST, 0., 1.); }\n"}};

TEST(DebugView, IncludesWhatATessellationStageMoves) {
    const SceneFolder folder(kHead + kTessellated + kPatch, kMoved);
    Session session(context(), {});
    openView(session, folder, DebugView::depth);
    EXPECT_NEAR(numbersAt(session, 11, 30)[0], .375F, 1e-6F);
    session.look().setDebugView(DebugView::coordinates);
    session.drawIfNeeded();
    EXPECT_NEAR(numbersAt(session, 11, 30)[0], 11.5 / 40, 1e-5);
    EXPECT_NEAR(numbersAt(session, 11, 30)[1], 30.5 / 40, 1e-5);
    session.look().setDebugView(DebugView::overdraw);
    session.drawIfNeeded();
    EXPECT_EQ(numbersAt(session, 11, 30)[0], 1);
}

TEST(DebugView, WarnsOfWhatItCannotShow) {
    auto files = kMoved;
    files["a.tes"] =
        "#version 400\nlayout(quads) in;\nout vec2 vOther;\nvoid main() { vOther = gl_TessCoord.xy;\n"
        "gl_Position = vec4(gl_TessCoord.xy, 0., 1.); }\n";
    files["a.frag"] =
        "#version 400\nin vec2 vOther; out vec4 c;\nvoid main() { c = vec4(vOther, 0., 1.); }\n";
    const SceneFolder folder(kHead + kTessellated + kPatch, files);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.look().setDebugView(DebugView::coordinates);
    session.drawIfNeeded();
    ASSERT_EQ(session.diagnostics().size(), 1U) << text(session.diagnostics());
    EXPECT_EQ(session.diagnostics()[0].id, "view-W01");
    EXPECT_EQ(session.diagnostics()[0].place.line, 14);
}

struct Seen {
    int pixels = 0;
    int highest = -1;  ///< row of the highest one, counted from below
};
/// The pixels whose colour satisfies `isMeant`.
template <class Test>
Seen seen(const Session& session, Test isMeant) {
    Seen found;
    const std::vector<std::byte> all = pixelsOf(session);
    const int rowBytes = 3 * session.look().width();
    for (int i = 0; i + 2 < static_cast<int>(all.size()); i += 3) {
        const auto at = static_cast<std::size_t>(i);
        if (!isMeant(std::to_integer<int>(all[at]), std::to_integer<int>(all[at + 1]),
                     std::to_integer<int>(all[at + 2])))
            continue;
        ++found.pixels;
        found.highest = std::max(found.highest, session.look().height() - 1 - i / rowBytes);
    }
    return found;
}
const auto kYellow = [](int red, int green, int blue) { return red > 150 && green > 120 && blue < 120; };
const auto kCyan = [](int red, int green, int blue) { return red < 120 && green > 150 && blue > 150; };

TEST(DebugView, LinesOfNormalsEndWhereTheMatricesPutThem) {
    // A quad seen on its edge: its normals, along y, reach .4 of half the picture's height above it.
    const SceneFolder folder("WindowSize 200 200\nOrtho -1 1 -1 1 -1 1\nColor 0 0 0\nQuadXZ 0 .5\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.look().setDebugView(DebugView::normals);
    session.look().setNormalLength(.4);
    session.drawIfNeeded();
    const Seen lines = seen(session, kYellow);
    EXPECT_GE(lines.pixels, 2 * 40) << "at least at the corners";
    EXPECT_NEAR(lines.highest, 100 + .4 * 100, 1.5);
}

TEST(DebugView, NormalsOfMovedVerticesAreThoseOfTheTrianglesTheyMake) {
    // The quad faces z; the vertex stage turns it to face y. Only the triangles show that.
    const SceneFolder folder(
        "WindowSize 200 200\nOrtho -1 1 -1 1 -1 1\n" + kProgram + "QuadXY .1 .5\n",
        {{"a.vert",
          "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * vec4(aVertex.x, 0., "
          "-aVertex.y, 1.); }\n"},
         {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(0., 0., 0., 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.look().setDebugView(DebugView::normals);
    session.look().setNormalLength(.4);
    session.drawIfNeeded();
    EXPECT_EQ(seen(session, kYellow).pixels, 0);
    EXPECT_NEAR(seen(session, kCyan).highest, 100 + .4 * 100, 1.5);
}

TEST(DebugView, SurfacesBehindAGeometryStageShowWhereTheyFace) {
    const SceneFolder folder(
        kHead + "Vertex a.vert\nGeometry a.geom\nFragment a.frag\nProgram P\nQuadXY 0 1\n",
        {{"a.vert", "#version 330\nvoid main() { gl_Position = aVertex; }\n"},
         {"a.geom",
          "#version 330\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nvoid main() { "
          "for (int i = 0; i < 3; ++i) { gl_Position = uModelViewProjectionMatrix * gl_in[i].gl_Position; "
          "EmitVertex(); } }\n"},
         {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"}});
    Session session(context(), {});
    openView(session, folder, DebugView::normals);
    EXPECT_NEAR(pixelOf(session, 20, 20)[0], 128, 1);
    EXPECT_NEAR(pixelOf(session, 20, 20)[1], 128, 1);
    EXPECT_EQ(pixelOf(session, 20, 20)[2], 255);
}

TEST(DebugView, LeavesThePictureUnchangedWhenItIsTurnedOff) {
    const SceneFolder folder(
        kHead + kProgram + "QuadXY 0 .5\nTranslate .2 .2 .2\nRotate 20 1 1 0\nQuadXY 0 .5\n", kPlain);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const std::vector<std::byte> before = pixelsOf(session);
    for (int i = 1; i < view::kDebugViewCount; ++i) {
        session.look().setDebugView(static_cast<DebugView>(i));
        ASSERT_TRUE(session.drawIfNeeded());
        EXPECT_FALSE(pixelsOf(session) == before) << i;
        session.pickAt(20, 20);
        EXPECT_TRUE(session.look().picked()) << i;
    }
    session.look().setDebugView(DebugView::picture);
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before);
    EXPECT_TRUE(session.diagnostics().empty()) << text(session.diagnostics());
}

TEST(DebugView, FollowsChangedValuesAndAReloadedScene) {
    const SceneFolder folder(
        kHead + "Vertex a.vert\nFragment a.frag\nProgram P uTurn <-1. 1. 1.> uMove <0 .0 1.>\nQuadXY 0 .4\n",
        {{"a.vert",
          "#version 330\nuniform float uTurn, uMove; out vec4 vST;\nvoid main() { vST = aTexCoord0;\nvec4 p "
          "= aVertex; p.x "
          "*= "
          "uTurn; p.z += uMove;\ngl_Position = uModelViewProjectionMatrix * p; }\n"},
         {"a.frag", kPlainFragment}});
    Session session(context(), {});
    openView(session, folder, DebugView::facing);
    EXPECT_EQ(numbersAt(session, 20, 20)[0], 1);
    session.values().set(knobIndex(session, "uTurn"), {-1});
    session.drawIfNeeded();
    EXPECT_EQ(numbersAt(session, 20, 20)[0], 0);
    session.look().setDebugView(DebugView::depth);
    session.values().set(knobIndex(session, "uMove"), {.5});
    session.drawIfNeeded();
    EXPECT_NEAR(numbersAt(session, 20, 20)[0], .25F, 1e-6F);
    folder.write("scene.glib", kHead + "QuadXY .8 .4\n");
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    EXPECT_NEAR(numbersAt(session, 20, 20)[0], .1F, 1e-6F);
}

}  // namespace
}  // namespace glibra::test
