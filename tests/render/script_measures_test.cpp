// Sums, means and extremes of textures and buffers in conditions, at several times; parts in checks; Print
// (language, 12.9).

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

/// Textures and buffers with known content: texel x y of `pic` is x, y, x * y, 1.
const std::string kObjects = R"(Texture2D pic 8 4 rgba32f
Texture2D ints 4 4 rg32ui
Texture2D deep 4 4 depth32f
CubeMap sky 4 rgba8
Texture2DArray layers 4 4 3 r32f
Buffer a float [10 12 16 18 50 17]
Buffer v vec2 [1 10  2 20  3.5 30]
Buffer d double [0.1 0.2 0.3]
Buffer m mat2 [1 2 3 4  5 6 7 8]
Let k <0 2 5>
Fragment inline
#version 330
out vec4 c;
void main() { vec2 p = floor(gl_FragCoord.xy); c = vec4(p, p.x * p.y, 1); }
EndFragment
Program P
Fill pic with P
Fragment inline
#version 330
out uvec2 c;
void main() { c = uvec2(4000000000u, 7u); }
EndFragment
Program U
Fill ints with U
Pass deep
EndPass
Pass sky.face(-y) clear {1 0 0 1}
EndPass
Pass layers.layer(1) clear {.5 0 0 0}
EndPass
)";

std::string found(const std::string& statement) {
    return problemsOf(kObjects + statement + "\n");
}

TEST(ScriptMeasures, GoIntoFunctionsOfTheScene) {
    const std::string functions =
        "Let twice(x) (2 * x)\nLet above(x) (x > k)\nLet least(x) (x)\n";  // a name of the language
    EXPECT_NE(found(functions), "");
    const std::string own = "Let twice(x) (2 * x)\nLet above(x) (x > k)\n";
    EXPECT_EQ(found(own + "Expect (twice(sum(a)) == 246 && above(mean(a)) && twice(a[1]) == 24)"), "");
    EXPECT_NE(found(own + "Expect (above(-sum(a)))"), "");
    EXPECT_EQ(found("Let wave(x t) (sin(3 * x + t))\nExpect (wave(0, 0) == 0)"), "");  // longer than its call
    const std::string inside = found("Let total(x) (x + sum(a))\nExpect (total(1) == 124)");
    EXPECT_NE(inside.find("as an argument"), std::string::npos) << inside;
}

TEST(ScriptMeasures, DoNotEndRepetitions) {
    const std::string problems =
        found("Once\nRepeat 5 until (sum(a) > 100)\nFill pic with P\nEndRepeat\nEndOnce");
    EXPECT_NE(problems.find("glib-E32"), std::string::npos) << problems;
    EXPECT_EQ(found("Once\nRepeat 5 until (a[0] > 100)\nFill pic with P\nEndRepeat\nEndOnce\n"
                    "Expect error glib-W43"),
              "");
}

TEST(ScriptMeasures, AreThoseOfAllComponents) {
    for (const char* condition : {
             "sum(a) == 123",
             "mean(a) == 20.5",
             "least(a) == 10 && largest(a) == 50",
             "sum(v) == vec2(6.5, 60)",
             "largest(v).y == 30",
             "sum(m) == mat2(6, 8, 10, 12)",
             "abs(sum(d) - .6) < 1e-15",
             "sum(pic) == vec4(4 * 28, 8 * 6, 28 * 6, 32)",
             "mean(pic) == vec4(3.5, 1.5, 5.25, 1)",
             "sum(pic.b) == 168 && sum(pic.gr) == vec2(48, 112)",
             "sum(ints) == vec2(64e9, 112)",
             "mean(deep) == 1",
             "sum(sky).r == 16",
             "mean(window.a) == 1",
         })
        EXPECT_EQ(found("Expect (" + std::string(condition) + ")"), "") << condition;
}

TEST(ScriptMeasures, TakeParts) {
    for (const char* condition : {
             "sum(pic, 2, 1, 3, 2).rg == vec2(18, 9)",
             "sum(a, 1, k) == 28",
             "sum(a, 0, a.count - 1) == 123",
             "sum(v.y, 1, 1) == 20",
             "sum(sky.face(-y)).r == 16 && sum(sky.face(3)).r == 16 && largest(sky.face(+y)).r == 0",
             "sum(layers.layer(1)) == 8 && sum(layers) == 8 && sum(layers.layer(k)) == 0",
         })
        EXPECT_EQ(found("Expect (" + std::string(condition) + ")"), "") << condition;
}

TEST(ScriptMeasures, SumsAreCompensated) {
    EXPECT_EQ(problemsOf("Buffer c float [1e8 1 -1e8 1]\nBuffer t double 100000 (.1)\n"
                         "Expect (sum(c) == 2)\nExpect (sum(t) == 10000)\n"),
              "");
}

TEST(ScriptMeasures, WhatIsNotANumberIsReported) {
    const std::string scene =
        "Texture2D t 2 2 r32f\nFragment inline\n#version 330\nout vec4 c;\nvoid main() { c "
        "= vec4(gl_FragCoord.x < 1. ? sqrt(-gl_FragCoord.x) : 1.); }\nEndFragment\n"
        "Program P\nFill t with P\n";
    EXPECT_NE(problemsOf(scene + "Expect (sum(t) == 1)\n").find("'sum(t)': the result is not a number"),
              std::string::npos);
    EXPECT_EQ(problemsOf(scene + "Expect (isnan(sum(t)) && isnan(least(t)) && isnan(largest(t)))\n"), "");
    EXPECT_EQ(problemsOf(scene + "Expect (sum(t, 1, 0, 1, 2) == 2)\n"), "");
}

TEST(ScriptMeasures, ReportMistakesAtTheirPlace) {
    const auto place = [](const std::string& condition) {
        const std::string problems = found("Expect (" + condition + ")");
        const std::size_t at = problems.find("error: ");
        return at == std::string::npos ? problems : problems.substr(at + 7, problems.find(']', at) - at - 6);
    };
    const std::size_t lines = static_cast<std::size_t>(std::count(kObjects.begin(), kObjects.end(), '\n'));
    EXPECT_NE(found("Expect (1 + sum(pix) == 1)").find(std::to_string(lines + 1) + ":17: error"),
              std::string::npos)
        << found("Expect (1 + sum(pix) == 1)");
    EXPECT_EQ(place("sum(pix) == 1"),
              "no texture or buffer 'pix' is declared before this line; did you mean 'pic'? [glib-E27]");
    EXPECT_EQ(place("sum(pic.face(+x)).r == 1"), "'pic' has no part 'face'; it has level [glib-E35]");
    EXPECT_EQ(place("sum(pic.level(1)).r == 1"), "pic.level: 1 is not between 0 and 0 [glib-E05]");
    EXPECT_EQ(place("sum(deep.g) == 1"), "'deep' has 1 component, and no component 'g' [glib-E35]");
    EXPECT_EQ(place("sum(sky.face(+w)).r == 1"), "unknown name 'w' [expr-E02]");
    EXPECT_EQ(place("sum(pic, 4, 0, 5, 1).r == 1"),
              "sum: the rectangle of 5 x 1 at 4 0 is not inside of 'pic', which has 8 x 4 texels [glib-E05]");
    EXPECT_EQ(place("sum(pic, 4).r == 1"),
              "sum: a rectangle of 'pic' needs 4 numbers, x y width height, found 1 [glib-E26]");
    EXPECT_EQ(place("sum(a, 3, 1) == 1"), "sum: the first element 3 stands after the last, 1 [glib-E29]");
    EXPECT_EQ(place("sum(v) == 1"), "'==' does not combine vec2 and number [expr-E03]");
    EXPECT_EQ(place("sum(a, 0, sum(a)) == 1"),
              "sum: its numbers and times are known before anything is drawn; they cannot read what textures "
              "and buffers hold [expr-E07]");
    EXPECT_EQ(place("sum(a) at a[0] == 1"), place("sum(a, 0, sum(a)) == 1"));
    EXPECT_EQ(
        place("a[0] at 1 == 1"),
        "expected an operator or the end of the expression, found 'at'; a time may stand after sum, mean, "
        "least and largest alone: sum(NAME) at 2 [expr-E01]");
    EXPECT_NE(
        found("Let n (sum(a))").find("only Expect (condition) and Print (expression) read what textures"),
        std::string::npos);
    EXPECT_NE(found("Print (sum(a) at 1)").find("'at' stands in Expect (condition) alone"),
              std::string::npos);
}

/// Steps move two particles towards each other; their structure has members of several types.
const std::string kParticles = R"(Buffer p Particle 4
Compute inline
#version 430
layout(local_size_x = 4) in;
struct Particle { vec3 place; float mass; mat2 frame; uint id; };
layout(std430) buffer Particles { Particle p[]; };
uniform float uDt;
void main() {
    uint i = gl_GlobalInvocationID.x;
    p[i].place += vec3(uDt, 2. * uDt, float(i));
    p[i].mass = 2.;
    p[i].frame = mat2(1, 2, 3, 4);
    p[i].id = i;
}
EndCompute
Program Move  Particles p  uDt (dt)
Step 4
    Dispatch Move 1
EndStep
)";

TEST(ScriptMeasures, CompareSeveralTimes) {
    for (const char* check : {
             "(sum(p.mass) == sum(p.mass) at 1) at 2",
             "(sum(p.mass) at 0 == 0 && sum(p.mass) at .25 == 8)",
             "(mean(p.place).x at 3 == 3 && mean(p.place.x) at 1 == 1) at 2",
             "(mean(p.place).y at 3 - mean(p.place).y == 4) at 1",
             "(mean(p.place).z == 4 * 1.5 * time) at 3",
             "(sum(p.frame) == 4 * mat2(1, 2, 3, 4) && largest(p.id) == 3) at 1",
         })
        EXPECT_EQ(problemsOf(kParticles + "Expect " + check + "\n"), "") << check;
    const std::string drift =
        problemsOf(kParticles + "Expect (mean(p.place.x) == mean(p.place.x) at 3) at 2\n");
    EXPECT_NE(drift.find("found 2 == 3 [check-E01]"), std::string::npos) << drift;
}

TEST(ScriptMeasures, MembersAreNamed) {
    const auto why = [](const char* condition) {
        return problemsOf(kParticles + "Expect (" + condition + ") at 1\n");
    };
    EXPECT_NE(why("sum(p.mas) == 8").find("'p' has no member 'mas'; did you mean 'mass'?"), std::string::npos)
        << why("sum(p.mas) == 8");
    EXPECT_NE(why("sum(p) == 8").find("an element of 'p' has 9 numbers; name one of its members: p.place"),
              std::string::npos)
        << why("sum(p) == 8");
    EXPECT_NE(why("sum(p.place) == 8").find("'==' does not combine vec3 and number"), std::string::npos);
    EXPECT_EQ(
        problemsOf(kParticles + "Expect range p.id 0 3 at 1\nExpect finite p.place at 1\n"
                                "Expect range p.place.xy .5 1 in 0 1 at .5\nExpect sum p.mass 8 at 1\n"),
        "");
}

TEST(ScriptChecks, LookAtPartsOfTheirObjects) {
    for (const char* check : {
             "pixel 3 2 [6] of pic.b",
             "mean 0 0 2 1 [.5] of pic.r",
             "count [1 0 0 1] 4 of sky.face(-y) in 0 0 2 2",
             "count [1 0 0] 16 of sky",
             "finite pic.rgb in 1 1 2 2",
             "range pic.r 2 3 in 2 0 2 4",
             "range a 12 18 in 1 3",
             "same pic.r pic.r in 0 0 3 3",
             "different pic.r pic.g in 2 0 1 1",
             "same layers.layer(0) layers.layer(1) within .5 in 1 1 2 2",
             "sum pic.g 3 in 0 1 3 1",
             "sum v.y 50 in 1 2",
             "buffer v.y [10 20 30]",
         })
        EXPECT_EQ(found("Expect " + std::string(check)), "") << check;
    const std::string outside = found("Expect range pic.b 0 6 in 5 1 2 2");
    EXPECT_NE(outside.find("expected 0 to 6, found 2 others: 10 at 5 2, 12 at 6 2 [check-E01]"),
              std::string::npos)
        << outside;
    EXPECT_NE(
        found("Expect finite pic in 0 0 9 9").find("not inside of 'pic', which has 8 x 4 texels [glib-E05]"),
        std::string::npos);
    EXPECT_NE(found("Expect finite window in 0 0 9999 9").find("[check-E02]"), std::string::npos);
    EXPECT_NE(found("Expect finite window.level(1)").find("only components may stand after the window"),
              std::string::npos);
}

/// What the notes of Print say, one after another.
std::string printed(const std::string& scene) {
    const std::string problems = problemsOf(scene);
    std::string all;
    for (std::size_t at = problems.find("note: "); at != std::string::npos;
         at = problems.find("note: ", at + 1)) {
        const std::size_t end = problems.find(" [check-N02]", at);
        all += (all.empty() ? "" : "; ") + problems.substr(at + 6, end - at - 6);
    }
    return all;
}

TEST(ScriptPrints, ShowTexelsElementsAndValues) {
    const auto of = [](const std::string& what) { return printed(kObjects + "Print " + what + "\n"); };
    EXPECT_EQ(of("pic 3 2"), "pic[3 2]: 3 2 6 1");
    EXPECT_EQ(of("pic.b in 6 3 2 1"), "pic.b[6 3]: 18; pic.b[7 3]: 21");
    EXPECT_EQ(of("ints 0 0"), "ints[0 0]: 4000000000 7");
    EXPECT_EQ(of("layers in 0 0 1 1"),
              "layers[0 0 of layer 0]: 0; layers[0 0 of layer 1]: 0.5; layers[0 0 of layer 2]: 0");
    EXPECT_EQ(of("sky.face(-y) 1 1"), "sky.face(-y)[1 1]: 1 0 0 1");
    EXPECT_EQ(of("a 4 9"), "a[4]: 50; a[5]: 17");
    EXPECT_EQ(of("v in 1 2"), "v[1]: 2 20; v[2]: 3.5 30");
    EXPECT_EQ(of("m 1"), "m[1]: [5 7] [6 8]");
    EXPECT_EQ(of("d 2"), "d[2]: 0.3");
    EXPECT_EQ(of("(sum(d) - .1)"), "(sum(d) - .1): 0.5");
    EXPECT_EQ(of("(mean(pic).rg)"), "(mean(pic).rg): [3.5 1.5]");
    EXPECT_EQ(of("(a[2] + k)"), "(a[2] + k): 18");
    EXPECT_EQ(of("(sum(m))"), "(sum(m)): [6 10] [8 12]");
}

TEST(ScriptPrints, SayHowManyTexelsAreLeftOut) {
    const std::string all = printed("Texture2D t 40 50 r8\nPass t clear {1 0 0}\nEndPass\nPrint t\n");
    EXPECT_NE(all.find("t[39 24]: 1; Print t: 1000 more texels; --save t=FILE.exr writes all"),
              std::string::npos)
        << all.substr(all.size() - 200);
}

TEST(ScriptPrints, ShowRecordsMemberByMember) {
    EXPECT_EQ(
        printed("Buffer p Rec 2 [1 2 3 4 5 6 7 8  0 0 0 0 0 0 0 0]\nCompute inline\n#version 430\n"
                "layout(local_size_x = 1) in;\nstruct Rec { vec3 place; float mass; mat2 frame; };\n"
                "layout(std430) buffer Recs { Rec p[]; };\nvoid main() { p[1].mass = 2.5; }\nEndCompute\n"
                "Program Move  Recs p\nDispatch Move 1\nPrint p\n"),
        "p[0]: place 1 2 3, mass 4, frame [5 7] [6 8]; p[1]: place 0 0 0, mass 2.5, frame [0 0] [0 0]");
}

}  // namespace
}  // namespace glibra::test
