#include "glib/parse/match.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/suggest.h"
#include "glib/statement_table.h"
#include "glib/syntax.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

/// The first line of a piece in quotes.
std::string found(const Pieces& pieces, std::size_t at) {
    const std::string_view all = pieces.source(pieces[at]);
    return inQuotes(all.substr(0, all.find_first_of("\r\n")));
}

}  // namespace

bool Mismatch::expect(std::size_t at, Expectation expected) {
    if (at > furthest_) {
        furthest_ = at;
        expected_.clear();
    }
    if (at == furthest_ &&
        std::ranges::none_of(expected_, [&](const Expectation& each) { return each.text == expected.text; }))
        expected_.push_back(std::move(expected));
    return false;
}

bool Mismatch::expectWord(std::size_t at, const std::string& word) {
    return expect(at, {Kind::word, fmt::format("'{}'", word), word});
}

void Mismatch::contradict(std::size_t before, std::size_t at) {
    if (!conflict_ || at > conflict_->second) conflict_ = {before, at};
}

bool Mismatch::expects(Kind kind) const {
    return std::ranges::any_of(expected_, [&](const Expectation& each) { return each.kind == kind; });
}

std::string Mismatch::listOfExpected() const {
    constexpr std::size_t kShown = 8;
    std::string text;
    const std::size_t shown = std::min(expected_.size(), kShown);
    for (std::size_t i = 0; i < shown; ++i) {
        if (i > 0) text += i + 1 == shown && shown == expected_.size() ? " or " : ", ";
        text += expected_[i].text;
    }
    return shown < expected_.size() ? text + " ..." : text;
}

std::string Mismatch::suggested(std::string_view word) const {
    std::vector<std::string_view> words;
    for (const Expectation& each : expected_)
        if (each.kind == Kind::word) words.push_back(each.name);
    std::string nearest = base::nearestName(word, words);
    if (nearest.empty()) nearest = base::nearestName(beforePoint(word), words);
    // `culling` for `cull`: the longest word with which it begins.
    constexpr std::size_t kFewestLetters = 3;
    for (const std::string_view each : nearest.empty() ? words : std::vector<std::string_view>())
        if (each.size() >= kFewestLetters && each.size() > nearest.size() &&
            sameWord(each, word.substr(0, each.size())))
            nearest = each;
    return sameWord(nearest, word) ? std::string() : nearest;  // the word is right, and something else is not
}

std::string Mismatch::valueHint(const Pieces& pieces, std::size_t at, const DeclaredNames& names) const {
    constexpr std::string_view kCounter = "i";
    const Value& found = pieces[at];
    const std::string_view head = beforePoint(found.text);
    const bool hasList = at + 1 < pieces.size() && pieces[at + 1].kind == Value::Kind::list;
    if (hasList && isUnquoted(found) && names.has(head) &&
        std::ranges::find(expected_, "buffer", &Expectation::name) != expected_.end())
        return fmt::format("; write buffer {}", found.text);
    const bool expectsNumber = expects(Kind::number);
    const bool expectsValue = expectsNumber || expects(Kind::value) || expects(Kind::expression);
    if (expectsValue && isUnquoted(found)) {
        const std::string whole = pieces.expressionFrom(at);
        const bool isCall = whole.size() > found.text.size() && whole.ends_with(')');
        if (isCall || looksLikeExpression(found.text))
            return fmt::format("; write ({}) for its value", whole);
    }
    if (!isUnquoted(found) || !isDotted(found.text, false)) return {};
    if (!names.has(head) && !(expectsNumber && head == kCounter)) return {};
    return fmt::format("; write ({}) for its value", found.text);
}

std::string Mismatch::bracketHint(const Pieces& pieces, std::size_t at) const {
    const Value& found = pieces[at];
    if (at > 0 && isUnquoted(found) && found.text.size() == 1 &&
        std::string_view("+-*/%").find(found.text) != std::string_view::npos && at + 1 < pieces.size())
        return fmt::format("; write ({}) for its value", pieces.onOneLine(at - 1, pieces.size()));
    const bool isColor = expects(Kind::color), isList = expects(Kind::components);
    std::size_t end = at;
    constexpr std::size_t kLongestRun = 4;
    while (end < pieces.size() && end - at < kLongestRun && pieces[end].kind == Value::Kind::number) ++end;
    if ((!isColor && !isList) || end - at < (isColor ? 3 : 1)) return {};
    const std::string numbers = pieces.onOneLine(at, end);
    if (isList && end < pieces.size() && pieces[end].kind == Value::Kind::list)
        return fmt::format("; write {} {}", pieces.onOneLine(end, end + 1), numbers);
    return isColor ? fmt::format("; write {{{}}}", numbers) : fmt::format("; write [{}]", numbers);
}

std::string Mismatch::nameHint(const Pieces& pieces) const {
    // `Camera LookAt 0 0 5 ...`: the name and what follows it are read as one.
    const bool isKeyword = furthest_ == 1 && pieces[0].kind == Value::Kind::word &&
                           std::ranges::any_of(expected_, [&](const Expectation& each) {
                               return each.kind == Kind::word && sameWord(each.name, pieces[0].text);
                           });
    return isKeyword ? fmt::format("; write a name before '{}'", pieces[0].text) : std::string();
}

std::string Mismatch::commandHint(const StatementRow& row, const Value& found) {
    // `State pointsize 4`.
    const StatementRow* command = isUnquoted(found) ? findCommand(found.text) : nullptr;
    if (command == nullptr || sameWord(command->name, row.name)) return {};
    return fmt::format("; {} is a statement of its own", command->name);
}

namespace {

bool isNumberAt(const Pieces& pieces, std::size_t at) {
    return at < pieces.size() && pieces[at].kind == Value::Kind::number;
}

/// `Texture2D a width 30 rgba8`: the variable was read as the name of a file.
bool isVariableAsFile(const StatementRow& row, const Pieces& pieces, std::size_t at,
                      const DeclaredNames& names) {
    return at > 1 && isNumberAt(pieces, at) && isUnquoted(pieces[at - 1]) &&
           isDotted(pieces[at - 1].text, false) && names.has(beforePoint(pieces[at - 1].text)) &&
           hasNode(row, [](const SyntaxNode& each) {
               return each.type == ValueType::file && each.text == "file";
           });
}

}  // namespace

std::string Mismatch::surplusHint(const Pieces& pieces, std::size_t at) const {
    std::string hint = bracketHint(pieces, at);
    // `uColor 1 0 0`: a number with one value of a tag before it.
    const bool isOfTag = at > 1 && isNumberAt(pieces, at) && isNumberAt(pieces, at - 1) &&
                         pieces[at - 2].kind == Value::Kind::word;
    if (!hint.empty() || !isOfTag) return hint;
    std::size_t end = at;
    while (isNumberAt(pieces, end)) ++end;
    return fmt::format("; write {} [{}]", pieces[at - 2].text, pieces.onOneLine(at - 1, end));
}

void Mismatch::report(const StatementRow& row, const Pieces& pieces, const DeclaredNames& names, bool matched,
                      std::size_t at, Position command, MessageLog& log) {
    const auto reportAt = [&](const char* id, std::size_t place, const std::string& message) {
        log.report(id, fmt::format("{}: {}", row.name, message), pieces[place].position);
    };
    const auto suggest = [&](std::size_t place, const std::string& meant) {
        reportAt("glib-E16", place,
                 fmt::format("unknown word {}; did you mean '{}'?", found(pieces, place), meant));
    };
    if (conflict_ && conflict_->second >= std::max(furthest_, at)) {
        const auto [before, later] = *conflict_;
        return reportAt("glib-E18", later,
                        sameWord(pieces[before].text, pieces[later].text)
                            ? fmt::format("{} given twice", found(pieces, later))
                            : fmt::format("{} contradicts {}", found(pieces, later), found(pieces, before)));
    }
    if (furthest_ < at) {
        furthest_ = at;
        expected_.clear();
    }
    if (furthest_ >= pieces.size()) {
        // `Fill glow wiht Ramp`: the misspelt word was read as one more name.
        for (std::size_t i = 1; i < pieces.size(); ++i)
            if (const std::string meant = isUnquoted(pieces[i]) ? suggested(pieces[i].text) : std::string();
                !meant.empty())
                return suggest(i, meant);
        log.report("glib-E17",
                   fmt::format("{}: expected {}, found the end of the statement", row.name, listOfExpected()),
                   command, expected_);
        return;
    }
    const std::string text = found(pieces, furthest_);
    std::string hint = valueHint(pieces, furthest_, names);
    if (hint.empty()) hint = nameHint(pieces);
    if (isUnquoted(pieces[furthest_]) && expects(Kind::word)) {
        const std::string nearest = hint.empty() ? suggested(pieces[furthest_].text) : std::string();
        if (!nearest.empty()) return suggest(furthest_, nearest);
        if (hint.empty()) hint = commandHint(row, pieces[furthest_]);
        return reportAt("glib-E16", furthest_,
                        fmt::format("unknown word {}; expected {}{}", text, listOfExpected(), hint));
    }
    if (matched && furthest_ == at && isVariableAsFile(row, pieces, at, names))
        return reportAt("glib-E19", at - 1,
                        fmt::format("expected a number, found {0}; write ({1}) for its value",
                                    found(pieces, at - 1), pieces[at - 1].text));
    if (matched && furthest_ == at) {
        // The misspelt word was read as a tag: `diqcard uColor {1 0 0}`, whose value is the next tag, and
        // `tiqes 2 discard`, after which a word of the statement is surplus.
        const std::vector<std::string>& keys = syntaxOf(row).keys;
        const std::vector<std::string_view> known(keys.begin(), keys.end());
        const bool isKey = isUnquoted(pieces[at]) && isAmong(pieces[at].text, keys);
        for (std::size_t i = at - 2; i > 0 && i < at && (isKey || isUnquoted(pieces[i + 1])); i -= 2)
            if (const std::string meant = base::nearestName(pieces[i].text, known); !meant.empty())
                return suggest(i, meant);
        // `Material shqniness 20`: the word was read as that of a preset.
        if (at > 0 && isUnquoted(pieces[at - 1]) && !names.has(pieces[at - 1].text))
            if (const std::string meant = base::nearestName(pieces[at - 1].text, known); !meant.empty())
                return suggest(at - 1, meant);
        // `Let wave (x) (2 * x)`
        const bool isFunction = row.id == CommandId::let && furthest_ == 2 &&
                                pieces[1].kind == Value::Kind::expression &&
                                pieces[2].kind == Value::Kind::expression;
        return reportAt("glib-E18", furthest_,
                        fmt::format("surplus argument {}{}", text,
                                    isFunction ? fmt::format("; a function has no blank before its "
                                                             "parameters: {}{}",
                                                             pieces[0].text, written(pieces[1]))
                                               : surplusHint(pieces, furthest_)));
    }
    reportAt("glib-E19", furthest_,
             fmt::format("expected {}, found {}{}", listOfExpected(), text,
                         hint.empty() ? bracketHint(pieces, furthest_) : hint));
}

}  // namespace glibra::glib
