#include "editor/completion.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>

#include "editor/declared_names.h"
#include "editor/glsl_reference.h"
#include "editor/reference.h"
#include "glib/syntax.h"

namespace glibra::test {
namespace {

using editor::CodeContext;
using editor::Completion;
using source::CodeLanguage;

/// The completions at the '|' of a text.
std::vector<Completion> at(std::string text, const CodeContext& context = {}) {
    const std::size_t cursor = text.find('|');
    text.erase(cursor, 1);
    return editor::completionsAt(text, cursor, context);
}

const Completion* find(const std::vector<Completion>& all, std::string_view word) {
    const auto found = std::ranges::find(all, word, &Completion::word);
    return found == all.end() ? nullptr : &*found;
}

CodeContext scene() {
    CodeContext context;
    context.language = CodeLanguage::glib;
    return context;
}

TEST(Completion, ProposesWhatTheShaderDeclaresFirst) {
    const std::string shader =
        "#version 330\n#define SHARP 2\nuniform float uShare, uKa; in vec3 vNormal[3];\nstruct Light { vec3 "
        "color; };\n"
        "float shade(vec3 n, float r) { float shadow = 1.; return sh|";
    const auto words = at(shader);
    ASSERT_GE(words.size(), 2U);
    EXPECT_EQ(words[0].word, "shade");
    EXPECT_EQ(words[0].type, "float shade(vec3 n, float r)");
    EXPECT_EQ(words[1].word, "shadow");
    EXPECT_EQ(words[1].type, "float");
    EXPECT_TRUE(find(words, "SHARP")) << "in any case";
    ASSERT_TRUE(find(at("#version 330\nin vec3 vNormal[3];\nvN|"), "vNormal"));
    EXPECT_EQ(find(at("#version 330\nin vec3 vNormal[3];\nvN|"), "vNormal")->type, "vec3[3]");
    EXPECT_TRUE(find(at("struct Light { vec3 color; };\nLi|"), "Light"));
}

TEST(Completion, ShowsTypesOfTheNamesThatGlibraSupplies) {
    const auto matrices = at("#version 330\nvoid main() { uModelV|");
    ASSERT_TRUE(find(matrices, "uModelViewMatrix"));
    EXPECT_EQ(find(matrices, "uModelViewMatrix")->type, "mat4");
    EXPECT_EQ(find(at("Ti|"), "Timer")->type, "float");
    CodeContext vertex, fragment;
    vertex.stage = glsl::Stage::vertex;
    fragment.stage = glsl::Stage::fragment;
    EXPECT_TRUE(find(at("aVer|", vertex), "aVertex"));
    EXPECT_FALSE(find(at("aVer|", fragment), "aVertex")) << "an input of the vertex stage";
}

TEST(Completion, KnowsTheWordsOfTheVersionAndTheStage) {
    EXPECT_TRUE(find(at("#version 120\ntexture2|"), "texture2D"));
    EXPECT_FALSE(find(at("#version 330\ntexture2|"), "texture2D"));
    EXPECT_FALSE(find(at("#version 120\ntexelF|"), "texelFetch"));
    EXPECT_EQ(find(at("#version 330\nsmoo|"), "smoothstep")->type, "T smoothstep(T low, T high, T x)");
    EXPECT_TRUE(find(at("#version 330\nunif|"), "uniform"));
    EXPECT_TRUE(find(at("#version 400\ndve|"), "dvec3"));
    EXPECT_FALSE(find(at("#version 330\ndve|"), "dvec3"));
    CodeContext fragment, vertex;
    fragment.stage = glsl::Stage::fragment;
    vertex.stage = glsl::Stage::vertex;
    EXPECT_TRUE(find(at("#version 330\ndFd|", fragment), "dFdx"));
    EXPECT_FALSE(find(at("#version 330\ndFd|", vertex), "dFdx"));
    EXPECT_TRUE(find(at("#version 330\ndisc|", fragment), "discard"));
    EXPECT_FALSE(find(at("#version 330\ndisc|", vertex), "discard"));
    EXPECT_TRUE(find(at("#version 330\ndisc|"), "discard")) << "the stage is not known";
    EXPECT_FALSE(find(at("#version 430\nshar|", fragment), "shared"));
}

TEST(Completion, ProposesOnlyWhatALayoutOrAPrecisionMayBe) {
    for (const char* each :
         {"layout(|", "layout (|", "layout(std430, |", "layout(location = 0, |", "layout(lo|"}) {
        const std::vector<Completion> all = at(std::string("#version 430\n") + each);
        EXPECT_TRUE(find(all, "location")) << each;
        EXPECT_FALSE(find(all, "gl_FragCoord") || find(all, "log")) << each;
    }
    for (const char* each : {"precision |", "precision  hi|"}) {
        const std::vector<Completion> all = at(std::string("#version 430\n") + each);
        EXPECT_TRUE(find(all, "highp")) << each;
        EXPECT_FALSE(find(all, "gl_FragCoord")) << each;
    }
    for (const char* each :
         {"layout(location = 0) in vec4 a; void main() { a = max(|", "layout(location = 0) |",
          "void main() { layouts(|", "|", "(|", "float f(float a, |"})
        EXPECT_FALSE(find(at(std::string("#version 430\n") + each), "std430")) << each;
}

TEST(Completion, KnowsTheStageThatASuffixSays) {
    using glsl::Stage;
    EXPECT_EQ(editor::stageOfFile("a/b.vert"), Stage::vertex);
    EXPECT_EQ(editor::stageOfFile("b.FRAG"), Stage::fragment);
    EXPECT_EQ(editor::stageOfFile("b.frag.glsl"), Stage::fragment);
    EXPECT_EQ(editor::stageOfFile("b.tcs"), Stage::tessControl);
    EXPECT_EQ(editor::stageOfFile("b.tese"), Stage::tessEvaluation);
    EXPECT_EQ(editor::stageOfFile("b.comp"), Stage::compute);
    for (const char* each : {"b.glsl", "frag", "b.frag.txt", ".frag", ""})
        EXPECT_FALSE(editor::stageOfFile(each)) << each;
}

TEST(Completion, ProposesNamesOfTheScene) {
    CodeContext context;
    context.names = {{"uOvalSize", "float", "a uniform of Ovals", ".25", CodeLanguage::glsl}};
    const auto words = at("#version 330\nvoid main() { float a = uOv|", context);
    ASSERT_TRUE(find(words, "uOvalSize"));
    EXPECT_EQ(find(words, "uOvalSize")->what, "a uniform of Ovals");
}

TEST(Completion, SaysNothingInCommentsNumbersAndAfterAPoint) {
    EXPECT_TRUE(at("// mi|").empty());
    EXPECT_TRUE(at("/* a\nmi| */").empty());
    EXPECT_FALSE(at("/* a */ mi|").empty());
    EXPECT_TRUE(at("float a = 1e|").empty());
    EXPECT_TRUE(at("v.mi|").empty());
    EXPECT_TRUE(at("uniform float uOnlyThis; uOnlyThis|").empty()) << "it stands there already";
    for (const char* each : {"# Sph|", "Sphere (1) // (si|", "MessageBox (si|", "Sphere 1 //a|"})
        EXPECT_TRUE(at(each, scene()).empty()) << each;
}

TEST(Completion, ProposesCommandsAndStatementsAtTheBeginningOfALine) {
    const auto words = at("WindowSize 300 300\n  Sph|", scene());
    ASSERT_TRUE(find(words, "Sphere"));
    EXPECT_EQ(find(words, "Sphere")->type, "command");
    EXPECT_FALSE(find(words, "Sphere")->what.empty());
    EXPECT_TRUE(find(at("EndPa|", scene()), "EndPass"));
    EXPECT_FALSE(find(at("Sphere Sph|", scene()), "Sphere"));
}

TEST(Completion, ProposesKeysOfTheStatementAndDeclaredNames) {
    EXPECT_TRUE(find(at("Camera eye LookAt 0 0 5 0 0 0 0 1 0 Persp|", scene()), "Perspective"));
    EXPECT_TRUE(find(at("Texture2D glow 64 64 rgba8 lin|", scene()), "linear"));
    EXPECT_TRUE(find(at("Texture2D glow 64 64 rgba8 \\\n    lin|", scene()), "linear")) << "over two lines";
    EXPECT_EQ(find(at("Texture2D glow 64 64 rgba8\nPass into gl|", scene()), "glow")->type, "Texture2D");
    EXPECT_TRUE(find(at("Let size <.2 .5 1>\nSphere (si|", scene()), "size"));
    EXPECT_EQ(find(at("Sphere (smo|", scene()), "smoothstep")->word, "smoothstep");
    EXPECT_TRUE(find(at("Sphere (ti|", scene()), "time"));
}

TEST(Completion, ProposesPartsOfTheNameBeforeAPoint) {
    const auto wordsAfter = [](const std::string& typed) {
        std::string all;
        for (const Completion& each : at("Texture2D glow 8 8 rgba8\nCubeMap sky 8 rgba8\nBuffer p vec4 "
                                         "9\nCamera sun LookAt 0 0 5  0 0 "
                                         "0  0 1 0  Perspective 50 1 9\n" +
                                             typed + "|",
                                         scene()))
            all += each.word + " ";
        return all;
    };
    EXPECT_EQ(wordsAfter("Expect finite glow."), "layer level prev size r g b a ");
    EXPECT_EQ(wordsAfter("Expect finite sky.face(+x)."), "face layer level prev size r g b a ");
    EXPECT_EQ(wordsAfter("Expect (sum(p."), "count prev ");
    EXPECT_EQ(wordsAfter("Print window."), "r g b a ");
    EXPECT_EQ(wordsAfter("Expect (sum(sky.level(2).fa"), "face ");
    EXPECT_EQ(wordsAfter("MultMatrix (sun.viewP"), "viewProjection ");
    EXPECT_EQ(wordsAfter("Sphere ."), "");
    EXPECT_EQ(wordsAfter("Sphere nothing."), "");
    EXPECT_EQ(find(at("Buffer p vec4 9\nExpect (lar|", scene()), "largest")->type, "T largest(object)");
}

TEST(Completion, ProposesFormatsOfTexturesAndNoNamesAmongNumbers) {
    EXPECT_TRUE(find(at("Texture2D t 10 10 rg|", scene()), "rg16f"));
    EXPECT_TRUE(find(at("CubeMap t 10 r32|", scene()), "r32f"));
    const std::string declared = "Let size 2\nProgram Paint\n";
    EXPECT_FALSE(find(at(declared + "Sphere |", scene()), "size"));
    EXPECT_FALSE(find(at(declared + "Background P|", scene()), "Paint"));
    EXPECT_TRUE(find(at(declared + "Sphere (si|", scene()), "size"));
    EXPECT_TRUE(find(at(declared + "Use P|", scene()), "Paint"));
}

TEST(Completion, ProposesTheNamesThatMayStandThere) {
    CodeContext context = scene();
    context.names = {{"uTint", "vec4", {}, {}, CodeLanguage::glib},
                     {"uK", "uniform", {}, {}, CodeLanguage::glib},
                     {"vST", "vec2", {}, {}, CodeLanguage::glib, true},
                     {"wave", "wave(x)", {}, {}, CodeLanguage::glib}};
    const std::string declared =
        "Let mode <red green>\nLet size 1\nTexture2D pic 8 8 rgba8\nProgram Lit\nGroup ball rad 2 tint {1 0 "
        "0} "
        "far 3\nSphere (rad)\nEndGroup\n";
    const auto proposed = [&](const std::string& line, std::initializer_list<const char*> words,
                              std::initializer_list<const char*> others) {
        for (std::string text : {declared + line + "\nEndRepeat\n", declared + line + "\r"}) {
            if (text.ends_with('\r')) std::ranges::replace(text, '\n', '\r');
            const std::vector<Completion> all = at(text, context);
            for (const char* each : words) EXPECT_TRUE(find(all, each)) << line << " " << each;
            for (const char* each : others) EXPECT_FALSE(find(all, each)) << line << " " << each;
        }
    };
    proposed("Sphere (|", {"size", "wave", "pic", "time"}, {"uTint", "uK", "vST", "Lit", "ball", "rad", "i"});
    proposed("Repeat 3 as k\nSphere (|", {"k"}, {"i"});
    proposed("Repeat 3\nSphere (|", {"i"}, {"rad"});
    proposed("Group g r 1 s {1 1} u 2\nSphere (|", {"r", "s", "u"}, {"rad", "g"});
    proposed("Draw |", {"ball"}, {"Lit", "rad"});
    proposed("Draw ball |", {"rad", "tint", "far", "size"}, {"Lit", "r"});
    proposed("When (mode == |", {"red", "green"}, {});
    proposed("Use |", {"Lit"}, {"pic", "ball", "uTint", "size"});
    proposed("Fill |", {"window", "pic"}, {"Lit", "ball"});
    proposed("Fill window with |", {"Lit"}, {"pic", "ball"});
    proposed("Pass |", {"window", "pic"}, {"Lit"});
    proposed("Pass window from |", {"eye"}, {"Lit", "window"});
    proposed("Set |", {"uTint"}, {"Lit", "vST"});
    const auto whole = at("Program Gr\xc3\xbcn\nUse Gr\xc3\xbc|", context);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].word, "Gr\xc3\xbcn");
    EXPECT_EQ(whole[0].begin, std::string_view("Program Gr\xc3\xbcn\nUse ").size());
}

TEST(Completion, ProposesTheWordsOfEveryValueOfTheTables) {
    using glib::SyntaxNode, glib::ValueType;
    const auto offers = [](const glib::StatementRow& row) {
        const SyntaxNode* before = nullptr;
        (void)hasNode(row, [&](const SyntaxNode& each) {
            const SyntaxNode* const key = std::exchange(before, &each);
            std::string line = std::string(row.name) + " ";
            const auto arguments = argumentsOf(row);
            if (arguments.front()->text == "name") line += "a ";
            if (key && key->kind == SyntaxNode::Kind::key) line += key->text + " ";
            const auto words = at(line + "|", scene());
            const bool isOpen =
                each.type == ValueType::word || each.type == ValueType::key || each.type == ValueType::truth;
            EXPECT_TRUE(!isOpen || std::ranges::find(words, each.text, &Completion::type) != words.end())
                << line << each.text;
            for (const std::string& word : each.words) {
                const bool isSuffix = each.kind == SyntaxNode::Kind::key;
                const std::string typed = isSuffix ? std::string(row.name) + " " + each.text + "." : line;
                EXPECT_TRUE(find(at(typed + "|", scene()), word)) << typed << word;
                EXPECT_TRUE(find(at(typed + word.substr(0, word.size() - 1) + "|", scene()), word))
                    << typed << word;
            }
            return false;
        });
    };
    for (const glib::StatementRow& each : glib::statementTable())
        if (!argumentsOf(each).empty()) offers(each);
    for (const glib::StatementRow& each : glib::commandTable())
        if (!argumentsOf(each).empty()) offers(each);
    EXPECT_TRUE(find(at("Buffer b flo|", scene()), "float"));
    EXPECT_TRUE(find(at("Buffer b |", scene()), "vec3"));
    EXPECT_TRUE(find(at("Mesh m |", scene()), "Sphere"));
    EXPECT_TRUE(find(at("Mesh m Tea|", scene()), "Teapot"));
    EXPECT_TRUE(find(at("Attribute aT as tang|", scene()), "tangent"));
    EXPECT_FALSE(find(at("Attribute |", scene()), "tangent")) << "behind its key alone";
    EXPECT_TRUE(find(at("Material go|", scene()), "gold"));
    EXPECT_TRUE(find(at("Clamp |", scene()), "off"));
    EXPECT_TRUE(find(at("State stencil.|", scene()), "back"));
}

TEST(Completion, SpeaksGlslInShadersOfTheScene) {
    const std::string text =
        "Fragment inline\n#version 330\nuniform float uLocal;\nvoid main() { uLo| }\nEndFragment\nSphere 1\n";
    const auto words = at(text, scene());
    ASSERT_TRUE(find(words, "uLocal"));
    EXPECT_TRUE(find(at("Fragment inline\n#version 330\ndFd|\nEndFragment\n", scene()), "dFdx"));
    EXPECT_TRUE(find(at("Fragment inline\nvoid main() {}\nEndFragment\nSph|", scene()), "Sphere"));
    EXPECT_TRUE(find(at("Compute inline\nvoid main() {}\nEndC|", scene()), "EndCompute"));
    EXPECT_TRUE(find(at("Fragment a.frag\nSph|", scene()), "Sphere")) << "a file begins no shader";
}

TEST(DeclaredNames, ReadsIncompleteCode) {
    const auto names = editor::declaredNames(
        "uniform Block { mat4 m; } inst;\nvoid main( { vec3 n = vec3(1., 2., 3.), k; for (int i = 0");
    std::string all;
    for (const editor::DeclaredName& each : names) all += each.type + " " + each.name + "; ";
    EXPECT_EQ(all, "block Block; mat4 m; Block inst; void main; vec3 n; vec3 k; int i; ");
}

TEST(DeclaredNames, KnowsWhatIsAnInterface) {
    for (const editor::DeclaredName& each : editor::declaredNames(
             "uniform vec2 uA, uB; flat in int vC; float f(in vec3 n, out float r) { float x; }"))
        EXPECT_EQ(each.isInterface, each.name == "uA" || each.name == "uB" || each.name == "vC") << each.name;
}

TEST(GlslTable, HasEveryNameOnceWithItsOwnSignature) {
    std::vector<std::string_view> names;
    for (const editor::GlslRow& each : editor::glslTable()) {
        names.push_back(each.name);
        EXPECT_NE(each.signature.find(each.name), std::string_view::npos) << each.name;
        EXPECT_LT(each.since, each.until) << each.name;
        EXPECT_FALSE(each.summary.empty()) << each.name;
    }
    std::ranges::sort(names);
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(Reference, GivesTheEntryOfAWord) {
    const auto entry = editor::referenceOf("sphere", CodeLanguage::glib, {});
    EXPECT_EQ(entry.word, "Sphere");
    ASSERT_EQ(entry.code.size(), 1U);
    EXPECT_TRUE(entry.code[0].starts_with("Sphere [radius = 1]")) << entry.code[0];
    EXPECT_NE(entry.chapter.find("docs/language.md"), std::string::npos);
    EXPECT_EQ(editor::referenceOf("smoothstep", CodeLanguage::glsl, {}).code.at(0),
              "T smoothstep(T low, T high, T x)");
    EXPECT_EQ(editor::referenceOf("Timer", CodeLanguage::glsl, {}).code.at(0), "uniform float Timer");
    EXPECT_EQ(editor::referenceOf("aVertex", CodeLanguage::glsl, {}).code.at(0), "in vec4 aVertex");
    EXPECT_EQ(editor::referenceOf("EndPass", CodeLanguage::glib, {}).word, "EndPass");
}

TEST(Reference, SuggestsTheNearestWord) {
    const auto entry = editor::referenceOf("smothstep", CodeLanguage::glsl, {});
    EXPECT_TRUE(entry.word.empty());
    EXPECT_EQ(entry.text, "there is no entry for 'smothstep'; did you mean 'smoothstep'?");
}

TEST(Reference, ShowsTheDeclarationAndTheValueOfAName) {
    CodeContext context;
    context.names = {{"uKd", "float", "a uniform of P", "0.25", CodeLanguage::glsl}};
    const std::string text = "#version 330\nuniform float uKd;\nvoid main() { float a = uKd; }\n";
    const auto entry = editor::referenceAt(text, text.rfind("uKd") + 1, context);
    EXPECT_EQ(entry.word, "uKd");
    EXPECT_EQ(entry.code, std::vector<std::string>{"uniform float uKd"});
    EXPECT_EQ(entry.text, "declared in line 2");
    EXPECT_EQ(entry.value, "0.25");
    EXPECT_EQ(editor::referenceAt(text, text.find('{'), context).word, "");
}

TEST(NameNear, IsTheWordAtTheCursorOrTheLastNameBeforeItInTheLine) {
    const auto near = [](std::string_view marked) {
        std::string text(marked);
        const std::size_t at = text.find('|');
        text.erase(at, 1);
        const editor::TextRange range = editor::nameNear(text, at);
        return text.substr(range.begin, range.end - range.begin);
    };
    EXPECT_EQ(near("c = mi|x(a, b)"), "mix");
    EXPECT_EQ(near("c = mix(|"), "mix");
    EXPECT_EQ(near("c = mix( .5, 1|0."), "mix") << "numbers are no names";
    EXPECT_EQ(near("a;\n  |b"), "b");
    EXPECT_EQ(near("a;\n |"), "") << "the line above is not looked at";
    EXPECT_EQ(near("|"), "");
}

TEST(Completion, ProposesMembersAndSwizzlesAfterAPoint) {
    const std::string shader =
        "#version 330\nstruct Light { vec3 color; float power; };\nuniform Light uSun;\nin vec2 vPlace;\n"
        "void main() {\n    vec3 n = vec3(1.);\n    ";
    const auto labels = [&](const std::string& rest) {
        std::string all;
        for (const Completion& each : at(shader + rest)) all += each.word + " ";
        return all;
    };
    EXPECT_EQ(labels("uSun.|\n    n = n;\n}\n"), "color power ");
    EXPECT_EQ(labels("max(vPlace.|, 1.);\n}\n"), "xy x y rg r g st s t ");
    EXPECT_EQ(labels("n.xy|"), "xyz xy ") << "in the order of use";
    EXPECT_EQ(labels("uSun.color.r|;"), "rgb rg r ");
    EXPECT_EQ(labels("gl_in[0].gl_Po|"), "gl_Position gl_PointSize ");
    EXPECT_EQ(labels("1.|"), "");
    EXPECT_EQ(labels("noSuch.|"), "");
    // What a scene that uses the shader sets does not hide it.
    CodeContext used;
    used.names = {{"vNormal", "vec3", "out vec3 vNormal in a.vert", "", CodeLanguage::glsl},
                  {"uSun.color", "vec3", "a uniform of P", "1 0 0", CodeLanguage::glsl},
                  {"uLights[0].power", "float", "a uniform of P", "1", CodeLanguage::glsl}};
    EXPECT_TRUE(find(at(shader + "uSun.|\n}\n", used), "color"));
    EXPECT_TRUE(find(at(shader + "uSun.po|\n}\n", used), "power"));
}

TEST(Completion, OffersTheNamesThatMayStandThere) {
    CodeContext context = scene();
    context.names = {{"uAmbient", "float", "", "", CodeLanguage::glib},
                     {"aNormal", "vec3", "", "", CodeLanguage::glib, true},
                     {"fColor", "vec4", "", "", CodeLanguage::glib, true}};
    const std::string before = "Texture2D glow 8 8\nProgram Lit\nGroup ball\nSphere 1\nEndGroup\n";
    const auto labels = [&](const std::string& line) {
        std::set<std::string> all;
        for (const Completion& each : at(before + line + "\n", context)) all.insert(each.word);
        return all;
    };
    const auto program = labels("Program Other uAmbient .5 |");
    EXPECT_TRUE(program.contains("uAmbient") && program.contains("glow"));
    for (const char* each : {"aNormal", "fColor", "Lit", "ball"})
        EXPECT_FALSE(program.contains(each) || labels("Set |").contains(each)) << each;
    EXPECT_EQ(labels("Draw |"), std::set<std::string>{"ball"});
    EXPECT_TRUE(labels("Attribute |").contains("aNormal"));
    EXPECT_TRUE(labels("Include |").empty());
    EXPECT_FALSE(labels("Let a <0 |").contains("uAmbient"));
    EXPECT_TRUE(labels("Let a (|").contains("glow"));
}

TEST(Completion, ShowsTheNamesOfTheScopeAlone) {
    const std::string shader =
        "#version 330\nfloat f(float first) { float inner = 1.; return inner; }\nvoid main() { float outer = "
        "1.; ";
    EXPECT_FALSE(find(at(shader + "x = inn|"), "inner"));
    EXPECT_FALSE(find(at(shader + "x = fir|"), "first"));
    EXPECT_TRUE(find(at(shader + "x = out|"), "outer"));
    EXPECT_TRUE(find(at(shader + "for (int count = 0; cou|"), "count"));
    EXPECT_TRUE(at(shader + "float ou|").empty()) << "a new name";
    EXPECT_TRUE(at("#version 330\nuniform vec3 |").empty());
    EXPECT_TRUE(find(at("#version 330\nuniform v|"), "vec3"));
    EXPECT_FALSE(find(at("#version 330\nuniform mi|"), "mix")) << "a type is wanted";
}

TEST(Completion, KnowsTheLinesOfThePreprocessor) {
    EXPECT_TRUE(find(at("#ver|"), "version"));
    EXPECT_EQ(at("#version |").front().word, "330");
    EXPECT_TRUE(find(at("#version 3|"), "300 es"));
    EXPECT_TRUE(find(at("#version 330 |"), "core"));
    EXPECT_TRUE(find(at("#define FAST\n#ifdef FA|"), "FAST"));
    EXPECT_FALSE(find(at("float FASTER;\n#ifdef FA|"), "FASTER")) << "no macro";
}

TEST(Completion, ProposesFilesBesideTheScene) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("glibra-files-" + std::to_string(::getpid()));
    fs::create_directories(folder / "sub");
    for (const char* each :
         {"lit.vert", "lit.frag", "shade.glsl", "glow.png", "b.glib", "sub/deep.frag", ".lit.vert"})
        std::ofstream(folder / each) << "x";
    CodeContext context = scene();
    context.folders = {folder};
    const auto labels = [&](const std::string& text) {
        std::string all;
        for (const Completion& each : at(text, context)) all += each.word + " ";
        return all;
    };
    EXPECT_EQ(labels("Vertex |"), "lit.vert shade.glsl sub/ inline ");
    EXPECT_EQ(labels("Fragment lit.f|"), "lit.frag ");
    EXPECT_EQ(at("Fragment lit.f|", context).front().begin, 9U);
    EXPECT_EQ(labels("Fragment \"sub/|"), "sub/deep.frag ");
    EXPECT_EQ(labels("Obj gl|"), "glow.png ");
    EXPECT_EQ(labels("Include b|"), "b.glib ");
    EXPECT_TRUE(labels("Texture2D wide g|").starts_with("glow.png "));
    EXPECT_TRUE(labels("Texture2D wide 64 64 rgba8|").starts_with("rgba8"));
    EXPECT_EQ(labels("Texture2D wide 64 64 glo|"), "") << "after a size stands a format";
    EXPECT_TRUE(labels("Texture2D wide 64 64 rgba8 levels 3 ne|").starts_with("nearest "));
    EXPECT_EQ(labels("Texture2D 5 gl|"), "glow.png ") << "after a unit stands a file";
    CodeContext shader;
    shader.folders = {folder};
    EXPECT_EQ(at("#include \"sh|", shader).front().word, "shade.glsl");
    EXPECT_TRUE(at("#include \"../../../../../../../../proc/|", shader).size() <= 200U);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace glibra::test
