#include "editor/reference.h"

#include <gtest/gtest.h>

#include <string>

namespace glibra::test {
namespace {

using editor::CallHint;

/// The first signature at the '|' of a text, with the argument in square brackets; the word alone is not
/// shown.
std::string hintAt(std::string text, bool isScene = false) {
    const std::size_t cursor = text.find('|');
    text.erase(cursor, 1);
    editor::CodeContext context;
    if (isScene) context.language = source::CodeLanguage::glib;
    const CallHint hint = editor::callAt(text, cursor, context);
    if (hint.word.empty()) return {};
    const editor::SignatureParts& first = hint.signatures.front();
    return first.before + (first.argument.empty() ? "" : "[" + first.argument + "]") + first.after;
}

TEST(CallHint, NamesTheArgumentThatIsWritten) {
    const std::string head = "#version 330\nvoid main() { float f = ";
    EXPECT_EQ(hintAt(head + "mix(|"), "T mix([T x], T y, T a)");
    EXPECT_EQ(hintAt(head + "mix(1., |"), "T mix(T x, [T y], T a)");
    EXPECT_EQ(hintAt(head + "mix(max(1., 2.), vec3(1, 2, 3)[2], |); }"), "T mix(T x, T y, [T a])");
    EXPECT_EQ(hintAt(head + "mix(1., max(|"), "T max([T x], T y)");
    EXPECT_EQ(hintAt(head + "mix(1., (2. + |"), "T mix(T x, [T y], T a)");
    EXPECT_EQ(hintAt(head + "mix(1.,\n      |"), "T mix(T x, [T y], T a)");
    EXPECT_EQ(hintAt("float shade(vec3 n, float r) { return r; }\nvoid main() { shade(vec3(1.), |"),
              "float shade(vec3 n, [float r])");
}

TEST(CallHint, ChoosesTheOverloadsThatHaveTheArgument) {
    const std::string text = "#version 330\nvoid main() { vec4 c = texture(uMap, vST, ";
    const editor::CodeContext context;
    const CallHint hint = editor::callAt(text, text.size(), context);
    ASSERT_EQ(hint.signatures.size(), 1U);
    EXPECT_EQ(hint.signatures[0].argument, "float bias");
}

TEST(CallHint, SaysNothingWhereNothingIsCalled) {
    for (const char* text : {"#version 330\nvoid main() { float f = |", "#version 330\nvoid main() { if (|",
                             "#version 330\nvoid main() { f = mix(1., 2., 3.); |", "// mix(|",
                             "void main() { mix(1., // 2|", "|"})
        EXPECT_EQ(hintAt(text), "") << text;
    EXPECT_EQ(hintAt("void main() { mix(1., // half (\n  |"), "T mix(T x, [T y], T a)");
}

TEST(CallHint, ShowsTheUsageOfACommandAndOfFunctionsInExpressions) {
    EXPECT_EQ(hintAt("Sphere |", true).find("Sphere [radius"), 0U) << hintAt("Sphere |", true);
    EXPECT_EQ(hintAt("Sphere 1 \\\n    2|", true).find("Sphere [radius"), 0U);
    EXPECT_EQ(hintAt("Spher|", true), "");
    EXPECT_EQ(hintAt("# Sphere |", true), "");
    EXPECT_NE(hintAt("Let x (mix(1, |", true).find("mix("), std::string::npos);
    EXPECT_NE(hintAt("Let x (mix(1, |", true).find('['), std::string::npos);
}

TEST(Reference, KnowsCommandsOnlyWhereAStatementBegins) {
    editor::CodeContext context;
    context.language = source::CodeLanguage::glib;
    context.names = {{"light", "variable", "a variable of the scene", {}, source::CodeLanguage::glib},
                     {"scale", "variable", "a variable of the scene", {}, source::CodeLanguage::glib}};
    const std::string text =
        "Let light 1\nLight 0 position (light) 0 0\nScale (scale.x)\nSphere (rotate(1, 1, 0, 0))\n";
    const auto entry = [&](const char* word, std::size_t further = 0) {
        return editor::referenceAt(text, text.find(word) + further, context);
    };
    EXPECT_EQ(entry("light 1").text, "a variable of the scene");
    EXPECT_EQ(entry("(light", 1).text, "a variable of the scene");
    EXPECT_EQ(entry("scale.x").text, "a variable of the scene");
    EXPECT_EQ(entry("Light 0").word, "Light");
    EXPECT_EQ(editor::referenceAt("Group box rad 1\nEndGroup\nDraw box\n", 31, context).code.front(),
              "Group box rad 1");
    EXPECT_EQ(entry("Scale").word, "Scale");
    EXPECT_EQ(entry("rotate").code.front().substr(0, 4), "mat4");
    EXPECT_EQ(editor::referenceOf("Scale", source::CodeLanguage::glib, context).word, "Scale");
}

}  // namespace
}  // namespace glibra::test
