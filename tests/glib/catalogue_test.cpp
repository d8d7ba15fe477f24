// The catalogue (language, 10), and that the parser's messages equal its examples.

#include "glib/messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

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

TEST(Catalogue, HoldsEveryIdOnceWithAMeaningAndAnExample) {
    std::set<std::string_view> ids, meanings;
    for (const CatalogueRow& row : diagnosticCatalogue()) {
        EXPECT_TRUE(ids.insert(row.id).second) << row.id;
        EXPECT_TRUE(row.meaning.ends_with('.')) << row.id << ": a sentence is missing";
        EXPECT_TRUE(meanings.insert(row.meaning).second) << row.id << ": another id means the same";
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

/// The ids of messages that were removed, as "file-W08". Their numbers are not used again.
const std::set<std::string_view> kRemoved{};

TEST(Catalogue, NumbersOfEachFamilyHaveNoGaps) {
    std::set<std::string_view> all = kRemoved;
    for (const CatalogueRow& row : diagnosticCatalogue())
        EXPECT_TRUE(all.insert(row.id).second) << row.id << ": this id had another meaning";
    std::map<std::string_view, int> counts;  // by "glib-E"
    for (const std::string_view id : all) {
        const std::size_t length = id.size() - 2;
        EXPECT_EQ(std::stoi(std::string(id.substr(length))), ++counts[id.substr(0, length)])
            << id << ": an id before it is missing; one that was removed belongs to kRemoved";
    }
}

/// The ids that the texts of these folders name, with one file for each.
std::map<std::string, std::string> idsNamedIn(const std::vector<std::string>& folders) {
    std::map<std::string, std::string> ids;
    const auto isOfId = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-'; };
    for (const std::string& folder : folders)
        for (const auto& each :
             std::filesystem::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/" + folder)) {
            static const std::set<std::filesystem::path> kText{".cpp", ".h", ".md", ".glib", ".toml", ".py"};
            if (!kText.contains(each.path().extension()) || each.path().filename() == "catalogue_test.cpp")
                continue;
            std::ifstream file(each.path());
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            std::string family;
            std::size_t last = 0;  // the end of the last id
            for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
                while (begin < text.size() && !isOfId(text[begin])) ++begin;
                end = begin;
                while (end < text.size() && isOfId(text[end])) ++end;
                std::string word = text.substr(begin, end - begin);
                // "file-W03, W07, W08" are three of one family.
                constexpr std::size_t kFar = 16;
                if (word.size() == 3 && begin - last <= kFar) word.insert(0, family + "-");
                if (!looksLikeId(word)) continue;
                family = word.substr(0, word.find('-'));
                last = end;
                ids.emplace(word, each.path().string());
            }
        }
    return ids;
}

TEST(Catalogue, HoldsEveryIdThatIsNamedAnywhere) {
    const auto named = idsNamedIn({"src", "include", "docs", "tests", "glib", "scenes"});
    EXPECT_GT(named.size(), 100U);
    for (const auto& [id, file] : named)
        EXPECT_TRUE(findDiagnostic(id))
            << file << " names " << id << ", which has no row in src/glib/messages.txt";
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
        Example{"glib-E31", "Translate 1e39 0 0"}, Example{"glib-E37", "Let a []"},
        Example{"glib-W42", "Rotate 90 0 0 0"},
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
