// Loops that a driver ends before their bound. The count in the picture is too small exactly where draw-W08
// is reported (llvmpipe ends the loops of a stage after 65,535 rounds in total).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.h"

namespace glibra::stress {
namespace {

/// A stage that shows n. `body` adds 1 to n in each round.
struct Counting {
    std::string body, tags;
    int rounds;
    int slack = 0;  ///< allowed error of a sum of floats
};

FloatPicture counted(const Counting& of, bool inVertexStage) {
    const std::string declarations =
        "uniform int uN, uM, uOne;\nuniform float uStep;\nint count() {\n  int n = 0;\n  " + of.body +
        "\n  return n;\n}\n";
    const Files files = inVertexStage
                            ? Files{{"v.vert", "#version 330 core\nflat out int vN;\n" + declarations +
                                                   "void main() { vN = count(); gl_Position = "
                                                   "uModelViewProjectionMatrix * aVertex; }\n"},
                                    {"f.frag",
                                     "#version 330 core\nflat in int vN;\nout vec4 fColor;\nvoid main() { "
                                     "fColor = vec4(vec3(vN), 1.); }\n"}}
                            : shaded("vec3(count())", declarations);
    return draw(
        "WindowSize 1 1\nLookAt 0 0 5 0 0 0 0 1 0\nVertex v.vert\nFragment f.frag\nProgram P uOne 1 " +
            of.tags + "\nQuadXY 0 10\n",
        files);
}

TEST(LongLoops, AreReportedExactlyWhereTheDriverEndsThem) {
    const Counting cases[] = {
        {"for (int i = 0; i < uN; ++i) n += uOne;", "uN 60000", 60'000},
        // After 65,535 rounds the driver does not ask the condition again, which may have held or not.
        {"for (int i = 0; i < uN; ++i) n += uOne;", "uN 65534", 65'534},
        {"for (int i = 0; i < uN; ++i) n += uOne;", "uN 65536", 65'536},
        {"for (int i = 0; i < uN; ++i) n += uOne;", "uN 100000", 100'000},
        {"for (int i = 0; i < 100000; ++i) n += uOne;", "", 100'000},
        {"const int kMost = 50000; for (int i = 2 * kMost; i >= 1; i--) n += uOne;", "", 100'000},
        {"int i = 0; while (i < uN) { n += uOne; i++; }", "uN 65534", 65'534},
        {"int i = 0; while (i < uN) { n += uOne; i++; }", "uN 65536", 65'536},
        {"int i = uN; while (i-- > 0) n += uOne;", "uN 65534", 65'534},
        {"int i = uN; while (i-- > 0) n += uOne;", "uN 70000", 70'000},
        {"for (float t = 0.; t < 1.; t += uStep) n += uOne;", "uStep .0000078125", 128'000, 100},
        {"for (int i = 0; i < uN; ++i) for (int j = 0; j < uM; ++j) n += uOne;", "uN 300 uM 300", 90'000},
        {"for (int i = 0; i < uN; ++i) for (int j = 0; j < uM; ++j) n += uOne;", "uN 200 uM 200", 40'000},
        {"for (int i = 0; i < uN; ++i) n += uOne; for (int i = 0; i < uM; ++i) n += uOne;",
         "uN 60000 uM 60000", 120'000},
        // Sixteen rounds that the compiler unrolls do not count.
        {"for (int i = 0; i < uN; ++i) for (int j = 0; j < 16; ++j) n += uOne;", "uN 5000", 80'000},
    };
    for (const Counting& each : cases)
        for (const bool inVertexStage : {false, true}) {
            const FloatPicture picture = counted(each, inVertexStage);
            ASSERT_EQ(picture.width, 1);
            const float seen = picture.at(0, 0)[0];
            const auto expected = static_cast<float>(each.rounds);
            EXPECT_LE(seen, expected + static_cast<float>(each.slack)) << each.body;
            const bool isShort = seen < expected - static_cast<float>(each.slack);
            EXPECT_EQ(has(picture.diagnostics, "draw-W08"), isShort)
                << each.body << " " << each.tags << ": " << seen << "\n"
                << text(picture.diagnostics);
        }
}

TEST(LongLoops, AreReportedWithTheirLine) {
    const FloatPicture picture =
        counted({"\n  for (int i = 0; i < uN; ++i) n += uOne;", "uN 1000000", 0}, false);
    for (const Diagnostic& each : picture.diagnostics) {
        if (each.id != "draw-W08") continue;
        EXPECT_TRUE(each.place.file.ends_with("f.frag")) << each.place.file;
        EXPECT_EQ(each.place.line, 12);
        EXPECT_EQ(each.place.column, 3);
        EXPECT_NE(each.text.find("1,000,000 rounds"), std::string::npos) << each.text;
    }
}

}  // namespace
}  // namespace glibra::stress
