// One mistake in the words of each compiler: the line, the hint and the consequences are the same.

#include <gtest/gtest.h>

#include "glsl/emit/log.h"
#include "glsl/emit/log_line.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

/// A program whose fragment stage reads `difuse`, which is a misspelt name, and `vN`, which the vertex stage
/// delivers.
TranslatedProgram loggedProgram() {
    return translateStages(
        {{Stage::vertex,
          "#version 330\nout vec3 vN;\nvoid main() { vN = vec3(1.); gl_Position = vec4(1.); }\n"},
         {Stage::fragment,
          "#version 330\nuniform vec4 diffuse;\nout vec4 fColor;\nvoid main() {\n"
          "    fColor = difuse;\n    fColor.rgb = vN;\n    fColor = glow(diffuse) + vec3(1.);\n}\n"}});
}

struct LogSample {
    const char* compiler;
    const char* undeclared;  ///< @ stands for the line and % for the name
    const char* function;    ///< of a function that nobody declares; null: it says the same as of a variable
    const char* types;       ///< of vec4 + vec3
    const char* syntax;
};
constexpr LogSample kLogSamples[] = {
    {"Mesa", "0:@(14): error: `%' undeclared", "0:@(14): error: no function with name '%'",
     "0:@(14): error: vector size mismatch for arithmetic operator",
     "0:@(5): error: syntax error, unexpected '}', expecting ',' or ';'"},
    {"NVIDIA", "0(@) : error C1008: undefined variable \"%\"", nullptr,
     "0(@) : error C1020: invalid operands to \"+\"",
     "0(@) : error C0000: syntax error, unexpected '}', expecting ',' or ';' at token \"}\""},
    {"AMD", "ERROR: 0:@: '%' : undeclared identifier ",
     "ERROR: 0:@: '%' : no matching overloaded function found ",
     "ERROR: 0:@: '+' :  wrong operand types  no operation '+' exists that takes a left-hand operand of type "
     "'vec4' and a right operand of type 'vec3'",
     "ERROR: 0:@: '}' : syntax error syntax error"},
    {"fglrx", "ERROR: 0:@: error(#143) Undeclared identifier: %", nullptr,
     "ERROR: 0:@: error(#162) Wrong operand types: no operation \"+\" exists that takes a left-hand operand "
     "of type \"vec4\" and a right operand of type \"vec3\" (and there is no acceptable conversion)",
     "ERROR: 0:@: error(#132) Syntax error: \"}\" parse error"},
    {"Intel", "ERROR: 0:@: '%' : undeclared identifier ",
     "ERROR: 0:@: '%' : no matching overloaded function found ",
     "ERROR: 0:@: '+' :  wrong operand types  no operation '+' exists that takes a left-hand operand of type "
     "'vec4' and a right operand of type 'vec3' (or there is no acceptable conversion)",
     "ERROR: 0:@: '}' : syntax error parse error"},
    {"Apple", "ERROR: 0:@: Use of undeclared identifier '%'",
     "ERROR: 0:@: Invalid call of undeclared identifier '%'",
     "ERROR: 0:@: Invalid operands to binary expression, incompatible types ('vec4' and 'vec3')",
     "ERROR: 0:@: '}' : syntax error: syntax error"},
    {"glslang", "ERROR: 0:@: '%' : undeclared identifier ",
     "ERROR: 0:@: '%' : no matching overloaded function found ",
     "ERROR: 0:@: '+' :  wrong operand types: no operation '+' exists that takes a left-hand operand of type "
     "'vec4' and a right operand of type 'vec3' (or there is no acceptable conversion)",
     "ERROR: 0:@: '' :  syntax error, unexpected RIGHT_BRACE, expecting COMMA or SEMICOLON"},
};

std::string filledLog(std::string text, int line, const std::string& name) {
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@'))
        text.replace(at, 1, std::to_string(line));
    for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%'))
        text.replace(at, 1, name);
    return text + "\n";
}

Diagnostics explainLogged(const std::string& log) {
    const TranslatedProgram translated = loggedProgram();
    return explainCompileLog(translated, translated.stages.at(1), log);
}

TEST(LogSamples, AMisspeltNameIsSuggestedInTheLineOfTheUser) {
    for (const LogSample& each : kLogSamples) {
        const Diagnostics found =
            explainLogged(filledLog(each.undeclared, 5, "difuse") + filledLog(each.undeclared, 5, "difuse"));
        ASSERT_EQ(2U, found.size()) << each.compiler;  // once, and the note about the program
        EXPECT_EQ(5, found[0].place.line) << each.compiler;
        EXPECT_TRUE(found[0].text.ends_with("; did you mean 'diffuse'?")) << found[0].text;
        EXPECT_EQ("difuse", undeclaredName(found[0].text)) << each.compiler;
    }
}

TEST(LogSamples, AnInputOfTheStageBeforeIsNamed) {
    for (const LogSample& each : kLogSamples)
        EXPECT_TRUE(explainLogged(filledLog(each.undeclared, 6, "vN"))
                        .at(0)
                        .text.ends_with("; declare 'in vec3 vN;' in this stage"))
            << each.compiler;
}

TEST(LogSamples, AnUnknownFunctionIsSuggested) {
    for (const LogSample& each : kLogSamples)
        EXPECT_TRUE(explainLogged(filledLog(each.function ? each.function : each.undeclared, 7, "lerp"))
                        .at(0)
                        .text.ends_with("; did you mean 'mix'?"))
            << each.compiler;
}

TEST(LogSamples, TypesThatDoNotFitAreNamed) {
    for (const LogSample& each : kLogSamples) {
        EXPECT_TRUE(isAboutTypes(each.types)) << each.compiler;
        EXPECT_EQ("", undeclaredName(each.types)) << each.compiler;
    }
}

TEST(LogSamples, SyntaxErrorsNameTheToken) {
    const std::string source = "#version 330\nout vec4 fColor;\nvoid main() {\n    fColor = vec4(1.)\n}\n";
    const TranslatedProgram translated = translateSingle(Stage::fragment, source);
    for (const LogSample& each : kLogSamples) {
        EXPECT_TRUE(isSyntaxError(each.syntax)) << each.compiler;
        const Diagnostics found =
            explainCompileLog(translated, translated.stages.at(0), filledLog(each.syntax, 5, ""));
        EXPECT_TRUE(found.at(0).place.line == 4 || found.at(0).place.line == 5) << each.compiler;
        EXPECT_EQ("glsl-E01", found.at(0).id) << each.compiler;
    }
}

TEST(LogSamples, OtherMessagesNameNothing) {
    for (const char* const text : {"too many arguments", "'x' : redefinition",
                                   "initializer of const variable `a' must be a constant expression",
                                   "array index out of range \"3\""}) {
        EXPECT_EQ("", undeclaredName(text)) << text;
        EXPECT_FALSE(isAboutTypes(text)) << text;
    }
}

}  // namespace
}  // namespace glibra::glsl::test
