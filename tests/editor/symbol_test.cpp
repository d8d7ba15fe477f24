// What the language server says about names: where they are declared and used, and other names for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

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
