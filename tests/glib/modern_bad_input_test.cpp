// Every modern statement with every kind of wrong argument, made from the rows of the table: each gives
// exactly one error, at the right place.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "modern_syntax.h"
#include "scene.h"

namespace glibra::glib::test {
namespace {

/// The one message of the scene; a message without text if there are more or fewer.
Diagnostic onlyMessage(const std::string& text) {
    const Script script = read(text);
    std::string all;
    for (const Diagnostic& each : script.diagnostics) all += toString(each) + "\n";
    EXPECT_EQ(script.diagnostics.size(), 1U) << text << all;
    return script.diagnostics.size() == 1 ? script.diagnostics.front() : Diagnostic{};
}

/// A text that no argument of this node can be.
std::string wrongFor(const Sample& sample) {
    const SyntaxNode& node = *sample.node;
    const bool takesRanges = (node.kind == SyntaxNode::Kind::pairs && !sample.isTag) ||
                             (node.kind == SyntaxNode::Kind::value &&
                              (node.type == ValueType::any || node.type == ValueType::constant));
    return takesRanges ? "\"text\"" : "<0 1 2>";
}

/// The word with one letter changed.
std::string misspelt(std::string word) {
    char& letter = word[std::min<std::size_t>(word.size() - 1, 2)];
    letter = letter == 'q' ? 'j' : 'q';
    return word;
}

class EachStatement : public testing::TestWithParam<const StatementRow*> {
  protected:
    static std::vector<Samples> samples() { return samplesOf(syntaxOf(*GetParam()).root); }

    static void expectAt(const Diagnostic& message, const SampleScene& scene, int column,
                         const std::string& text) {
        EXPECT_EQ(message.place.line, scene.line) << text;
        EXPECT_EQ(message.place.column, column) << text << message.text;
        EXPECT_EQ(message.severity, Severity::error) << text;
    }
};

TEST_P(EachStatement, IsReadInAllItsForms) {
    std::set<std::string> seen;
    for (const Samples& each : samples()) {
        const SampleScene scene = sceneOf(*GetParam(), each);
        const Script script = read(scene.text);
        for (const Diagnostic& message : script.diagnostics) ADD_FAILURE() << scene.text << toString(message);
        EXPECT_TRUE(script.isModern) << scene.text;
        const auto found = std::find_if(
            script.commands.begin(), script.commands.end(),
            [&](const Command& c) { return c.id == GetParam()->id && c.position.line == scene.line; });
        ASSERT_NE(found, script.commands.end()) << scene.text;
        EXPECT_TRUE(found->isModern) << scene.text;
        for (const KeyedValues& key : found->keys) seen.insert(key.key);
    }
    for (const std::string& key : syntaxOf(*GetParam()).keys) EXPECT_TRUE(seen.contains(key)) << key;
}

TEST_P(EachStatement, WithoutArgumentsSaysWhatIsMissing) {
    const StatementRow& row = *GetParam();
    if (row.sharesWord()) return;  // the classic form
    const std::vector<Samples> all = samples();
    const bool mayBeEmpty =
        std::any_of(all.begin(), all.end(), [](const Samples& each) { return each.empty(); });
    const SampleScene scene = sceneOf(row, {});
    if (mayBeEmpty) {
        EXPECT_EQ(idsOf(scene.text), Ids{}) << scene.text;
        return;
    }
    const Diagnostic message = onlyMessage(scene.text);
    EXPECT_EQ(message.id, "glib-E17") << scene.text;
    expectAt(message, scene, 1, scene.text);
}

TEST_P(EachStatement, ReportsASurplusArgument) {
    for (Samples each : samples()) {
        const bool takesFile = GetParam()->id == CommandId::buffer && each.back().text != "history" &&
                               each.back().node->type == ValueType::number;
        if (each.empty() && GetParam()->sharesWord()) continue;
        // A file may stand after the shape of a mesh.
        const bool isMesh = GetParam()->id == CommandId::mesh && each.size() == 2;
        const std::string surplus = takesFile || isMesh ? "{1 1 1}" : "\"surplus\"";
        each.push_back({surplus, nullptr});
        const SampleScene scene = sceneOf(*GetParam(), each);
        const Diagnostic message = onlyMessage(scene.text);
        expectAt(message, scene, scene.columns.back(), scene.text);
        EXPECT_NE(message.text.find(surplus), std::string::npos) << message.text;
    }
}

TEST_P(EachStatement, SuggestsTheKeyThatWasMeant) {
    for (const Samples& good : samples())
        for (std::size_t i = 0; i < good.size(); ++i) {
            const SyntaxNode& node = *good[i].node;
            const bool isWord = node.kind == SyntaxNode::Kind::key ||
                                (node.kind == SyntaxNode::Kind::value && node.type == ValueType::oneOf);
            const std::string word = good[i].text.substr(0, good[i].text.find('.'));
            if (!isWord || GetParam()->sharesWord()) continue;
            Samples bad = good;
            bad[i].text = misspelt(word);
            const SampleScene scene = sceneOf(*GetParam(), bad);
            // Among tags, the program decides whether the word is one.
            const Script script = read(scene.text);
            const auto isTag = [&](const KeyedValues& tag) { return tag.resembles == word; };
            if (std::any_of(script.commands.begin(), script.commands.end(), [&](const Command& each) {
                    return std::any_of(each.tags.begin(), each.tags.end(), isTag);
                }))
                continue;
            const Diagnostic message = onlyMessage(scene.text);
            if (word.size() < 3) {
                EXPECT_EQ(message.place.line, scene.line) << scene.text;
                continue;
            }
            expectAt(message, scene, scene.columns[i], scene.text);
            EXPECT_EQ(message.id, "glib-E16") << scene.text;
            // Another mask, such as rg, may be as near as the one that was meant.
            const std::string meant = word.starts_with("rg") || word.ends_with("b") || word.ends_with("ba")
                                          ? "did you mean"
                                          : "'" + word + "'";
            EXPECT_NE(message.text.find(meant), std::string::npos) << scene.text << message.text;
        }
}

TEST_P(EachStatement, ReportsAnArgumentOfTheWrongKind) {
    for (const Samples& good : samples())
        for (std::size_t i = 0; i < good.size(); ++i) {
            if (i == 0 && GetParam()->sharesWord()) continue;  // the classic form
            Samples bad = good;
            bad[i].text = wrongFor(good[i]);
            const SampleScene scene = sceneOf(*GetParam(), bad);
            expectAt(onlyMessage(scene.text), scene, scene.columns[i], scene.text);
        }
}

TEST_P(EachStatement, ReportsBracketsThatAreNotClosed) {
    if (GetParam()->sharesWord()) return;
    for (const auto& [bracket, id] :
         std::vector<std::pair<const char*, const char*>>{{"(", "glib-E20"},
                                                          {"[", "glib-E20"},
                                                          {"{", "glib-E20"},
                                                          {"<", "glib-E20"},
                                                          {"(1 + (2)", "glib-E20"},
                                                          {")", "glib-E20"},
                                                          {"]", "glib-E20"},
                                                          {"[1 [2]]", "glib-E20"},
                                                          {"()", "glib-E37"},
                                                          {"[]", "glib-E37"},
                                                          {"[1 of 2 3]", "glib-E37"}}) {
        const SampleScene scene = sceneOf(*GetParam(), {{bracket, nullptr}});
        const Diagnostic message = onlyMessage(scene.text);
        EXPECT_EQ(message.id, id) << scene.text;
        EXPECT_EQ(message.place.line, scene.line) << scene.text;
    }
}

TEST_P(EachStatement, IsPrintedSoThatItIsReadAgain) {
    for (const Samples& each : samples()) {
        const SampleScene scene = sceneOf(*GetParam(), each);
        const Script script = read(scene.text);
        std::string again;
        for (const Command& command : script.commands) again += written(command) + "\n";
        std::string twice;
        for (const Command& command : read(again).commands) twice += written(command) + "\n";
        EXPECT_EQ(again, twice) << scene.text;
        EXPECT_EQ(idsOf(again), Ids{}) << again;
    }
}

std::vector<const StatementRow*> allRows() {
    std::vector<const StatementRow*> rows;
    for (const StatementRow& row : statementTable())
        if (row.id != CommandId::program) rows.push_back(&row);  // modern only after a declaration
    return rows;
}

INSTANTIATE_TEST_SUITE_P(Table, EachStatement, testing::ValuesIn(allRows()),
                         [](const testing::TestParamInfo<const StatementRow*>& row) {
                             return std::string(row.param->name);
                         });

}  // namespace
}  // namespace glibra::glib::test
