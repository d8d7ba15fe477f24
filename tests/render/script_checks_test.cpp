// Expect: what scripts state about themselves (language, 12.9).

#include <gtest/gtest.h>

#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

TEST(ScriptChecks, LevelsAreGeneratedForTheCheck) {
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
Texture2D a 8 8 rgba8 mipmap levels 4 generate
Fragment inline
#version 430
in vec2 vST; out vec4 c; void main(){ c=vec4(vST.x<.5,0,0,1); }
EndFragment
Program P
Fill a with P
Expect pixel 0 0 [.5] of a.level(3) within .01
)"),
              "");
}

TEST(ScriptChecks, AConditionThatFailsShowsBothSides) {
    const auto found = [](const std::string& check) {
        const std::string problems = problemsOf(
            "Buffer sums uint [40 26 96]\nLet aim <0 3 9>\nFragment inline\n"
            "#version 430\nlayout(std430) buffer sums { uint n[]; };\nout vec4 c;\n"
            "void main() { c = vec4(n[0]); }\nEndFragment\nProgram P\nUse P\n"
            "FullScreen\nExpect " +
            check + "\n");
        const std::size_t at = problems.find("expected true, found ");
        return at == std::string::npos ? problems : problems.substr(at + 21, problems.rfind(" [") - at - 21);
    };
    EXPECT_EQ(found("(sums[0] == 40)"), "");
    EXPECT_EQ(found("(sums[0] == 41)"), "40 == 41");
    EXPECT_EQ(found("(sums[1] + 1 <= aim * (2 + aim))"), "27 <= 15");
    EXPECT_EQ(found("(vec2(aim, 1) == vec2(1, 1))"), "[3 1] == [1 1]");
    EXPECT_EQ(found("(sums[0] == 40 && sums[1] == 2)"), "false");
    EXPECT_EQ(found("(aim - 3)"), "0");
    EXPECT_NE(found("primitives (sums[0])")
                  .find("'sums[0]' has no value here: only Expect (condition) and Print "
                        "(expression) read the elements of buffers"),
              std::string::npos);
}

TEST(ScriptChecks, SumsAreOfEachComponent) {
    const auto found = [](const std::string& check) {
        return problemsOf(
            "Buffer a vec2 [1 10  2 20  3.5 30]\nBuffer b float 1000 (.1)\n"
            "Buffer c float [1e8 1 -1e8 1]\nTexture2D t 4 4 rg32f\n"
            "Pass t clear {.25 .5 0 0}\nEndPass\nExpect sum " +
            check + "\n");
    };
    EXPECT_EQ(found("a [6.5 60]"), "");
    EXPECT_EQ(found("a 6.5"), "");
    EXPECT_EQ(found("b (10*10) within 1e-4"), "");
    EXPECT_EQ(found("c 2"), "");
    EXPECT_EQ(found("t [4 8]"), "");
    EXPECT_NE(found("a [6 61] within .9")
                  .find("Expect sum a [6 61] within 0.9: expected 6 61 within 0.9, found "
                        "6.5 60 [check-E01]"),
              std::string::npos)
        << found("a [6 61] within .9");
    EXPECT_NE(found("b 100").find("expected 100, found 100.00000"), std::string::npos) << found("b 100");
    EXPECT_NE(found("a [1 2 3]").find("'a' has 2 components, not 3 [check-E02]"), std::string::npos)
        << found("a [1 2 3]");
}

TEST(ScriptChecks, WholeNumbersAreShownInFull) {
    const std::string found = problemsOf(
        "Buffer a uint [4294967294 7]\nExpect buffer a at 0 [4294967295]\nExpect sum a 7 within 1e9\n");
    EXPECT_NE(found.find("expected 4294967295, found 4294967294"), std::string::npos) << found;
    EXPECT_NE(found.find("expected 7 within 1000000000, found 4294967301"), std::string::npos) << found;
}

TEST(ScriptChecks, ValuesBeyondTheirIntegersAreReported) {
    const auto found = [](const std::string& buffer) {
        return problemsOf("Buffer a " + buffer + "\nExpect finite a\n");
    };
    EXPECT_EQ(found("uint [0 4294967295 1]"), "");
    EXPECT_EQ(found("int [-2147483648 2147483647]"), "");
    EXPECT_EQ(found("float [-1 3e10]"), "");
    EXPECT_NE(found("uint [0 1 -1]")
                  .find("warning: buffer 'a': value 2 is -1, which is stored as 0; a uint holds 0 to "
                        "4,294,967,295 [memory-W02]"),
              std::string::npos)
        << found("uint [0 1 -1]");
    EXPECT_NE(found("int 3 (3e9)").find("value 0 is 3e+09, which is stored as 2147483647; an int holds"),
              std::string::npos)
        << found("int 3 (3e9)");
}

TEST(ScriptChecks, EqualContentsMayDifferWithinATolerance) {
    const auto found = [](const std::string& check) {
        return problemsOf("Buffer a float [1 2 3]\nBuffer b float [1 2.25 3]\nExpect " + check + "\n");
    };
    EXPECT_EQ(found("same a b within .25"), "");
    EXPECT_EQ(found("different a b within .2"), "");
    EXPECT_NE(found("same a b within .2")
                  .find("expected the same content within 0.2, found 1 differing value, by up to 0.25"),
              std::string::npos)
        << found("same a b within .2");
    EXPECT_NE(
        found("different a b within .25").find("expected different content, found the same within 0.25"),
        std::string::npos);
}

TEST(ScriptChecks, SeveralDifferencesAreCountedAndTheFirstOnesAreShown) {
    const auto foundBy = [](const std::string& check) {
        return problemsOf("Buffer a float [0 1 2 3 4 5 6 7 8 9]\nBuffer b float 10\nExpect " + check + "\n");
    };
    const auto expectText = [&](const std::string& check, const std::string& part) {
        const std::string problems = foundBy(check);
        EXPECT_NE(problems.find(part), std::string::npos) << problems;
    };
    expectText("buffer a [0 1 2 3 4 5 6 7 8 8]", "expected 8 as value 9, found 9 [");
    expectText("buffer a [1 1 2 3 4 5 6 7 7 9]",
               "expected 10 values, found 2 that differ: value 0 is 0, not 1, value 8 is 8, not 7 [");
    expectText(
        "buffer b [0 1 2 3 4 5 6 7 8 9]",
        "found 9 that differ: value 1 is 0, not 1, value 2 is 0, not 2, value 3 is 0, not 3, value 4 is "
        "0, not 4, ... [");
    expectText("range a 0 8", "expected 0 to 8, found 9 at 9 [");
    expectText("range a 0 7", "expected 0 to 7, found 2 others: 8 at 8, 9 at 9 [");
    expectText("range a 0 1", "found 8 others: 2 at 2, 3 at 3, 4 at 4, 5 at 5, ... [");
    expectText("same a b",
               "found 9 differing values, by up to 9: 1 and 0 at 1, 2 and 0 at 2, 3 and 0 at 3, 4 "
               "and 0 at 4, ... [");
}

TEST(ScriptChecks, AMisspeltSetIsReported) {
    const auto found = [](const std::string& set, const std::string& after = "FullScreen\n") {
        return problemsOf(
            "WindowSize 8 8\nFragment inline\n#version 430\nuniform vec4 uColor, uLight1; out vec4 c;\n"
            "layout(std430) buffer Sums { float sums[]; };\nvoid main() { c = uColor + uLight1; sums[0] = "
            "1.; }\n"
            "EndFragment\nBuffer sums float 1\nProgram P uColor {1 0 0} uLight1 {0 0 0 0}\n" +
            set + "\n" + after);
    };
    const std::string expected =
        "warning: no program of the scene has a uniform 'uClor'; did you mean 'uColor'?";
    EXPECT_NE(found("Set uClor {1 0 0 1}").find(expected), std::string::npos) << found("Set uClor {1 0 0 1}");
    EXPECT_NE(found("Set uClor {1 0 0 1}", "Once\nClear sums\nEndOnce\nFullScreen\n").find(expected),
              std::string::npos);
    EXPECT_EQ(found("Set uColor {1 0 0 1}"), "");
    EXPECT_EQ(found("Set uLight2 {1 0 0 1}"), "") << "it may be of a row that this scene does not need whole";
    EXPECT_EQ(found("Set uOther 5"), "") << "a Set is for all programs, and none of them need have it";
    EXPECT_EQ(found("Set Sums sums"), "");
    EXPECT_NE(found("Set Sumss sums").find("'Sumss'; did you mean 'Sums'?"), std::string::npos);
    EXPECT_EQ(found("Set uClor {1 0 0 1}", "Program Q\nUse P\nFullScreen\n"), "") << "Q may have it";
}

TEST(ScriptChecks, OutputsFitTheirTargets) {
    const auto drawn = [](const std::string& output, const std::string& format,
                          const std::string& state = {}) {
        return problemsOf(
            "WindowSize 8 8\nTexture2D ids 8 8 " + format + "\nFragment inline\n#version 430\nout " + output +
            " c;\nvoid main() { c = " + output + "(7); }\nEndFragment\nProgram P\nPass ids\n" + state +
            "Use P\nFullScreen\nEndPass\nExpect pixel 2 2 [" + (state.empty() ? "7" : "0") + "] of ids\n");
    };
    EXPECT_EQ(drawn("uint", "r32ui"), "");
    EXPECT_EQ(drawn("int", "r8i"), "");
    EXPECT_EQ(drawn("float", "r32f"), "");
    EXPECT_NE(drawn("vec4", "r32ui")
                  .find("error: fragment output 'c' is of type vec4, but target 'ids' (line 2) "
                        "holds unsigned integers; declare the output as uvec4"),
              std::string::npos)
        << drawn("vec4", "r32ui");
    EXPECT_NE(drawn("uint", "r32i").find("holds signed integers; declare the output as int"),
              std::string::npos);
    EXPECT_NE(drawn("ivec2", "rg8").find("holds floating-point numbers; declare the output as vec2"),
              std::string::npos);
    EXPECT_EQ(drawn("vec4", "r32ui", "State write none\n"), "") << "nothing is written";
}

TEST(ScriptChecks, SmallBuffersLast) {
    EXPECT_EQ(problemsOf(R"(Buffer b float 1
Compute inline
#version 430
layout(local_size_x=1) in; layout(std430) buffer B { float b[]; };
void main(){ b[0]+=1.; }
EndCompute
Program C
Once
    Dispatch C 1
EndOnce
Expect buffer b [1]
)"),
              "");
}

TEST(ScriptChecks, SmallBlocksOfStepAndOnceMayBePadded) {
    const auto found = [](const std::string& type, const std::string& members, const std::string& begin,
                          const std::string& end) {
        return problemsOf("Buffer n " + type + "\nCompute inline\n#version 430\n" +
                          "layout(local_size_x = 1) in;\nlayout(std430) buffer N { " + members +
                          " };\nvoid main() { n += 1u; }\nEndCompute\nProgram C N n\n" + begin +
                          "\nDispatch C 1\n" + end + "\nExpect sum n [1]\n");
    };
    for (const std::string block : {"Once", "Step 3", ""}) {
        const std::string end = block.empty() ? "" : "End" + block.substr(0, 4);
        EXPECT_EQ(found("uint 1", "uint n;", block, end).find("memory"), std::string::npos)
            << found("uint 1", "uint n;", block, end);
        EXPECT_EQ(found("uint 5", "uint n, a[4];", block, end).find("memory"), std::string::npos)
            << found("uint 5", "uint n, a[4];", block, end);
        EXPECT_NE(found("uint 5", "uint n, a[5];", block, end).find("memory-E04"), std::string::npos);
    }
    EXPECT_EQ(found("uint 1", "uint n;", "Once", "EndOnce"), "");
    EXPECT_EQ(found("uint 5", "uint n, a[4];", "Once", "EndOnce"), "");
    EXPECT_EQ(found("uint 5 history", "uint n, a[4];", "Once", "EndOnce"), "");
}

TEST(Print, ShowsTheValueOfAComparison) {
    const std::string found = problemsOf("Let k 2\nPrint (k == 3)\nPrint (vec2(k) == vec2(2))\n");
    EXPECT_NE(found.find("(k == 3): false"), std::string::npos) << found;
    EXPECT_NE(found.find("(vec2(k) == vec2(2)): true"), std::string::npos) << found;
}

/// A program whose invocations do that with a storage block of this name and these members.
std::string compute(const std::string& name, const std::string& before, const std::string& block,
                    const std::string& what) {
    return "Compute inline\n#version 430\nlayout(local_size_x = 4) in;\n" + before +
           "layout(std430) buffer " + block + ";\nvoid main() { " + what + " }\nEndCompute\nProgram " + name +
           "\n";
}
const std::string kBody = "struct Body { vec2 place; float speed; float mass; };\n";
const std::string kMove =
    compute("Move", kBody, "P { Body p[]; }", "p[gl_GlobalInvocationID.x].speed += 1.;");

TEST(Structures, OfTheTypeOfABufferMayStandInAnyProgram) {
    const std::string declared = "Buffer p Body 8 (vec4(i, 2*i, 3, 4))\nBuffer total uint 4\n";
    const std::string count = compute("Count", "", "total { uint t[]; }", "t[gl_GlobalInvocationID.x] = 9u;");
    const std::string step = "Step 10\nDispatch Move over p\nEndStep\n", expect = "Expect sum p.mass 32\n";
    EXPECT_EQ(problemsOf(declared + kMove + "Once\nEndOnce\n" + step + expect), "");
    EXPECT_EQ(problemsOf(declared + kMove + count + "Once\nDispatch Count 1\nEndOnce\n" + step + expect), "");
    const std::string fill =
        "Texture2D t 8 8 rgba8\nFragment inline\n#version 330\nout vec4 o;\nvoid main() { o = vec4(1.); }\n"
        "EndFragment\nProgram F\n";
    EXPECT_EQ(
        problemsOf(fill + "Buffer p Body 4 (vec4(i, 0, 0, time))\n" + kMove +
                   "Dispatch Move over p\nStep 10\nFill t with F\nEndStep\nExpect (mean(t).r == 1) at 1\n"),
        "")
        << "the frame has it, and nothing reads it";
    const std::string other = compute("Other", "", "P { vec4 p[]; }", "p[gl_GlobalInvocationID.x].x += 1.;") +
                              "Dispatch Other over p\n";
    EXPECT_EQ(problemsOf(declared + kMove + other + "Expect buffer p [1 0]\n"), "")
        << "nothing dispatches it";
    EXPECT_NE(problemsOf(declared + other + "Expect buffer p [1 0]\n").find("memory-E05"), std::string::npos);
}

TEST(Elements, AreThoseOfTheBlockOfTheDeclaredTypeWhateverComesFirst) {
    const std::string vectors =
        compute("Vectors", "", "P { vec4 p[]; }", "p[gl_GlobalInvocationID.x] += 1.;");
    const auto floats = [](const std::string& at) {
        return compute("Floats", "", "Raw { float raw[]; }", "raw[" + at + "] += float(raw.length());");
    };
    const std::string first = "Dispatch Floats 8  Raw p\n", second = "Dispatch Vectors over p\n";
    for (const std::string& both : {first + second, second + first})
        EXPECT_EQ(problemsOf("Buffer p vec4 8\n" + vectors + floats("gl_GlobalInvocationID.x") + both +
                             "Expect sum p.w 264\nExpect (p[7] == vec4(33))\n"),
                  "");
    const std::string beyond = problemsOf("Buffer p vec4 8\n" + vectors + floats("gl_GlobalInvocationID.x") +
                                          second + "Dispatch Floats 16  Raw p\nExpect finite p\n");
    EXPECT_NE(
        beyond.find("goes up to element 63, but buffer 'p' has 32 such elements; write 'over p', compare "
                    "with raw.length(), or declare 16 elements"),
        std::string::npos)
        << beyond;
    EXPECT_EQ(problemsOf("Buffer p Body 8 (vec4(i, 2*i, 3, 4))\n" + kMove +
                         compute("Other", "", "P { vec4 p[]; }", "p[gl_GlobalInvocationID.x].x += 1.;") +
                         "Dispatch Other over p\nDispatch Move over p\nExpect (sum(p.mass) == 32)\n"),
              "");
}

TEST(Tags, OfBlocksAreCheckedAsThoseOfUniformsAre) {
    const auto found = [](const std::string& program, const std::string& dispatch,
                          const std::string& set = "") {
        return problemsOf(
            "Buffer a float 4 (1)\nBuffer b float 4 (2)\nBuffer sum float 4\nTexture2D t 4 4 rgba8\n"
            "Compute inline\n#version 430\nlayout(local_size_x = 4) in;\nuniform float uScale;\n"
            "layout(std430) readonly buffer Left { float a[]; };\nlayout(std430) buffer Sum { float sum[]; "
            "};\n"
            "void main() { sum[gl_GlobalInvocationID.x] = uScale*a[gl_GlobalInvocationID.x]; }\nEndCompute\n"
            "Pass t clear {0}\nEndPass\nProgram Add  uScale 1 " +
            program + "\n" + set + "Dispatch Add 1 " + dispatch + "\nExpect finite sum\n");
    };
    EXPECT_EQ(found("", "Left b"), "");
    const std::string misspelt = "no shader of 'Add' has a uniform 'Lefft'; did you mean 'Left'? [glib-W23]";
    for (const std::string& each : {found("", "Lefft b"), found("Lefft b", ""), found("", "Lefft t")})
        EXPECT_NE(each.find(misspelt), std::string::npos) << each;
    EXPECT_NE(found("", "", "Set Lefft b\n").find("'Lefft'; did you mean 'Left'? [glib-W23]"),
              std::string::npos);
    for (const std::string& each : {found("", "Left t"), found("", "Left 3")})
        EXPECT_NE(each.find("'Left'; the block or atomic counter takes a buffer [glib-W23]"),
                  std::string::npos)
            << each;
    EXPECT_NE(found("", "uScale b").find("float 'uScale'"), std::string::npos) << found("", "uScale b");
}

TEST(ScriptChecks, KeepWhatIsReportedWithoutDrawing) {
    const SceneFolder folder("Sphere\nExpect error glib-W23\n");
    const Diagnostics known = {diagnose("glib-W23", "a"), diagnose("glib-W24", "b")};
    const std::string found = text(render::runChecks(sharedContext(), folder / "scene.glib", {}, known));
    EXPECT_EQ(found.find("glib-W23"), std::string::npos) << found;
    EXPECT_NE(found.find("glib-W24"), std::string::npos) << found;
}

TEST(ScriptChecks, ReportWhatDoesNotHold) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nPass window clear {1 0 0}\nEndPass\nExpect pixel 2 2 [1 0 0]\n"),
              "");
    EXPECT_NE(problemsOf("WindowSize 8 8\nPass window clear {1 0 0}\nEndPass\nExpect pixel 2 2 [0 1 0]\n")
                  .find("check-E01"),
              std::string::npos);
}

// ---- Checks.

TEST(Conditions, NeedTheBuffersThatTheyReadAndNoOthers) {
    const auto scene = [](const std::string& condition) {
        return R"(Compute inline
#version 430
layout(local_size_x = 1) in;
buffer Sum { float sum[]; };
void main() { sum[0] = 3.; }
EndCompute
Program Add
Buffer Sum float 1
Buffer Su float [3]
Dispatch Add 1 1 1
Expect ()" + condition +
               ")\n";
    };
    EXPECT_EQ(problemsOf(scene("Sum[0] == 3")), "");
    RenderOptions checked;
    checked.checks = true;
    EXPECT_EQ(draw(SceneFolder(scene("Sum[0] == 3")), checked).count("dispatches"), 1U);
    EXPECT_EQ(draw(SceneFolder(scene("Su[0] == 3")), checked).count("dispatches"), 0U);
}

TEST(ScriptChecks, ElementsAreThoseOfTheArrayBehindOtherMembers) {
    const auto found = [](const std::string& block, const std::string& write, const std::string& checks) {
        return problemsOf("WindowSize 8 8\n" + checks.substr(0, checks.find('\n') + 1) +
                          "Fragment inline\n#version 430\nstruct P { vec2 a; float b; };\n"
                          "layout(std430) buffer Block { " +
                          block + " };\nout vec4 c;\nvoid main() { " + write +
                          " c = vec4(1); }\nEndFragment\nProgram F Block parts\nFill window with F\n" +
                          checks.substr(checks.find('\n') + 1));
    };
    EXPECT_EQ(found("int head; vec2 e[];",
                    "head = 9; for (int i = 0; i < 4; ++i) e[i] = vec2(10 * i + 1, 10 * i + 2);",
                    "Buffer parts vec2 4\nExpect buffer parts at 1 [11 12]\nExpect (parts[1].x == 11)\n"
                    "Expect (parts[0].x == 1)\nExpect (parts[3].y == 32)\nExpect (parts.count == 4)\n"
                    "Expect sum parts [64 68]\nExpect buffer parts at 3 [31 32]\n"),
              "");
    EXPECT_EQ(found("uvec3 head; float more; uint e[];", "head = uvec3(7); more = 3.; e[0] = 4u; e[2] = 6u;",
                    "Buffer parts uint 3\nExpect buffer parts [4 0 6]\nExpect (parts.count == 3)\n"),
              "");
    EXPECT_EQ(found("float head; P e[];", "head = 9.; e[1] = P(vec2(1, 2), 3.);",
                    "Buffer parts P 2\nExpect buffer parts at 1 [1 2 3]\nExpect sum parts [1 2 3]\n"),
              "");
}

TEST(ScriptChecks, AConditionReadsTheNumberOfElementsAndNamesThatAreFolded) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nLet arr [1 2 3 4 5]\nLet k 5\nCamera eye (mat4(1)) (mat4(1))\n"
                         "Texture2D t 16 4 rgba8\nPass t clear {1 1 1}\nEndPass\nSphere 1\n"
                         "Expect (arr.count == 5)\nExpect (arr[2] == 3 && arr.count > 3)\n"
                         "Expect (true || k == 4)\nExpect (t.size.x == 16)\nExpect (0*k + 1 == 1)\n"),
              "");
}

TEST(ScriptChecks, TellDoublesApartThatLookAlike) {
    const std::string problems = problemsOf(
        "Buffer b double [(1/3) (1/3 + 1e-14)]\nPrint b\nExpect buffer b [(1/3 + 2e-14)] within "
        "1e-15\nFragment "
        "inline\n#version 430\nlayout(std430) readonly buffer b { double n[]; };\nout vec4 c;\nvoid main() { "
        "c = "
        "vec4(n[0]); }\nEndFragment\nProgram P\nUse P\nFullScreen\n");
    EXPECT_NE(problems.find("expected 0.3333333333333533"), std::string::npos) << problems;
    EXPECT_NE(problems.find("found 0.333333333333333"), std::string::npos) << problems;
}

TEST(ScriptChecks, NameTheFaceAndTheComponentOfAValueOutOfRange) {
    const std::string problems = problemsOf(
        "CubeMap sky 4 rgba8\nPass sky.face(0) clear {.5 .5 .5 .5}\nEndPass\nPass sky.face(3) clear {.5 1 .5 "
        ".5}\nEndPass\n"
        "Expect range sky 0 .9\n");
    EXPECT_NE(problems.find("of face 3, component 1"), std::string::npos) << problems;
}

TEST(ScriptChecks, NameNoDistanceFromWhatIsNoNumber) {
    const std::string scene =
        "Texture2D a 2 1 r32f\nTexture2D b 2 1 r32f\nPass b clear {1}\nEndPass\nFragment inline\n#version "
        "430\nuniform "
        "float zero;\nout vec4 c;\nvoid main() { c = vec4(zero / zero); }\nEndFragment\nProgram P zero "
        "0\nFill a with "
        "P\nExpect same a b\n";
    const std::string problems = problemsOf(scene);
    EXPECT_NE(problems.find("2 differing values: nan and 1 at"), std::string::npos) << problems;
}

}  // namespace
}  // namespace glibra::test
