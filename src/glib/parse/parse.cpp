// From the text of a scene to its commands.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "glib/lexer.h"
#include "glib/limits.h"
#include "glib/messages.h"
#include "glib/parse/arguments.h"
#include "glib/parse/blocks.h"
#include "glib/parse/match.h"
#include "glib/parse/pieces.h"
#include "glib/parse/statement.h"
#include "glib/script.h"
#include "glib/statement_table.h"
#include "glib/syntax.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

// ---- Statements that go on in the next line without a backslash (language, 1.3): one message says so.

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

/// Follows the statements of a script in order.
class ContinuationAdvice {
  public:
    /// Remembers the statement as the one that the next line may go on with.
    void follow(const Statement& statement);

    /// Adds advice to the last message, which is about the statement: if it ends too early and the next line
    /// begins with what is missing, whose statements are then skipped; or if it begins with a key of the
    /// statement on the line before.
    void advise(std::string_view text, const Statement& statement, MessageLog& log);

    /// True for a statement on a line that belongs to an earlier one, which has been reported.
    [[nodiscard]] bool isSkipped(const Statement& statement);

    /// Reports glib-E01 with advice for an unknown word or a value at the beginning of a line that the
    /// statement before it can go on with. True if that is so; of several such lines only the first is
    /// reported.
    bool report(const Statement& statement, MessageLog& log);

  private:
    std::string name_;                   ///< of the statement before, for messages
    const StatementRow* row_ = nullptr;  ///< its row, if it has a modern form
    bool isClassic_ = false;
    int firstLine_ = 0, lastLine_ = 0;
    int skippedLine_ = 0;
    bool isReported_ = false;  ///< the line before has been reported by report()
};

void ContinuationAdvice::follow(const Statement& statement) {
    if (isReported_ && statement.row == nullptr && statement.modern == nullptr) {
        lastLine_ = lastLineOf(statement);
        return;
    }
    isReported_ = false;
    row_ = statement.modern;
    isClassic_ = statement.row != nullptr && statement.modern == nullptr;
    if (isClassic_) row_ = modernFormOf(statement.row->name);
    name_ = statement.modern != nullptr ? std::string(statement.modern->name)
            : isClassic_                ? std::string(statement.row->name)
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

// ---- Statements.

bool belongsToList(CommandId id) {
    return id == CommandId::glVertex || id == CommandId::glNormal || id == CommandId::glColor ||
           id == CommandId::glTexCoord || id == CommandId::glEnd;
}

class Parser {
  public:
    Parser(std::string_view text, bool isModern, MessageLog& log)
        : text_(text), reader_(text, isModern, log), log_(log), blocks_(log), isModern_(isModern) {}

    /// True if the scene has a modern statement, and a line that would mean something else if that were
    /// known.
    [[nodiscard]] bool hasToReadAgain() const {
        return isModern_ && (reader_.wasAmbiguous() || wouldDiffer_);
    }
    [[nodiscard]] bool isModern() const { return isModern_; }

    /// Fills the commands of the script, and what its faulty statements lack and would declare.
    void parse(Script& script) {
        // Memory that is reserved and not used costs nothing; growing would copy the commands.
        const auto lines = static_cast<std::size_t>(std::ranges::count(text_, '\n'));
        commands_.reserve(std::min(lines + 1, kMostStatements));
        std::size_t statements = 0;
        while (const std::optional<Statement> statement = reader_.next()) {
            if (++statements > kMostStatements) {
                log_.report("glib-E15",
                            fmt::format("more than {} statements", base::groupedText(kMostStatements)),
                            statement->word.position);
                break;
            }
            if (continuation_.isSkipped(*statement)) continue;
            if (statement->modern) {
                keepModern(*statement, *statement->modern);
            } else if (!statement->row) {
                reportUnknown(*statement);
            } else if (!statement->refused) {
                keep(*statement);
            }
            continuation_.follow(*statement);
        }
        blocks_.finish(commands_);
        for (const Command& each : commands_)
            if (declares(each.id) && !withoutTags_.contains(each.begin)) lostNames_.erase(nameOfObject(each));
        script.commands = std::move(commands_);
        script.lostNames = std::move(lostNames_);
        script.withoutFile = std::move(withoutFile_);
    }

  private:
    void reportUnknown(const Statement& statement) {
        const Token& word = statement.word;
        if (continuation_.report(statement, log_)) return;
        constexpr std::string_view kEnd = "End";
        if (word.kind == TokenKind::word && sameWord(word.text.substr(0, kEnd.size()), kEnd)) {
            const StatementRow* stage = modernFormOf(word.text.substr(kEnd.size()));
            if (!stage) stage = findStatement(word.text.substr(kEnd.size()));
            if (stage && stage->takesBody)
                return log_.report("glib-E21", fmt::format("{} without '{} inline'", word.text, stage->name),
                                   word.position);
        }
        const bool suggests = word.kind == TokenKind::word && !log_.isFull();
        const std::string_view nearest = suggests ? nearestCommand(word.text) : std::string_view();
        std::string text = "unknown command " + inQuotes(word.text);
        if (const std::string key = stateKeyNamed(word); !key.empty())
            text += fmt::format("; write 'State {}'", key);
        else if (!nearest.empty())
            text += fmt::format("; did you mean '{}'?", nearest);
        log_.report("glib-E01", std::move(text), word.position);
    }

    /// The key of State that has the name of an unknown command: Blend, Cull, DepthWrite. Empty for other
    /// words.
    static std::string stateKeyNamed(const Token& word) {
        for (const std::string& key : syntaxOf(*statementOf(CommandId::state)).keys)
            if (word.kind == TokenKind::word && key.size() == word.text.size() && sameWord(key, word.text))
                return key;
        return {};
    }

    static Command start(const Statement& statement, CommandId id) {
        Command command;
        command.id = id;
        command.word = statement.word.text;
        command.position = statement.word.position;
        command.begin = statement.word.begin;
        command.end = statement.end;
        return command;
    }

    void keep(const Statement& statement) {
        const StatementRow* form = statementOf(statement.row->id);
        if (statement.row->id == CommandId::program) {
            if (isModernProgram(statement)) return keepModern(statement, *form);
            if (keepSubscripts(statement, *form)) return;
            noteName(statement);
        }
        Command command = start(statement, statement.row->id);
        const std::size_t errors = log_.errorCount();
        if (form && !statement.faulty) blocks_.checkPlace(*form, command);
        if (!refusesNames(statement)) read(statement, command);
        if (log_.errorCount() > errors) continuation_.advise(text_, statement, log_);
        const bool faulty = statement.faulty || log_.errorCount() > errors || losesStage(command.id);
        if (command.id == CommandId::fragment) fragmentFile_ = command.text();
        isModern_ = isModern_ || command.isEvaluatedLater;
        if (command.lacksFile) withoutFile_.push_back(command);
        if (leavesOut(command.id, faulty) || faulty) return;
        commands_.push_back(std::move(command));
    }

    /// True if the tags are read by the rules of modern statements: after the first declaration of a name,
    /// if a value is an expression, with `const`, and in a modern scene if a tag has a subscript or a value
    /// is malformed.
    bool isModernProgram(const Statement& statement) {
        if (declaresNames_ || std::ranges::any_of(statement.arguments, [](const Token& token) {
                return token.kind == TokenKind::expression ||
                       (token.kind == TokenKind::word && sameWord(token.text, "const"));
            }))
            return true;
        if (!hasSubscriptedTag(statement.arguments) && !hasMalformedValue(statement.arguments)) return false;
        if (!isModern_) wouldDiffer_ = true;
        return isModern_;
    }

    /// Keeps the program of a classic scene whose tags have subscripts, if the rules of modern statements can
    /// read it. False if there is no such tag, or the statement has something else that they refuse.
    bool keepSubscripts(const Statement& statement, const StatementRow& form) {
        if (isModern_ || statement.faulty || !hasSubscriptedTag(statement.arguments)) return false;
        MessageLog unused{""};
        Command command = start(statement, form.id);
        command.isModern = true;
        readStatement(form, text_, statement.arguments,
                      {[](std::string_view) { return false; }, [](std::string_view) { return false; }},
                      command, unused);
        if (unused.errorCount() > 0 || command.values.empty()) return false;
        takeUniforms(command);
        if (!command.tags.empty() || ++programs_ > kMostPrograms) return false;
        command.isModern = false;
        noteName(statement);
        if (!losesStage(form.id)) commands_.push_back(std::move(command));
        return true;
    }

    void keepModern(const Statement& statement, const StatementRow& row) {
        isModern_ = true;
        if (declares(row.id)) noteName(statement);
        Command command = start(statement, row.id);
        command.isModern = true;
        command.body = statement.body;
        command.bodyPosition = statement.bodyPosition;
        const std::size_t errors = log_.errorCount();
        if (!statement.faulty && !lacksParentheses(statement, row))
            readStatement(row, text_, statement.arguments,
                          {[this](std::string_view name) { return names_.contains(std::string(name)); },
                           [this](std::string_view name) { return mayBeDeclared(name); }},
                          command, log_);
        const bool isRead = !statement.faulty && log_.errorCount() == errors;
        if (!isRead) continuation_.advise(text_, statement, log_);
        if (isRead) blocks_.checkPlace(row, command);
        finishModern(row, command);
        const bool hasStages = !losesStage(row.id);
        const bool faulty = statement.faulty || log_.errorCount() > errors || !hasStages;
        if (row.id == CommandId::compute || (statement.faulty && statement.row != nullptr && row.takesBody))
            isStageLost_ = faulty;
        if (!faulty)
            commands_.push_back(std::move(command));
        else if (row.id == CommandId::program && hasStages)
            keepWithoutTags(statement);
        blocks_.follow(row, statement.word.position, faulty, commands_);
    }

    /// A program whose tags are faulty takes its shaders all the same: the next program does not inherit
    /// them.
    void keepWithoutTags(const Statement& statement) {
        if (statement.arguments.empty() || programs_ > kMostPrograms) return;
        const Token& name = statement.arguments.front();
        if (!isIdentifier(name.text)) return;
        Command program = start(statement, CommandId::program);
        program.isModern = true;
        program.values.push_back(wordOf(name.text, name.position));
        // The shaders have the names of the constants, whatever is wrong with their values.
        for (std::size_t i = 1; i + 1 < statement.arguments.size(); ++i) {
            if (!sameWord(statement.arguments[i].text, "const")) continue;
            const Token* constant = &statement.arguments[i + 1];
            if (i + 2 < statement.arguments.size() && constant[1].kind == TokenKind::word) ++constant;
            if (!isIdentifier(constant->text)) continue;
            Value lost;
            lost.kind = Value::Kind::text;
            program.keys.push_back(
                {"const", {}, {}, constant->position, {wordOf(constant->text, constant->position), lost}});
        }
        withoutTags_.insert(program.begin);
        commands_.push_back(std::move(program));
    }

    bool mayBeDeclared(std::string_view name) const {
        return hasInclude_ || name == "window" || name == "eye" || names_.contains(std::string(name)) ||
               lostNames_.contains(name);
    }

    static bool declares(CommandId id) {
        if (id == CommandId::program || id == CommandId::group) return true;
        const StatementRow* row = statementOf(id);
        return row != nullptr && row->declaresName;
    }

    static std::string nameOfObject(const Command& command) {
        return command.values.empty() ? std::string() : headOf(command.values.front());
    }

    /// Keeps the name that the statement declares even if it is faulty.
    void noteName(const Statement& statement) {
        if (statement.arguments.empty()) return;
        const std::string_view first = statement.arguments.front().text;
        const std::string name(first.substr(0, first.find('[')));
        if (!name.empty()) lostNames_.insert(name);
    }

    /// Keeps the names that the statement declares.
    void finishModern(const StatementRow& row, Command& command) {
        if (row.id == CommandId::include) hasInclude_ = true;
        if (row.declaresName || row.id == CommandId::include) declaresNames_ = true;
        if (row.id == CommandId::group)  // parameters may stand for textures and buffers
            for (const KeyedValues& each : command.tags) names_.insert(each.key);
        if (row.declaresName && !command.values.empty()) names_.insert(nameOfObject(command));
        if (row.id == CommandId::repeat)
            if (const KeyedValues* counter = command.key("as")) names_.insert(counter->values.front().text);
        if (row.id != CommandId::program) return;
        if (++programs_ > kMostPrograms)
            log_.report("glib-E15", fmt::format("more than {} programs", kMostPrograms), command.position);
        takeUniforms(command);
    }

    /// True for the program of a shader that is not closed, and of a faulty Compute statement, which would be
    /// a program that draws.
    bool losesStage(CommandId id) { return id == CommandId::program && std::exchange(isStageLost_, false); }

    /// True inside a vertex list whose glBegin is faulty. Its vertices are skipped, since they would only
    /// repeat the error.
    bool leavesOut(CommandId id, bool faulty) {
        if (id == CommandId::glBegin) inFaultyList_ = faulty;
        const bool result = inFaultyList_ && belongsToList(id);
        if (id == CommandId::glEnd) inFaultyList_ = false;
        return result;
    }

    void read(const Statement& statement, Command& command) {
        if (lastTypeOf(*statement.row) == ValueType::points && refusesExpressions(statement)) return;
        if (statement.row->id != CommandId::program) return readArguments(statement, command, log_);
        if (++programs_ <= kMostPrograms) return readProgram(statement, fragmentFile_, command, log_);
        log_.report("glib-E15", fmt::format("more than {} programs", kMostPrograms), command.position);
    }

    /// Reports glib-E19 for a declared name or an expression without parentheses among the numbers of a
    /// classic command, which would count as 0 or be cut. Classic scenes keep such expressions.
    bool refusesNames(const Statement& statement) {
        if (!takesNumbers(*statement.row)) return false;
        if (lacksClosing(statement)) return true;
        for (const Token& token : statement.arguments) {
            const std::string_view head = token.text.substr(0, token.text.find('.'));
            const bool isName = token.kind == TokenKind::word && names_.contains(std::string(head));
            const bool isFormula = (token.kind == TokenKind::word || token.kind == TokenKind::number) &&
                                   (looksLikeExpression(token.text) ||
                                    looksLikeExpression(expressionAt(text_, statement.arguments, token)));
            if (isFormula && !isModern_) wouldDiffer_ = true;
            if (!isName && !(isFormula && isModern_)) continue;
            const std::string_view whole = expressionAt(text_, statement.arguments, token);
            log_.report("glib-E19",
                        fmt::format("{}: expected a number, found {}; write ({}) for its value",
                                    statement.row->name, inQuotes(whole), whole),
                        token.position);
            return true;
        }
        return false;
    }

    /// Reports glib-E20 for a parenthesis before a word that is not closed; classic scenes close it.
    bool lacksClosing(const Statement& statement) {
        const auto& tokens = statement.arguments;
        const auto open = std::ranges::find_if(tokens, [](const Token& token) { return token.text == "("; });
        if (open == tokens.end() || open->kind != TokenKind::open) return false;
        const auto end = std::find_if(open, tokens.end(),
                                      [](const Token& token) { return token.kind == TokenKind::close; });
        const bool hasWord =
            std::any_of(open, tokens.end(), [](const Token& token) { return token.kind == TokenKind::word; });
        if (end != tokens.end() || !hasWord) return false;
        if (!isModern_) wouldDiffer_ = true;
        if (!isModern_) return false;
        log_.report("glib-E20", fmt::format("{}: '(' is not closed on this line", statement.row->name),
                    open->position);
        return true;
    }

    /// Reports glib-E19 for a condition that begins without a parenthesis.
    bool lacksParentheses(const Statement& statement, const StatementRow& row) {
        const auto& tokens = statement.arguments;
        std::size_t at = row.id == CommandId::when ? 0 : tokens.size();
        for (std::size_t i = 0; row.id == CommandId::repeat && i < tokens.size(); ++i)
            if (tokens[i].text == "until") at = i + 1;
        if (at >= tokens.size()) return false;
        const Token& first = tokens[at];
        if (first.kind != TokenKind::word || first.truth()) return false;
        log_.report(
            "glib-E19",
            fmt::format("{}: expected a condition in parentheses, found {}", row.name, inQuotes(first.text)),
            first.position);
        return true;
    }

    /// Reports glib-E24 for an expression in a command that takes none.
    bool refusesExpressions(const Statement& statement) {
        for (const Token& token : statement.arguments) {
            if (token.kind != TokenKind::expression) continue;
            log_.report("glib-E24",
                        fmt::format("{}: an expression cannot stand here; use glVertex", statement.row->name),
                        token.position);
            return true;
        }
        return false;
    }

    std::string_view text_;
    StatementReader reader_;
    MessageLog& log_;
    BlockStack blocks_;
    ContinuationAdvice continuation_;
    bool isModern_ = false;
    bool wouldDiffer_ = false;               ///< something so far would mean something else in a modern scene
    std::unordered_set<std::string> names_;  ///< of textures, buffers, samplers, cameras and variables
    std::vector<Command> withoutFile_;
    std::set<std::string, std::less<>> lostNames_;  ///< that statements so far would declare
    std::set<std::size_t> withoutTags_;             ///< where the programs of keepWithoutTags() begin
    bool declaresNames_ = false;
    bool hasInclude_ = false;
    std::vector<Command> commands_;
    std::string fragmentFile_;  ///< the name in the last Fragment statement
    std::size_t programs_ = 0;
    bool inFaultyList_ = false;
    bool isStageLost_ = false;
};

/// Reads the commands. Returns true if the scene has modern statements.
bool read(std::string_view text, Script& script, MessageLog& log) {
    const MessageLog empty = log;
    Parser parser(text, false, log);
    parser.parse(script);
    if (!parser.hasToReadAgain()) return parser.isModern();
    log = empty;
    Parser(text, true, log).parse(script);
    return true;
}

/// Makes the messages of a file that is no scene a single one: "this is a GLSL shader, not a scene".
void nameForeignFile(std::string_view text, Script& script) {
    const auto unknown = std::ranges::count(script.diagnostics, "glib-E01", &Diagnostic::id);
    // A scene with a misspelt word may begin like other files: with "#version 2 of my scene".
    const bool isForeign = script.commands.empty() || !base::foreignEncoding(text).empty() ||
                           std::cmp_greater(unknown, script.commands.size());
    const std::string problem = isForeign ? base::notThe("a scene", text) : std::string();
    if (problem.empty() || !hasError(script.diagnostics)) return;
    script.commands.clear();
    script.diagnostics = {diagnose("glib-E03", "this " + problem, {script.path, 1, 1})};
}

}  // namespace

Script parse(std::string_view text, std::string path) {
    Script script;
    MessageLog log(path);
    script.path = std::move(path);
    try {
        if (text.size() > kLargestFile)
            log.report("glib-E15",
                       fmt::format("scene of {} bytes; the limit is {}", base::groupedText(text.size()),
                                   base::groupedText(kLargestFile)),
                       {});
        else
            script.isModern = read(text, script, log);
    } catch (const std::exception& problem) {
        script.commands.clear();
        log.report("glib-E14", "the scene cannot be read: " + base::reasonOf(problem), {});
    }
    script.diagnostics = log.take();
    nameForeignFile(text, script);
    return script;
}

std::vector<Statement> statementsOf(std::string_view text) {
    MessageLog unused{""};
    StatementReader reader(text, parse(text, {}).isModern, unused);
    std::vector<Statement> all;
    while (std::optional<Statement> each = reader.next()) all.push_back(std::move(*each));
    return all;
}

}  // namespace glibra::glib
