// What the language server says about names: where they are declared and used, and other names for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "editor/declared_names.h"
#include "example_scenes.h"
#include "server_test.h"

namespace glibra::test {
namespace {

class SymbolTest : public ServerTest {
  protected:
    /// "flat.frag 2:13; " for the places of references.
    std::string places(const char* name, std::string_view text, std::string_view word,
                       std::size_t further = 0) {
        json parameters = at(name, text, word, further);
        parameters["context"] = {{"includeDeclaration", true}};
        std::vector<std::string> all;
        for (const json& each : ask("textDocument/references", parameters)) {
            const std::string file = each["uri"].get<std::string>();
            const json& start = each["range"]["start"];
            all.push_back(file.substr(file.rfind('/') + 1) + " " + start["line"].dump() + ":" +
                          start["character"].dump() + "; ");
        }
        std::ranges::sort(all);
        std::string joined;
        for (const std::string& each : all) joined += each;
        return joined;
    }
};

/// Renaming in files of a folder: what the scene and its shaders are afterwards.
class RenamingTest : public SymbolTest {
  protected:
    void SetUp() override { begin(); }
    /// The texts of the files that change, one after the other; or the error.
    std::string renamed(const char* name, std::string_view word, const char* to, std::size_t further = 0) {
        json parameters = at(name, textOf(folder_ / name), word, further);
        parameters["newName"] = to;
        const json answer = ask("textDocument/rename", parameters);
        if (answer.contains("error")) return answer["error"]["message"];
        std::string all;
        for (const auto& [file, edits] : answer["changes"].items()) {
            std::string text = textOf(editor::fileOf(file));
            const editor::TextLines lines(text);
            std::vector<std::pair<std::size_t, std::size_t>> places;
            for (const json& each : edits)
                places.emplace_back(lines.byte(editor::positionIn(each["range"]["start"])),
                                    lines.byte(editor::positionIn(each["range"]["end"])));
            std::ranges::sort(places, std::greater());
            std::string changed = text;
            for (const auto& [begin, end] : places) changed.replace(begin, end - begin, to);
            all += file.substr(file.rfind('/') + 1) + ":\n" + changed;
        }
        return all;
    }
    void openAs(const char* name, std::string_view text) {
        write(name, text);
        open(name, text);
    }
};

TEST_F(RenamingTest, FollowsANameWhereverTheSceneGivesItToShaders) {
    const std::string shader =
        "#version 330\nuniform vec4 uTint;\nin vec4 aOff;\nout vec4 c;\nconst int TAPS = 1;\n"
        "void main() { c = uTint * float(TAPS) + aOff; }\n";
    openAs("v.vert", shader);
    const std::string scene =
        "Let q 1\nVertex v.vert\nFragment v.vert\nProgram A const TAPS 9 uTint {1 0 0 1}\n"
        "Program B const int TAPS (q)\nSet uTint {0 1 0 1} uNot q\nAttribute aOff 1 2 3\n"
        "Fill window with A uNot q uTint {0 1 0 1}\nDispatch A over 64 64 uTint {1 0 0 1}\n";
    openAs("a.glib", scene);
    const auto count = [](const std::string& text, std::string_view word) {
        std::size_t found = 0;
        for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) ++found;
        return found;
    };
    for (const auto& [name, places] :
         {std::pair("uTint", 6U), std::pair("TAPS", 4U), std::pair("aOff", 3U)}) {
        const std::string from = renamed("v.vert", name, "N0");
        EXPECT_EQ(count(from, "N0"), places) << from;
        EXPECT_EQ(count(from, name), 0U) << from;
        EXPECT_EQ(renamed("a.glib", name, "N0"), from) << "from the scene";
    }
    EXPECT_EQ(renamed("a.glib", "Set uTint", "N0", 4), renamed("v.vert", "uTint", "N0"));
}

TEST_F(RenamingTest, FollowsAVariableOrTextureThatAUniformReadsByItsName) {
    openAs("f.frag",
           "#version 330\nuniform vec4 uTint;\nuniform sampler2D pic;\nout vec4 c;\n"
           "void main() { c = uTint * texture(pic, vec2(0.)); }\n");
    openAs("a.glib",
           "Let uTint {0 1 0 1}\nTexture2D pic 16 16 rgba8\nFragment f.frag\nProgram A\n"
           "Fill window with A\nPrint (uTint.r)\n");
    const std::string all =
        "a.glib:\nLet N {0 1 0 1}\nTexture2D pic 16 16 rgba8\nFragment f.frag\nProgram A\n"
        "Fill window with A\nPrint (N.r)\n"
        "f.frag:\n#version 330\nuniform vec4 N;\nuniform sampler2D pic;\nout vec4 c;\n"
        "void main() { c = N * texture(pic, vec2(0.)); }\n";
    EXPECT_EQ(renamed("a.glib", "uTint", "N"), all);
    EXPECT_EQ(renamed("f.frag", "uTint", "N"), all);
    EXPECT_NE(renamed("a.glib", "pic", "image").find("sampler2D image"), std::string::npos);
    EXPECT_EQ(renamed("a.glib", "pic", "image"), renamed("f.frag", "pic", "image"));
    for (const auto& [name, line] : {std::pair("a.glib", 1), std::pair("f.frag", 2)}) {
        const json place = ask("textDocument/definition", at(name, textOf(folder_ / name), "pic"));
        EXPECT_EQ(place["range"]["start"]["line"], line) << place.dump();
        EXPECT_EQ(place["uri"], uri(name));
    }
}

TEST_F(RenamingTest, SearchesFilesThatAreNotOpen) {
    write("lib.glsl", "vec4 half3(vec4 a) { return a * .5; }\n");
    const std::string shader =
        "#version 330\n#include \"lib.glsl\"\nuniform vec4 uTint;\nout vec4 c;\nvoid main() { c = "
        "half3(uTint); }\n";
    write("f.frag", shader);
    write("g.frag", shader);
    const std::string scene = "Let q 1\nFragment f.frag\nProgram A uTint {1 0 0 1}\nFill window with A\n";
    for (const char* each : {"a.glib", "b.glib", "c.glib", "d.glib", "e.glib"}) write(each, scene);
    write("z.glib", "Fragment g.frag\nProgram A uTint {1 0 0 1}\n");
    open("f.frag", shader);
    const std::string uniform = renamed("f.frag", "uTint", "N");
    for (const char* each : {"a.glib", "b.glib", "c.glib", "d.glib", "e.glib", "f.frag"})
        EXPECT_NE(uniform.find(each), std::string::npos) << each;
    EXPECT_EQ(uniform.find("g.frag:"), std::string::npos) << "no program has both";
    open("lib.glsl", textOf(folder_ / "lib.glsl"));
    const std::string function = renamed("lib.glsl", "half3", "N");
    for (const char* each : {"lib.glsl:", "f.frag:", "g.frag:"})
        EXPECT_NE(function.find(each), std::string::npos) << each;
    EXPECT_EQ(function.find(".glib:"), std::string::npos);
    EXPECT_EQ(places("f.frag", shader, "half3"), "f.frag 4:18; g.frag 4:18; lib.glsl 0:5; ");
}

TEST_F(RenamingTest, KeepsMembersOfBlocksAndStructuresTogether) {
    openAs("v.vert",
           "#version 330\nin vec4 aVertex;\nout Data { vec2 st; } vOut;\n"
           "void main() { vOut.st = aVertex.xy; gl_Position = aVertex; }\n");
    openAs("f.frag",
           "#version 330\nstruct Lamp { vec4 col; float k; };\nuniform Lamp uL[2];\n"
           "in Data { vec2 st; } vIn;\nout vec4 c;\n"
           "void main() { c = vec4(vIn.st.st, 0., 1.) * uL[1].k; }\n");
    openAs("a.glib", "Let q 1\nVertex v.vert\nFragment f.frag\nProgram A uL[1].k 1 uL[0].col {1 1 1 1}\n");
    const std::string block = renamed("f.frag", "st; }", "tex");
    EXPECT_NE(block.find("vec2 tex; } vOut;\nvoid main() { vOut.tex = "), std::string::npos) << block;
    EXPECT_NE(block.find("vIn.tex.st"), std::string::npos) << block;
    EXPECT_EQ(renamed("v.vert", "st; }", "tex"), block);
    const std::string member = renamed("f.frag", "k; }", "gain");
    EXPECT_NE(member.find("Program A uL[1].gain 1 uL[0].col"), std::string::npos) << member;
    EXPECT_NE(member.find("uL[1].gain; }"), std::string::npos) << member;
    EXPECT_EQ(renamed("a.glib", "k 1", "gain"), member);
    // The structure of a file that others include.
    openAs("lib.glsl", "struct Lamp { float k; };\n");
    openAs("g.frag",
           "#version 330\n#include \"lib.glsl\"\nuniform Lamp l;\nvoid main() { gl_FragDepth = l.k; }\n");
    EXPECT_EQ(renamed("lib.glsl", "k; }", "gain"),
              "'.k' in g.frag may be this member of 'Lamp' or another one");
}

TEST_F(RenamingTest, FollowsSubroutinesThatTheSceneChooses) {
    openAs("f.frag",
           "#version 410\nsubroutine float Shade();\nsubroutine(Shade) float phong() { return 1.; }\n"
           "subroutine uniform Shade uShade;\nvoid main() { gl_FragDepth = uShade(); }\n");
    openAs("a.glib",
           "Let mode <phong flat>\nFragment f.frag\nProgram A uShade phong\nProgram B uShade mode\n");
    const std::string all = renamed("f.frag", "phong", "N");
    EXPECT_NE(all.find("Let mode <N flat>\nFragment f.frag\nProgram A uShade N\n"), std::string::npos) << all;
    EXPECT_NE(all.find("float N() {"), std::string::npos) << all;
}

TEST_F(RenamingTest, TakesWholeNamesOfPrograms) {
    openAs("f.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n");
    for (const char* name : {"Gr\xc3\xbcn", "Grau-1", "\"My Prog\""}) {
        const std::string quote = name[0] == '"' ? "\"" : "";
        const auto scene = [](const std::string& as) {
            return "Let k 1\nFragment f.frag\nProgram " + as + " uK k\nUse " + as + "\nFill window with " +
                   as + "\n";
        };
        openAs("a.glib", scene(name));
        EXPECT_EQ(renamed("a.glib", "Use ", "Neu", 6), "a.glib:\n" + scene(quote + "Neu" + quote));
    }
    openAs("a.glib", "Fragment f.frag\nProgram Gr\xc3\xbcn\n");
    const json data =
        ask("textDocument/semanticTokens/full", {{"textDocument", {{"uri", uri("a.glib")}}}})["data"];
    EXPECT_EQ(std::vector<int>(data.begin(), data.begin() + 3), (std::vector<int>{1, 8, 4})) << data.dump();
}

TEST_F(RenamingTest, RefusesTheNameOfTheImplicitCounter) {
    openAs("a.glib", "Let i .9\nLet size 2\nRepeat 2\nSphere (i * .3 + size)\nEndRepeat\n");
    EXPECT_EQ(renamed("a.glib", "i .9", "N"), "'i' is also the counter of Repeat, arrays and [n of (...)]");
    EXPECT_EQ(renamed("a.glib", "size", "i"), renamed("a.glib", "i .9", "N"));
}

constexpr std::string_view kShader =
    "#version 330\n#define TWICE(x) (2. * (x))\nuniform float b;\nstruct S { float a; float b; };\n"
    "float f(float a) { return a; }\nfloat f(vec3 a) { return a.x; }\n"
    "void main() {\n    S s = S(1., b);\n    { float b = s.b; b += TWICE(b); }\n"
    "    gl_FragDepth = f(s.a) + f(vec3(b));\n}\n";

TEST_F(SymbolTest, FindsTheUsesOfANameInItsScope) {
    begin();
    open("y.frag", kShader);
    EXPECT_EQ(places("y.frag", kShader, "b;\n"), "y.frag 2:14; y.frag 7:16; y.frag 9:35; ");
    EXPECT_EQ(places("y.frag", kShader, "b += "), "y.frag 8:12; y.frag 8:21; y.frag 8:32; ");
    EXPECT_EQ(places("y.frag", kShader, "b; };"), "y.frag 3:26; y.frag 8:18; ");
    EXPECT_EQ(places("y.frag", kShader, "TWICE"), "y.frag 1:8; y.frag 8:26; ");
    EXPECT_EQ(places("y.frag", kShader, "S s ="), "y.frag 3:7; y.frag 7:10; y.frag 7:4; ");
    EXPECT_EQ(places("y.frag", kShader, "gl_FragDepth"), "");
    EXPECT_EQ(ask("textDocument/documentHighlight", at("y.frag", kShader, "b += ")).size(), 3U);
    const auto lineOf = [&](std::string_view word) {
        return ask("textDocument/definition", at("y.frag", kShader, word))["range"]["start"]["line"];
    };
    EXPECT_EQ(lineOf("f(s.a)"), 4);
    EXPECT_EQ(lineOf("f(vec3(b"), 5) << "the overload with this type";
}

TEST_F(SymbolTest, RenamesAUniformInItsProgramAlone) {
    write("other.frag", "#version 330\nuniform vec4 uTint;\nout vec4 c;\nvoid main() { c = uTint; }\n");
    const std::string scene =
        std::string(kScene) + "Fragment other.frag\nProgram Other uTint {0 0 1}\nSphere\n";
    begin();
    open("a.glib", scene);
    const std::string shader = textOf(folder_ / "flat.frag");
    open("flat.frag", shader);
    EXPECT_EQ(places("flat.frag", shader, "uTint"), "a.glib 2:13; flat.frag 2:13; flat.frag 4:29; ");
    json parameters = at("flat.frag", shader, "uTint");
    parameters["newName"] = "uColor";
    const json changes = ask("textDocument/rename", parameters)["changes"];
    EXPECT_EQ(changes.size(), 2U) << changes.dump();
    EXPECT_EQ(changes[uri("a.glib")][0]["newText"], "uColor");
    EXPECT_EQ(ask("textDocument/prepareRename", at("flat.frag", shader, "uTint"))["placeholder"], "uTint");
    for (const char* wrong : {"vec3", "2x", "a b", "", "gl_x"}) {
        parameters["newName"] = wrong;
        const json refused = ask("textDocument/rename", parameters);
        EXPECT_EQ(refused["error"]["code"], -32602) << wrong;
    }
    EXPECT_TRUE(ask("textDocument/prepareRename", at("flat.frag", shader, "vec4")).is_null());
}

TEST_F(SymbolTest, FollowsIncludesAndNamesOfTheScene) {
    begin();
    open("a.glib", kScene);
    const std::string shader = textOf(folder_ / "flat.frag");
    open("flat.frag", shader);
    EXPECT_EQ(places("flat.frag", shader, "shade(uT"), "flat.frag 4:23; shade.glsl 1:5; ");
    const std::string included = textOf(folder_ / "shade.glsl");
    open("shade.glsl", included);
    EXPECT_EQ(places("shade.glsl", included, "shade(vec4"), "flat.frag 4:23; shade.glsl 1:5; ");
    EXPECT_EQ(places("a.glib", kScene, "size)"), "a.glib 3:4; a.glib 4:5; ");
    EXPECT_EQ(places("a.glib", kScene, "uTint"), "a.glib 2:13; flat.frag 2:13; flat.frag 4:29; ");
    const json hint = ask("textDocument/signatureHelp", at("flat.frag", shader, "uTint)"));
    EXPECT_EQ(hint["signatures"][0]["label"], "vec4 shade(vec4 tint)");
    EXPECT_EQ(hint["signatures"][0]["parameters"][0]["label"], json({11, 20}));
}

TEST_F(SymbolTest, SaysWhatNamesAreAndWhichValuesTheyHave) {
    begin();
    open("a.glib", kScene);
    const std::string shader = textOf(folder_ / "flat.frag");
    open("flat.frag", shader);
    const json document = {{"textDocument", {{"uri", uri("flat.frag")}}}};
    // uTint in its declaration: a variable that cannot be changed.
    const json data = ask("textDocument/semanticTokens/full", document)["data"];
    EXPECT_EQ(std::vector<int>(data.begin(), data.begin() + 5), (std::vector<int>{2, 13, 5, 0, 3}));
    json whole = document;
    whole["range"] = {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 99}, {"character", 0}}}};
    const json hints = ask("textDocument/inlayHint", whole);
    ASSERT_EQ(hints.size(), 1U);
    EXPECT_EQ(hints[0]["label"], " = {1 0.5 0 1}");
    EXPECT_EQ(hints[0]["position"], json({{"line", 2}, {"character", 18}}));
    std::string names;
    for (const json& each : ask("workspace/symbol", {{"query", "sHa"}}))
        names += each["name"].get<std::string>();
    EXPECT_EQ(names, "shade");
}

TEST_F(SymbolTest, KnowsFunctionsOfExpressionsAndTheirParameters) {
    begin();
    const std::string scene =
        "Let x 2\nLet wave(x t) (x * t)\nLet other(x) (x + wave(x, 1))\nSphere (wave(x, 3))\n";
    open("a.glib", scene);
    EXPECT_EQ(places("a.glib", scene, "wave(x, 3"), "a.glib 1:4; a.glib 2:18; a.glib 3:8; ");
    EXPECT_EQ(places("a.glib", scene, "x t)"), "a.glib 1:15; a.glib 1:9; ") << "a parameter is of its body";
    EXPECT_EQ(places("a.glib", scene, "x, 3"), "a.glib 0:4; a.glib 3:13; ");
    const auto lineOf = [&](std::string_view word) {
        return ask("textDocument/definition", at("a.glib", scene, word))["range"]["start"]["line"];
    };
    EXPECT_EQ(lineOf("wave(x, 3"), 1);
    const json hint = ask("textDocument/signatureHelp", at("a.glib", scene, "3))"));
    ASSERT_EQ(hint["signatures"].size(), 1U);
    EXPECT_EQ(hint["signatures"][0]["label"], "wave(x, t)");
    const std::string hover = ask("textDocument/hover", at("a.glib", scene, "wave(x, 3")).dump();
    EXPECT_NE(hover.find("wave(x, t)"), std::string::npos) << hover;
    EXPECT_NE(hover.find("(x * t), line 2"), std::string::npos) << hover;
}

TEST_F(SymbolTest, FoldsBlocksCommentsAndShaders) {
    begin();
    const std::string scene =
        "Group tree\nBox\nEndGroup\nFragment inline\n#version 330\n/* of\ntwo */\nvoid main() {\n\n}\n"
        "EndFragment\n";
    open("a.glib", scene);
    std::string folds;
    for (const json& each : ask("textDocument/foldingRange", {{"textDocument", {{"uri", uri("a.glib")}}}}))
        folds += each["startLine"].dump() + "-" + each["endLine"].dump() + " ";
    EXPECT_EQ(folds, "0-1 3-9 5-6 7-8 ");
    folds.clear();
    std::string old = "glBegin points\nglVertex 0 0 0\nglEnd\nPushMatrix\nBox\nPopMatrix\n" + scene;
    std::ranges::replace(old, '\n', '\r');
    open("a.glib", old);
    for (const json& each : ask("textDocument/foldingRange", {{"textDocument", {{"uri", uri("a.glib")}}}}))
        folds += each["startLine"].dump() + "-" + each["endLine"].dump() + " ";
    EXPECT_EQ(folds, "0-1 3-4 6-7 9-15 11-12 13-14 ") << "with lone carriage returns";
}

TEST(NamesOfShader, SurvivesTextsThatAreNoShaders) {
    for (const char* text : {"", "#", "#define", "}}}}", "((((", "a.", ".a", "struct", "struct {",
                             "uniform B { float a", "#if\\\n\\", "void f(", "void f({", "for (int i = 0",
                             "/*", "\xff\xc3 a;", "\r\r\n\r", "float a[", "const const"}) {
        const editor::ShaderNames names = editor::namesOfShader(text);
        const std::size_t size = std::string_view(text).size();
        for (const editor::NameUse& each : names.uses) EXPECT_LE(each.place.end, size) << text;
        for (std::size_t i = 0; i < size; ++i) editor::membersAt(text, i, size);
    }
    std::string deep;
    for (int i = 0; i < 20000; ++i) deep += "{float a;(";
    EXPECT_FALSE(editor::namesOfShader("void f() {" + deep).names.empty());
}

}  // namespace
}  // namespace glibra::test
