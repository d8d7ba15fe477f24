// Which images and storage blocks a compute stage is known to write whole.

#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"
#include "whole_write_bodies.h"

namespace glibra::glsl::test {
namespace {

std::vector<WholeWrite> wholeWritesOf(const std::string& text) {
    const TranslatedProgram translated = translateStages({{Stage::compute, text}});
    EXPECT_FALSE(hasError(translated.diagnostics)) << ids(translated.diagnostics) << "\n" << text;
    return translated.wholeWrites;
}
bool writesWhole(const std::string& text, const std::string& name) {
    const std::vector<WholeWrite> all = wholeWritesOf(text);
    return std::any_of(all.begin(), all.end(), [&](const WholeWrite& each) { return each.name == name; });
}

TEST(WholeWrites, ImagesThatEachInvocationStoresTo) {
    for (const glibra::test::WholeWriteBody& each : glibra::test::kWholeWriteBodies)
        EXPECT_EQ(writesWhole(stageOf(each), "uOut"), each.isWhole) << each.before << "\n" << each.statements;
}

/// One statement more before or after, which changes nothing, or makes the writes uncertain.
TEST(WholeWrites, OneStatementMore) {
    struct More {
        const char* statement;
        bool isHarmless;
    };
    constexpr auto kMore = std::to_array<More>({{"if (uOne == 3) return;", false},
                                                {"{ if (uOne == 3) return; }", false},
                                                {"if (uOne == 3) { ; } else return;", false},
                                                {"for (;;) { if (uOne < 9) return; break; }", false},
                                                {"return;", false},
                                                {"if (uOne == 3) ;", true},
                                                {"for (int i = 0; i < 3; ++i) { if (i == 1) break; }", true},
                                                {"memoryBarrier();", true},
                                                {";", true}});
    for (const glibra::test::WholeWriteBody& each : glibra::test::kWholeWriteBodies)
        for (const More& more : kMore) {
            glibra::test::WholeWriteBody body = each;
            const std::string first = std::string(more.statement) + "\n" + each.statements;
            body.statements = first.c_str();
            EXPECT_EQ(writesWhole(stageOf(body), "uOut"), each.isWhole && more.isHarmless) << first;
            const std::string last = std::string(each.statements) + "\n" + more.statement;
            body.statements = last.c_str();
            EXPECT_EQ(writesWhole(stageOf(body), "uOut"), each.isWhole) << last;
        }
}

TEST(WholeWrites, WhatIsReadIsNotWhole) {
    const std::string head = "#version 430 core\nlayout(local_size_x = 8) in;\n";
    const std::string place = "ivec2 p = ivec2(gl_GlobalInvocationID.xy);";
    const std::string image = head + "layout(r32ui) uniform uimage2D uOut;\n";
    EXPECT_TRUE(writesWhole(image + "void main() { " + place + " imageStore(uOut, p, uvec4(1u)); }", "uOut"));
    EXPECT_FALSE(writesWhole(
        image + "void main() { " + place + " imageStore(uOut, p, imageLoad(uOut, p) + 1u); }", "uOut"));
    EXPECT_FALSE(writesWhole(
        image + "void main() { " + place + " imageStore(uOut, p, uvec4(1u)); imageAtomicAdd(uOut, p, 1u); }",
        "uOut"));
    EXPECT_FALSE(writesWhole(image + "uint at(ivec2 p) { return imageLoad(uOut, p).r; }\nvoid main() { " +
                                 place + " imageStore(uOut, p, uvec4(at(p.yx))); }",
                             "uOut"));
    EXPECT_FALSE(writesWhole(head + "layout(r32ui) uniform uimage2D uOut[2];\nvoid main() { " + place +
                                 " imageStore(uOut[0], p, uvec4(1u)); }",
                             "uOut"));
}

TEST(WholeWrites, PlacesHaveTheAxesOfTheImage) {
    struct Shape {
        const char* type;
        const char* place;
        int axes;  ///< 0: not known
    };
    for (const Shape& each :
         {Shape{"image1D", "int(gl_GlobalInvocationID.x)", 1},
          {"image1D", "int(gl_GlobalInvocationID)", 1},
          {"image1D", "int(gl_GlobalInvocationID.y)", 0},
          {"image1DArray", "ivec2(gl_GlobalInvocationID.xy)", 2},
          {"image2DArray", "ivec3(gl_GlobalInvocationID)", 3},
          {"image2DArray", "ivec3(gl_GlobalInvocationID.xy, 0)", 0},
          {"image2DArray", "ivec3(gl_GlobalInvocationID.xzy)", 0},
          {"image3D", "ivec3(gl_GlobalInvocationID.xyz)", 3},
          {"image3D", "ivec3(ivec2(gl_GlobalInvocationID.xy), gl_GlobalInvocationID.z)", 3},
          {"imageCube", "ivec3(gl_GlobalInvocationID)", 0},
          {"imageBuffer", "int(gl_GlobalInvocationID.x)", 0}}) {
        const std::vector<WholeWrite> all = wholeWritesOf(
            "#version 430 core\nlayout(local_size_x = 8) in;\nlayout(rgba8) writeonly uniform " +
            std::string(each.type) + " uOut;\nvoid main() { imageStore(uOut, " + each.place +
            ", vec4(1.)); }");
        ASSERT_EQ(all.size(), each.axes > 0 ? 1U : 0U) << each.type << each.place;
        EXPECT_EQ(all.empty() ? 0 : all.front().axes, each.axes) << each.type << each.place;
    }
}

TEST(WholeWrites, ArraysThatEachInvocationStoresTo) {
    struct Body {
        const char* statements;
        bool isWhole;
    };
    for (const Body& each : {
             Body{"next[gl_GlobalInvocationID.x] = last[gl_GlobalInvocationID.x] + 1.;", true},
             {"uint i = gl_GlobalInvocationID.x; if (i >= next.length()) return; next[i] = last[i];", true},
             {"int i = int(gl_GlobalInvocationID.x); if (i < last.length()) next[i] = last[i];", true},
             {"uint i = gl_GlobalInvocationID.x; if (i >= uCount) return; next[i] = last[i];", false},
             {"uint i = gl_GlobalInvocationID.x; next[i] += last[i];", false},
             {"uint i = gl_GlobalInvocationID.x; next[i].x = 1.;", false},
             {"uint i = gl_GlobalInvocationID.x; next[i] = last[i]; next[i].y = 2.;", false},
             {"uint i = gl_GlobalInvocationID.x; next[i] = next[i + 1u];", false},
             {"uint i = gl_GlobalInvocationID.x; next[i + 1u] = last[i];", false},
             {"uint i = gl_GlobalInvocationID.x; if (last[i].x > 0.) next[i] = last[i];", false},
             {"uint i = gl_GlobalInvocationID.x; if (next[i] == last[i]) return; next[i] = last[i];", false},
             {"uint i = gl_GlobalInvocationID.x; last[i].x > 0. ? next[i] = last[i] : last[i];", false},
         })
        EXPECT_EQ(writesWhole("#version 430 core\nlayout(local_size_x = 64) in;\nuniform uint uCount;\n"
                              "layout(std430) readonly buffer Last { vec4 last[]; };\n"
                              "layout(std430) buffer Next { vec4 next[]; };\nvoid main() { " +
                                  std::string(each.statements) + " }",
                              "Next"),
                  each.isWhole)
            << each.statements;
    // Of a block with more members, or with a fixed number of elements, other parts stay.
    for (const char* block : {"buffer Next { uint count; vec4 next[]; };", "buffer Next { vec4 next[8]; };",
                              "buffer Next { vec4 next[]; } own;"})
        EXPECT_FALSE(writesWhole("#version 430 core\nlayout(local_size_x = 64) in;\nlayout(std430) " +
                                     std::string(block) + "\nvoid main() { " +
                                     (std::string(block).ends_with("own;") ? "own." : "") +
                                     "next[gl_GlobalInvocationID.x] = vec4(1.); }",
                                 "Next"))
            << block;
}

/// Nested and long texts neither take long nor overflow the stack.
TEST(WholeWrites, HostileTextsGiveUp) {
    const std::string head =
        "#version 430 core\nlayout(local_size_x = 8) in;\n"
        "layout(r32ui) writeonly uniform uimage2D uOut;\nvoid main() {\n";
    const std::string store = "imageStore(uOut, ivec2(gl_GlobalInvocationID.xy), uvec4(1u));\n";
    const auto times = [](int count, const std::string& text) {
        std::string all;
        for (int i = 0; i < count; ++i) all += text;
        return all;
    };
    EXPECT_FALSE(writesWhole(
        head + times(5000, "if (gl_GlobalInvocationID.x == 1u) ") + "return;\n" + store + "}", "uOut"));
    EXPECT_FALSE(writesWhole(head + times(100, "{") + store + times(100, "}") + "}", "uOut"));
    EXPECT_FALSE(writesWhole(
        head + "int p0 = int(gl_GlobalInvocationID.x);\n" +
            [] {
                std::string chain;
                for (int i = 1; i < 200; ++i)
                    chain += "int p" + std::to_string(i) + " = p" + std::to_string(i - 1) + ";\n";
                return chain;
            }() +
            "imageStore(uOut, ivec2(p199, gl_GlobalInvocationID.y), uvec4(1u)); }",
        "uOut"));
}

}  // namespace
}  // namespace glibra::glsl::test
