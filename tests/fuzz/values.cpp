// Any lines as numbers, as options of the command line ("size 800x600"), as values of --set, as shards, and
// as lines of a list of accepted hashes. What is accepted is written and read again.

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "check.h"
#include "glib/number.h"
#include "plan/overrides.h"
#include "scratch_folder.h"
#include "suite/file/selection.h"
#include "suite/file/suite_file.h"
#include "suite/golden/hash_list.h"
#include "suite/options/option_words.h"
#include "text_mutator.h"

namespace {

using namespace glibra;
using fuzz::check;

void checkNumber(std::string_view token) {
    const auto prefix = glib::numberPrefix(token);
    check(glib::numberLength(token) == (prefix ? prefix->length : 0), "a number has one length");
    if (!prefix) return;
    check(prefix->length >= 1 && prefix->length <= token.size(), "a number is a prefix of its token");
    check(glib::isCompleteNumber(token) == (prefix->length == token.size()), "a complete number has no rest");
    if (!prefix->finite) return;
    const auto again = glib::numberPrefix(glib::numberText(prefix->value));
    check(again && again->value == prefix->value, "a number is read as it was written");
}

/// A folder with the scene that suites name.
const std::filesystem::path& folder() {
    struct SceneFolder : fuzz::ScratchFolder {
        SceneFolder() { write("a.glib", "Sphere\n"); }
    };
    static const SceneFolder kFolder;
    return kFolder.path();
}

/// Gives a new shot the options that these words of a command line state.
suite::Shot shotOf(const std::vector<std::string>& words) {
    suite::Shot shot;
    for (std::size_t i = 0; i < words.size(); ++i) {
        check(words[i].starts_with("--"), "an option begins with two dashes");
        const suite::OptionRow* row = suite::findOption(std::string_view(words[i]).substr(2));
        check(row != nullptr, "an option that is written exists");
        const bool isFlag = std::holds_alternative<suite::FlagValue>(row->value);
        const std::string value = isFlag ? "" : words.at(++i);
        check(suite::readOptionText(*row, value, shot).empty(), "an option is accepted as it was written");
    }
    return shot;
}

void checkOption(std::string_view line) {
    const std::size_t blank = std::min(line.find(' '), line.size());
    const suite::OptionRow* row = suite::findOption(line.substr(0, blank));
    if (!row) return;
    suite::Shot shot;
    const std::string wrong =
        suite::readOptionText(*row, line.substr(std::min(blank + 1, line.size())), shot);
    if (!wrong.empty()) return check(suite::isDefault(*row, shot), "a wrong value changes nothing");
    if (!row->needs.empty()) return;  // is not written without the option that it needs
    check(shotOf(suite::optionWords(*row, shot)).options == shot.options,
          "an option is read as it was written");
    // A suite cannot state every option; names of uniforms and folders have rules of their own there.
    if (row->key.empty() || std::holds_alternative<suite::UniformsValue>(row->value) ||
        std::holds_alternative<suite::FoldersValue>(row->value))
        return;
    const std::string text = "[[shot]]\nscript = \"a.glib\"\n" + suite::optionLine(*row, shot, folder());
    const Result<suite::Suite> suite = suite::readSuiteText(text, folder() / "suite.toml");
    check(suite && suite->shots.size() == 1 && suite->shots.front().options == shot.options,
          "an option of a suite is read as it was written");
}

void checkHashes(std::string_view text) {
    suite::HashList list;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        const Result<suite::AcceptedHash> accepted = suite::parseLine(line, {});
        fuzz::checkMessages(accepted.diagnostics);
        if (!accepted) continue;
        const Result<suite::AcceptedHash> again = suite::parseLine(suite::toLine(*accepted), {});
        check(again && suite::toLine(*again) == suite::toLine(*accepted), "a line is read as it was written");
        list.accept({&*accepted, 1});
        const suite::Hash* found =
            list.find(accepted->shot, accepted->variant, accepted->golden, accepted->key);
        check(found && *found == accepted->pixels, "a hash that was accepted is found");
    }
}

}  // namespace

const fuzz::Grammar& fuzz::grammar() {
    static const Grammar kGrammar = [] {
        Grammar made;
        for (const suite::OptionRow& row : suite::optionTable()) {
            made.words.emplace_back(row.name);
            for (const char* value :
                 {"", "5", "0.5", "800x600", "uKd=.5", "0,.5,1,1", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1",
                  "7:1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1", "glman", "orthographic"})
                made.statements.push_back(std::string(row.name) + " " + value);
        }
        for (const char* line :
             {"2/8", "uM=[1 0 0 1]", "Dots:uKd=<0 1 2>", "uColor={1 .5 0}", "uOn=true",
              "teapot - 0123456789abcdef0123456789abcdef fedcba98765432100123456789abcdef llvmpipe; 4.5",
              "1e-3", "-.25", "+5.e+10x"})
            made.statements.emplace_back(line);
        return made;
    }();
    return kGrammar;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = fuzz::textOf(data, size);
    checkHashes(text);
    for (int lines = 0; !text.empty() && lines < 100; ++lines) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        checkNumber(line);
        checkOption(line);
        const Result<plan::Override> value = plan::parseOverride(line);
        check(value.value.has_value() != hasError(value.diagnostics), "a value or an error");
        if (value)
            check(!value->name.empty() && value->values.empty() != value->word.empty(),
                  "a value has a name, and numbers or a word");
        const Result<suite::Shard> shard = suite::parseShard(line);
        check(shard.value.has_value() != hasError(shard.diagnostics), "a shard or an error");
        if (shard) check(shard->index >= 1 && shard->index <= shard->count, "a shard is one of its count");
    }
    return 0;
}
