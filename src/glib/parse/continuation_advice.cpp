#include "glib/parse/continuation_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "glib/bracket_group.h"
#include "glib/modern/grammar.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

int lastLineOf(const Statement& statement) {
    if (statement.bodyPosition.line > 1)
        return statement.bodyPosition.line + static_cast<int>(std::ranges::count(statement.body, '\n'));
    return statement.arguments.empty() ? statement.word.position.line
                                       : statement.arguments.back().position.line;
}

/// The first word of the line after the statement, without the comments of its own line.
std::string_view wordOfNextLine(std::string_view text, std::size_t end) {
    const std::size_t line = text.find_first_of("\r\n", end);
    if (line == std::string_view::npos) return {};
    LineSplitter lines(text.substr(line + (text.substr(line, 2) == "\r\n" ? 2 : 1)));
    const std::optional<LineRange> next = lines.next();
    if (!next) return {};
    const std::size_t begin = line + (text.substr(line, 2) == "\r\n" ? 2 : 1);
    return startOf(text, {next->number, begin + next->begin, begin + next->end}).word;
}

bool isKeyOf(const StatementRow& row, std::string_view word) {
    const std::vector<std::string>& keys = syntaxOf(row).keys;
    const std::string_view head = word.substr(0, word.find('.'));
    return isAmong(head, keys);
}

}  // namespace

void ContinuationAdvice::follow(const Statement& statement) {
    if (isReported_ && statement.row == nullptr && statement.modern == nullptr) {
        lastLine_ = lastLineOf(statement);
        return;
    }
    isReported_ = false;
    row_ = statement.modern;
    isClassic_ = statement.row != nullptr && statement.modern == nullptr;
    if (isClassic_) row_ = modernFormOf(statement.row->name());
    name_ = statement.modern != nullptr ? std::string(statement.modern->name)
            : isClassic_                ? std::string(statement.row->name())
                                        : std::string();
    firstLine_ = statement.word.position.line;
    lastLine_ = lastLineOf(statement);
}

void ContinuationAdvice::advise(std::string_view text, const Statement& statement, MessageLog& log) {
    Diagnostic* message = log.last();
    if (message == nullptr) return;
    const Token& first = statement.word;
    if (row_ != nullptr && first.position.line == lastLine_ + 1 && first.kind == TokenKind::word &&
        lower(first.text.front()) == first.text.front() && isKeyOf(*row_, first.text)) {
        message->text += fmt::format("; if {} (line {}) goes on here, end line {} with a backslash", name_,
                                     firstLine_, lastLine_);
        return;
    }
    const std::string_view word = wordOfNextLine(text, statement.end);
    const std::vector<Expectation>& missing = log.lastMissing();
    if (std::ranges::none_of(missing, [&](const Expectation& each) { return each.mayBegin(word); })) return;
    message->text += fmt::format("; end line {} with a backslash if the statement goes on in the next one",
                                 lastLineOf(statement));
    skippedLine_ = lastLineOf(statement) + 1;
}

bool ContinuationAdvice::isSkipped(const Statement& statement) {
    return skippedLine_ != 0 && statement.word.position.line == std::exchange(skippedLine_, 0);
}

bool ContinuationAdvice::report(const Statement& statement, MessageLog& log) {
    const Token& word = statement.word;
    if (name_.empty() || word.position.line != lastLine_ + 1) return false;
    const bool isValue = word.beginsValue();
    const bool isKey = row_ != nullptr && word.kind == TokenKind::word && isKeyOf(*row_, word.text);
    const bool takesTags = row_ != nullptr && hasNode(*row_, [](const SyntaxNode& each) {
                               return each.kind == SyntaxNode::Kind::pairs;
                           });
    const bool isTag = takesTags && word.kind == TokenKind::word && !word.text.empty() &&
                       lower(word.text.front()) == word.text.front() && !statement.arguments.empty() &&
                       (statement.arguments.front().beginsValue() || statement.arguments.size() == 1);
    if (!isValue && !isKey && !isTag) return false;
    if (isReported_) return true;
    isReported_ = true;
    log.report("glib-E01",
               fmt::format("unknown command {}; if {} (line {}) goes on here, end line {} with a backslash",
                           inQuotes(word.text), name_, firstLine_, lastLine_),
               word.position);
    return true;
}

}  // namespace glibra::glib
