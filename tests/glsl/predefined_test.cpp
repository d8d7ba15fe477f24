// The macros that exist without #define, and #line, in every version, against glslangValidator -E.

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <string>
#include <vector>

#include "glsl/read/source.h"
#include "preprocessed.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

constexpr std::array<const char*, 27> kVersions = {"100",
                                                   "110",
                                                   "120",
                                                   "130",
                                                   "140",
                                                   "150",
                                                   "150 core",
                                                   "150 compatibility",
                                                   "330",
                                                   "330 core",
                                                   "330 compatibility",
                                                   "400",
                                                   "400 core",
                                                   "410",
                                                   "420",
                                                   "430",
                                                   "440",
                                                   "450",
                                                   "450 core",
                                                   "450 compatibility",
                                                   "460",
                                                   "460 core",
                                                   "460 compatibility",
                                                   "300 es",
                                                   "310 es",
                                                   "320 es",
                                                   "430 compatibility"};

std::string tested(const std::string& version, const std::vector<std::string>& names) {
    std::string text = "#version " + version + "\n";
    for (const std::string& name : names)
        text += "#ifdef " + name + "\ndefined_ " + name + "\n#endif\n#if defined(" + name + ") && !defined " +
                name + "x\nagain_\n#endif\n";
    return text;
}

TEST(Predefined, MacrosAreThoseOfTheVersion) {
    for (const std::string version : kVersions) {
        std::vector<std::string> names{"GL_ES", "GL_core_profile", "GL_es_profile",
                                       "GL_FRAGMENT_PRECISION_HIGH", "GL_NO_SUCH_macro"};
        // Language, 7.2: without a profile the names of the compatibility profile are there.
        const bool isOwnRule = version.find("es") == std::string::npos && version >= "150" &&
                               version.find(' ') == std::string::npos;
        if (isOwnRule)
            EXPECT_EQ((Tokens{"defined_", "1", "again_"}),
                      preprocessed(tested(version, {"GL_compatibility_profile"})).tokens);
        else
            names.emplace_back("GL_compatibility_profile");
        const std::string text = tested(version, names);
        EXPECT_EQ(glslangTokens(text), preprocessed(text).tokens) << text;
        // glslang knows the values of these, but #ifdef and defined() do not find them there.
        const Tokens values = glslangTokens("#version " + version + "\n\n__VERSION__\n__LINE__\n");
        EXPECT_EQ((Tokens{"defined_", values.at(0), "again_"}),
                  preprocessed(tested(version, {"__VERSION__"})).tokens);
        EXPECT_EQ((Tokens{"defined_", "3", "again_"}), preprocessed(tested(version, {"__LINE__"})).tokens);
        EXPECT_EQ("4", values.at(1));
    }
}

TEST(Predefined, WithoutVersionAllProfilesAreThere) {
    const Tokens tokens = preprocessed("GL_core_profile GL_compatibility_profile GL_ES __VERSION__").tokens;
    EXPECT_EQ((Tokens{"1", "1", "GL_ES", "330"}), tokens);
}

TEST(Predefined, ExtensionsThatAreAcceptedAreDefined) {
    const StageText stage;
    for (const std::string version : {"100", "110", "450", "320 es"})
        EXPECT_EQ((Tokens{"yes", "1", "GL_XYZ_foo"}),
                  preprocessed("#version " + version +
                               "\n#ifdef GL_ARB_texture_rectangle\nyes GL_ARB_texture_rectangle\n#endif\n"
                               "GL_XYZ_foo\n")
                      .tokens);
}

TEST(Predefined, LinesFollowTheDeclaredVersion) {
    for (const std::string version : kVersions) {
        const std::string text =
            "#version " + version +
            "\n__LINE__\n#define HERE __LINE__\nHERE HERE\n#line 40\n__LINE__ HERE\n"
            "#line 7\n\n__LINE__\n#if __LINE__ == 9\nnine\n#elif __LINE__ == 10\nten\n#endif\n";
        EXPECT_EQ(glslangTokens(text), preprocessed(text).tokens) << text;
    }
}

TEST(Predefined, FileIsTheNumberThatLineGives) {
    EXPECT_EQ(
        (Tokens{"0", "7", "7", "3"}),
        preprocessed("#version 330\n__FILE__\n#line 4 7\n__FILE__\n#line 9\n__FILE__\n#line 1 3\n__FILE__")
            .tokens);
}

TEST(Predefined, MacrosOfTheTargetAreOrdinaryNamesElsewhere) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nvoid main() { float GL_core_profile = .5; gl_FragColor = "
                        "vec4(GL_core_profile); }\n");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Predefined, TheyCannotBeDefinedAgain) {
    for (const char* line : {"#define __LINE__ 3", "#define __VERSION__ 450", "#undef __VERSION__",
                             "#undef GL_ES", "#define GL_foo", "#undef __FILE__", "#define defined 1"})
        EXPECT_EQ("glsl-E14", preprocessed(std::string("#version 330\n") + line + "\n").ids) << line;
    EXPECT_EQ("", preprocessed("#version 330\n#define GL_EXT_gpu_shader4 1\n").ids);
}

}  // namespace
}  // namespace glibra::glsl::test
