// Which messages are removed beside others.

#include "render/consequences.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glibra::render {
namespace {

std::vector<std::string> kept(Diagnostics diagnostics, bool strict = false) {
    applyStrict(diagnostics, strict);
    std::vector<std::string> ids;
    for (const Diagnostic& each : diagnostics)
        ids.push_back(each.id + (each.severity == Severity::error ? " error" : ""));
    return ids;
}

Diagnostic at(int line, const char* id, const char* text = "") {
    return diagnose(id, text, {"a.glib", line, 1});
}

using Ids = std::vector<std::string>;

TEST(Consequences, OfASamplerThatIsNotSetConcernThatSamplerOnly) {
    const Diagnostics both{about(at(1, "glib-W37"), "first"), about(at(2, "draw-W02"), "first"),
                           about(at(3, "draw-W02"), "second"), at(4, "draw-W02")};
    Diagnostics left = both;
    applyStrict(left, false);
    ASSERT_EQ(left.size(), 3u);
    EXPECT_EQ(left[1].place.line, 3);
    EXPECT_EQ(left[2].place.line, 4);
}

TEST(Consequences, OfAnUnwrittenInputNeedAMisspelling) {
    EXPECT_EQ(kept({at(1, "glsl-W11"), at(2, "glib-W24")}), (Ids{"glsl-W11", "glib-W24"}));
    EXPECT_EQ(kept({about(at(1, "glsl-W11"), "vColour", "vColor"), at(2, "glib-W24")}), (Ids{"glsl-W11"}));
}

TEST(Consequences, OfAnyErrorAreUnwrittenTargets) {
    EXPECT_EQ(kept({at(1, "draw-W11"), at(2, "draw-W13")}), (Ids{"draw-W11", "draw-W13"}));
    EXPECT_EQ(kept({at(1, "draw-W11"), at(2, "draw-W13"), at(3, "glsl-E01")}), (Ids{"glsl-E01 error"}));
}

TEST(Consequences, OfFaultyStatementsAreWhatTheSceneLacks) {
    for (const char* cause : {"glib-E02", "expr-E01", "file-E01"})
        for (const char* id : {"glib-W23", "glib-W37", "glib-W38", "glib-W39", "draw-N04", "draw-W01",
                               "draw-W02", "draw-W16", "memory-E02"}) {
            EXPECT_EQ(kept({at(1, id), at(2, cause)}), (Ids{std::string(cause) + " error"})) << id;
            EXPECT_EQ(kept({at(1, id), at(2, "glsl-E01")}).size(), 2u) << id;
        }
}

TEST(Consequences, OfCommasAreOnTheLineOfTheError) {
    EXPECT_EQ(kept({at(1, "glib-W03"), at(2, "glib-W03"), at(2, "expr-E01")}),
              (Ids{"glib-W03", "expr-E01 error"}));
}

TEST(Consequences, OfADriverWithoutComputeAreItsPrograms) {
    EXPECT_EQ(kept({at(1, "glsl-E12"), at(2, "memory-E01")}), (Ids{"memory-E01 error"}));
    EXPECT_EQ(kept({at(1, "glsl-E12")}), (Ids{"glsl-E12 error"}));
}

TEST(Consequences, StayOnceTheyAreErrorsByStrict) {
    Diagnostics shown{at(1, "draw-W11")};
    applyStrict(shown, true);
    shown.push_back(at(2, "glsl-E01"));
    EXPECT_EQ(kept(shown, true), (Ids{"draw-W11 error", "glsl-E01 error"}));
}

TEST(Repeats, AreOfOnePlaceAndText) {
    EXPECT_EQ(
        kept({at(1, "glib-W04", "a"), at(1, "glib-W04", "a"), at(1, "glib-W04", "b"), at(2, "glib-W04", "a")})
            .size(),
        3u);
}

}  // namespace
}  // namespace glibra::render
