// What a window does not draw again from frame to frame, and what its textures share: every picture has the
// bytes of a window that is opened anew.

#include <algorithm>

#include "render/check/object_content.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

/// The box stands in the light, whose depth map the floor shows. uShade changes the floor only, `size` the
/// box.
const std::string kShadow = R"(WindowSize 48 32
Let size <.2 .5 1>
Camera eye LookAt 0 2 3  0 0 0  0 1 0  Perspective 50 .1 20
Camera light LookAt 0 3 0  0 0 0  0 0 -1  Ortho -2 2 -2 2 .1 10
Texture2D map 32 32 depth32f nearest
Texture2D seen 32 32 rgba8 nearest
Vertex inline
#version 330
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
EndVertex
Fragment inline
#version 330
uniform sampler2D uMap, uSeen;
uniform float uShade;
out vec4 c;
void main() { c = vec4(texture(uMap, gl_FragCoord.xy / 48.).r * uShade, texture(uSeen, gl_FragCoord.xy / 48.).rg, 1.); }
EndFragment
Program Floor uMap map uSeen seen uShade <0 .5 1>
Fragment inline
#version 330
out vec4 c;
void main() { c = vec4(1., fract(gl_FragCoord.x / 8.), 0., 1.); }
EndFragment
Program Plain
Pass map from light
    Box (size)
EndPass
Pass seen from eye clear {0 0 0}
    Box (size)
EndPass
Pass window from eye clear {0 0 .3}
    Use Floor
    Box 3 .1 3
EndPass
)";

std::uint64_t counted(const render::Stats& stats, std::string_view name) {
    for (const auto& each : stats.counts)
        if (each.name == name) return each.value;
    return 0;
}

class KeptNodes : public testing::Test {
  protected:
    void open(const std::string& scene) {
        folder.emplace(scene);
        ASSERT_TRUE(session.open(folder->scene()));
        ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
        session.drawIfNeeded();
    }
    /// Draws a frame, compares it with that of a new window, and returns how many passes were not repeated.
    std::uint64_t passesKept() {
        const std::uint64_t before = counted(session.live().drawStats(), render::kStillPasses);
        EXPECT_TRUE(session.drawIfNeeded());
        Session fresh(context(), {});
        EXPECT_TRUE(fresh.open(folder->scene()));
        fresh.look().resize(session.look().width(), session.look().height());
        for (std::size_t i = 0; i < session.values().knobs().size(); ++i)
            fresh.values().set(i, session.values().knobs()[i].current);
        fresh.look().setView(session.look().view());
        fresh.clock().setState(session.clock().state());
        fresh.drawIfNeeded();
        EXPECT_TRUE(pixelsOf(session) == pixelsOf(fresh));
        return counted(session.live().drawStats(), render::kStillPasses) - before;
    }
    void set(std::string_view tag, double value) { session.values().set(knobIndex(session, tag), {value}); }

    std::optional<SceneFolder> folder;
    Session session{context(), {}};
};

TEST_F(KeptNodes, AColourThatMovesLeavesTheShadowMapAlone) {
    open(kShadow);
    for (const double shade : {.6, .7, .8}) {
        set("uShade", shade);
        EXPECT_EQ(passesKept(), 2U) << shade;
    }
}

TEST_F(KeptNodes, WhatASliderChangesIsDrawnAgain) {
    open(kShadow);
    set("size", .8);
    EXPECT_EQ(passesKept(), 0U);
    set("uShade", .2);
    set("size", .4);
    EXPECT_EQ(passesKept(), 0U) << "both at once";
    set("size", .6);
    set("size", .4);
    EXPECT_EQ(passesKept(), 2U) << "there and back before a frame";
}

TEST_F(KeptNodes, TheMouseMovesOnlyWhatIsSeenFromTheEye) {
    open(kShadow);
    session.look().drag(view::TransformMode::eye, {view::Gesture::rotate, {9, 4}, {48, 32}});
    EXPECT_EQ(passesKept(), 1U) << "the map of the light";
    session.look().drag(view::TransformMode::scene, {view::Gesture::pan, {3, 4}, {48, 32}});
    EXPECT_EQ(passesKept(), 1U);
    session.setNeedsFrame();
    EXPECT_EQ(passesKept(), 2U) << "the same view again";
    session.look().resetTransforms();
    EXPECT_EQ(passesKept(), 1U);
    session.pickAt(24, 20);
    ASSERT_TRUE(session.look().picked());
    session.look().drag(view::TransformMode::object, {view::Gesture::rotate, {9, 4}, {48, 32}});
    EXPECT_EQ(passesKept(), 0U) << "an object may cast a shadow";
    session.look().resize(60, 32);
    EXPECT_EQ(passesKept(), 0U);
}

TEST_F(KeptNodes, NothingIsKeptAfterFramesThatAreNotThePicture) {
    open(kShadow);
    session.look().setWireframe(true);
    session.drawIfNeeded();
    session.look().setWireframe(false);
    EXPECT_EQ(passesKept(), 0U);
    session.look().setDebugView(view::DebugView::depth);
    session.drawIfNeeded();
    session.look().setDebugView(view::DebugView::picture);
    EXPECT_EQ(passesKept(), 0U);
    session.setMeasuresObjects(true);
    session.drawIfNeeded();
    EXPECT_TRUE(session.objectMilliseconds());
    session.setMeasuresObjects(false);
    EXPECT_FALSE(session.objectMilliseconds());
    set("uShade", .9);
    EXPECT_EQ(passesKept(), 0U);
    set("uShade", .4);
    EXPECT_EQ(passesKept(), 2U);
    session.reload();
    EXPECT_EQ(passesKept(), 0U);
}

/// Three textures in a row; the third may lie where the first was.
const std::string kChain = R"(WindowSize 16 16
Texture2D a 8 8 rgba8 nearest
Texture2D b 8 8 rgba8 nearest
Texture2D c 8 8 rgba8 nearest
Fragment inline
#version 330
uniform sampler2D uFrom;
in vec2 vST;
out vec4 f;
void main() { f = vec4(texture(uFrom, vST).gbr, 1.); }
EndFragment
Program Next
Pass a clear {1 .5 .25}
    Sphere .001
EndPass
Fill b with Next uFrom a
Fill c with Next uFrom b
Fill window with Next uFrom c
)";

TEST_F(KeptNodes, TexturesShareMemoryUntilTheyAreLookedAt) {
    open(kChain);
    EXPECT_EQ(counted(session.live().loadStats(), "textures that share memory"), 1U);
    const auto red = [&](const std::string& name) {
        for (const scene::TextureIndex each : session.live().scene().textures.indices()) {
            if (session.live().scene().textures[each].name != name) continue;
            const auto content = render::contentOf(*session.live().texture(each), 0, std::nullopt);
            return content ? content->at(0)[0] : -1;
        }
        return -2.0;
    };
    session.keepTextures();
    session.setNeedsFrame();
    passesKept();
    EXPECT_NEAR(red("a"), 1, .01);
    EXPECT_NEAR(red("b"), .5, .01);
    EXPECT_NEAR(red("c"), .25, .01);
    session.reload();
    session.drawIfNeeded();
    EXPECT_EQ(counted(session.live().loadStats(), "textures that share memory"), 0U)
        << "the inspector is still open";
}

}  // namespace
}  // namespace glibra::test
