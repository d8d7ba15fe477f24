// The six samples of the specification of modern statements, read without messages.

#include <gtest/gtest.h>

#include <string>

#include "scene.h"

namespace glibra::glib::test {
namespace {

/// "0 Camera eye LookAt ...": index and text of each command; a block's command has "-> partner" after it.
std::string outline(std::string_view text) {
    const Script script = read(text);
    for (const Diagnostic& each : script.diagnostics) ADD_FAILURE() << toString(each);
    EXPECT_TRUE(script.isModern);
    std::string lines;
    for (const Command& each : script.commands) {
        lines += written(each);
        for (const UniformSpec& spec : each.uniforms) lines += " | " + spec.tag;
        if (each.partner != Command::kNoPartner) lines += " -> " + std::to_string(each.partner);
        lines += "\n";
    }
    return lines;
}

TEST(ModernSamples, ShadowMap) {
    EXPECT_EQ(outline(R"(# A shadow map with soft edges.
Camera eye    LookAt 0 3 6  0 0 0  0 1 0   Perspective 50 .1 100
Camera light  LookAt 3 6 3  0 0 0  0 1 0   Perspective 70 1 20
Texture2D shadow 1024 1024 depth32f

Group world
    PushMatrix
        Set uColor {.8 .4 .2}
        Teapot
    PopMatrix
EndGroup

Vertex depth.vert
Program Depth
Vertex lit.vert
Fragment pcf.frag
Program Lit  uShadow shadow  uShadowMatrix (light.shadow * model)  uRadius <0. 1.5 4.>

Pass shadow from light
    State offset 2 4
    Use Depth
    Draw world
EndPass
Pass window from eye
    Use Lit
    Draw world
EndPass
)"),
              R"(Camera eye LookAt 0 3 6 0 0 0 0 1 0 Perspective 50 0.1 100
Camera light LookAt 3 6 3 0 0 0 0 1 0 Perspective 70 1 20
Texture2D shadow 1024 1024 depth32f
Group world -> 8
PushMatrix
Set uColor {0.8 0.4 0.2}
Teapot
PopMatrix
EndGroup -> 3
Vertex depth.vert
Program Depth
Vertex lit.vert
Fragment pcf.frag
Program Lit uShadow shadow uShadowMatrix (light.shadow * model) | uRadius
Pass shadow from light -> 18
State offset 2 4
Use Depth
Draw world
EndPass -> 14
Pass window from eye -> 22
Use Lit
Draw world
EndPass -> 19
)");
}

TEST(ModernSamples, Life) {
    EXPECT_EQ(outline(R"(# Conway's game of life, ten generations a second.
Texture2D life 512 512 r8ui history
Compute seed.comp
Program Seed  uOut life  uSeed <0 7 100>
Compute life.comp
Program Generation  uIn life.prev  uOut life
Fragment show.frag
Program Show  uLife life

Once
    Dispatch Seed over life
EndOnce
Step 10
    Dispatch Generation over life
EndStep
Fill window with Show
)"),
              R"(Texture2D life 512 512 r8ui history
Compute seed.comp
Program Seed uOut life | uSeed
Compute life.comp
Program Generation uIn life.prev uOut life
Fragment show.frag
Program Show uLife life
Once -> 9
Dispatch Seed over life
EndOnce -> 7
Step 10 -> 12
Dispatch Generation over life
EndStep -> 10
Fill window with Show
)");
}

TEST(ModernSamples, Anaglyph) {
    EXPECT_EQ(outline(R"(Let iod <0. .06 .3>
Camera left   Shift eye (-iod/2) 0 0
Camera right  Shift eye (iod/2) 0 0
Group scene
    Teapot
EndGroup
Pass window from left
    State write r
    Draw scene
EndPass
Pass window from right keep color
    State write gb
    Draw scene
EndPass
)"),
              R"(Let iod <0 0.06 0.3>
Camera left Shift eye (-iod/2) 0 0
Camera right Shift eye (iod/2) 0 0
Group scene -> 5
Teapot
EndGroup -> 3
Pass window from left -> 9
State write r
Draw scene
EndPass -> 6
Pass window from right keep color -> 13
State write gb
Draw scene
EndPass -> 10
)");
}

TEST(ModernSamples, Mirror) {
    EXPECT_EQ(outline(R"(Camera eye    LookAt 3 3 6  0 .5 0  0 1 0   Perspective 50 .1 100
Camera below  Reflect eye 0 1 0 0 clip
Pass window from eye
    State write none depthwrite off mark 1
    Draw mirror
EndPass
Pass window from below
    State where 1
    Draw scene
EndPass
Pass window from eye keep color stencil
    State blend alpha where 1
    Draw mirror
    State default
    Draw scene
EndPass
)"),
              R"(Camera eye LookAt 3 3 6 0 0.5 0 0 1 0 Perspective 50 0.1 100
Camera below Reflect eye 0 1 0 0 clip
Pass window from eye -> 5
State write none depthwrite off mark 1
Draw mirror
EndPass -> 2
Pass window from below -> 9
State where 1
Draw scene
EndPass -> 6
Pass window from eye keep color stencil -> 15
State blend alpha where 1
Draw mirror
State default
Draw scene
EndPass -> 10
)");
}

TEST(ModernSamples, Sums) {
    EXPECT_EQ(outline(R"(Buffer a float [10 12 16 18 50 17]
Buffer b float [30 14 80 20 51 12]
Buffer sum float 6
Compute add.comp
Program Add  A a  B b  Sum sum
Dispatch Add over sum
Expect buffer sum [40 26 96 38 101 29]
)"),
              R"(Buffer a float [10 12 16 18 50 17]
Buffer b float [30 14 80 20 51 12]
Buffer sum float 6
Compute add.comp
Program Add A a B b Sum sum
Dispatch Add over sum
Expect buffer sum [40 26 96 38 101 29]
)");
}

TEST(ModernSamples, Planets) {
    const std::string_view text = R"(Group moon
    Rotate (120*time) 0 1 0
    Translate 2 0 0
    Box .5
EndGroup
Group planet
    Rotate (40*time) 0 1 0
    Draw moon
    Box 2
EndGroup
Pass window from eye
    Draw planet
    Pyramid
EndPass
)";
    EXPECT_EQ(outline(text), R"(Group moon -> 4
Rotate (120*time) 0 1 0
Translate
Box
EndGroup -> 0
Group planet -> 9
Rotate (40*time) 0 1 0
Draw moon
Box
EndGroup -> 5
Pass window from eye -> 13
Draw planet
Pyramid
EndPass -> 10
)");
    const Command rotate = read(text).commands.at(1);
    EXPECT_TRUE(rotate.isEvaluatedLater);
    EXPECT_FALSE(rotate.isModern);
    EXPECT_TRUE(rotate.numbers.empty());
    ASSERT_EQ(rotate.values.size(), 4U);
    EXPECT_EQ(rotate.values[0].text, "120*time");
    EXPECT_EQ(rotate.values[0].position, (Position{2, 12}));
    EXPECT_EQ(text.substr(rotate.values[0].begin, rotate.values[0].end - rotate.values[0].begin),
              "(120*time)");
    EXPECT_EQ(rotate.values[2].number, 1);
}

}  // namespace
}  // namespace glibra::glib::test
