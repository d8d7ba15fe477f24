#include "glib/parse/statement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "base/suggest.h"
#include "base/text.h"
#include "glib/limits.h"
#include "glib/syntax.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

constexpr std::size_t kCubeMapArguments = 7;  // a unit and six files

const StatementRow* commandRowOf(const Token& token) {
    return token.kind == TokenKind::word ? findCommand(token.text) : nullptr;
}

bool isCommand(const Statement& statement, CommandId id) {
    return statement.row && statement.row->id == id;
}

/// Returns the statement's name for messages: "Program 'Magic'", "CubeMap".
std::string described(const Statement& statement) {
    std::string text(statement.row->name);
    if (isCommand(statement, CommandId::program) && !statement.arguments.empty())
        text.append(" ").append(inQuotes(statement.arguments.front().text));
    return text;
}

/// Returns how many of the tokens are not brackets.
std::size_t countPlain(std::span<const Token> tokens) {
    return static_cast<std::size_t>(std::ranges::count_if(
        tokens, [](const Token& t) { return t.kind != TokenKind::open && t.kind != TokenKind::close; }));
}

/// True if the command word that begins the line may be a tag: a value can follow it.
bool fitsAsTag(const Line& line) {
    const std::vector<Token>& tokens = line.tokens;
    if (tokens.size() < 2 || !tokens[1].beginsValue()) return false;
    const std::size_t end = valueEnd(tokens, 1);
    return end >= tokens.size() || !tokens[end].beginsValue();
}

/// True for the commands among whose arguments an expression may stand.
bool takesExpressions(const StatementRow& row) {
    const ValueType last = lastTypeOf(row);
    return takesNumbers(row) || last == ValueType::any || last == ValueType::points;
}

/// True for a classic statement that begins with a texture unit.
bool takesUnit(const StatementRow& row) {
    return !argumentsOf(row).empty() && argumentsOf(row).front()->type == ValueType::unit;
}

/// What parentheses mean on a line, which may continue a statement.
Parentheses parenthesesOf(std::string_view text, const LineRange& range, const Statement* pending) {
    if (pending && pending->modern) return Parentheses::expressions;
    const LineStart start = startOf(text, range);
    if (!pending && findStatement(start.word)) return Parentheses::expressions;
    const StatementRow* row = findCommand(start.word);
    if (!pending && row && takesUnit(*row) && modernFormOf(start.word) && isIdentifier(start.next))
        return Parentheses::expressions;
    if (pending && (!row || isCommand(*pending, CommandId::program))) row = pending->row;
    return !row || takesExpressions(*row) ? Parentheses::byContent : Parentheses::brackets;
}

/// True for `Fragmnet inline`: what follows is probably a shader.
bool isUnknownInline(const Statement& statement) {
    return !statement.row && statement.arguments.size() == 1 &&
           sameWord(statement.arguments.front().text, "inline");
}

// ---- The end of a shader that stands in the script (language, 12.2).

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kEndPrefix = "End";

/// Where a shader ends that begins at the next line of a splitter.
struct ShaderBody {
    enum class End {
        itsWord,         ///< a line with the end word of its stage
        otherWord,       ///< a line with another end word, or a misspelt one
        otherStatement,  ///< a line that states another shader or a program
        missing          ///< the text ends first
    };
    End end = End::missing;
    std::size_t first = 0, last = 0;  ///< byte offsets of the text of the shader
    int firstLine = 1;                ///< the number of its first line
    LineRange line{};                 ///< that ends it
    std::string_view words{};         ///< of that line, without blanks at either end
    LineSplitter before;              ///< a splitter whose next line is that one
};

bool isStageRow(const StatementRow* row) {
    return row != nullptr && row->takesBody;
}

const StatementRow* anyRowOf(std::string_view word) {
    const StatementRow* row = modernFormOf(word);
    return row != nullptr ? row : findStatement(word);
}

std::vector<std::string_view> wordsOfLine(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::size_t kMostWords = 4;
    while (words.size() < kMostWords) {
        const std::string_view word = base::nextWord(line, kBlanks);
        if (word.empty()) break;
        words.push_back(word);
    }
    return words;
}

/// True for the end word of any block or stage: EndVertex, EndPass.
bool isEndWord(std::string_view word) {
    if (word.size() <= kEndPrefix.size() || !sameWord(word.substr(0, kEndPrefix.size()), kEndPrefix))
        return false;
    if (isStageRow(anyRowOf(word.substr(kEndPrefix.size())))) return true;
    const StatementRow* row = findStatement(word);
    return row != nullptr && row->role == BlockRole::closes;
}

/// True for `EndFragmnet`: a line of a single word that is nearly the end word.
bool isNearly(std::string_view word, std::string_view end) {
    if (word.size() < kEndPrefix.size() || !sameWord(word.substr(0, kEndPrefix.size()), kEndPrefix))
        return false;
    const std::array<std::string_view, 1> only{end};
    return isIdentifier(word) && !base::nearestName(word, only).empty();
}

/// True for a line that GLSL does not have: `Fragment inline`, `Vertex a.vert`, `Program Lit uTint {1 0 0}`.
bool statesAnother(const std::vector<std::string_view>& words) {
    if (words.size() < 2) return false;
    const StatementRow* row = anyRowOf(words[0]);
    if (row == nullptr) return false;
    if (row->id == CommandId::glslText)
        return words.size() == 3 && isIdentifier(words[1]) && sameWord(words[2], "inline");
    if (isStageRow(row)) {
        if (words.size() > 2) return false;
        if (sameWord(words[1], "inline")) return true;
        return row->name == words[0] && words[1].find('.') != std::string_view::npos &&
               words[1].find_first_of(";()[]{}=,") == std::string_view::npos;
    }
    return row->id == CommandId::program && row->name == words[0] && isIdentifier(words[1]) &&
           (words.size() == 2 || isIdentifier(words[2].substr(0, words[2].find_first_of(".["))));
}

/// Follows comments from line to line: true if the line begins outside of one.
class CommentState {
  public:
    bool beginsOutside(std::string_view line) {
        const bool wasOutside = !isInside_;
        for (std::size_t at = 0; at + 1 < line.size(); ++at) {
            const std::string_view two = line.substr(at, 2);
            if (isInside_ ? two == "*/" : two == "/*") {
                isInside_ = !isInside_;
                ++at;
            } else if (!isInside_ && two == "//") {
                break;
            }
        }
        return wasOutside;
    }

  private:
    bool isInside_ = false;
};

/// True for a line that is probably no line of a shader: it states another shader or a program.
bool endsShader(std::string_view line) {
    std::string_view word = line.substr(0, line.find_first_of(" \t"));
    const bool isEnd = word.starts_with(kEndPrefix) && word.size() == line.size();
    if (isEnd) word.remove_prefix(kEndPrefix.size());
    const StatementRow* row = anyRowOf(word);
    if (row == nullptr || row->name != word) return false;
    return isStageRow(row) || (row->id == CommandId::program && !isEnd);
}

/// Reads lines up to the end of the shader. `stage` is the name of the stage, such as "Fragment". The lines
/// that end it are none that GLSL can have outside of comments.
ShaderBody readShaderBody(std::string_view text, LineSplitter& lines, std::string_view stage) {
    const std::string endWord = std::string(kEndPrefix) + std::string(stage);
    ShaderBody body{.before = lines};
    CommentState comments;
    bool isFirst = true;
    for (LineSplitter before = lines;; before = lines) {
        const std::optional<LineRange> line = lines.next();
        if (!line) return body;
        if (std::exchange(isFirst, false)) {
            body.first = line->begin;
            body.firstLine = line->number;
        }
        body.line = *line;
        body.before = before;
        body.last = line->begin;
        const std::string_view whole = text.substr(line->begin, line->end - line->begin);
        body.words = base::trimmed(whole, kBlanks);
        if (sameWord(body.words, endWord)) {
            body.end = ShaderBody::End::itsWord;
            return body;
        }
        const bool isOutside = comments.beginsOutside(whole);
        if (!isOutside || body.words.empty() || !isLetter(body.words.front())) continue;
        const std::vector<std::string_view> words = wordsOfLine(body.words);
        if (words.size() == 1 && (isEndWord(words[0]) || isNearly(words[0], endWord)))
            body.end = ShaderBody::End::otherWord;
        else if (statesAnother(words))
            body.end = ShaderBody::End::otherStatement;
        if (body.end != ShaderBody::End::missing) return body;
    }
}

}  // namespace

const Line* StatementReader::peek(const Statement* pending) {
    if (!ahead_) {
        std::optional<LineRange> range = lines_.next();
        if (!range) return nullptr;
        const bool joinsAny = pending && pending->modern;
        const Parentheses parentheses = parenthesesOf(text_, *range, pending);
        // The expressions of a modern statement go on after a backslash.
        int depth = 0;
        for (std::optional<LineRange> last = range; last && parentheses == Parentheses::expressions &&
                                                    range->end - range->begin <= kLongestLine &&
                                                    goesOnInParentheses(text_, *last, depth);) {
            last = lines_.next();
            if (last) range->end = last->end;
        }
        ahead_ = readLine(text_, *range, joinsAny ? MessageLines::tokens : MessageLines::rawText, log_,
                          parentheses);
    }
    return &*ahead_;
}

const Line* StatementReader::peekCode() {
    const Line* line = peek();
    for (; line && line->tokens.empty(); line = peek()) drop();
    return line;
}

Statement StatementReader::begin() {
    Line& line = *ahead_;
    Statement statement;
    statement.word = line.tokens.front();
    statement.row = commandRowOf(statement.word);
    statement.message = line.message;
    statement.end = line.isMessage ? line.messageEnd : line.tokens.back().end;
    statement.messagePosition = {
        line.range.number, static_cast<int>(statement.end - line.message.size() - line.range.begin) + 1};
    statement.faulty = line.faulty;
    line.tokens.erase(line.tokens.begin());
    statement.arguments.swap(line.tokens);
    statement.plainArguments = countPlain(statement.arguments);
    statement.modern = modernRowOf(statement);
    drop();
    return statement;
}

/// Returns the row of a modern statement; null if it is a classic one. A Program is decided by the parser.
const StatementRow* StatementReader::modernRowOf(const Statement& statement) {
    if (statement.word.kind != TokenKind::word) return nullptr;
    if (!statement.row) return findStatement(statement.word.text);
    const StatementRow* form = modernFormOf(statement.row->name);
    if (!form || statement.arguments.empty() || isCommand(statement, CommandId::program)) return nullptr;
    const Token& first = statement.arguments.front();
    if (isStageRow(form))
        return first.kind == TokenKind::word && sameWord(first.text, "inline") ? form : nullptr;
    if (takesUnit(*statement.row))
        return first.kind == TokenKind::word && isIdentifier(first.text) ? form : nullptr;
    wasAmbiguous_ = true;  // Clear with arguments
    return isModern_ ? form : nullptr;
}

void StatementReader::joinLine(Statement& statement) {
    const Line& line = *ahead_;
    statement.arguments.insert(statement.arguments.end(), line.tokens.begin(), line.tokens.end());
    statement.plainArguments += countPlain(line.tokens);
    if (!line.tokens.empty()) statement.end = line.tokens.back().end;
    statement.faulty = statement.faulty || line.faulty;
    drop();
}

std::optional<Statement> StatementReader::next() {
    const Line* line = peekCode();
    if (!line) return std::nullopt;
    bool pending = line->continues;
    Position backslash = line->backslash;
    Statement statement = begin();
    if (!pending && refuseShader(statement)) return statement;
    if (statement.modern) {
        joinModernLines(statement, pending, backslash);
        return statement;
    }
    if (refuseBraceBlock(statement)) return statement;
    if (isUnknownInline(statement)) {
        skipShader();
        return statement;
    }

    while (true) {
        line = pending ? peek(&statement) : peekCode();
        const bool blank = !line || (line->tokens.empty() && !line->continues);
        if (pending && blank) {
            const char* what = !line             ? "the file ends here"
                               : line->isComment ? "the next line is a comment"
                                                 : "the next line is blank";
            if (!line || !line->tooLong)
                log_.report("glib-W12",
                            fmt::format("backslash, but {}: statement ends unless tags follow", what),
                            backslash);
            pending = false;
            continue;
        }
        if (!line || !(pending ? continuesAfterBackslash(statement) : continuesWithoutBackslash(statement)))
            return statement;
        pending = ahead_->continues;
        backslash = ahead_->backslash;
        joinLine(statement);
    }
}

/// A modern statement goes on after a backslash, whatever the next line begins with, and never without one.
void StatementReader::joinModernLines(Statement& statement, bool pending, Position backslash) {
    while (pending) {
        const Line* line = peek(&statement);
        if (!line || (line->tokens.empty() && !line->continues)) {
            if (!line || !line->tooLong)
                log_.report("glib-W12", "backslash, but the statement ends here", backslash);
            return;
        }
        pending = line->continues;
        backslash = line->backslash;
        joinLine(statement);
    }
    const CommandId id = statement.modern->id;
    const std::size_t at = id == CommandId::glslText ? 1 : 0;
    const bool isInline = statement.arguments.size() > at &&
                          statement.arguments[at].kind == TokenKind::word &&
                          sameWord(statement.arguments[at].text, "inline");
    if (isInline && statement.modern->takesBody) readBody(statement);
    // The lines up to its end are GLSL, whatever is wrong with the statement.
    LineSplitter rest = lines_;
    if (!isInline && id == CommandId::glslText &&
        readShaderBody(text_, rest, statement.modern->name).end == ShaderBody::End::itsWord)
        readBody(statement);
}

/// Takes the lines up to one that holds only the end word.
void StatementReader::readBody(Statement& statement) {
    const std::string stage(statement.modern->name);
    const LineSplitter start = lines_;
    const ShaderBody body = bodiesWithoutEnd_.contains(stage) ? ShaderBody{.before = lines_}
                                                              : readShaderBody(text_, lines_, stage);
    if (body.end == ShaderBody::End::missing) {
        lines_ = start;
        bodiesWithoutEnd_.insert(stage);
        skipShader();
        log_.report("glib-E22", fmt::format("'{0} inline' is not closed by a line 'End{0}'", stage),
                    statement.word.position);
        statement.faulty = true;
        return;
    }
    statement.body = text_.substr(body.first, body.last - body.first);
    statement.bodyPosition = {body.firstLine, 1};
    statement.end = body.end == ShaderBody::End::otherStatement ? body.last : body.line.end;
    if (body.end == ShaderBody::End::itsWord) return;
    // The shader is whole, so what follows is read as if its end were there.
    const bool isWord = body.end == ShaderBody::End::otherWord;
    if (!isWord) lines_ = body.before;
    log_.report("glib-E22",
                fmt::format("'{} inline' is {} {} (line {}); write End{}", stage,
                            isWord ? "closed by" : "not closed before", inQuotes(body.words),
                            body.line.number, stage),
                statement.word.position);
}

/// Refuses a stage without a file whose next line is `#version`, and skips that shader.
bool StatementReader::refuseShader(Statement& statement) {
    const bool isStage = statement.row ? isStageRow(modernFormOf(statement.row->name))
                                       : statement.modern && statement.modern->id == CommandId::compute;
    if (!isStage || !statement.arguments.empty()) return false;
    LineSplitter after = lines_;
    const std::optional<LineRange> line = after.next();
    if (!line ||
        !base::trimmed(text_.substr(line->begin, line->end - line->begin), kBlanks).starts_with("#version"))
        return false;
    log_.report("glib-E17", fmt::format("{0}: a shader follows; write '{0} inline'", statement.word.text),
                statement.word.position);
    statement.faulty = true;
    skipShader();
    return true;
}

/// Skips the lines of a shader, up to the next statement about shaders or the end of the file.
void StatementReader::skipShader() {
    for (LineSplitter here = lines_; const std::optional<LineRange> line = lines_.next(); here = lines_) {
        const std::string_view words =
            base::trimmed(text_.substr(line->begin, line->end - line->begin), kBlanks);
        if (!endsShader(words)) continue;
        if (!words.starts_with("End")) lines_ = here;
        return;
    }
}

/// True if the word begins a statement where a Program or a CubeMap could go on. In a classic scene the words
/// of modern statements do not.
bool StatementReader::startsStatement(const Token& word) {
    if (commandRowOf(word)) return true;
    if (word.kind != TokenKind::word || !findStatement(word.text)) return false;
    wasAmbiguous_ = true;
    return isModern_;
}

bool StatementReader::continuesAfterBackslash(const Statement& statement) {
    if (ahead_->tokens.empty()) return true;  // only another backslash
    const Token first = ahead_->tokens.front();
    if (!commandRowOf(first)) return true;
    if (isCommand(statement, CommandId::program)) {
        if (statement.arguments.empty()) return true;  // the word after Program is always its name
        if (fitsAsTag(*ahead_)) return true;
        if (ahead_->isMessage) {  // MessageBox may also be a tag
            MessageLog unused{""};
            const Line line =
                readLine(text_, ahead_->range, MessageLines::tokens, unused, Parentheses::byContent);
            if (fitsAsTag(line)) {
                *ahead_ = readLine(text_, ahead_->range, MessageLines::tokens, log_, Parentheses::byContent);
                return true;
            }
        }
    }
    log_.report("glib-W13", fmt::format("{} after a backslash starts a new command", inQuotes(first.text)),
                first.position);
    return false;
}

bool StatementReader::continuesWithoutBackslash(const Statement& statement) {
    const bool isProgram = isCommand(statement, CommandId::program);
    const bool isCubeMap = isCommand(statement, CommandId::cubeMap);
    if (!isProgram && !(isCubeMap && statement.plainArguments < kCubeMapArguments)) return false;
    if (isProgram && !readsAsPairs(ahead_->tokens)) return false;
    if (startsStatement(ahead_->tokens.front())) return false;
    log_.report("glib-W11", fmt::format("line continues {} without a backslash", described(statement)),
                ahead_->tokens.front().position);
    return true;
}

/// Reports glib-E10. Returns true if the block was skipped.
bool StatementReader::refuseBraceBlock(Statement& statement) {
    const std::vector<Token>& tokens = statement.arguments;
    if (!isCommand(statement, CommandId::program) || tokens.empty() || tokens.size() > 2) return false;
    if (tokens.back().kind != TokenKind::open || tokens.back().text != "{") return false;
    if (tokens.size() == 2 && !tokens.front().isWord() && tokens.front().kind != TokenKind::number)
        return false;
    const std::string name = tokens.size() == 2 ? std::string(tokens.front().text) + " " : std::string();
    log_.report("glib-E10",
                fmt::format("{}: brace blocks belong to another program's scene language",
                            inQuotes("Program " + name + "{")),
                statement.word.position);
    statement.refused = true;
    return skipBraceBlock();
}

/// Skips the lines of a brace block, so that they are not all reported. Does nothing if the block is never
/// closed.
bool StatementReader::skipBraceBlock() {
    if (braceNeverCloses_) return false;
    const LineSplitter start = lines_;
    MessageLog unused{""};
    long long depth = 1;
    while (const std::optional<LineRange> range = lines_.next()) {
        for (const Token& token : readLine(text_, *range, MessageLines::rawText, unused).tokens) {
            if (token.kind == TokenKind::open && token.text == "{") ++depth;
            if (token.kind == TokenKind::close && token.text == "}") --depth;
        }
        if (depth <= 0) return true;
    }
    braceNeverCloses_ = true;
    lines_ = start;
    return false;
}

}  // namespace glibra::glib
