// The nesting of blocks: partners, what is not closed, what may not stand inside.

#include <gtest/gtest.h>

#include <string>

#include "glib/limits.h"
#include "scene.h"

namespace glibra::glib::test {
namespace {

/// "line:column id text", one message per line.
std::string messageLinesOf(const std::string& text) {
    std::string all;
    for (const Diagnostic& each : read(text).diagnostics)
        all += std::to_string(each.place.line) + ":" + std::to_string(each.place.column) + " " + each.id +
               " " + each.text + "\n";
    return all;
}

std::vector<std::size_t> partnersOf(const std::string& text) {
    std::vector<std::size_t> partners;
    const Script script = read(text);
    EXPECT_EQ(idsOf(script), Ids{});
    for (const Command& each : script.commands) partners.push_back(each.partner);
    return partners;
}

constexpr std::size_t kNo = Command::kNoPartner;

TEST(Blocks, KnowTheirEnds) {
    EXPECT_EQ(partnersOf("Group a\nRepeat 3\nBox 1\nEndRepeat\nEndGroup\nBox 2"),
              (std::vector<std::size_t>{4, 3, kNo, 1, 0, kNo}));
    EXPECT_EQ(partnersOf("When (a)\nBox 1\nElse\nBox 2\nEndWhen"),
              (std::vector<std::size_t>{2, kNo, 4, kNo, 0}));
    EXPECT_EQ(partnersOf("When 1\nEndWhen"), (std::vector<std::size_t>{1, 0}));
    EXPECT_EQ(partnersOf("When 1\nWhen 2\nElse\nEndWhen\nElse\nEndWhen"),
              (std::vector<std::size_t>{4, 2, 3, 1, 5, 0}));
}

TEST(Blocks, EndWithoutABeginningIsAnError) {
    EXPECT_EQ(messageLinesOf("Box 1\n  EndPass"), "2:3 glib-E21 EndPass without Pass\n");
    EXPECT_EQ(messageLinesOf("Else"), "1:1 glib-E21 Else without When\n");
    EXPECT_EQ(messageLinesOf("Repeat 3\nWhen 1\nBox 1\nEndRepeat\nEndWhen"),
              "2:1 glib-E22 When is not closed before EndRepeat (line 4); write EndWhen\n")
        << "ends that are exchanged are one mistake";
    EXPECT_EQ(messageLinesOf("Repeat 3\nWhen 1\nEndRepeat\nEndWhen\nEndWhen"),
              "2:1 glib-E22 When is not closed before EndRepeat (line 3); write EndWhen\n"
              "5:1 glib-E21 EndWhen without When\n");
    EXPECT_EQ(messageLinesOf("When 1\nElse\nElse\nEndWhen"), "3:1 glib-E21 a second Else in When (line 1)\n");
    EXPECT_EQ(messageLinesOf("When 1\nGroup\nElse\nEndWhen"),
              "2:1 glib-E22 Group is not closed before Else (line 3); write EndGroup\n");
}

TEST(Blocks, MissingEndIsReportedWhereTheBlockBegins) {
    EXPECT_EQ(messageLinesOf("Box 1\nGroup world\nBox 1"),
              "2:1 glib-E22 Group is not closed; write EndGroup\n");
    EXPECT_EQ(messageLinesOf("Pass window\nGroup\nBox 1\nEndPass\nBox 2"),
              "2:1 glib-E22 Group is not closed before EndPass (line 4); write EndGroup\n");
    EXPECT_EQ(messageLinesOf("Once\nEndOnce\nStep 5\nRepeat 2\nEndRepeat"),
              "3:1 glib-E22 Step is not closed; write EndStep\n");
}

TEST(Blocks, FaultyOnesAreLeftOutWhole) {
    EXPECT_EQ(wordsOf("Box 1\nRepeat two\nBox 2\nGroup\nEndGroup\nEndRepeat\nBox 3"),
              (std::vector<std::string>{"Box", "Box"}));
    EXPECT_EQ(messageLinesOf("Repeat two\nEndRepeat"),
              "1:8 glib-E19 Repeat: expected a number (count) or a list in [ ] (words), found 'two'\n");
    EXPECT_EQ(wordsOf("Box 1\nGroup a\nBox 2"), std::vector<std::string>{"Box"});
    EXPECT_EQ(wordsOf("Group a\nBox 2\nEndGroup 5\nBox 3"), std::vector<std::string>{"Box"});
}

TEST(Blocks, KeepDeclarationsOut) {
    for (const char* block : {"Group", "Repeat 2", "When 1", "Once", "Step 5"})
        for (const char* inside :
             {"Texture2D t 8 8 r8", "Buffer b float 6", "Sampler s nearest", "Vertex a.vert", "Program P",
              "Let a <0 1 2>", "Let a 5", "Compute a.comp", "Fragment inline\nEndFragment"}) {
            const std::string word = std::string(block).substr(0, std::string(block).find(' '));
            const std::string text = std::string(block) + "\n" + inside + "\nEnd" + word;
            EXPECT_EQ(idsOf(text), Ids{"glib-E23"}) << text;
            EXPECT_EQ(placeOf(text, "glib-E23"), "2:1") << text;
        }
    EXPECT_EQ(idsOf("Group\nLet a (b + 1)\nCamera c Shift eye 1 0 0\nEndGroup"), Ids{});
    EXPECT_EQ(idsOf("Pass window\nProgram P\nEndPass"), Ids{});
}

TEST(Blocks, HaveTheirPlaces) {
    EXPECT_EQ(messageLinesOf("Pass window\nPass window\nEndPass\nEndPass"),
              "2:1 glib-E23 Pass cannot stand inside Pass (line 1); move it out\n");
    EXPECT_EQ(messageLinesOf("Pass window\nSphere 1\nPass window\nEndPass"),
              "1:1 glib-E22 Pass is not closed; write EndPass before Pass (line 3)\n");
    EXPECT_EQ(idsOf("Pass window\nFill a with P\nEndPass"), Ids{"glib-E23"});
    EXPECT_EQ(idsOf("Repeat 2\nOnce\nEndOnce\nEndRepeat"), Ids{"glib-E23"});
    EXPECT_EQ(idsOf("Repeat 2 as i\nPass shadow.layer(i) from slice[i]\nEndPass\nEndRepeat"), Ids{});
    EXPECT_EQ(idsOf("glBegin points\nRepeat 100 as i\nglVertex (i) 0 0\nEndRepeat\nglEnd"), Ids{});
}

TEST(Blocks, AreNestedToALimit) {
    std::string fits, tooDeep;
    for (std::size_t i = 0; i < kDeepestBlocks; ++i) fits += "Group\n";
    for (std::size_t i = 0; i < kDeepestBlocks; ++i) fits += "EndGroup\n";
    EXPECT_EQ(idsOf(fits), Ids{});
    for (std::size_t i = 0; i < 90'000; ++i) tooDeep += "Group\n";
    for (std::size_t i = 0; i < 90'000; ++i) tooDeep += "EndGroup\n";
    EXPECT_EQ(idsOf(tooDeep), Ids{"glib-E15"});
    EXPECT_EQ(read(tooDeep).commands.size(), 2 * (kDeepestBlocks - 1));  // those around the innermost
}

}  // namespace
}  // namespace glibra::glib::test
