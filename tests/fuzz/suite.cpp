// Any bytes as a suite file.

#include <string>

#include "check.h"
#include "glib/messages.h"
#include "suite/file/selection.h"
#include "suite/file/suite_file.h"
#include "suite/options/option_table.h"
#include "text_mutator.h"

const glibra::fuzz::Grammar& glibra::fuzz::grammar() {
    static const Grammar kGrammar = [] {
        Grammar made;
        for (const suite::OptionRow& row : suite::optionTable()) {
            if (row.key.empty()) continue;
            made.words.emplace_back(row.key);
            for (const char* value : {"true", "5", "\"text\"", "[1, 2]", "{ uKd = 0.5 }", "0.25"})
                made.statements.push_back(std::string(row.key) + " = " + value);
        }
        for (const glib::CatalogueRow& row : glib::diagnosticCatalogue())
            made.words.push_back('"' + std::string(row.id) + '"');
        for (const char* word :
             {"true", "false", "inf", "nan", "[]", "{}", "[[1, 2], [3, 4]]", "\"\"", "'a'", "\"\"\"", "0x7f",
              "1979-05-27", "\"*.glib\"", "\"\\u0000\"", "a.b", "\"../x\""})
            made.words.emplace_back(word);
        made.statements.insert(
            made.statements.end(),
            {"[defaults]", "[[shot]]", "goldens = \"golden\"", "script = \"a.glib\"", "name = \"smooth\"",
             "script = [\"a.glib\", \"b.glib\"]", "except = \"c*.glib\"", "tags = [\"slow\", \"new\"]",
             "sweep = { uTol = [0.1, 0.2], uAd = [1, 2, 3] }",
             "set = { uKd = 0.5, light = { color = [1, 1, 1] } }", "time = [0, 0.5, 1]",
             "tolerance = { max = 2, fraction = 0.1, flip = 0.05 }", "golden = false",
             "expect-error = { id = \"glsl-E01\", text = \"x\", line = 3 }", "match = \"smooth\"",
             "differ = \"smooth\""});
        made.separators = " \t,()[]{}=.\"";
        return made;
    }();
    return kGrammar;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glibra;
    const std::string_view text = fuzz::textOf(data, size);
    const Result<suite::Suite> read = suite::readSuiteText(text, "nowhere/suite.toml");
    fuzz::checkMessages(read.diagnostics);
    fuzz::check(read.value.has_value() != hasError(read.diagnostics), "a suite or an error");
    if (!read) return 0;
    std::size_t chosen = 0;
    for (int index = 1; index <= 3; ++index) chosen += suite::select(*read, {}, {index, 3}).size();
    fuzz::check(chosen == read->shots.size(), "every shot is in one shard");
    return 0;
}
