// The catalogue (language, 10), and that the parser's messages equal its examples.

#include "glib/diagnostic_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "scene.h"

namespace glibra::glib::test {
namespace {

/// "glsl-E01": a family in small letters, a severity, two digits.
bool looksLikeId(std::string_view text) {
    const std::size_t dash = text.find('-');
    if (dash == 0 || dash == std::string_view::npos || text.size() != dash + 4) return false;
    const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    return std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(dash), isSmall) &&
           std::string_view("EWN").find(text[dash + 1]) != std::string_view::npos &&
           isDigit(text[dash + 2]) && isDigit(text[dash + 3]);
}

TEST(Catalogue, HoldsEveryIdOnceWithAnExample) {
    std::set<std::string_view> ids;
    for (const CatalogueRow& row : diagnosticCatalogue()) {
        EXPECT_TRUE(ids.insert(row.id).second) << row.id;
        EXPECT_FALSE(row.example.empty()) << row.id;
    }
    EXPECT_FALSE(ids.empty());
}

TEST(Catalogue, TheLetterOfAnIdIsItsSeverity) {
    EXPECT_EQ(findDiagnostic("glib-E05")->severity(), Severity::error);
    EXPECT_EQ(findDiagnostic("result-W01")->severity(), Severity::warning);
    EXPECT_EQ(findDiagnostic("draw-N02")->severity(), Severity::note);
    EXPECT_EQ(diagnose("suite-W01", "text").severity, Severity::warning);
    for (const CatalogueRow& row : diagnosticCatalogue()) EXPECT_TRUE(looksLikeId(row.id)) << row.id;
}

TEST(Catalogue, NumbersOfEachFamilyHaveNoGaps) {
    std::map<std::string_view, int> counts;  // by "glib-E"
    for (const CatalogueRow& row : diagnosticCatalogue()) {
        const std::size_t length = row.id.size() - 2;
        EXPECT_EQ(std::stoi(std::string(row.id.substr(length))), ++counts[row.id.substr(0, length)])
            << row.id;
    }
}

TEST(Catalogue, HoldsEveryIdThatTheSourcesGive) {
    std::set<std::string> given;
    for (const auto& each : std::filesystem::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/src")) {
        if (each.path().extension() != ".cpp" && each.path().extension() != ".h") continue;
        std::ifstream file(each.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        for (std::size_t begin = 0, end = 0; end < text.size(); begin = end + 1) {
            end = std::min(text.find('"', begin), text.size());
            const std::string piece = text.substr(begin, end - begin);
            if (looksLikeId(piece)) given.insert(piece);
        }
    }
    EXPECT_GT(given.size(), 100U);
    for (const std::string& each : given)
        EXPECT_TRUE(findDiagnostic(each)) << each << ": add a row to src/glib/diagnostic_catalogue.cpp";
}

TEST(Catalogue, FindsAnId) {
    ASSERT_TRUE(findDiagnostic("file-W02"));
    EXPECT_EQ(findDiagnostic("file-W02")->example,
              "'C:\\models\\cow.obj' found as 'cow.obj' beside the scene");
    EXPECT_FALSE(findDiagnostic("glib-W99"));
}

struct Example {
    const char* id;
    std::string scene;
};

class ParserExample : public testing::TestWithParam<Example> {};

TEST_P(ParserExample, IsPrintedAsTheCatalogueSays) {
    const CatalogueRow* row = findDiagnostic(GetParam().id);
    ASSERT_TRUE(row);
    EXPECT_EQ(messageOf(GetParam().scene, GetParam().id), row->example);
    for (const Diagnostic& each : read(GetParam().scene).diagnostics) {
        if (each.id == GetParam().id) {
            EXPECT_EQ(each.severity, row->severity());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ParserExample,
    testing::Values(
        Example{"glib-E01", "Spere 1"}, Example{"glib-E02", "Obj \"cow.obj"},
        Example{"glib-E03", std::string(512, '\n') + std::string(1, '\0')},
        Example{"glib-E04", "LookAt 0 0 5 0 0 0"}, Example{"glib-E05", "Perspective 190"},
        Example{"glib-E08", "glBegin gl_hexagons"}, Example{"glib-E10", "Program Lighting {\n}"},
        Example{"glib-E12", "Texture2D 200 a.bmp"}, Example{"glib-E16", "State dpeth less"},
        Example{"glib-E17", "Fps"}, Example{"glib-E18", "Pass window\nEndPass 5"},
        Example{"glib-E19", "Step ten\nEndStep"}, Example{"glib-E20", "Let a (sin(1)"},
        Example{"glib-E21", "EndPass"}, Example{"glib-E22", "Pass window\n\nGroup\nEndPass"},
        Example{"glib-E23", "Group\nTexture2D a b.bmp\nEndGroup"}, Example{"glib-E24", "Triangles [(a) 0 0]"},
        Example{"glib-W01", "Obj /cow.obj"}, Example{"glib-W02", "Program P \\ # x\n uA 1"},
        Example{"glib-W03", "Program P uA <0. .60, 1.>"}, Example{"glib-W04", "Program P uA <0.1. 1 2>"},
        Example{"glib-W05", "Translate 0 0 z"}, Example{"glib-W06", "Translate 1 2"},
        Example{"glib-W07", "Color 1 1 1 1 1"}, Example{"glib-W08", "Program P uA <0. 0. .5)"},
        Example{"glib-W09", "Program P uA <0 1 2 uKd 1"}, Example{"glib-W10", "Color [1 .5 0]"},
        Example{"glib-W11", "Program Magic\n uA 1"}, Example{"glib-W12", "Program P \\\n\n"},
        Example{"glib-W13", "Program P \\\nObj cow.obj"}, Example{"glib-W14", "Fragment cat.frag\nProgram"},
        Example{"glib-W15", "Program P uFreq <.1 1.5>"},
        Example{"glib-W16", "Program Final Project \\\n uA 1"}, Example{"glib-W17", "Program P uA 1 uKa"},
        Example{"glib-W18", "Program P uA 1 5"}, Example{"glib-W19", "Program P uTol 1 uTol 2"},
        Example{"glib-W26", "Color 1 .5 2."}, Example{"glib-W27", "Sphere 1 10.5"},
        Example{"glib-W28", "Sphere 1 2"}, Example{"glib-W29", "Ortho 0 0 -1 1"},
        Example{"glib-W35",
                "Sphere\xc2\xa0"
                "1"}),
    [](const testing::TestParamInfo<Example>& example) {
        std::string name = example.param.id;
        name.erase(name.find('-'), 1);
        return name;
    });

TEST(Catalogue, MessageHasTheFormOfTheLanguage) {
    const Script script = parse("\n\n\n\n\n\nSphere    0.1.", "sphere.glib");
    ASSERT_EQ(script.diagnostics.size(), 1U);
    EXPECT_EQ(toString(script.diagnostics[0]),
              "sphere.glib:7:11: warning: '0.1.' read as 0.1, '.' ignored [glib-W04]");
}

}  // namespace
}  // namespace glibra::glib::test
