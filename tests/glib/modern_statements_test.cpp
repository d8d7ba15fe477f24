// What modern statements become: values, keys, tags, names with parts, bodies; and their messages.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "glib/limits.h"
#include "scene.h"

namespace glibra::glib::test {
namespace {

using Kind = Value::Kind;

Command only(std::string_view text) {
    const Script script = read(text);
    for (const Diagnostic& each : script.diagnostics) ADD_FAILURE() << toString(each);
    return script.commands.empty() ? Command{} : script.commands.back();
}

std::string placedMessageOf(const std::string& text) {
    const Script script = read(text);
    std::string all;
    for (const Diagnostic& each : script.diagnostics)
        all += std::to_string(each.place.line) + ":" + std::to_string(each.place.column) + " " + each.id +
               " " + each.text;
    return all;
}

TEST(ModernValues, HaveKindsPlacesAndByteRanges) {
    const std::string text =
        "Set uA 1.5 uB (2 * (x + 1)) uC {1 0 .5} uD <0 (n) 2> uE [1 (a) 3] uF <true> \\\n uG name";
    const Command command = only(text);
    ASSERT_EQ(command.tags.size(), 7U);
    const auto value = [&](std::size_t i) { return command.tags.at(i).values.at(0); };
    EXPECT_EQ(value(0).kind, Kind::number);
    EXPECT_EQ(value(0).number, 1.5);
    EXPECT_EQ(value(1).kind, Kind::expression);
    EXPECT_EQ(value(1).text, "2 * (x + 1)");
    EXPECT_EQ(value(1).position, (Position{1, 15}));
    EXPECT_EQ(placeIn(value(1), 0), (Position{1, 16}));
    EXPECT_EQ(value(2).kind, Kind::color);
    EXPECT_EQ(value(2).items.at(2).number, .5);
    EXPECT_EQ(value(3).kind, Kind::range);
    EXPECT_EQ(value(3).items.at(1).text, "n");
    EXPECT_EQ(value(4).kind, Kind::list);
    EXPECT_EQ(value(4).items.at(2).kind, Kind::number);
    EXPECT_EQ(value(5).kind, Kind::truth);
    EXPECT_EQ(value(5).number, 1);
    EXPECT_EQ(value(6).position, (Position{2, 5}));
    for (std::size_t i = 0; i < 7; ++i) {
        const std::string source = text.substr(value(i).begin, value(i).end - value(i).begin);
        EXPECT_EQ(text.find(source, value(i).begin), value(i).begin);
        EXPECT_NE(source.front(), ' ');
        EXPECT_NE(source.back(), ' ');
    }
    EXPECT_EQ(text.substr(value(4).begin, value(4).end - value(4).begin), "[1 (a) 3]");
}

TEST(ModernValues, ListMayBeACountAndARule) {
    const Value list = only("Set uA [6 of (sin(i))]").tags.at(0).values.at(0);
    ASSERT_EQ(list.count.size(), 1U);
    EXPECT_EQ(list.count[0].number, 6);
    EXPECT_EQ(list.items.at(0).text, "sin(i)");
    EXPECT_EQ(only("Set uA [(n) of (i)]").tags.at(0).values.at(0).count.at(0).text, "n");
}

TEST(ModernNames, HavePartsAndSubscripts) {
    const Command pass =
        only("Pass slice[i - 1].level(2) glow.face((k)) from eye\nEndPass\nPass life.prev\nEndPass");
    const Command first = read("Pass slice[i - 1].level(2) glow.face(k)\nEndPass").commands.at(0);
    ASSERT_EQ(first.values.size(), 2U);
    const std::vector<NamePart>& path = first.values[0].path;
    ASSERT_EQ(path.size(), 2U);
    EXPECT_EQ(path[0].name, "slice");
    EXPECT_EQ(path[0].index.at(0).kind, Kind::expression);
    EXPECT_EQ(path[0].index.at(0).text, "i - 1");
    EXPECT_EQ(path[1].name, "level");
    EXPECT_EQ(path[1].index.at(0).text, "2");
    EXPECT_EQ(first.values[1].path.at(1).name, "face");
    EXPECT_EQ(pass.id, CommandId::endPass);
}

TEST(ModernNames, SubscriptOfATagNeedsAPointOrAValueAfterIt) {
    EXPECT_EQ(only("Set lights[2].position {1 2 3}").tags.at(0).key, "lights[2].position");
    EXPECT_EQ(only("Set lights[2].position {1 2 3}").tags.at(0).path.at(0).index.at(0).number, 2);
    EXPECT_EQ(only("Set uA[3] 5").tags.at(0).key, "uA[3]");
    EXPECT_EQ(only("Set uA[3] shadow").tags.at(0).key, "uA[3]");
    EXPECT_EQ(only("Set uA[3] shadow uB 5").tags.size(), 2U);
    const Command list = only("Set uA[3] uB 5");
    ASSERT_EQ(list.tags.size(), 2U);
    EXPECT_EQ(list.tags[0].key, "uA");
    EXPECT_EQ(list.tags[0].values.at(0).kind, Kind::list);
    EXPECT_EQ(only("Set uA[3]").tags.at(0).values.at(0).items.size(), 1U);
}

TEST(ModernNames, ArraysAreDeclaredWithACount) {
    const Command let = only("Let pose[6] (f(pose[i-1]))");
    EXPECT_EQ(let.values.at(0).path.at(0).index.at(0).number, 6);
    EXPECT_EQ(let.values.at(1).text, "f(pose[i-1])");
    EXPECT_EQ(only("Let weights[1 2 3]").values.at(1).items.size(), 3U);
    EXPECT_EQ(only("Camera slice[(n)] Shift eye (i) 0 0").values.at(0).path.at(0).index.at(0).text, "n");
}

TEST(ModernKeys, HaveTheValuesAfterThem) {
    const Command state =
        only("State blend.1 ONE one_minus_src_alpha Add alpha one zero stencil.back less 1 depth off");
    ASSERT_EQ(state.keys.size(), 4U);
    EXPECT_EQ(state.keys[0].key, "blend");
    EXPECT_EQ(state.keys[0].suffix, "1");
    EXPECT_EQ(state.keys[0].values.at(0).text, "one");
    EXPECT_EQ(state.keys[0].values.at(2).text, "add");
    EXPECT_EQ(state.keys[1].key, "alpha");
    EXPECT_EQ(state.keys[2].suffix, "back");
    EXPECT_EQ(state.key("depth")->values.at(0).text, "off");
    EXPECT_EQ(state.key("cull"), nullptr);
    const Command expect = only("Expect buffer sum at 3 [1 2] within .1 at 5");
    ASSERT_EQ(expect.keys.size(), 4U);
    EXPECT_EQ(expect.keys[1].values.size(), 2U);
    EXPECT_EQ(expect.keys[3].values.at(0).number, 5);
}

TEST(ModernKeys, WordMayBeAnExpression) {
    const Command state = only("State blend (op) depth (test)");
    EXPECT_EQ(state.keys.at(0).values.at(0).kind, Kind::expression);
    EXPECT_EQ(state.keys.at(1).values.at(0).text, "test");
}

TEST(ModernNumbers, OneExpressionMayFillSeveral) {
    EXPECT_EQ(only("Camera a LookAt (e) (c) 0 1 0 Ortho (box)").keys.at(0).values.size(), 5U);
    EXPECT_EQ(only("Dispatch P (groups)").values.size(), 2U);
    EXPECT_EQ(only("Texture2D t (window) rgba8 nearest").values.size(), 3U);
    EXPECT_EQ(placedMessageOf("Viewport (a) 0 0 1 1"), "1:20 glib-E18 Viewport: surplus argument '1'");
    EXPECT_EQ(placedMessageOf("Viewport 0 0 1"),
              "1:1 glib-E17 Viewport: expected number 4 of 4 (area), found the end of the statement");
}

TEST(ModernNames, MisspeltWordAfterSeveralIsNamed) {
    const std::string head = "Texture2D a 8 8 rgba8\nTexture2D b 8 8 rgba8\n";
    EXPECT_EQ(placedMessageOf(head + "Fill a b wiht Ramp"),
              "3:10 glib-E16 Fill: unknown word 'wiht'; did you mean 'with'?");
    EXPECT_EQ(placedMessageOf(head + "Fill a b"),
              "3:1 glib-E17 Fill: expected 'with', found the end of the statement");
}

TEST(ModernTextures, NameInPlaceOfAUnit) {
    EXPECT_EQ(only("Texture2D 6 512 512 RGBA8").id, CommandId::texture2D);
    EXPECT_EQ(only("Texture2D wood wood.bmp").id, CommandId::namedTexture2D);
    EXPECT_EQ(only("Texture2D wood \"my wood.bmp\" mipmap repeat clamp aniso 8").keys.size(), 4U);
    EXPECT_EQ(only("CubeMap sky a b c d e f linear").values.size(), 7U);
    EXPECT_EQ(only("CubeMap sky panorama.hdr").values.size(), 2U);
    EXPECT_EQ(only("CubeMap sky 256 rgba16f").values.size(), 3U);
    EXPECT_EQ(only("Texture2DArray maps 512 512 4 depth32f").id, CommandId::textureArray);
    EXPECT_EQ(only("Texture1DArray ramps 64 4 rgba8 linear").id, CommandId::textureArray1D);
    EXPECT_EQ(only("Texture1DArray ramps a.png b.png c.png").values.size(), 4U);
    EXPECT_EQ(only("TextureRect grid 64 32 r32f nearest border").id, CommandId::textureRect);
    EXPECT_EQ(placedMessageOf("Texture2D t a.bmp nearest linear"),
              "1:27 glib-E18 Texture2D: 'linear' contradicts 'nearest'");
    EXPECT_EQ(placedMessageOf("Texture2D t a.bmp aniso 1 aniso 2"),
              "1:27 glib-E18 Texture2D: 'aniso' given twice");
}

TEST(ModernProgram, NamesAndExpressionsAreTags) {
    const Command program =
        only("Texture2D wood w.bmp\nProgram Lit uWood wood uTime (time) uKd .5 uC {1 0 0} uR <0 1 2>");
    EXPECT_EQ(program.text(), "Lit");
    ASSERT_EQ(program.tags.size(), 2U);
    EXPECT_EQ(program.tags[0].values.at(0).path.at(0).name, "wood");
    ASSERT_EQ(program.uniforms.size(), 3U);
    EXPECT_EQ(program.uniforms[0].form, UniformForm::number);
    EXPECT_EQ(program.uniforms[1].form, UniformForm::color);
    EXPECT_EQ(program.uniforms[2].values, (std::vector<double>{0, 1, 2}));
}

TEST(ModernProgram, NameIsOneWordOnlyAfterADeclaration) {
    EXPECT_EQ(idsOf("Program Final Project uA 1"), Ids{"glib-W16"});
    EXPECT_EQ(placedMessageOf("Let a 1\nProgram Final Project 5 uA wood"), "");
    EXPECT_EQ(only("Let a 1\nProgram Final Project 5").uniforms.at(0).tag, "Project");
    EXPECT_EQ(placedMessageOf("Let a 1\nProgram P uA"),
              "2:1 glib-E17 Program: expected a value of 'uA', found the end of the statement");
}

TEST(ModernProgram, MessagesAboutValuesOnSeveralLinesAreOnOne) {
    EXPECT_EQ(placedMessageOf("Let a 1\nProgram P uA 5   \\\n      6"),
              "3:7 glib-E18 Program: surplus argument '6'; write uA [5 6]");
    EXPECT_EQ(placedMessageOf("Let a 1\nProgram P uA 5\t\\\r\n\t6  7"),
              "3:2 glib-E18 Program: surplus argument '6'; write uA [5 6  7]");
}

TEST(ModernProgram, ExpressionAloneMakesItModern) {
    const Script script = read("Program P uA (2*time) uB 1");
    EXPECT_TRUE(script.isModern);
    EXPECT_EQ(script.commands.at(0).tags.at(0).values.at(0).text, "2*time");
    EXPECT_EQ(script.commands.at(0).uniforms.at(0).tag, "uB");
}

TEST(ModernShaders, AreTakenRawUpToTheEndWord) {
    const Script script =
        read("Vertex inline\n#version 410\nvoid main() { gl_Position = vec4(0); } // (\n  endvertex \nBox 1");
    EXPECT_EQ(idsOf("Vertex inline\n\"(<[\n  endvertex \nBox 1"), Ids{});
    ASSERT_EQ(script.commands.size(), 2U);
    EXPECT_EQ(script.commands[0].id, CommandId::vertex);
    EXPECT_EQ(script.commands[0].body, "#version 410\nvoid main() { gl_Position = vec4(0); } // (\n");
    EXPECT_EQ(script.commands[0].bodyPosition, (Position{2, 1}));
    EXPECT_EQ(script.commands[1].position.line, 5);
    EXPECT_EQ(placedMessageOf("Compute inline\nEndVertex\n"),
              "1:1 glib-E22 'Compute inline' is closed by 'EndVertex' (line 2); write EndCompute");
    EXPECT_EQ(only("Compute inline\nEndCompute").body, "");
    EXPECT_EQ(only("Compute a.comp").text(), "a.comp");
}

TEST(ModernShaders, AMistakeInTheFirstLineIsReportedOnce) {
    const std::string shader = "\n#version 430\nout vec4 c;\nvoid main() { c = vec4(1.); }\n";
    const auto found = [&](const std::string& begin, const std::string& end) {
        return placedMessageOf("Let a 1\n" + begin + shader + end + "\nProgram P\n");
    };
    EXPECT_EQ(found("Fragmnet inline", "EndFragment"),
              "2:1 glib-E01 unknown command 'Fragmnet'; did you mean 'Fragment'?");
    EXPECT_EQ(found("Fragment", "EndFragment"),
              "2:1 glib-E17 Fragment: a shader follows; write 'Fragment inline'");
    EXPECT_EQ(found("Compute", "EndCompute"),
              "2:1 glib-E17 Compute: a shader follows; write 'Compute inline'");
}

TEST(ModernLines, GoOnOnlyAfterABackslash) {
    EXPECT_EQ(only("Set uA 1 \\\n  Color {1 0 0} \\\n  Box 5").tags.size(), 3U);
    EXPECT_EQ(idsOf("Set uA 1\n uB 2"), Ids{"glib-E01"});
    EXPECT_EQ(idsOf("Let a \\\n MessageBox"), Ids{"glib-E19"});
    EXPECT_EQ(idsOf("Let a 1 \\\n\nBox 1"), Ids{"glib-W12"});
    EXPECT_EQ(only("State cull back \\\n depth less").keys.size(), 2U);
}

TEST(ModernWords, AreSuggested) {
    EXPECT_EQ(placedMessageOf("Camrea eye"), "1:1 glib-E01 unknown command 'Camrea'; did you mean 'Camera'?");
    EXPECT_EQ(placedMessageOf("Pass window form eye\nEndPass"),
              "1:13 glib-E16 Pass: unknown word 'form'; did you mean 'from'?");
    EXPECT_EQ(placedMessageOf("Texture2D form 8 8 r8\nPass window form\nEndPass"), "");
    EXPECT_EQ(placedMessageOf("Include a.glib\nPass window form\nEndPass"), "");
}

TEST(ModernWords, AreHiddenByDeclaredNames) {
    EXPECT_EQ(placedMessageOf("Texture2D depth 8 8 depth24\nPass window depth clear depth .5\nEndPass"), "");
    EXPECT_EQ(placedMessageOf("Pass window depth\nEndPass"),
              "1:13 glib-E16 Pass: unknown word 'depth'; expected a name (targets), 'from', 'reversed', "
              "'clear' or 'keep'");
    EXPECT_EQ(placedMessageOf("Pass window clear {1 0 0} {0 1 0} keep depth stencil\nEndPass"), "");
    EXPECT_EQ(placedMessageOf("Include a.glib\nPass window clear depth .5\nEndPass"), "");
    EXPECT_EQ(placedMessageOf("Include a.glib\nPass window from left keep color\nEndPass"), "");
}

TEST(ModernValues, OfNamesStandInParentheses) {
    EXPECT_EQ(
        placedMessageOf("Let many 3\nInstances many"),
        "2:11 glib-E16 Instances: unknown word 'many'; expected 'from' or a number (count); write (many) for "
        "its value");
    EXPECT_EQ(
        placedMessageOf("Repeat [first last] as mode\nState provoking mode\nEndRepeat"),
        "2:17 glib-E16 State: unknown word 'mode'; expected 'first' or 'last'; write (mode) for its value");
    EXPECT_EQ(placedMessageOf("Camera side[6] Face i 0 0 0 1 9"),
              "1:21 glib-E19 Camera: expected a number (face), found 'i'; write (i) for its value");
    EXPECT_EQ(placedMessageOf("Let x 3\nTranslate 0 x 0"),
              "2:13 glib-E19 Translate: expected a number, found 'x'; write (x) for its value");
    EXPECT_EQ(placedMessageOf("Let x 3\nTranslate 0 y 0"), "2:13 glib-W05 'y' is not a number, 0 used");
    EXPECT_EQ(placedMessageOf("Let x 3\nTexture kept 256 256 rgba8"),
              "2:9 glib-W05 'kept' is not a number, 0 used; a texture with a name is declared by Texture2D "
              "NAME");
    EXPECT_EQ(placedMessageOf("Texture2D ? a.png"), "1:11 glib-W05 '?' is not a number, 0 used");
    EXPECT_EQ(placedMessageOf("Let speed 3\nWhen speed > 1\nEndWhen"),
              "2:6 glib-E19 When: expected a condition in parentheses, found 'speed'");
}

TEST(ModernDispatches, TakeOneToThreeCountsAndTags) {
    const Command one = only("Dispatch Sort 4 uStage 3 uLast <true>");
    EXPECT_EQ(one.values.size(), 2U);
    EXPECT_EQ(one.tags.size(), 2U);
    EXPECT_EQ(only("Dispatch Sort over (window) tiles 2 uStage 3").tags.size(), 1U);
    EXPECT_EQ(only("Dispatch Sort 1 2 3").values.size(), 4U);
}

TEST(ModernLimits, HaveMessages) {
    const std::string deep = "Let a (" + std::string(10'000, '(') + "1" + std::string(10'000, ')') + ")";
    EXPECT_EQ(placedMessageOf(deep), "1:7 glib-E15 expression of 20,001 bytes; the limit is 8,192");
    EXPECT_EQ(placedMessageOf("Let a (" + std::string(200, '(') + "1" + std::string(200, ')') + ")"),
              "1:7 glib-E15 parentheses 201 deep; the limit is 128");
    EXPECT_EQ(idsOf("Translate (" + std::string(200, '(') + "x" + std::string(200, ')') + ")"),
              Ids{"glib-E15"});
    EXPECT_EQ(idsOf("Let a (" + std::string(10'000, '(')), Ids{"glib-E20"});
    std::string many = "Buffer a float [";
    for (std::size_t i = 0; i <= kMostValues; ++i) many += i % 100 == 0 ? "1 \\\n" : "1 ";
    EXPECT_EQ(idsOf(many + "]"), Ids{"glib-E15"});
    std::string tags = "Set";
    for (std::size_t i = 0; i <= kMostTags; ++i) tags += " \\\n u" + std::to_string(i) + " 1";
    EXPECT_EQ(idsOf(tags), Ids{"glib-E15"});
    EXPECT_EQ(idsOf("Set uA 1e999"), Ids{"glib-E31"});
}

/// The ids and texts of all messages.
std::string messagesOf(std::string_view text) {
    std::string all;
    for (const Diagnostic& each : parse(text, "scene.glib").diagnostics)
        all += each.id + " " + each.text + "\n";
    return all;
}

TEST(Hints, ExpressionsWithoutParenthesesAreErrorsInModernScenesOnly) {
    EXPECT_EQ(messagesOf("Let n 3\nTranslate 2*k 0 0\n"),
              "glib-E19 Translate: expected a number, found '2*k'; write (2*k) for its value\n");
    EXPECT_EQ(messagesOf("Sphere n/3\nLet n 3\n"),
              "glib-E19 Sphere: expected a number, found 'n/3'; write (n/3) for its value\n")
        << "also before the first modern statement";
    EXPECT_EQ(messagesOf("Translate 2*k 0 0\n"), "glib-W04 '2*k' read as 2, '*k' ignored\n");
    EXPECT_EQ(messagesOf("Let n 3\nTranslate 1e-3 1.5f 0\n"), "glib-W04 '1.5f' read as 1.5, 'f' ignored\n");
    EXPECT_NE(messagesOf("Instances 2*n\n").find("write (2*n) for its value"), std::string::npos);
}

TEST(Hints, SayWhatToWriteInstead) {
    const auto says = [](std::string_view text, std::string_view hint) {
        const std::string all = messagesOf(text);
        EXPECT_NE(all.find(hint), std::string::npos) << all;
    };
    says("Let y 2 + 3\n", "surplus argument '+'; write (2 + 3) for its value");
    says("Pass window clear 0 0 0 1\nEndPass\n", "'0'; write {0 0 0 1}");
    says("Expect pixel 3 3 1 0 0\n", "'1'; write [1 0 0]");
    says("Expect count 5 [1 0 0]\n", "'5'; write [1 0 0] 5");
    says("Buffer b float 1\nExpect b [1]\n", "; write buffer b");
    says("Repeat 5 until k > 3\nEndRepeat\n", "Repeat: expected a condition in parentheses, found 'k'");
    says("State culling back\n", "did you mean 'cull'?");
    says("Repeat 2\nLet v 3\nEndRepeat\n", "move it out, or write (3), which may stand here");
}

TEST(ModernStates, WhereContradictsMark) {
    EXPECT_EQ(messagesOf("State mark 1 where 1\n"), "glib-E18 State: 'where' contradicts 'mark'\n");
    EXPECT_EQ(messagesOf("State mark 1 depth less\nState depth less where 1\n"), "");
}

TEST(ModernNames, MayBeTheWordInline) {
    EXPECT_EQ(messagesOf("Texture2D inline 4 4 rgba8\nBuffer b float 4\n"), "");
}

TEST(Hints, AShaderWithoutItsEndIsReportedOnce) {
    const std::string all = messagesOf(
        "Camera eye LookAt 0 1 4  0 0 0  0 1 0  Perspective 45 .1 50\nVertex inline\n#version 330\n"
        "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }\nFragment inline\n"
        "void main() {}\nEndFragment\nProgram P\nSphere\nSpere\n");
    EXPECT_EQ(all.find("glib-E22 'Vertex inline' is not closed"), 0U) << all;
    EXPECT_NE(all.find("glib-E01 unknown command 'Spere'"), std::string::npos) << "the rest is read: " << all;
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 2) << all;
}

}  // namespace
}  // namespace glibra::glib::test
